#!/usr/bin/env python3
"""Measure what the library costs on each microcontroller, and compare with what is written down.

    tables.py --show | --write | --check  [--only NAME,...] [--targets TARGET,...] [--kinds KIND,...]

flash         bytes that a program links because it calls this one function, -Os and -O2: the function, what it calls
              in the library, and what the compiler's own libraries add for soft float and square roots; then because
              it calls all functions of a header, of all headers up to one, and of the library
stack         most bytes of stack that a call takes, all that it calls included but for a function of the caller's own,
              at -O2
instructions  least, typical and most of a call over all reference vectors at -O2, net of a call that does nothing;
              typical is the median, and it and the least are those of calls without an error; an array form is called
              for 17 elements

Everything is built anew below --build. The figures are the same on every run and every machine with the same compiler
and emulator. --check fails where a figure has grown, or stands on one side alone: a function that is new, or one that is no more;
what has shrunk is printed, for --write to record.
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TABLES = HERE / "tables"
TARGETS = {"cortex-m0plus": "M0+", "cortex-m4": "M4F", "cortex-m7": "M7", "cortex-m33": "M33", "rv32imafc": "RV32"}
BUILD_TYPES = {"-Os": "MinSizeRel", "-O2": "Release"}
KINDS = ("flash", "stack", "instructions")
WHOLE = "whole library"
ICOUNT = {"qemu-system-arm": "shift=8", "qemu-system-riscv32": "shift=0"}
TEXTBOOK = "textbook, newlib"


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def build(directory, goals, *arguments):
    """Configure and build; with the compiler's notes on each function's stack."""
    environment = {**os.environ, "CFLAGS": "-fstack-usage"}
    run("cmake", "-S", ROOT, "-B", directory, "-DCHASLES_BUILD_TESTS=OFF", *arguments, env=environment)
    run("cmake", "--build", directory, "--parallel", os.cpu_count() or 1, "--target", *goals)


class Target:
    """One microcontroller at one optimisation."""

    def __init__(self, name, option, directory):
        self.name, self.directory = name, directory / f"{name}{option}"
        goals = ["device_count", "device_hollow", "device_textbook"] if option == "-O2" else ["chasles"]
        build(self.directory, goals, f"-DCMAKE_TOOLCHAIN_FILE={HERE / name}.cmake",
              "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", f"-DCMAKE_BUILD_TYPE={BUILD_TYPES[option]}")
        commands = json.loads((self.directory / "compile_commands.json").read_text())
        self.compiler, *words = commands[0]["command"].split()
        self.flags = [word for word in words if re.match(r"-m|-O|--specs", word)]
        if "arm" in self.compiler:
            self.flags.append("--specs=nano.specs")
        self.library = self.directory / "src" / "libchasles.a"

    def tool(self, name):
        return re.sub(r"gcc$", name, self.compiler)

    def program(self, name):
        return self.directory / "tools" / "firmware" / f"{name}.elf"

    def functions(self):
        """(name, format) -> symbol of each public function."""
        found, single = {}, None
        for line in run(self.tool("nm"), "-g", self.library).splitlines():
            member = re.match(r"(\w+)\.c\.obj:$", line)
            symbol = re.match(r"\w+ T (chs_(?!p_)(\w+))$", line)
            if member:
                single = member.group(1).endswith("f")
            elif symbol:
                name = symbol.group(2)
                found[(name[:-1], "float") if single else (name, "double")] = symbol.group(1)
        found.pop(("status_text", "double"), None)
        return found


def link(target, symbols):
    """A program that holds these functions and what they need, and nothing else."""
    program = target.directory / ("links-" + re.sub(r"\W", "", symbols[0]) + str(len(symbols)))
    roots = [f"-Wl,-u,{symbol}" for symbol in symbols]
    run(target.compiler, *target.flags, "-nostartfiles", "-Wl,--gc-sections", "-T", HERE / "board" / "sections.ld",
        "-Wl,--defsym=CODE=0,--defsym=RAM=0x20000000,--defsym=RAM_SIZE=0x400000", f"-Wl,-e,{symbols[0]}", *roots,
        target.library, "-lm", f"-Wl,-Map={program}.map", "-o", program)
    return program


def linked_bytes(target, symbols):
    program = link(target, symbols)
    size = run(target.tool("size"), program).splitlines()[1].split()
    program.unlink()
    program.with_name(f"{program.name}.map").unlink()
    return int(size[0]) + int(size[1])


def read_sets():
    """Title -> names of the functions of a header, and of the headers so far; motion.h counts as two."""
    read = lambda pattern, *place: re.findall(pattern, ROOT.joinpath(*place).read_text(), re.M)
    n_points = read(r"^(?:int|void) FN\(chs_(\w+)\)", "src", "motion_points.c")
    alone, together, so_far = {}, {}, []
    for title in ("so3.h", "se3.h", "screw.h", "motion.h, 3 points", "tilt.h", "line.h", "motion.h, n points", "chain.h",
                  "agile_eye.h", "array.h"):
        prototypes = read(r"^(?:int|void) chs_(\w+)\(", "include", "chasles", title.split(",")[0])
        alone[title] = [name for name in prototypes if f"{name}f" in prototypes and
                        (not title.startswith("motion") or (name in n_points) == title.endswith("n points"))]
        so_far = so_far + alone[title]
        together[f"so3.h to {title}"] = so_far
    del together["so3.h to so3.h"], together["so3.h to array.h"]  # the whole library
    return {**alone, **together}


SETS = read_sets()
LAST = [*SETS, WHOLE]


def measure_flash(target, only):
    functions = target.functions()
    wanted = {key: [symbol] for key, symbol in functions.items() if not only or key[0] in only}
    if not only:
        for precision in ("double", "float"):
            for title, names in SETS.items():
                wanted[(title, precision)] = [functions[name, precision] for name in names]
            wanted[(WHOLE, precision)] = [symbol for key, symbol in functions.items() if key[1] == precision]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        sizes = pool.map(lambda symbols: linked_bytes(target, symbols), wanted.values())
        return {key: [size] for key, size in zip(wanted, sizes)}


# Instructions that take stack, in the assembly that no .su file covers.
STACK = (
    (re.compile(r"(?:push|stmdb(?:\.w)?\s+sp!,|stmfd(?:\.w)?\s+sp!,)\s*(?:\.w\s*)?\{(.*)\}"), lambda m: 4 * registers(m)),
    (re.compile(r"vpush\s+\{(d.*)\}"), lambda m: 8 * registers(m)),
    (re.compile(r"vpush\s+\{(s.*)\}"), lambda m: 4 * registers(m)),
    (re.compile(r"sub(?:w|\.w)?\s+(?:sp, )?sp, #(\d+)"), lambda m: int(m.group(1))),
    (re.compile(r"strd?(?:\.w)?\s+.*\[sp, #-(\d+)\]!"), lambda m: int(m.group(1))),
    (re.compile(r"addi\s+sp,sp,-(\d+)"), lambda m: int(m.group(1))),
)
CALL = re.compile(r"(?:bl|(b|b\.w|b\.n|j|tail)|jal|call)\s+(?:ra,)?(?:0x)?([0-9a-f]+) <[^>+]+>")
INDIRECT = re.compile(r"blx\s+r|jalr\s")


def registers(match):
    count = 0
    for part in match.group(1).split(","):
        ends = [int(end) for end in re.findall(r"\d+", part)]
        count += ends[1] - ends[0] + 1 if "-" in part else 1
    return count


def read_frames(directory):
    """(object file, name) -> bytes of its own frame, as the compiler says; of several functions of one name the
    largest."""
    frames = collections.defaultdict(int)
    for file in (directory / "src").rglob("*.su"):
        for line in file.read_text().splitlines():
            where, size, kind = line.split("\t")
            if kind != "static":
                sys.exit(f"{where}: its stack is {kind}")
            key = re.sub(r"\.c$", "", file.stem), where.rsplit(":", 1)[1]
            frames[key] = max(frames[key], int(size))
    return frames


def read_origins(program):
    """address -> object file of each of the library's functions, which have sections of their own, in a program."""
    text = program.with_name(f"{program.name}.map").read_text()
    found = re.findall(r"^ \.text\.\S+\s+0x([0-9a-f]+)\s+0x[0-9a-f]+ \S*\((\w+)\.c\.obj\)$", text, re.M)
    return {int(address, 16): name for address, name in found}


