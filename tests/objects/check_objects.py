"""Check what the object files of the library contain, and above all what they do not.

    check_objects.py --nm NM --objdump OBJDUMP LIBRARY

- Undefined symbols that the library does not define itself are on the short list below: no allocation, no errno, no
  stdio, none of libm's transcendental functions.
- Every symbol that a program can see starts with chs_.
- No writable data, initialised or not: every function can be called from any thread and any interrupt.
- Objects of the single-precision sources (so3f and so on) hold no double-precision arithmetic: neither instructions
  (x86-64, Arm, RISC-V) nor calls of the compiler's helpers for soft float.
- No function calls itself, directly or through others.
"""

import argparse
import collections
import re
import sys

import call_graph
from call_graph import members, run

ALLOWED = {
    "sqrt", "sqrtf", "fabs", "fabsf",  # exact by IEEE 754; mostly one instruction
    "memcpy", "memset", "memmove",  # what compilers make of copies
    "_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail",  # position-independent and hardened code
}

# What compilers call where the processor has no such instruction: integers, then numbers of either precision.
INTEGER_HELPERS = re.compile(r"__aeabi_u?idiv(mod)?|__u?(div|mod)si3|__gnu_thumb1_case_\w+")
SINGLE_HELPERS = re.compile(r"__aeabi_(f(add|sub|rsub|mul|div|cmp\w+)|u?i2f|f2u?iz)|__(add|sub|mul|div|neg)sf3"
                            r"|__(eq|ne|lt|le|gt|ge|unord)sf2|__float(un)?sisf|__fix(uns)?sfsi")
DOUBLE_HELPERS = re.compile(r"__aeabi_(d(add|sub|rsub|mul|div|cmp\w+)|u?i2d|d2u?iz)|__(add|sub|mul|div|neg)df3"
                            r"|__(eq|ne|lt|le|gt|ge|unord)df2|__float(un)?sidf|__fix(uns)?dfsi")

# Arithmetic, comparison and conversion in double; moves and shuffles of 64 bits serve pairs of floats too. x87 code,
# whose mnemonics all start with f, has no place in either precision.
DOUBLE_INSTRUCTION = {
    "x86-64": re.compile(
        r"v?(add|sub|mul|div|sqrt|min|max|round|u?comi|cmp[a-z]*|hadd|hsub|addsub|dp|fn?m(add|sub)[0-9]*)[sp]d"
        r"|v?cvt[a-z0-9]*[sp]d[a-z0-9]*|f[a-z0-9]+"),
    "arm": re.compile(r"v(?!mov|ldr|str)[a-z]+\S*\.f64\S*"),
    "riscv": re.compile(r"f(?!ld|sd)[a-z]+\S*\.d(\.\S+)?"),
}


def is_single_precision(member):
    return re.match(r"[a-z0-9_]+f\.", member) is not None


def is_allowed(symbol, member):
    if symbol in ALLOWED or INTEGER_HELPERS.fullmatch(symbol):
        return True
    return bool((SINGLE_HELPERS if is_single_precision(member) else DOUBLE_HELPERS).fullmatch(symbol))


def check_symbols(nm, library):
    defined, undefined = set(), collections.defaultdict(set)
    for line in run(nm, "-A", "-g", "-P", library).splitlines():
        # libchasles.a[so3.c.o]: chs_so3_exp T 0 1f
        where, symbol, kind = line.split()[:3]
        if kind in "Uw":
            undefined[symbol].add(where)
        else:
            defined.add(symbol)
    for symbol in sorted(set(undefined) - defined):
        wrong = sorted(where for where in undefined[symbol] if not is_allowed(symbol, re.search(r"[^\[(]+$", where)[0]))
        if wrong:
            yield f"{symbol} is needed by {' '.join(wrong)}"
    for symbol in sorted(defined):
        if not symbol.startswith("chs_"):
            yield f"{symbol} is visible to programs but does not start with chs_"
    if not defined:
        yield "no symbol was found"


def check_sections(objdump, library):
    for name, lines in members(run(objdump, "-h", library)):
        for line in lines:
            #   1 .data         00000000  0000000000000000  ...
            found = re.match(r"\s*\d+\s+(\.s?data|\.s?bss|\.tdata|\.tbss)(\S*)\s+([0-9a-f]+)\s", line)
            # What is constant but for the relocation of pointers is read-only when the program runs.
            if found and int(found.group(3), 16) and not found.group(2).startswith(".rel.ro"):
                yield f"{name} has {int(found.group(3), 16)} bytes of writable data in {found.group(1)}{found.group(2)}"


def check_single_precision(objdump, library, instruction):
    checked = 0
    for name, lines in members(run(objdump, "-d", "--no-show-raw-insn", library)):
        if not is_single_precision(name):
            continue
        checked += 1
        for line in lines:
            found = re.match(r"\s*[0-9a-f]+:\s+(\S+)", line)
            if found and instruction.fullmatch(found.group(1)):
                yield f"{name} computes in double: {line.strip()}"
    if not checked:
        yield "no object of a single-precision source was found"


def main():
    parser = argparse.ArgumentParser(description="check the object files of the library")
    parser.add_argument("library")
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--objdump", default="objdump")
    arguments = parser.parse_args()

    faults = list(check_symbols(arguments.nm, arguments.library))
    faults += check_sections(arguments.objdump, arguments.library)
    kind = run(arguments.objdump, "-f", arguments.library)
    instruction = next((DOUBLE_INSTRUCTION[name] for name in DOUBLE_INSTRUCTION if name in kind), None)
    if instruction:
        faults += check_single_precision(arguments.objdump, arguments.library, instruction)
    else:
        print("instructions not looked at: neither x86-64 nor Arm nor RISC-V")
    circle = call_graph.cycle(call_graph.read(arguments.objdump, arguments.library))
    if circle:
        faults.append(f"{' calls '.join(circle)}")
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults in {arguments.library}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
