"""Which functions of a library's object files call, or name, which: from the relocations and direct calls in objdump's
output, GNU's or LLVM's."""

import collections
import re
import subprocess

# A call or jump to the start of a function in the same section: no relocation is needed for it.
DIRECT = re.compile(r"\s*[0-9a-f]+:\s+[a-z].*<([A-Za-z_][\w.$]*)>")
RELOCATION = re.compile(r"\s*[0-9a-f]+:\s+R_\w+\s+(?:\.text\.(?:unlikely\.|hot\.)?)?([A-Za-z_][\w.$]*)")
CALL = re.compile(r"\b(call|callq|bl|jal|jalr)\b|\bauipc\s+ra,")
START = re.compile(r"[0-9a-f]+ <([A-Za-z_][^>]*)>:$")


def run(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def members(dump):
    """Part objdump's output into (object's name, lines)."""
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


def whole(name):
    """Compilers split a function into itself and NAME.cold, which lies elsewhere."""
    return re.sub(r"\.cold$", "", name)


def read(objdump, library):
    """function -> functions that it calls. A function that programs cannot see is 'object:name'."""
    graph = collections.defaultdict(set)
    for member, lines in members(run(objdump, "-d", "-r", "--no-show-raw-insn", library)):
        own = {whole(start.group(1)) for start in map(START.match, lines) if start}
        node = lambda name: f"{member}:{whole(name)}" if whole(name) in own and whole(name)[:4] != "chs_" else whole(name)
        function = instruction = None
        for line, following in zip(lines, lines[1:] + [""]):
            start = START.match(line)
            if start:
                function = node(start.group(1))
                graph[function] |= set()
            relocation = re.match(r"\s*[0-9a-f]+:\s+R_", line)
            if not relocation:
                instruction = line
            # An instruction with a relocation shows some target or other.
            direct = None if re.match(r"\s*[0-9a-f]+:\s+R_", following) else DIRECT.match(line)
            named = RELOCATION.match(line) if relocation else direct
            if not named or not function:
                continue
            callee = node(named.group(1))
            if callee != function or CALL.search(instruction):
                graph[function].add(callee)
    return graph


def reachable(graph, function):
    found, left = set(), [function]
    while left:
        name = left.pop()
        if name not in found:
            found.add(name)
            left += graph.get(name, ())
    return found


def cycle(graph):
    """The names of functions that call each other in a circle, or None."""
    done, path = set(), []

    def visit(name):
        if name in path:
            return path[path.index(name):] + [name]
        if name in done:
            return None
        path.append(name)
        for callee in sorted(graph.get(name, ())):
            found = visit(callee)
            if found:
                return found
        path.pop()
        done.add(name)
        return None

    for name in sorted(graph):
        found = visit(name)
        if found:
            return found
    return None
