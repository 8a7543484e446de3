"""chain.h: products of exponentials of six joints."""

from mpmath import mpf, pi

import chains
import exact
import sampling
from exact import norm, times
from sampling import direction, magnitude, point, sign, uniform
from vectors import Band, Errors, Function, Group, Listed, Result

JOINTS = 6
INPUTS = 6 * JOINTS + 16 + 1 + JOINTS  # screws, home, form, joint values
HOME, FORM, VALUES = 6 * JOINTS, 6 * JOINTS + 16, 6 * JOINTS + 17


def parts(x):
    """(screws, home, body, q) of a flat input."""
    screws = [x[6 * i : 6 * i + 6] for i in range(JOINTS)]
    return screws, exact.pose(x[HOME : HOME + 16]), x[FORM] == 1, x[VALUES:]


# Inputs


def line_screw(axis, place, pitch):
    return axis + exact.add(exact.cross(place, axis), times(pitch, axis))


def joint(fmt, rng, length, kind):
    """A screw axis: about an axis of the frame (half of them), any axis, a helix, a slide, one with a gear ratio."""
    axes = direction(rng, 1 if kind < 5 else None)
    place = sampling.vector(rng, length())
    if kind in (0, 1, 2, 3, 5, 6, 7):
        return fmt.round_all(line_screw(axes, place, mpf(0)))
    if kind in (4, 8):
        return fmt.round_all(line_screw(axes, place, sign(rng) * length()))
    if kind == 9:
        return fmt.round_all([mpf(0)] * 3 + direction(rng))
    ratio = magnitude(rng, 0.1, 10)
    return fmt.round_all(times(ratio, line_screw(axes, place, mpf(0))))


def chain(fmt, rng, band, k, odd=True):
    length = lambda: sampling.length(fmt, rng, band)
    screws = [joint(fmt, rng, length, rng.getrandbits(20) % (11 if odd else 10)) for _ in range(JOINTS)]
    home = sampling.pose_of(fmt, rng, sampling.random_rotation(fmt, rng), point(fmt, rng, band), k)
    return sum(screws, []) + home + [mpf(rng.getrandbits(1))]


def bands_of(counts):
    """Bands of lengths with ordinary angles, bands of angles with ordinary lengths."""

    def bands(fmt, rng):
        def of_lengths(band):
            def inputs(fmt, rng, k):
                return chain(fmt, rng, band, k) + fmt.round_all([uniform(rng, -pi, pi) for _ in range(JOINTS)])

            return inputs

        def of_angles(band):
            def inputs(fmt, rng, k):
                angles = [sign(rng) * sampling.ANGLES[band](fmt, rng) for _ in range(JOINTS)]
                return chain(fmt, rng, "ordinary", k, odd=band != "far") + fmt.round_all(angles)

            return inputs

        listed = [Band(name, count, of_lengths(name)) for name, count in counts.items() if name in sampling.LENGTHS]
        listed += [
            Band(name, count, of_angles(name), "angles_" + name) for name, count in counts.items() if name in sampling.ANGLES
        ]
        base = [mpf(x) for x in UR5_SCREWS + UR5_HOME + (0,)]
        base = fmt.round_all(base)
        values = fmt.round_all([mpf(x) / 10 for x in (3, -7, 11, 5, -9, 2)])
        listed.append(Listed("example", [base + [mpf(0)] * JOINTS, base + values], "ur5"))
        read = [0, 3, 8, 10, 14, 19, 30, 35, HOME, HOME + 3, HOME + 6, HOME + 11, VALUES, VALUES + 3, VALUES + 5]
        listed += sampling.spoilt(base + values, read)
        far = [list(base + values) for _ in range(2)]
        far[0][VALUES + 2] = fmt.round(5 * sampling.angle_max(fmt))
        far[1][VALUES + 5] = -fmt.round(1000 * sampling.angle_max(fmt))
        listed.append(Errors(-4, far, "angle_range"))
        huge = list(base + values)
        huge[3] = huge[9] = huge[15] = fmt.round(mpf(2) ** (fmt.greatest - 1))
        for i in range(3):
            huge[VALUES + i] = fmt.round(pi)
        return listed + [Errors(-3, [huge], "overflow")]

    return bands


# Lynch & Park, Modern Robotics, example 4.5: UR5.
UR5_SCREWS = (
    (0, 0, 1, 0, 0, 0)
    + (0, 1, 0, "-0.089", 0, 0)
    + (0, 1, 0, "-0.089", 0, "0.425")
    + (0, 1, 0, "-0.089", 0, "0.817")
    + (0, 0, -1, "-0.109", "0.817", 0)
    + (0, 1, 0, "0.006", 0, "0.817")
)
UR5_HOME = (-1, 0, 0, "0.817", 0, 0, 1, "0.191", 0, 1, 0, "-0.006", 0, 0, 0, 1)

FEW = {"ordinary": 16, "large": 8, "small": 8, "mixed": 8, "tiny": 8, "moderate": 8, "near_pi": 8, "beyond_pi": 8, "far": 8}
COUNTS = {**{name: 2 * count for name, count in FEW.items()}, "at_pi": 16}


# The functions


def pose_groups(first, translation="norm", count=1):
    """The groups of `count` poses that start at the output `first`."""
    places = lambda indices: [first + 16 * k + i for k in range(count) for i in indices]
    return [
        Group("rotation", "max", places((0, 1, 2, 4, 5, 6, 8, 9, 10))),
        Group("translation", translation, places((3, 7, 11))),
        Group("last_row", "max", places((12, 13, 14, 15))),
    ]


def scales(fmt, screws, home, q):
    times_joints = chains.count(fmt, screws, q)
    return [times_joints, times_joints * chains.reach(fmt, screws, home, q), mpf(0)]


def evaluate_fk(fmt, x):
    screws, home, body, q = parts(x)
    return Result(exact.pose_matrix(*chains.forward(fmt, screws, home, body, q)), scales(fmt, screws, home, q))


def evaluate_links(fmt, x):
    screws, home, body, q = parts(x)
    rotation, translation, zero = scales(fmt, screws, home, q)
    further = rotation * norm(home[1]) if body else 0
    outputs = [entry for link in chains.links(fmt, screws, home, body, q) for entry in exact.pose_matrix(*link)]
    return Result(outputs, [rotation, translation + further, zero])


def evaluate_jacobian(columns):
    def evaluate(fmt, x):
        screws, home, body, q = parts(x)
        rotation, translation, zero = scales(fmt, screws, home, q)
        # The columns of a joint with a gear ratio are |omega| times as large.
        gear = max([mpf(1)] + [norm(S[0:3]) for S in screws])
        J = chains.matrix_of(columns(fmt, screws, home, body, q))
        T = exact.pose_matrix(*chains.forward(fmt, screws, home, body, q))
        return Result(J + T, [rotation * gear, translation * gear, rotation, translation, zero])

    return evaluate


JACOBIAN = [
    Group("angular", "max", range(0, 3 * JOINTS)),
    Group("linear", "max", range(3 * JOINTS, 6 * JOINTS)),
] + pose_groups(6 * JOINTS)

FUNCTIONS = [
    Function("chain_fk", INPUTS, pose_groups(0), evaluate_fk, bands_of(COUNTS)),
    Function("chain_links", INPUTS, pose_groups(0, "max", JOINTS), evaluate_links, bands_of(FEW)),
    Function("chain_space_jacobian", INPUTS, JACOBIAN, evaluate_jacobian(chains.space_columns), bands_of(FEW)),
    Function("chain_body_jacobian", INPUTS, JACOBIAN, evaluate_jacobian(chains.body_columns), bands_of(FEW)),
]
