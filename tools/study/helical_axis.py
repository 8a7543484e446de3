"""Draws the finite helical axis of a joint over its cycle, from what chasles solve writes, as SVG and PNG.

    chasles solve --markers ForearmR1,ForearmR2,ForearmR3 --relative-to ArmR1,ArmR2,ArmR3 --out elbow.csv trial.csv
    python3 helical_axis.py elbow.csv [--least-angle DEG] [--title TEXT] [--out DIR]

Each frame has an axis, about which the joint has turned since the reference frame. Four panels: by what angle; where the
axis points, as angles from the mean axis; how far it passes from the pivot, the point that is nearest to all axes; and
the axes themselves near the pivot, drawn in the plane of the two coordinates in which they show best. Every cycle counts
as 100 %. Small angles leave the axis uncertain (its error grows like the marker's error over the angle):
below --least-angle no axis is drawn. Gaps stay gaps.
"""

import argparse
import sys

import matplotlib.pyplot as plt
import numpy as np
from figures import read_number, read_rows, save

HALF_LENGTH = 1.3  # of an axis as drawn, over the largest distance from the pivot


def read(path):
    """Time, angle in radians, axis, a point of it, and the unit of length; a frame without a screw is not a number."""
    rows = read_rows(path)
    titles = list(rows[0])
    title = lambda start: next((t for t in titles if t.startswith(start)), start)
    column = lambda start: np.array([read_number(path, row[title(start)]) for row in rows])
    vector = lambda name: np.column_stack([column(name + axis) for axis in ("_x", "_y", "_z")])
    time = column(next((t for t in titles[1:] if t != "from"), "time"))
    angle = np.radians(column("angle_deg")) if "angle_deg" in titles else column("angle_rad")
    unit = title("point_x").replace("point_x", "").strip("_")
    return time, angle, vector("axis"), vector("point"), unit


def phase_of(time, angle):
    """Percent of the cycle, which begins when the angle, having been in its lowest third, rises through the middle of its
    range; and the mean period. Not a number before the first cycle and after the last."""
    low, high = np.nanpercentile(angle, [5, 95])
    starts, armed = [], False
    for k in range(1, len(angle)):
        armed = armed or angle[k] < low + (high - low) / 3
        middle = (low + high) / 2
        if armed and angle[k - 1] < middle <= angle[k]:
            share = (middle - angle[k - 1]) / (angle[k] - angle[k - 1])
            starts.append(time[k - 1] + share * (time[k] - time[k - 1]))
            armed = False
    if len(starts) < 2:
        sys.exit("the file holds no whole cycle of the angle")
    cycles = np.interp(time, starts, np.arange(len(starts)), left=np.nan, right=np.nan)
    return 100 * (cycles % 1), (starts[-1] - starts[0]) / (len(starts) - 1), len(starts) - 1


def pivot_of(axes, points):
    """The point with the least sum of squared distances from the axes."""
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    return np.linalg.solve(across.sum(0), np.einsum("nij,nj->i", across, points))


def near(pivot, axes, points):
    """The point of each axis that is nearest to the pivot."""
    return points + axes * np.sum((pivot - points) * axes, axis=1)[:, None]


def draw(time, angle, axes, points, unit, least, title):
    phase, period, cycles = phase_of(time, angle)
    seen = (angle >= least) & np.isfinite(phase)
    axes, points = axes[seen], points[seen]
    if len(axes) < 2:
        sys.exit("at most one axis has an angle of --least-angle or more")
    mean = axes.sum(0) / np.linalg.norm(axes.sum(0))
    pivot = pivot_of(axes, points)
    feet = near(pivot, axes, points)
    scale, shown = (1000, "mm") if unit == "m" else (1, unit or "unit of the file")

    figure, panels = plt.subplots(2, 2, figsize=(8, 6))
    dots = dict(s=5, c=phase[seen], cmap="turbo", vmin=0, vmax=100, linewidths=0, rasterized=True)
    panel = panels[0, 0]
    panel.scatter(phase, np.degrees(angle), **dict(dots, c=phase))
    panel.axhline(np.degrees(least), color="0.6", linewidth=0.8, linestyle="--")
    panel.text(1, np.degrees(least), "no axis drawn below", ha="left", va="bottom", color="0.4", fontsize=7)
    panel.set_ylim(0)
    panel.set_ylabel("angle from the reference frame [°]")

    panel = panels[0, 1]
    plane = [i for i in range(3) if i != np.argmax(np.abs(mean))]
    for i, mark in zip(plane, "ox"):
        lean = np.degrees(np.arcsin(axes[:, i]) - np.arcsin(mean[i]))
        options = dict(dots, marker=mark, s=5 if mark == "o" else 9, linewidths=0 if mark == "o" else 0.7)
        panel.scatter(phase[seen], lean, **options)
        panel.scatter([], [], marker=mark, color="0.3", s=14, label="towards %s" % "xyz"[i])
    panel.axhline(0, color="0.6", linewidth=0.8)
    panel.legend(frameon=False, loc="best", title="mean axis (%.2f, %.2f, %.2f)" % tuple(mean))
    panel.set_ylabel("lean from the mean axis [°]")

    panel = panels[1, 0]
    panel.scatter(phase[seen], scale * np.linalg.norm(feet - pivot, axis=1), **dots)
    panel.set_ylim(0)
    panel.set_ylabel("distance of the axis from the pivot [%s]" % shown)

    panel = panels[1, 1]
    half = HALF_LENGTH * np.max(np.linalg.norm(feet - pivot, axis=1))
    colors = plt.get_cmap("turbo")(phase[seen] / 100)
    spread = axes.std(axis=0) + 1e-9
    flat = sorted([np.argmax(np.abs(mean)), max(plane, key=lambda i: spread[i])])
    for k in range(len(axes)):
        ends = scale * (feet[k] - pivot + half * np.outer((-1, 1), axes[k]))
        panel.plot(ends[:, flat[0]], ends[:, flat[1]], color=colors[k], linewidth=0.5, rasterized=True)
    panel.plot(0, 0, "+", color="black", markersize=8)
    panel.set_aspect("equal", adjustable="datalim")
    panel.set_xlabel("%s from the pivot [%s]" % ("xyz"[flat[0]], shown))
    panel.set_ylabel("%s from the pivot [%s]" % ("xyz"[flat[1]], shown))
    for panel in panels.flat[:3]:
        panel.set_xlim(0, 100)
        panel.set_xlabel("cycle [%]")
    where = ", ".join("%.3g" % x for x in pivot)
    figure.suptitle("%s\n%d cycles of %.2f s, %d axes, pivot at (%s) %s" % (title, cycles, period, len(axes), where, unit), fontsize=9)
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description="Draw the helical axis that chasles solve has written.")
    parser.add_argument("screws", help="CSV of chasles solve --out")
    parser.add_argument("--least-angle", type=float, default=25, metavar="DEG", help="smallest angle whose axis is drawn")
    parser.add_argument("--title", default="Finite helical axis", metavar="TEXT")
    parser.add_argument("--out", default=".", metavar="DIR", help="directory of the figure")
    arguments = parser.parse_args()
    figure = draw(*read(arguments.screws), np.radians(arguments.least_angle), arguments.title)
    save(figure, arguments.out, "helical_axis")


if __name__ == "__main__":
    main()
