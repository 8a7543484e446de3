"""What the figures of this folder share: how their data is read, how they look, and how they are saved: small, and the
same bytes on every run."""

import base64
import csv
import io
import os
import re
import sys

import matplotlib
from PIL import Image

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.hashsalt": "chasles", "svg.fonttype": "none", "font.size": 8, "axes.titlesize": 9})


class Named(dict):
    """What a CSV file has under the name of a column; another name ends the program with a message."""

    def __init__(self, path, items):
        super().__init__(items)
        self.path = path

    def __missing__(self, name):
        sys.exit("%s: no column %s" % (self.path, name))


def read_rows(path):
    """The rows of a CSV file, at least one; what cannot be read ends the program with a message."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = [Named(path, row) for row in csv.DictReader(file)]
    except (OSError, ValueError, csv.Error) as error:
        sys.exit("%s: %s" % (path, getattr(error, "strerror", None) or error))
    return rows or sys.exit("%s: no rows" % path)


def read_number(path, text):
    """An empty cell is not a number."""
    try:
        return float(text) if text else float("nan")
    except ValueError:
        sys.exit("%s: expected a number, found '%s'" % (path, text))


def with_palette(png):
    """The bytes of a PNG with 64 colours."""
    result = io.BytesIO()
    image = Image.open(io.BytesIO(png)).convert("RGBA")
    image.quantize(64, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE).save(result, "png", optimize=True)
    return result.getvalue()


def with_palettes(svg):
    """The text of an SVG, its images with 64 colours."""
    begin = "data:image/png;base64,"
    shrink = lambda found: begin + base64.b64encode(with_palette(base64.b64decode(found.group(1)))).decode()
    return re.sub(begin + r"([^\"]+)", shrink, svg)


def save(figure, out, name):
    """NAME.svg and NAME.png in the directory, which is made if need be."""
    os.makedirs(out, exist_ok=True)
    dateless = {".svg": {"Date": None}, ".png": {"Software": None}}
    for suffix, memory, shrink in ((".svg", io.StringIO, with_palettes), (".png", io.BytesIO, with_palette)):
        file = memory()
        figure.savefig(file, format=suffix[1:], dpi=110, metadata=dateless[suffix])
        data = shrink(file.getvalue())
        path = os.path.join(out, name + suffix)
        with open(path, "w" if suffix == ".svg" else "wb") as written:
            written.write(data)
        print("%s: %d kB" % (path, len(data) // 1000))
