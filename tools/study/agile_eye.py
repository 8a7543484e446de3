"""Draws the errors of the Agile Eye and its singular curves, figures 3 and 2b of Briot & Bonev (2008), as SVG and PNG.

    chasles agile-eye --out errors.csv && chasles agile-eye --curves curves.csv
    python3 agile_eye.py errors.csv curves.csv [--out DIR]

A torsion sigma is a disc: phi goes round it, theta outwards. Singular orientations are crosses where a curve passes
through the disc, and dotted where it lies in it.
"""

import argparse

import matplotlib.pyplot as plt
import numpy as np
from figures import Named, read_number, read_rows, save
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D

LEVELS = {"alpha": np.geomspace(0.01, 0.16, 17), "beta": np.geomspace(0.01, 0.16, 17)}
TICKS = [0.01, 0.02, 0.04, 0.08, 0.16]
PANELS = 4  # in a row


def read(path):
    """The columns of a CSV file by name."""
    rows = read_rows(path)
    names = [name for name in rows[0] if name != "inside"]
    return Named(path, {name: np.array([read_number(path, row[name]) for row in rows]) for name in names})


def disc(errors, sigma, name):
    """(phi, theta, values) on a grid, phi closed."""
    here = errors["sigma_deg"] == sigma
    phi, theta = (np.unique(errors[column][here]) for column in ("phi_deg", "theta_deg"))
    values = errors[name][here].reshape(len(theta), len(phi))
    return np.radians(np.append(phi, 360)), theta, np.column_stack([values, values[:, :1]])


def each_curve(curves):
    for leg in (1, 2, 3):
        for sign in (1, -1):
            here = (curves["leg"] == leg) & (curves["sign"] == sign)
            yield [curves[column][here] for column in ("phi_deg", "theta_deg", "sigma_deg")]


def broken(values, *angles):
    """The values of a line with a gap wherever one of the angles jumps."""
    jumps = np.any([np.abs(np.diff(angle)) > 90 for angle in angles], axis=0)
    return np.where(np.append(False, jumps), np.nan, values)


def cross(axes, phi, theta):
    axes.plot(np.radians(phi), theta, "kx", markersize=5, markeredgewidth=1.3, clip_on=False)


def draw_singular(axes, curves, sigma, limit):
    for phi, theta, torsion in each_curve(curves):
        # At a tilt of 180 degrees only 2 phi - sigma has a meaning, and the torsion in the file is 0.
        for k in np.nonzero(np.abs(theta - 180) < 1e-6)[0]:
            if limit == 180:
                cross(axes, phi[k] + sigma / 2 + np.array([0, 180]), [180, 180])
        away = (torsion - sigma + 180) % 360 - 180
        if np.median(np.abs(away)) < 1e-6:
            axes.plot(np.radians(phi), broken(theta, phi), "k:", linewidth=1.2)
            continue
        for k in np.nonzero((away[:-1] * away[1:] <= 0) & (np.abs(away[:-1] - away[1:]) < 90))[0]:
            part = away[k] / (away[k] - away[k + 1])
            turn = (phi[k + 1] - phi[k] + 180) % 360 - 180
            tilt = theta[k] + part * (theta[k + 1] - theta[k])
            if tilt <= limit:
                cross(axes, phi[k] + part * turn, tilt)


def draw_disc(axes, errors, curves, sigma, name):
    phi, theta, values = disc(errors, sigma, name + "_deg")
    levels = LEVELS[name]
    filled = axes.contourf(
        phi, theta, np.nan_to_num(values, nan=1), levels, norm=LogNorm(levels[0], levels[-1]), cmap="viridis",
        extend="both",
    )
    filled.set_rasterized(True)
    draw_singular(axes, curves, sigma, theta[-1])
    axes.set_title(r"$\sigma = %g\degree$" % sigma, pad=4)
    axes.set_rlim(0, theta[-1])
    axes.set_rgrids([theta[-1] / 2], [r"$\theta = %g°$" % (theta[-1] / 2)])
    axes.set_thetagrids(range(0, 360, 90), ["0°", "90°", "", ""])
    axes.tick_params(pad=1, labelsize=6)
    axes.grid(linewidth=0.3, color="0.4")
    return filled


def draw_errors(errors, curves):
    sigmas = np.unique(errors["sigma_deg"])
    rows = -(-(len(sigmas) + 1) // PANELS)
    figure = plt.figure(figsize=(2.25 * PANELS, 2.45 * 2 * rows))
    for block, name in enumerate(("alpha", "beta")):
        for k, sigma in enumerate(sigmas):
            axes = figure.add_subplot(2 * rows, PANELS, block * rows * PANELS + k + 1, projection="polar")
            filled = draw_disc(axes, errors, curves, sigma, name)
        axes = figure.add_subplot(2 * rows, PANELS, (block + 1) * rows * PANELS)
        axes.axis("off")
        bar = figure.colorbar(filled, ax=axes, location="left", fraction=0.5, aspect=9, ticks=TICKS, pad=0.1)
        bar.ax.set_yticklabels(["%g°" % tick for tick in TICKS])
        bar.ax.minorticks_off()
        bar.set_label(r"max $\%s$" % name, fontsize=10)
    crosses = Line2D([], [], color="k", marker="x", linestyle="", label="singular")
    dots = Line2D([], [], color="k", linestyle=":", label="curve")
    figure.tight_layout(h_pad=0.6, w_pad=0.2)
    figure.legend(handles=[crosses, dots], loc="center right", frameon=False, bbox_to_anchor=(0.98, 0.62))
    return figure


def draw_curves(curves):
    """The six curves in cylinder coordinates: phi around, theta outwards, sigma upwards."""
    figure = plt.figure(figsize=(6, 5.4))
    axes = figure.add_subplot(projection="3d")
    for k, (phi, theta, sigma) in enumerate(each_curve(curves)):
        # Where the tilt passes through 180 degrees the curve goes on at the other side, its torsion in the file is 0.
        sigma = np.where(np.abs(theta - 180) < 1e-6, np.nan, sigma)
        x, y = broken(theta * np.cos(np.radians(phi)), phi, sigma), theta * np.sin(np.radians(phi))
        label = r"$\mathbf{v}_%d = %s\mathbf{u}_%d$" % (k // 2 + 1, "-" if k % 2 == 0 else "", k // 2 + 1)
        axes.plot(x, y, sigma, color="C%d" % (k // 2), linestyle="-" if k % 2 == 0 else "--", label=label)
    axes.set_xlabel(r"$\theta \cos\varphi$ [°]")
    axes.set_ylabel(r"$\theta \sin\varphi$ [°]")
    axes.set_zlabel(r"$\sigma$ [°]")
    axes.set_zticks(range(-180, 181, 60))
    axes.legend(loc="upper left", fontsize=8)
    axes.view_init(elev=22, azim=-60)
    figure.tight_layout()
    return figure


def main():
    parser = argparse.ArgumentParser(description="Draw what chasles agile-eye has written.")
    parser.add_argument("errors", help="CSV of --out")
    parser.add_argument("curves", help="CSV of --curves")
    parser.add_argument("--out", default=".", metavar="DIR", help="directory of the figures")
    arguments = parser.parse_args()
    curves = read(arguments.curves)
    save(draw_errors(read(arguments.errors), curves), arguments.out, "agile_eye_errors")
    save(draw_curves(curves), arguments.out, "agile_eye_singularities")


if __name__ == "__main__":
    main()