CALLBACKS = ("take", "pose_of_robot")  # chs_so3_solve and chs_tilt_worst ask a function of the caller


class Function:
    """One function of a linked program: static ones of the same name are different ones."""

    def __init__(self, name, origin):
        self.name, self.origin = name, origin
        self.calls, self.jumps, self.taken, self.indirect = set(), set(), 0, False


def read_functions(target):
    """address -> Function: its calls and its jumps to others, by address, and the bytes of stack that its instructions
    take."""
    functions, address = {}, None
    program = link(target, list(target.functions().values()))
    origins = read_origins(program)
    for line in run(target.tool("objdump"), "-d", "--no-show-raw-insn", program).splitlines():
        start = re.match(r"([0-9a-f]+) <([^>]+)>:$", line)
        if start:
            address = int(start.group(1), 16)
            functions[address] = Function(start.group(2), origins.get(address))
            continue
        found = re.match(r"\s*[0-9a-f]+:\s+(.*)", line)
        if not found:
            continue
        instruction, function = found.group(1), functions[address]
        called = CALL.search(instruction)
        if called and int(called.group(2), 16) != address:
            (function.jumps if called.group(1) else function.calls).add(int(called.group(2), 16))
        function.indirect |= bool(INDIRECT.match(instruction))
        for pattern, amount in STACK:
            took = pattern.match(instruction)
            if took:
                function.taken += amount(took)
                break
    return functions


