"""Check that a program which calls one function of the library links that function and what it calls, and no other.

    check_links.py --nm NM --objdump OBJDUMP LIBRARY COMPILER [option...]
"""

import argparse
import concurrent.futures
import os
import subprocess
import sys
import tempfile

import call_graph
from call_graph import run, whole


def library_functions(nm, file, kinds):
    names = (line.split()[:2] for line in run(nm, "-P", file).splitlines() if len(line.split()) > 1)
    return {whole(name) for name, kind in names if kind in kinds and name.startswith("chs_")}


def reachable(graph, function):
    return {name for name in call_graph.reachable(graph, function) if name.startswith("chs_")}


def check(function, graph, copies, directory, arguments):
    program = os.path.join(directory, function)
    command = [arguments.compiler, *arguments.options, "-nostartfiles", "-Wl,--gc-sections", f"-Wl,-e,{function}",
               f"-Wl,-u,{function}", arguments.library, "-lm", "-o", program]
    subprocess.run(command, check=True)
    linked = library_functions(arguments.nm, program, "TtWR")
    allowed = reachable(graph, function)
    wanted = reachable({name: calls for name, calls in graph.items() if name not in copies}, function) - copies
    return [f"{function} links {name}" for name in sorted(linked - allowed)] + [
        f"{function} lacks {name}" for name in sorted(wanted - linked)]


def main():
    parser = argparse.ArgumentParser(description="check what single functions of the library link")
    parser.add_argument("--nm", default="nm")
    parser.add_argument("--objdump", default="objdump")
    parser.add_argument("library")
    parser.add_argument("compiler")
    parser.add_argument("options", nargs=argparse.REMAINDER)
    arguments = parser.parse_args()

    graph = call_graph.read(arguments.objdump, arguments.library)
    functions = sorted(library_functions(arguments.nm, arguments.library, "T"))
    # What is static stands in several objects under one name, and one copy may have inlined what another calls.
    copies = library_functions(arguments.nm, arguments.library, "tr")
    with tempfile.TemporaryDirectory() as directory, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = sum(pool.map(lambda function: check(function, graph, copies, directory, arguments), functions), [])
    for fault in faults:
        print(fault)
    print(f"{len(functions)} functions linked, {len(faults)} faults")
    return 1 if faults or not functions else 0


if __name__ == "__main__":
    sys.exit(main())
