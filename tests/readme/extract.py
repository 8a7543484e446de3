"""Takes the programs out of README.md, and what it says they print.

    python3 extract.py README.md DIRECTORY

A program is a block ```c, followed by a line `prints` and an indented block. Writes example_1.c and example_1.txt and so
on, and prints how many there are. A block ```c without the rest, or none at all, is an error.
"""

import pathlib
import re
import sys

EXAMPLE = re.compile(r"```c\n(.*?)\n```\n\nprints\n\n((?: {4}[^\n]*\n)+)", re.DOTALL)


def main():
    text = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    out = pathlib.Path(sys.argv[2])
    examples = EXAMPLE.findall(text)
    if not examples or len(examples) != text.count("```c\n"):
        sys.exit(f"{sys.argv[1]}: {text.count('```c')} programs, {len(examples)} of them with what they print")
    for number, (program, printed) in enumerate(examples, 1):
        (out / f"example_{number}.c").write_text(program + "\n", encoding="utf-8")
        (out / f"example_{number}.txt").write_text(re.sub("(?m)^ {4}", "", printed), encoding="utf-8")
    print(len(examples))


main()