def measure_stack(target, only):
    frames, functions = read_frames(target.directory), read_functions(target)
    depths = {}

    def depth(address, above=()):
        function = functions[address]
        if address in above:
            sys.exit(f"{target.name}: {function.name} calls itself")
        key = function.origin, function.name
        if function.indirect and key in frames and function.name not in CALLBACKS:
            sys.exit(f"{target.name}: {function.name} calls through a pointer")
        if address not in depths:
            above += (address,)
            own = frames.get(key, function.taken)
            # A jump to another function is its last deed, its own stack given back.
            depths[address] = max(own + max((depth(called, above) for called in function.calls), default=0),
                                  max((depth(other, above) for other in function.jumps), default=0))
        return depths[address]

    places = {function.name: address for address, function in functions.items()}
    return {key: [depth(places[symbol])] for key, symbol in target.functions().items() if not only or key[0] in only}


def count(target, program, host, only):
    """(name, format) -> least, typical and most, as the device counts."""
    table = target.directory / f"{program}.csv"
    machine = re.search(r"^set\(target_machine (\S+)", (HERE / f"{target.name}.cmake").read_text(), re.M).group(1)
    emulate = target.directory / "tools" / "firmware" / "emulate"
    command = [host, "compare", "--quiet", "--counts", table, "--device",
               f"exec:{emulate} {target.program(program)} -icount {ICOUNT[machine]}", ROOT / "tests" / "vectors"]
    if only:
        command += ["--only", ",".join(sorted(only))]
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    if done.returncode == 2 or (done.returncode and program == "device_count"):
        sys.exit(f"{target.name}: {program}:\n{done.stdout}")
    calls = collections.defaultdict(list)
    for row in csv.DictReader(table.open()):
        calls[row["function"], row["precision"]].append((int(row["count"]), int(row["status"])))
    return {key: summary(found) for key, found in calls.items()}


def summary(calls):
    good = [number for number, status in calls if status >= 0] or [0]
    return min(good), statistics.median_low(good), max(number for number, _ in calls)


def measure_instructions(target, host, only):
    left = re.findall(r" T (chs_p_\w+)", run(target.tool("nm"), target.program("device_hollow")))
    if left:
        sys.exit(f"{target.name}: device_hollow still calls the library: {' '.join(left)}")
    overhead = count(target, "device_hollow", host, only)
    result = {}
    for program, label in (("device_count", None), ("device_textbook", TEXTBOOK)):
        names = only
        if label:
            names = {name for name in TEXTBOOK_FUNCTIONS if not only or name in only}
            if not names:
                continue
        for key, figures in count(target, program, host, names).items():
            if label and key[1] != "float":
                continue
            name = f"{key[0]} ({label})" if label else key[0]
            off = overhead[key][-1]
            result[name, key[1]] = [max(figure - off, 0) for figure in figures]
    return result


TEXTBOOK_FUNCTIONS = re.findall(r"^int chs_(\w+)f\(", (HERE / "device" / "textbook.c").read_text(), re.M)
ORDER = re.findall(r"^FUNCTION\((\w+),", (ROOT / "tools" / "chasles" / "functions.def").read_text(), re.M)


def place(key):
    name = key[0].split(" ")[0]
    last = LAST.index(key[0]) if key[0] in LAST else -1
    return (ORDER.index(name) if name in ORDER else len(ORDER), last, key[1], key[0])


