#!/usr/bin/env python3
"""Makes of the JSON files of a benchmark run one JSON file, tables in Markdown, and a figure of speed against error.

    report.py --out DIRECTORY [--missing PEER,PEER] O2.json O3_native.json
"""
import argparse
import datetime
import json
import pathlib
import platform

import bounds

REGIONS = ["tiny", "small", "ordinary", "near_pi", "beyond_pi"]
WITHIN_PI = ["tiny", "small", "ordinary", "near_pi"]
JUDGED = WITHIN_PI[1:]  # below 1e-150 squares underflow, which few have thought of: nobody is held to that
EPS = {"double": 2.0**-52, "float": 2.0**-23}
OWN = "chasles"
OWN_INLINED = "chasles inlined"  # part of the loop, as peers that are header files are
OWN_ARRAY = "chasles array"  # one call for all cases
MEMCPY = "memcpy"  # of the points that a pose moves
NOT_PEERS = (OWN_INLINED, OWN_ARRAY, MEMCPY)
CLOUDS = ["cloud_in_cache", "cloud_beyond_cache"]
FLAVOURS = {"O2": "-O2", "O3_native": "-O3 -march=native"}


class Results:
    """Times by (flavour, function, precision, library, angles, cases), errors by (function, precision, library)."""

    def __init__(self, runs):
        self.runs = runs
        self.times = {}
        self.errors = {}
        self.libraries = {}
        for run in runs:
            self.libraries.update(run["libraries"])
            for row in run["errors"]:
                # The same source in another flavour may err differently: the worse counts.
                kept = self.errors.setdefault(key_of(row), {})
                for region in REGIONS:
                    if region in row:
                        kept[region] = max(kept.get(region, 0.0), float(row[region]))
                if "remark" in row:
                    kept["remark"] = row["remark"]
            for row in run["times"]:
                self.times[(run["flavour"], *key_of(row), row["angles"], int(row["cases"]))] = row
        self.functions = list(dict.fromkeys(key[1] for key in self.times))

    def time(self, flavour, function, precision, library, angles="ordinary", cases=1024):
        return self.times.get((flavour, function, precision, library, angles, cases))

    def others(self, function, precision):
        return [name for name in self.libraries
                if name != OWN and self.time("O2", function, precision, name) is not None]

    def peers(self, function, precision):
        return [name for name in self.others(function, precision) if name not in NOT_PEERS]

    def has(self, function, precision):
        return self.time("O2", function, precision, OWN) is not None

    def worst(self, function, precision, library, regions=WITHIN_PI):
        errors = self.errors.get((function, precision, library), {})
        found = [errors[region] for region in regions if region in errors]
        return max(found) if found else None

    def is_accurate(self, function, precision, library):
        """Keeps two thirds of the format's digits in every band from 1e-150 (in float 1e-19) to pi."""
        worst = self.worst(function, precision, library, JUDGED)
        return worst is not None and worst * EPS[precision] <= EPS[precision] ** (2 / 3)

    def fastest(self, flavour, function, precision, accurate=False, cases=1024):
        """(ratio of its time to ours, its name) of the fastest peer, or None."""
        found = [(row["ratio"], name) for name in self.peers(function, precision)
                 if (row := self.time(flavour, function, precision, name, cases=cases)) is not None
                 and (not accurate or self.is_accurate(function, precision, name))]
        return min(found) if found else None


def key_of(row):
    return row["function"], row["precision"], row["library"]


