#!/usr/bin/env python3
"""Keep the figures in README.md true.

    figures.py PROGRAM [--write]

The table of the controller has those of tools/firmware/tables for a Cortex-M4F in float at -O2; the table "How exact"
has what PROGRAM, the host program, finds in tests/vectors and what the headers promise, and a search that found more
than the promise is an error. Without --write a figure that differs fails; with it the tables are made anew. The search's
own figures are typed by hand.
"""

import argparse
import csv
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
TABLES = ROOT / "tools" / "firmware" / "tables"

# A row is named by a function, or by these.
FUNCTIONS = {
    "so3 Jacobians": ["so3_left_jacobian", "so3_right_jacobian"],
    "their inverses": ["so3_left_jacobian_inverse", "so3_right_jacobian_inverse"],
    "se3 Jacobians": ["se3_left_jacobian", "se3_right_jacobian"],
    "se3 inverse Jacobians": ["se3_left_jacobian_inverse", "se3_right_jacobian_inverse"],
}
# Then by a group of outputs, as in functions.def or by these, by a range of angles, or by what the error is counted for.
GROUPS = {"rotation": {"rotation", "diagonal", "off_diagonal", "rotation_vector"}, "feet": {"foot"}}
BEYOND_PI = {"beyond_pi", "far"}
RANGES = {"up to pi": lambda band: band not in BEYOND_PI, "beyond pi": lambda band: band in BEYOND_PI}
COUNTED = {"a joint"}


def controller_figures():
    """function -> cells of its row, from the firmware's tables."""
    rows = {}
    for table, titles in (("instructions", ["M4F:least", "M4F:typical", "M4F:most"]), ("stack", ["M4F"]),
                          ("flash", ["M4F-O2"])):
        columns = []
        for line in (TABLES / f"{table}.txt").read_text(encoding="utf-8").splitlines():
            words = line.split()
            if words[0] == "function":
                columns = words[2:]
            elif len(words) == len(columns) + 2 and words[1] == "float":
                rows.setdefault(words[0], []).extend(words[2 + columns.index(title)] for title in titles)
    return rows


def controller_row(cells, figures):
    name = cells[0].split(",")[0]
    if len(figures.get(name, [])) != len(cells) - 1:
        sys.exit(f"README.md: the firmware's tables have no {name}")
    return [cells[0], *figures[name]]


def measured(program):
    with tempfile.TemporaryDirectory() as directory:
        table = pathlib.Path(directory) / "errors.csv"
        subprocess.run([program, "compare", "--quiet", "--csv", table, ROOT / "tests" / "vectors"], check=True,
                       stdout=subprocess.DEVNULL)
        return list(csv.DictReader(table.open(encoding="utf-8")))


def exactness_row(cells, errors):
    name, *parts = cells[0].split(", ")
    functions, groups, in_range = FUNCTIONS.get(name, [name]), None, lambda band: True
    for part in parts:
        if part in RANGES:
            in_range = RANGES[part]
        elif part not in COUNTED:
            groups = GROUPS.get(part, {part})
    chosen = [row for row in errors if row["function"] in functions and (groups is None or row["group"] in groups)
              and in_range(row["band"]) and float(row["promise_eps"] or 0) > 0]
    promises = {float(row["promise_eps"]) for row in chosen}
    if len(promises) != 1:
        sys.exit(f"README.md: {cells[0]} has {len(promises)} promises")
    promise = promises.pop()
    if cells[3] and float(cells[3]) > promise:
        sys.exit(f"README.md: {cells[0]}: the search found more than is promised")
    worst = [max(float(row["largest_eps"]) for row in chosen if row["precision"] == precision)
             for precision in ("double", "float")]
    return [cells[0], *(f"{error:.2f}" for error in worst), cells[3], f"{promise:g}"]


def remade(text, title, make_row):
    """The text with the rows of the table with this title made anew."""
    head, found, rest = text.partition(title)
    if not found:
        sys.exit(f"README.md has no table with the title {title}")
    rule, *lines = rest.split("\n")[1:]
    rows = [line for line in lines[: next(i for i, line in enumerate(lines) if not line.startswith("|"))]]
    new = ["| " + " | ".join(make_row([cell.strip() for cell in row.strip("|").split("|")])) + " |" for row in rows]
    new = [re.sub(r"\|  \|", "| |", row) for row in new]
    return "\n".join([head + title, rule, *new, *lines[len(rows):]])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    old = README.read_text(encoding="utf-8")
    controller, errors = controller_figures(), measured(arguments.program)
    new = remade(old, "| function | instructions, least | typical | most | stack, bytes | flash, bytes |",
                 lambda cells: controller_row(cells, controller))
    new = remade(new, "| function | vectors, double | float | search | promise |",
                 lambda cells: exactness_row(cells, errors))
    if arguments.write:
        README.write_text(new, encoding="utf-8")
        return 0
    wrong = [(was, now) for was, now in zip(old.splitlines(), new.splitlines()) if was != now]
    for was, now in wrong:
        print(f"README.md says\n  {was}\nand should say\n  {now}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
