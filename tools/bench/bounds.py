"""The distance to the limit: what a processor's execution units alone would need for the instructions of an ordinary
call, by llvm-mca, beside what was measured.

The instructions are those that at least half of the calls over the ordinary band of the reference vectors executed, in
the order of their addresses; calls and returns are left out.
"""
import pathlib
import re
import shutil
import subprocess
import tempfile

import executed

KERNELS = ["so3_exp", "so3_log", "so3_apply", "se3_exp", "se3_log", "se3_compose", "se3_inverse", "se3_adjoint",
           "screw_from_pose", "motion_bottema_roth", "motion_laub_shiflett", "tilt_error", "tilt_from_rotation"]
PROCESSOR = "znver3"  # the newest of AMD's that llvm-mca 14 has a model of


def disassemble(program):
    """Instructions by address."""
    listing = subprocess.run(["objdump", "-d", "--no-show-raw-insn", program], check=True, text=True,
                             stdout=subprocess.PIPE).stdout
    lines = re.findall(r"^\s*([0-9a-f]+):\t(.*)$", listing, re.MULTILINE)
    return {int(address, 16): text.split("#")[0].split("<")[0].strip() for address, text in lines}


def block(execution, instructions):
    """The text of what at least half of the calls executed. Where jumps go to does not matter."""
    lines = []
    for address, count in sorted(execution.executed.items()):
        text = instructions[address]
        if 2 * count < execution.calls or re.match(r"(call|ret|leave|nop|endbr)", text):
            continue
        lines.append(re.sub(r"^(j\w+)\s.*", r"\1 start", text))
    return lines


def bound(lines):
    """Cycles an iteration: of the busiest unit, and simulated with all dependencies."""
    text = "start:\n" + "\n".join(lines) + "\n"
    report = subprocess.run(["llvm-mca", "-mtriple=x86_64", f"-mcpu={PROCESSOR}", "-iterations=200"], check=True,
                            input=text, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    value = {name: float(number) for name, number in re.findall(r"^([\w ]+):\s+([\d.]+)$", report, re.MULTILINE)}
    return {"instructions": len(lines), "units": value["Block RThroughput"],
            "simulated": value["Total Cycles"] / value["Iterations"]}


def measure():
    """Bounds by (function, precision) as a list of dictionaries, or in a text what is missing for it."""
    missing = [name for name in ("llvm-mca", "valgrind", "objdump") if shutil.which(name) is None]
    if missing:
        return "missing: " + ", ".join(missing)
    with tempfile.TemporaryDirectory() as directory:
        program, executions = executed.measure(pathlib.Path(directory))
        instructions = disassemble(program)
    found = []
    for function in KERNELS:
        for precision in ("double", "float"):
            execution = executions.get((function, precision, "ordinary"))
            if execution is not None:
                found.append({"function": function, "precision": precision, **bound(block(execution, instructions))})
    return found