def table(columns, rows):
    """Markdown; the first column is text, the others are numbers."""
    lines = ["| " + " | ".join(columns) + " |", "| --- |" + " ---: |" * (len(columns) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def shown_time(row):
    return "" if row is None else f"{row['ns']:.1f}" if row["ns"] < 1000 else f"{row['ns']:.0f}"


def shown_ratio(found):
    return "" if found is None else f"{found[0]:.2f} {found[1]}"


def shown_error(error):
    if error is None:
        return ""
    if error == float("inf"):
        return "NaN"
    return f"{error:.1f}" if error < 1000 else f"{error:.0e}"


def quotient(row, base):
    return "" if row is None else f"{row['ns'] / base['ns']:.2f}"


def overview(results, flavour):
    rows = []
    for function in results.functions:
        for precision in EPS:
            if not results.peers(function, precision):
                continue
            own = {angles: results.time(flavour, function, precision, OWN, angles)
                   for angles in ("ordinary", "mixed", "beyond")}
            rows.append([f"{function}{'f' if precision == 'float' else ''}", shown_time(own["ordinary"]),
                         quotient(own["mixed"], own["ordinary"]), quotient(own["beyond"], own["ordinary"]),
                         shown_ratio(results.fastest(flavour, function, precision)),
                         shown_ratio(results.fastest(flavour, function, precision, cases=8192)),
                         shown_ratio(results.fastest(flavour, function, precision, accurate=True)),
                         shown_error(results.worst(function, precision, OWN))])
    return table(["function", "ns", "mixed / ordinary", "beyond pi / ordinary", "fastest peer", "of 8192 cases",
                  "fastest accurate peer", "our error, eps"], rows)


def details(results, function, precision):
    rows = []
    for library in [OWN] + results.others(function, precision):
        row = [library]
        for flavour in FLAVOURS:
            for angles in ("ordinary", "mixed"):
                for cases in (1024, 8192):
                    row.append(shown_time(results.time(flavour, function, precision, library, angles, cases)))
            time = results.time(flavour, function, precision, library)
            row.append("" if time is None else f"{time['ratio']:.2f}")
        errors = results.errors.get((function, precision, library), {})
        row += [shown_error(errors.get(region)) for region in REGIONS]
        rows.append(row)
    titles = []
    for flavour in ("O2", "O3"):
        titles += [f"{flavour}, {angles}{count}" for angles in ("", "mixed ") for count in ("1024", "8192")] + ["ratio"]
    remarks = {results.errors.get((function, precision, name), {}).get("remark") for name in results.libraries}
    remarks = sorted(f"{name}: {results.errors[(function, precision, name)]['remark']}."
                     for name in results.others(function, precision)
                     if "remark" in results.errors.get((function, precision, name), {}))
    title = f"### {function}{'f' if precision == 'float' else ''}\n\n"
    return title + table(["library", *titles, "tiny", "small", "ordinary", "near pi", "beyond pi"], rows) + (
        "\n" + " ".join(remarks) + "\n" if remarks else "")


def alone(results):
    """Functions that no peer has."""
    rows = []
    for function in results.functions:
        if function in CLOUDS or results.peers(function, "double") or results.peers(function, "float"):
            continue
        row = [function]
        for precision in EPS:
            for flavour in FLAVOURS:
                row.append(shown_time(results.time(flavour, function, precision, OWN)))
            row.append(shown_error(results.worst(function, precision, OWN)))
        rows.append(row)
    return table(["function", "double, O2", "O3", "error", "float, O2", "O3", "error"], rows)


def arrays(results):
    """The array forms by the single ones, in a loop over the same cases."""
    rows = []
    for function in results.functions:
        row = [function]
        for precision in EPS:
            for flavour in FLAVOURS:
                own, array = (results.time(flavour, function, precision, name) for name in (OWN, OWN_ARRAY))
                row += ["", ""] if array is None else [shown_time(array), f"{own['ns'] / array['ns']:.2f}"]
        if any(row[1:]):
            rows.append(row)
    return table(["function", "double, O2", "times", "O3", "times", "float, O2", "times", "O3", "times"], rows)


def inlined(results):
    """The shortest functions called and inlined, and the fastest peer by the inlined one, in a loop over the same cases."""
    rows = []
    for function in results.functions:
        for precision in EPS:
            row = [f"{function}{'f' if precision == 'float' else ''}"]
            for flavour in FLAVOURS:
                own, copy = (results.time(flavour, function, precision, name) for name in (OWN, OWN_INLINED))
                if copy is not None:
                    peer = results.fastest(flavour, function, precision)
                    by_copy = peer and (peer[0] / copy["ratio"], peer[1])
                    row += [shown_time(own), shown_time(copy), shown_ratio(by_copy)]
            if row[1:]:
                rows.append(row)
    return table(["function", "O2, called", "inlined", "fastest peer", "O3, called", "inlined", "fastest peer"], rows)


def clouds(results):
    """What moving points takes by what copying them takes."""
    rows = []
    for function in CLOUDS:
        times = [results.time(flavour, function, precision, MEMCPY) for precision in EPS for flavour in FLAVOURS]
        rows.append([function] + ["" if row is None else f"{1 / row['ratio']:.2f}" for row in times])
    return table(["points", "double, O2", "O3", "float, O2", "O3"], rows)


def limits(results, static_bounds):
    if isinstance(static_bounds, str):
        return f"Not measured; {static_bounds}.\n"
    cycle = results.runs[0]["cycle_ns"]
    rows = []
    for row in static_bounds:
        cycles = results.time("O2", row["function"], row["precision"], OWN)["ns"] / cycle
        rows.append([f"{row['function']}{'f' if row['precision'] == 'float' else ''}", str(row["instructions"]),
                     f"{row['units']:.0f}", f"{row['simulated']:.0f}", f"{cycles:.0f}",
                     f"{cycles / row['units']:.2f}"])
    return f"""Cycles of the instructions that an ordinary call executes (-O2), by llvm-mca's model of {bounds.PROCESSOR}: what the
busiest unit needs however well the calls overlap, and what a simulation of dependencies gives. Measured: the time of
1024 ordinary cases in cycles of {cycle:.3f} ns, a dependent addition's time.

""" + table(["function", "instructions", "busiest unit", "simulated", "measured", "measured / busiest"], rows)


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def write_markdown(results, missing, static_bounds, path):
    libraries = ", ".join(f"{name} {version}" for name, version in results.libraries.items())
    text = f"""# Benchmark

Made by `cmake --workflow --preset bench` on {datetime.date.today()}; `tools/bench/peers.sh` installs the peers.

- Machine: {processor()}, {platform.system()}, {results.runs[0]['compiler']}
- Libraries: {libraries}
- Missing: {', '.join(missing) or 'none'}

Nanoseconds a call in a loop over random cases, medians over interleaved rounds. Ratios are a peer's time by ours in the
same round, so above 1 ours is the faster; they travel from one machine to another, times do not. chasles and the peers
that are compiled libraries are called, those that are header files become part of the loop. "Mixed" are half ordinary
angles, a quarter below 0.01 and a quarter within 0.01 of pi. Errors are the largest in each band of `tests/vectors`, in
eps, relative to what our headers name (off the diagonal of a rotation that is its angle, so that a peer's error of
1e-16 shows where the angle is small); matrices that are not rotations to within rounding are left out, and at a
half-turn either axis counts as right. "Tiny" angles are below 1e-150 (float: 1e-19), "small" ones below 1e-6, "near pi"
those within 0.14 of it. A peer is called accurate when it keeps two thirds of the format's digits in every band up to
pi but the tiny one.

![Speed against error](speed_error.svg)

## At a glance, -O2, 1024 cases

Processors learn which way a thousand cases make branches go, at least in part, but not 8192: those are nearer to what a
program meets that does something else in between.

{overview(results, 'O2')}
## At a glance, -O3 -march=native, 1024 cases

{overview(results, 'O3_native')}
## What a call costs, 1024 ordinary cases

Nanoseconds of the shortest functions: those of the library, which are called, and the same source as part of the loop,
as peers that are header files are. Then how many times as long as the latter the fastest peer takes. What the compiler
makes of a loop is not always quicker than the function that it calls. Columns O2 and O3 (with -march=native) as below.

{inlined(results)}
## What no peer has, 1024 ordinary cases

{alone(results)}
## Many at once, 1024 ordinary cases

Nanoseconds an element of the array forms, and how many times as fast as the single functions they are. Columns O2 and O3
(with -march=native) as below.

{arrays(results)}
A cloud of points moved by one pose: its time by that of memcpy of the same points. In cache are 1024 points, beyond it
2 million.

{clouds(results)}
## The limit

{limits(results, static_bounds)}
## Everything

Columns O2 and O3 (with -march=native): nanoseconds at 1024 and 8192 cases, ordinary and mixed, and the ratio at 1024
ordinary ones. Then errors in eps.

"""
    for function in results.functions:
        for precision in EPS:
            if results.peers(function, precision):
                text += details(results, function, precision) + "\n"
    path.write_text(text.rstrip("\n") + "\n")


PANELS = ["so3_exp", "so3_log", "se3_exp", "se3_log"]
MARKERS = "osD^vP*X<>"


def draw(results, directory):
    """One dot a library: time to the right, error upwards, both logarithmic."""
    try:
        import matplotlib
    except ImportError:
        print("report: no figure, for matplotlib is missing")
        return
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "chasles", "svg.fonttype": "none", "font.size": 9})
    from matplotlib import pyplot
    most = 1 / EPS["double"]  # not a digit is right
    least = 0.3
    styles = {name: (f"C{i}", MARKERS[i % len(MARKERS)])
              for i, name in enumerate(name for name in results.libraries if name not in (OWN, *NOT_PEERS))}
    figure, axes = pyplot.subplots(2, 2, figsize=(9, 6), sharex=True, sharey=True, layout="constrained")
    handles = {}
    for panel, function in zip(axes.flat, PANELS):
        for library in results.peers(function, "double") + [OWN]:
            time = results.time("O2", function, "double", library)["ns"]
            error = min(max(results.worst(function, "double", library, JUDGED), least), most)
            colour, marker = styles.get(library, ("black", "o"))
            handles[library] = panel.plot(time, error, marker, color=colour, markersize=10 if library == OWN else 7,
                                          linestyle="none", clip_on=False)[0]
        panel.set_title(function)
        panel.set_xscale("log")
        panel.set_yscale("log", base=2)
        panel.set_ylim(least / 2, most * 8)
        panel.set_yticks([1, 2**13, 2**26, 2**39, 2**52], ["1 eps", "$2^{13}$", "$2^{26}$", "$2^{39}$", "no digit"])
        panel.yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        panel.set_xticks([5, 10, 20, 50, 100, 200], ["5", "10", "20", "50", "100", "200"])
        panel.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
        panel.set_xlim(5, 200)
        panel.grid(alpha=0.3)
    figure.supxlabel("nanoseconds a call (double, -O2, random cases)")
    figure.supylabel("largest error, angles from 1e-150 to pi")
    names = [OWN] + [name for name in results.libraries if name in handles and name != OWN]
    figure.legend([handles[name] for name in names], names, loc="outside right center", frameon=False)
    figure.savefig(directory / "speed_error.svg", metadata={"Date": None})
    figure.savefig(directory / "speed_error.png", dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, required=True, help="where results.json, .md and the figure go")
    parser.add_argument("--missing", default="", help="peers that were not found, parted by commas")
    parser.add_argument("runs", nargs="+", type=pathlib.Path)
    options = parser.parse_args()
    missing = [name for name in options.missing.split(",") if name]
    runs = [json.loads(path.read_text()) for path in options.runs]
    results = Results(runs)
    static_bounds = bounds.measure()
    (options.out / "results.json").write_text(
        json.dumps({"machine": processor(), "missing": missing, "bounds": static_bounds, "runs": runs}, indent=1))
    draw(results, options.out)
    write_markdown(results, missing, static_bounds, options.out / "results.md")
    print(overview(results, "O2"))
    for name in missing:
        print(f"missing: {name}")
    print(f"written: {options.out}/results.json, results.md, speed_error.svg, speed_error.png")


if __name__ == "__main__":
    main()
