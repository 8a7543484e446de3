"""What the library's functions execute over the reference vectors, instruction by instruction, by callgrind.

The library is built here with one compiler and fixed options, so that the counts are the same on every run.
"""
import collections
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
HOST = ROOT / "tools/chasles"
COMPILER = "gcc"
OPTIONS = ["-std=c99", "-O2", "-ffp-contract=off", "-fno-math-errno"]


class Execution:
    """Of one function, precision and set of cases."""

    def __init__(self, calls):
        self.calls = calls
        self.executed = collections.Counter()  # how often, by address, inside the library alone

    @property
    def mean(self):
        return self.executed.total() / self.calls


def compiler():
    """"gcc 12.2.0" """
    return f"{COMPILER} {run([COMPILER, '-dumpfullversion'], stdout=subprocess.PIPE).stdout.strip()}"


def run(command, **options):
    return subprocess.run([str(word) for word in command], check=True, text=True, **options)


def build(directory):
    """The program, and the names of the library's functions."""
    options = [*OPTIONS, "-g", "-no-pie", "-fno-pie", "-D_POSIX_C_SOURCE=200809L", f"-I{ROOT / 'include'}", f"-I{HOST}"]
    objects = []
    for source in sorted((ROOT / "src").glob("*.c")):
        objects.append(directory / (source.stem + ".o"))
        run([COMPILER, *options, "-c", source, "-o", objects[-1]])
    symbols = run(["nm", "--defined-only", "--format=posix", *objects], stdout=subprocess.PIPE).stdout
    names = {line.split()[0] for line in symbols.splitlines() if re.match(r"\S+ [Tt] ", line)}
    program = directory / "executed"
    host = [HOST / f"{name}.c" for name in ("evaluate", "functions", "text", "vectors")]
    run([COMPILER, *options, ROOT / "tools/bench/executed.c", *host, *objects, "-lm", "-o", program])
    return program, names


def read_dump(path, names):
    """(function, precision, set of cases) and its execution, or None where nothing was traced."""
    title = None
    name = None
    inclusive = False
    execution = None
    for line in path.read_text().splitlines():
        if line.startswith("desc: Trigger: Client Request:"):
            *title, calls = line.split(":", 3)[3].split()
            execution = Execution(int(calls))
        elif line.startswith("fn="):
            name = line[3:].split("'")[0]
        elif line.startswith("calls="):
            inclusive = True  # the next line is about what was called
        elif line.startswith("0x") and execution is not None:
            if not inclusive and name in names:
                address, _, count = line.split()
                execution.executed[int(address, 16)] += int(count)
            inclusive = False
    return (tuple(title), execution) if execution is not None and execution.calls else None


def measure(directory):
    """The program, and executions by (function, precision, "ordinary" or "all")."""
    directory.mkdir(parents=True, exist_ok=True)
    for old in directory.glob("callgrind.out*"):
        old.unlink()
    program, names = build(directory)
    run(["valgrind", "--tool=callgrind", "--instr-atstart=no", "--dump-instr=yes", "--compress-strings=no",
         "--compress-pos=no", f"--callgrind-out-file={directory / 'callgrind.out'}", program, ROOT / "tests/vectors"],
        stderr=subprocess.DEVNULL)
    dumps = sorted(directory.glob("callgrind.out.*"), key=lambda path: int(path.suffix[1:]))
    return program, dict(filter(None, (read_dump(path, names) for path in dumps)))
