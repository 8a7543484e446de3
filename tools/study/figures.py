"""What the figures of this folder share: how they look, and how they are saved: small, and the same bytes on every run."""

import base64
import io
import os
import re

import matplotlib
from PIL import Image

matplotlib.use("Agg")
matplotlib.rcParams.update({"svg.hashsalt": "chasles", "svg.fonttype": "none", "font.size": 8, "axes.titlesize": 9})


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
