#!/usr/bin/env python3
"""Keeps the number of instructions that each function executes.

    instructions.py --write    makes tools/bench/instructions.txt anew
    instructions.py --check    fails where one has grown by more than 3 percent; that is for whoever made it grow
                               to mend, or to accept by --write

Counts are exact and repeatable, but each compiler's own: with another than the table's nothing is checked, and said.
"""
import argparse
import pathlib
import sys
import tempfile

import executed

TABLE = pathlib.Path(__file__).with_name("instructions.txt")
GROWTH = 1.03
SETS = ["ordinary", "all"]


def heading():
    return f"""# Instructions a call inside the library, mean over the cases of tests/vectors: the ordinary band, and all bands.
# Made by tools/bench/instructions.py --write; x86-64, {executed.compiler()} {' '.join(executed.OPTIONS)}
"""


def measure():
    """Means by (function, precision), for each of SETS; None where there is no such case."""
    with tempfile.TemporaryDirectory() as directory:
        _, executions = executed.measure(pathlib.Path(directory))
    keys = dict.fromkeys(key[:2] for key in executions)
    return {key: [executions[(*key, name)].mean if (*key, name) in executions else None for name in SETS] for key in keys}


def write(counts):
    rows = [f"{name:32} {precision:6} " + " ".join(f"{'-' if mean is None else f'{mean:.1f}':>8}" for mean in means)
            for (name, precision), means in counts.items()]
    TABLE.write_text(heading() + "\n".join(rows) + "\n")
    print(f"written: {TABLE}, {len(rows)} rows")


def read():
    rows = [line.split() for line in TABLE.read_text().splitlines() if not line.startswith("#")]
    return {(row[0], row[1]): [None if word == "-" else float(word) for word in row[2:]] for row in rows}


def complaints(kept, counts):
    for key in kept.keys() | counts.keys():
        label = " ".join(key)
        if key not in kept or key not in counts:
            yield f"{label}: {'is not in the table' if key in counts else 'is in the table alone'}"
            continue
        for name, before, now in zip(SETS, kept[key], counts[key]):
            if (before is None) != (now is None):
                yield f"{label}, {name}: there {'are no' if now is None else 'are now'} such cases"
            elif before is not None and now > before * GROWTH:
                yield f"{label}, {name}: {before:.1f} instructions have become {now:.1f}, {now / before - 1:+.1%}"


def check():
    if not TABLE.read_text().startswith(heading()):
        print(f"instructions: not compared, for {TABLE.name} was made with another compiler or other options than\n"
              f"{heading()}")
        return 0
    counts = measure()
    found = sorted(complaints(read(), counts))
    for line in found:
        print(line)
    print(f"instructions: {len(counts)} rows compared, {len(found)} complaints"
          + ("; see tools/bench/instructions.py --help" if found else ""))
    return 1 if found else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.write == options.check:
        parser.error("--write or --check?")
    if options.write:
        write(measure())
        return 0
    return check()


if __name__ == "__main__":
    sys.exit(main())
