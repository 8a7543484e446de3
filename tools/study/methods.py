"""Draws the figures of the comparison of methods from the files that `chasles study --out DIR` writes.

    python3 tools/study/methods.py DIR [--out DIR]

Figures 4 to 7 of Fenton & Shi 1990 (a_1 to a_4 against the error of the data, for the paper's uniform scaling and for
independent noise), and the error of each method against the angle, which the paper does not have.
"""

import argparse
import pathlib

import matplotlib.pyplot as plt
from figures import read_rows, save

STYLES = {
    "angeles": ("Angeles", "tab:purple", "v"),
    "laub-shiflett": ("Laub & Shiflett", "tab:blue", "s"),
    "spoor-veldpaus": ("Spoor & Veldpaus", "tab:green", "o"),
    "bottema-roth": ("Bottema & Roth", "tab:red", "^"),
    "beggs": ("Beggs", "tab:orange", "D"),
}
KINDS = {"scaling": "uniform scaling, as in the paper", "noise": "independent noise in each coordinate"}
MERITS = [
    (4, "a_1", "$a_1$: translation $u$ (unit of length)"),
    (5, "a_2", r"$a_2$: angle $\theta$ (rad)"),
    (6, "a_3", "$a_3$: point A of the axis (unit of length)"),
    (7, "a_4", "$a_4$: final points (unit of length)"),
]


def series(rows, x, y, **wanted):
    """The columns x and y of the rows that have the wanted values, a method at a time."""
    for method, style in STYLES.items():
        chosen = [r for r in rows if r["method"] == method and all(r[k] == v for k, v in wanted.items())]
        if chosen:
            yield style, [float(r[x]) for r in chosen], [float(r[y]) for r in chosen]


def draw(axes, rows, x, y, **wanted):
    axes.set_xscale("log")
    for (label, colour, marker), xs, ys in series(rows, x, y, **wanted):
        axes.plot(xs, ys, label=label, color=colour, marker=marker, markersize=4, linewidth=1, fillstyle="none")
    axes.grid(alpha=0.3)
    axes.minorticks_off()


def sensitivity(rows, out):
    for number, merit, label in MERITS:
        figure, both = plt.subplots(1, 2, figsize=(8, 3.2), sharey=True)
        for axes, (kind, title) in zip(both, KINDS.items()):
            draw(axes, rows, "level_percent", merit, kind=kind, precision="double")
            axes.set_yscale("log")
            axes.minorticks_off()
            axes.set_title(title, fontsize=9)
            axes.set_xlabel("error of the data (percent)")
        both[0].set_ylabel(label)
        both[1].legend(fontsize=8)
        figure.tight_layout()
        save(figure, out, f"figure_{number}_{merit}")
        plt.close(figure)


def angles(rows, out):
    figure, grid = plt.subplots(2, 2, figsize=(8, 5.6), sharey="row")
    for line, (column, label) in zip(
        grid, (("rotation_median_eps", "error of the rotation (eps)"), ("axis_median_eps", "error of the axis (eps)"))
    ):
        for axes, (start, title) in zip(line, (("zero", r"$\theta$ (rad)"), ("half_turn", r"$\pi - \theta$ (rad)"))):
            draw(axes, rows, "offset_rad", column, precision="double", **{"from": start})
            axes.set_xlabel(title)
        line[0].set_ylabel(label)
    grid[0][0].set_ylim(bottom=0)
    grid[1][0].set_yscale("log")
    for axes in grid[1]:
        axes.minorticks_off()
    grid[0][1].legend(fontsize=8)
    figure.tight_layout()
    save(figure, out, "error_against_angle")
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description="draw the figures of the comparison of methods")
    parser.add_argument("directory", type=pathlib.Path, help="what `chasles study --out` wrote")
    parser.add_argument("--out", type=pathlib.Path, help="where to put the figures (default: the same directory)")
    arguments = parser.parse_args()
    out = arguments.out or arguments.directory
    sensitivity(read_rows(arguments.directory / "sensitivity.csv"), out)
    angles(read_rows(arguments.directory / "angles.csv"), out)


if __name__ == "__main__":
    main()