def measure(kind, arguments):
    """The columns' titles, and (name, format) -> figures."""
    titles, rows = [], collections.defaultdict(dict)
    for name in arguments.targets:
        for option in ("-Os", "-O2") if kind == "flash" else ("-O2",):
            target = Target(name, option, arguments.build)
            if kind == "flash":
                columns, found = [f"{TARGETS[name]}{option}"], measure_flash(target, arguments.only)
            elif kind == "stack":
                columns, found = [TARGETS[name]], measure_stack(target, arguments.only)
            else:
                columns = [f"{TARGETS[name]}:{figure}" for figure in ("least", "typical", "most")]
                found = measure_instructions(target, arguments.program, arguments.only)
            titles += columns
            for key, figures in found.items():
                rows[key].update(zip(columns, figures))
    return titles, rows


def text_of(kind, titles, rows):
    width, wide = max(len(key[0]) for key in rows), max(10, *map(len, titles))
    lines = [f"# {' '.join(line.split())}" for line in explanation(kind)]
    lines.append(f"{'function':{width}} {'format':6} " + " ".join(f"{title:>{wide}}" for title in titles))
    for key in sorted(rows, key=place):
        cells = (str(rows[key].get(title, "-")) for title in titles)
        lines.append(f"{key[0]:{width}} {key[1]:6} " + " ".join(f"{cell:>{wide}}" for cell in cells))
    return "\n".join(lines) + "\n"


def explanation(kind):
    paragraph = re.search(rf"^{kind} +(.*?)(?=^\S|\n\n)", __doc__, re.M | re.S).group(1)
    return paragraph.strip().split("\n")


def read_table(text):
    titles, rows = [], {}
    for line in text.splitlines():
        if line.startswith("#"):
            continue
        name, precision, cells = re.match(r"(.+?) +(format|double|float) +(.*)", line).groups()
        if precision == "format":
            titles = cells.split()
        else:
            rows[name, precision] = {title: int(cell) for title, cell in zip(titles, cells.split()) if cell != "-"}
    return rows


def read_written(kind, titles, only):
    """What the table says in these columns, of these functions or of all."""
    file = TABLES / f"{kind}.txt"
    rows = read_table(file.read_text()) if file.exists() else {}
    return {key: {title: figure for title, figure in row.items() if title in titles} for key, row in rows.items()
            if not only or key[0].split(" (")[0] in only}


def growths(kind, written, rows):
    for key in sorted({**written, **rows}, key=place):
        for title in {**written.get(key, {}), **rows.get(key, {})}:
            before, figure = written.get(key, {}).get(title), rows.get(key, {}).get(title)
            label = f"{kind}: {key[0]} {key[1]}, {title}"
            if before is None:
                yield True, f"{label}: {figure}, not in the table"
            elif figure is None:
                yield True, f"{label}: {before}, in the table alone"
            elif figure != before and not title.endswith(":least"):
                yield figure > before, f"{label}: {before} before, {figure} now"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--show", action="store_true", help="print the tables")
    what.add_argument("--write", action="store_true", help="write them to tables/")
    what.add_argument("--check", action="store_true", help="compare them with tables/")
    words = lambda text: text.split(",")
    parser.add_argument("--only", type=words, default=[], help="these functions, without chs_")
    parser.add_argument("--targets", type=words, default=list(TARGETS))
    parser.add_argument("--kinds", type=words, default=list(KINDS))
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "tables")
    parser.add_argument("--program", type=pathlib.Path, help="chasles, the host program; built unless given")
    arguments = parser.parse_args()
    if arguments.write and (arguments.only or len(arguments.targets) < len(TARGETS)):
        parser.error("--write needs all functions and targets")
    if not arguments.program:
        build(arguments.build / "host", ["chasles_tool"], "-DCMAKE_BUILD_TYPE=Release")
        arguments.program = arguments.build / "host" / "tools" / "chasles" / "chasles"

    failed = False
    for kind in arguments.kinds:
        titles, rows = measure(kind, arguments)
        if arguments.show:
            print(text_of(kind, titles, rows))
        elif arguments.write:
            TABLES.mkdir(exist_ok=True)
            (TABLES / f"{kind}.txt").write_text(text_of(kind, titles, rows))
        else:
            for grown, message in growths(kind, read_written(kind, titles, arguments.only), rows):
                print(message if grown else f"{message} (less; --write records it)")
                failed = failed or grown
            print(f"{kind}: {sum(map(len, rows.values()))} figures compared")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
