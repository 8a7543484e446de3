"""Writes the reference vectors: one file a function and precision, the same bytes on every run and machine.

    python3 generate.py [--out DIR] [--only FUNCTION] [--jobs N] [--check] [--self-test]

The exact results are those of exact.py, the inputs those of cases_*.py, the format that of vectors.py.
"""

import argparse
import multiprocessing
import os
import sys
import time

import cases_agile_eye
import cases_chain
import cases_line
import cases_motion
import cases_points
import cases_screw
import cases_se3
import cases_so3
import cases_study
import cases_tilt
from formats import FORMATS

FUNCTIONS = {
    f.name: f for module in (cases_so3, cases_se3, cases_screw, cases_line, cases_motion, cases_points, cases_tilt, cases_chain, cases_agile_eye, cases_study) for f in module.FUNCTIONS
}
DEFAULT_OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "vectors")


def make(task):
    """(file name, bytes, seconds) of one function in one format; runs in a worker process."""
    name, index = task
    start = time.time()
    function, fmt = FUNCTIONS[name], FORMATS[index]
    return function.file_name(fmt), function.file_text(fmt).encode("ascii"), time.time() - start


def differs(path, data):
    try:
        with open(path, "rb") as file:
            return file.read() != data
    except FileNotFoundError:
        return True


def main():
    parser = argparse.ArgumentParser(description="Write the reference vectors of chasles.")
    parser.add_argument("--out", default=DEFAULT_OUT, metavar="DIR", help="directory of the vector files")
    parser.add_argument(
        "--only", action="append", choices=FUNCTIONS, metavar="FUNCTION", help="only this function's files"
    )
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="worker processes")
    parser.add_argument(
        "--check", action="store_true", help="write nothing; name the files that differ and exit 1 if any"
    )
    parser.add_argument("--self-test", action="store_true", help="compute every definition in a second way and compare")
    arguments = parser.parse_args()
    if arguments.self_test:
        import self_test

        return self_test.run()

    tasks = [(name, i) for name in arguments.only or FUNCTIONS for i in range(len(FORMATS))]
    changed = []
    made = set()
    with multiprocessing.Pool(arguments.jobs) as pool:
        for name, data, seconds in pool.imap_unordered(make, tasks):
            path = os.path.join(arguments.out, name)
            made.add(name)
            if arguments.check:
                if differs(path, data):
                    changed.append(name)
            else:
                os.makedirs(arguments.out, exist_ok=True)
                with open(path, "wb") as file:
                    file.write(data)
                print("%-44s %8d bytes %6.1f s" % (name, len(data), seconds))
    if not arguments.check:
        return 0
    if not arguments.only and os.path.isdir(arguments.out):
        changed += [name for name in os.listdir(arguments.out) if name.endswith(".txt") and name not in made]
    for name in sorted(changed):
        print("differs: " + name)
    print("%d of %d files differ" % (len(changed), len(tasks)))
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())
