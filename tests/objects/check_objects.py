"""Check what the object files of the library contain, and above all what they do not.

    check_objects.py --nm NM --objdump OBJDUMP LIBRARY

- Undefined symbols that the library does not define itself are on the short list below: no allocation, no errno, no
  stdio, none of libm's transcendental functions.
- Every symbol that a program can see starts with chs_.
- No writable data, initialised or not: every function can be called from any thread and any interrupt.
- Objects of the single-precision sources (so3f and so on) hold no double-precision arithmetic (x86-64 only).
"""

import argparse
import collections
import re
import subprocess
import sys

ALLOWED = {
    "sqrt", "sqrtf", "fabs", "fabsf",  # exact by IEEE 754; mostly one instruction
    "memcpy", "memmove", "memset",  # what compilers make of copies; C has them everywhere
    "_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail",  # position-independent and hardened code
}

# Arithmetic, comparison and conversion in double; moves and shuffles of 64 bits serve pairs of floats too. x87 code,
# whose mnemonics all start with f, has no place in either precision.
DOUBLE_INSTRUCTION = re.compile(
    r"v?(add|sub|mul|div|sqrt|min|max|round|u?comi|cmp[a-z]*|hadd|hsub|addsub|dp|fn?m(add|sub)[0-9]*)[sp]d"
    r"|v?cvt[a-z0-9]*[sp]d[a-z0-9]*|f[a-z0-9]+")


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def members(dump):
    """Part objdump's output, GNU's or LLVM's, into (object's name, lines)."""
    name, lines = None, []
    for line in dump.splitlines():
        # so3.c.o:     file format elf64-x86-64, or libchasles.a(so3.c.o): ...
        found = re.match(r"(?:.*\()?([^()]+)\)?:\s+file format", line)
        if found:
            if name:
                yield name, lines
            name, lines = found.group(1), []
        lines.append(line)
    if name:
        yield name, lines


def check_symbols(nm, library):
    defined, undefined = set(), collections.defaultdict(set)
    for line in run(nm, "-A", "-g", "-P", library).splitlines():
        # libchasles.a[so3.c.o]: chs_so3_exp T 0 1f
        where, symbol, kind = line.split()[:3]
        if kind in "Uw":
            undefined[symbol].add(where)
        else:
            defined.add(symbol)
    for symbol in sorted(set(undefined) - defined - ALLOWED):
        yield f"{symbol} is needed by {' '.join(sorted(undefined[symbol]))}"
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


def check_single_precision(objdump, library):
    checked = 0
    for name, lines in members(run(objdump, "-d", "--no-show-raw-insn", library)):
        if not re.match(r"[a-z0-9_]+f\.", name):
            continue
        checked += 1
        for line in lines:
            found = re.match(r"\s*[0-9a-f]+:\s+(\S+)", line)
            if found and DOUBLE_INSTRUCTION.fullmatch(found.group(1)):
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
    if "x86-64" in run(arguments.objdump, "-f", arguments.library):
        faults += check_single_precision(arguments.objdump, arguments.library)
    else:
        print("instructions not looked at: not x86-64")
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults in {arguments.library}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
