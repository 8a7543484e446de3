"""Draws the map of an arm's errors over two of its joints as SVG and PNG.

    chasles arm-error ../robots/ur5e.robot --over 3,5 --step 2 --out arm.csv -- 0 -90 90 -90 -90 0
    python3 arm_error.py arm.csv [--out DIR]
"""

import argparse

import matplotlib.pyplot as plt
import numpy as np
from agile_eye import read
from figures import save

TITLES = {"alpha_deg": r"max $\alpha$ [°]", "beta_deg": r"max $\beta$ [°]"}


def draw(errors):
    """One panel a measure; the first two columns are the joints."""
    names = list(errors)
    first, second = (np.unique(errors[name]) for name in names[:2])
    figure, panels = plt.subplots(1, 3, figsize=(9, 3.1), sharey=True)
    for axes, name in zip(panels, names[2:5]):
        values = errors[name].reshape(len(first), len(second))
        filled = axes.contourf(second, first, values, 16, cmap="viridis")
        filled.set_rasterized(True)
        figure.colorbar(filled, ax=axes, format="%.3g")
        axes.set_title(TITLES.get(name, "max position error [%s]" % name.replace("position_", "")))
        axes.set_xlabel("joint %s [°]" % names[1].strip("q").replace("_deg", ""))
        axes.set_xticks(range(-180, 181, 90))
        axes.set_yticks(range(-180, 181, 90))
    panels[0].set_ylabel("joint %s [°]" % names[0].strip("q").replace("_deg", ""))
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description="Draw the map that chasles arm-error --over has written.")
    parser.add_argument("errors", help="CSV of --out")
    parser.add_argument("--out", default=".", metavar="DIR", help="directory of the figure")
    arguments = parser.parse_args()
    save(draw(read(arguments.errors)), arguments.out, "arm_errors")


if __name__ == "__main__":
    main()
