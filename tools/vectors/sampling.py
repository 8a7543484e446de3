"""Seeded inputs: magnitudes, directions, angles, rotations, poses, and spoilt inputs for the error statuses.

Only random() and getrandbits() of the generator are used, whose sequence Python promises for a seed, and every number
is made from them in mpmath: the C library's transcendental functions differ from machine to machine.
"""

import os
import re

from mpmath import mpf, pi

import exact
from vectors import Errors, Unclear

SO3_HEADER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "include", "chasles", "so3.h")


def header_constant(name):
    """The value of a macro of so3.h, so that no limit of the library stands in two places."""
    with open(SO3_HEADER, encoding="utf-8") as header:
        found = re.search(r"#define\s+%s\s+([0-9.eE+-]+)F?\b" % name, header.read())
    return mpf(found.group(1))


SO3_FAR = header_constant("CHS_SO3_FAR")


def angle_max(fmt):
    return header_constant(fmt.pick("CHS_ANGLE_MAX", "CHS_ANGLE_MAXF"))


# Numbers


def uniform(rng, low, high):
    return low + (high - low) * mpf(rng.random())


def magnitude(rng, low, high):
    """Log-uniform between two positive numbers."""
    low, high = mpf(low), mpf(high)
    return low * (high / low) ** mpf(rng.random())


def pick(rng, items):
    return items[rng.getrandbits(30) % len(items)]


def sign(rng):
    return 1 - 2 * rng.getrandbits(1)


def gaussian_like(rng):
    """Symmetric and bell-shaped, without a transcendental function."""
    return sum((mpf(rng.random()) for _ in range(4)), mpf(-2))


def noise(rng, count, size):
    """Independent numbers up to `size` in magnitude."""
    return [size * uniform(rng, -1, 1) for _ in range(count)]


# Directions


def direction(rng, k=None):
    """A unit vector. The kinds, chosen by k, include the axes and their neighbourhoods."""
    kind = rng.getrandbits(10) % 10 if k is None else k % 10
    v = [gaussian_like(rng) for _ in range(3)]
    i = rng.getrandbits(10) % 3
    if kind == 1:  # along a coordinate axis, either way
        v = [mpf(sign(rng)) if j == i else mpf(0) for j in range(3)]
    elif kind == 2:  # in a coordinate plane
        v[i] = mpf(0)
    elif kind == 3:  # nearly along a coordinate axis
        v = [mpf(sign(rng)) if j == i else magnitude(rng, 1e-18, 1e-2) * sign(rng) for j in range(3)]
    elif kind == 4:  # two components equal in size
        v[i] = sign(rng) * v[(i + 1) % 3]
    elif kind == 5:  # all components negative
        v = [-abs(x) for x in v]
    elif kind == 6:  # nearly in a coordinate plane
        v[i] = magnitude(rng, 1e-18, 1e-2) * sign(rng)
    elif kind == 7:  # an axis with rational components whose half-turn matrix is not exactly representable
        v = [mpf(sign(rng) * c) for c in pick(rng, [(1, 2, 2), (2, 1, 2), (2, 3, 6), (1, 1, 1), (6, 2, 3), (1, 4, 8)])]
    return exact.unit(v)


def vector(rng, length, k=None):
    return exact.times(length, direction(rng, k))


# Angles


def tiny_angle(fmt, rng):
    return magnitude(rng, *fmt.pick(("1e-300", "1e-150"), ("1e-37", "1e-19")))


def small_angle(fmt, rng):
    if rng.getrandbits(1):
        return magnitude(rng, fmt.pick("1e-150", "1e-19"), 1e-6)
    return magnitude(rng, fmt.pick("1e-17", "1e-9"), 1e-6)


def moderate_angle(fmt, rng):
    return magnitude(rng, 1e-6, 0.1)


def ordinary_angle(fmt, rng):
    """0.1 to 3, a quarter of them at or within a few eps of pi/2 and 2 pi/3."""
    if rng.getrandbits(2) == 0:
        return pick(rng, [pi / 2, 2 * pi / 3]) * (1 + fmt.eps * (rng.getrandbits(3) - 4))
    return uniform(rng, 0.1, 3)


def near_pi_angle(fmt, rng):
    return pi - magnitude(rng, fmt.pick(1e-15, 1e-6), 0.14)


def at_pi_angle(fmt, rng):
    return pi * (1 + fmt.eps * (rng.getrandbits(3) - 4) / 2)


def beyond_pi_angle(fmt, rng):
    """pi to 1000, a quarter of them within a few eps of a multiple of pi/2."""
    if rng.getrandbits(2) == 0:
        return pi / 2 * (3 + rng.getrandbits(4)) * (1 + fmt.eps * (rng.getrandbits(3) - 4) / 2)
    return magnitude(rng, 3.2, 1000)


def far_angle(fmt, rng):
    return magnitude(rng, 1000, fmt.pick(1e12, 1e5))


ANGLES = {
    "tiny": tiny_angle,
    "small": small_angle,
    "moderate": moderate_angle,
    "ordinary": ordinary_angle,
    "near_pi": near_pi_angle,
    "at_pi": at_pi_angle,
    "beyond_pi": beyond_pi_angle,
    "far": far_angle,
}


def rotation_vector(fmt, rng, k, band):
    return fmt.round_all(vector(rng, ANGLES[band](fmt, rng), k))


# Lengths


LENGTHS = {
    "ordinary": (("1e-2", "1e2"), ("1e-2", "1e2")),
    "large": (("1e50", "1e100"), ("1e6", "1e12")),
    "small": (("1e-100", "1e-50"), ("1e-12", "1e-6")),
    "mixed": (("1e-100", "1e100"), ("1e-12", "1e12")),
}


def length(fmt, rng, band="mixed"):
    return magnitude(rng, *fmt.pick(*LENGTHS[band]))


def point(fmt, rng, band="mixed", k=None):
    return fmt.round_all(vector(rng, length(fmt, rng, band), k))


def independent_sizes(fmt, rng, count):
    """Numbers of independent magnitudes and signs."""
    return [fmt.round(sign(rng) * length(fmt, rng)) for _ in range(count)]


# Rotation matrices


def random_rotation(fmt, rng):
    """A rounded rotation by any angle; now and then one of the 24 that turn the axes into one another."""
    if rng.getrandbits(3) == 0:
        return axes_rotation(rng)
    return fmt.round_all(exact.exp(vector(rng, uniform(rng, 0, 3.2))))


def axes_rotation(rng):
    """An exact rotation: a signed permutation matrix with determinant 1."""
    R = list(exact.IDENTITY)
    for _ in range(2 + rng.getrandbits(1)):
        i = rng.getrandbits(10) % 3
        j = (i + 1) % 3
        quarter = [mpf(r == c) for r in range(3) for c in range(3)]
        quarter[4 * i] = quarter[4 * j] = mpf(0)
        quarter[3 * i + j], quarter[3 * j + i] = mpf(-1), mpf(1)
        R = exact.multiply(R, quarter)
    return R


def drift(fmt, rng, R, full):
    """R with a deviation of up to 0.005, as integration or measured data leave it.

    With `full` not set only the columns are stretched, and zeros and tiny entries stay what they are.
    """
    while True:
        size = magnitude(rng, fmt.pick(1e-15, 1e-6), 0.0012)
        stretch = noise(rng, 9, size)
        if not full:
            stretch = [x if i % 4 == 0 else mpf(0) for i, x in enumerate(stretch)]
        drifted = fmt.round_all(exact.multiply(R, exact.add(exact.IDENTITY, stretch)))
        if exact.deviation(drifted) < SO3_FAR / 2:
            return drifted


def half_turn(fmt, rng, axis):
    """2 e e^T - I, rounded: exactly symmetric."""
    return fmt.round_all([2 * axis[i] * axis[j] - (i == j) for i in range(3) for j in range(3)])


def symmetric_noise(rng, size):
    a, b, c, d, e, f = noise(rng, 6, size)
    return [a, b, c, b, d, e, c, e, f]


def clear_axis(rng, k):
    """An axis with components that are zero or well away from zero."""
    while True:
        axis = direction(rng, k)
        if all(x == 0 or abs(x) > 0.02 for x in axis):
            return axis
        k = 0


def rotation_of_band(fmt, rng, k, band):
    """A rounded rotation with an angle of the band, every third one with drift."""
    drifted = k % 3 == 2
    if band == "at_pi":
        axis = clear_axis(rng, k) if drifted else direction(rng, k)
        R = half_turn(fmt, rng, axis)
        if drifted and k % 10 not in (1, 2):  # those keep their zeros
            R = fmt.round_all(exact.add(R, symmetric_noise(rng, magnitude(rng, fmt.eps, 0.0012))))
        return R
    angle = ANGLES[band](fmt, rng)
    if band == "near_pi" and pi - angle < 64 * fmt.eps:
        # So near to pi the sign of the axis may be the convention's: build on the axis that the convention picks.
        axis = exact.standard_sign([mpf(0)] + clear_axis(rng, k))[1:]
        return fmt.round_all(exact.axis_rotation(axis, angle))
    R = fmt.round_all(exact.exp(vector(rng, angle, k)))
    return drift(fmt, rng, R, band not in ("tiny", "small")) if drifted else R


def log_status(fmt, M, axis, gap):
    """Statuses of a function that takes the logarithm of M: 1 within 2 eps of a half-turn, either within a factor 8."""
    if gap >= 8 * fmt.eps:
        return (0,)
    skew = exact.skew_vector(M)
    if gap > 0:
        first = next(x for x in axis if x != 0)
        if first < 0 or any(s != 0 and s * e <= 0 for s, e in zip(skew, axis)):
            raise Unclear
    return (0, 1) if gap >= fmt.eps / 4 else (1,)


def close_to_far(M):
    """Is the deviation of M so near to CHS_SO3_FAR that rounding could decide?"""
    return SO3_FAR / 2 < exact.deviation(M) < 4 * SO3_FAR


def column_ties(fmt, M):
    """Could rounding read a matrix that is not quite a rotation through another column?"""
    diagonal = sorted(row[i] for i, row in enumerate(exact.shepperd_matrix(M)))
    return exact.deviation(M) > 16 * fmt.eps and diagonal[2] > mpf("0.98") * diagonal[3]


def log_ties(fmt, M):
    """The same of the logarithm, which goes by the trace first."""
    diagonal, beyond = sorted(exact.shepperd_matrix(M)[i][i] for i in range(1, 4)), exact.trace(M) - mpf(1) / 2
    tie = abs(beyond) < mpf("0.02") or (beyond < 0 and diagonal[1] > mpf("0.98") * diagonal[2])
    return exact.deviation(M) > 16 * fmt.eps and tie


# Poses


def pose_of(fmt, rng, R, p, k=0):
    """T[16]; every eighth one with a last row that must not be read."""
    T = exact.pose_matrix(R, p)
    if k % 8 == 7:
        T[12:16] = pick(rng, [["nan"] * 4, ["inf", "-inf", "nan", mpf(0)], [mpf(7), mpf(-3), mpf(2), mpf(5)]])
    return T


def random_pose(fmt, rng, band="mixed", k=0):
    return pose_of(fmt, rng, random_rotation(fmt, rng), point(fmt, rng, band, k), k)


# Errors


def spoilt(base, indices, other=None):
    """Errors for NaN (-1), an infinity (-2), and both (-1) at the indices of a valid input."""
    nans, infinities, both = [], [], []
    indices = list(indices)
    for n, i in enumerate(indices):
        bad = list(base)
        bad[i] = "nan"
        nans.append(bad)
        bad = list(base)
        bad[i] = "-inf" if n % 2 else "inf"
        infinities.append(bad)
    if len(indices) > 1:
        for i, j in ((indices[0], indices[-1]), (indices[-1], indices[0])):
            bad = list(base)
            bad[i], bad[j] = "nan", "inf"
            both.append(bad)
    return [Errors(-1, nans, "nan"), Errors(-2, infinities, "infinite"), Errors(-1, both, "nan_and_infinite")]


def not_rotations(fmt, rng):
    """(matrices far from a rotation, reflections), each clear of the limit by a factor 4 or more."""
    far, reflections = [], []
    for k in range(8):
        R = random_rotation(fmt, rng)
        far.append(fmt.round_all(exact.times(pick(rng, [mpf("0.9"), mpf("1.1"), mpf(2), mpf("1e-3"), mpf("1e5")]), R)))
        sheared = fmt.round_all(exact.multiply(R, [mpf(x) for x in (1, "0.1", 0, 0, 1, 0, 0, 0, 1)]))
        far.append(sheared)
        mirror = [
            mpf(x)
            for x in pick(
                rng,
                [
                    (1, 0, 0, 0, 1, 0, 0, 0, -1),
                    (-1, 0, 0, 0, 1, 0, 0, 0, 1),
                    (-1, 0, 0, 0, -1, 0, 0, 0, -1),
                    (0, 1, 0, 1, 0, 0, 0, 0, 1),
                ],
            )
        ]
        reflections.append(fmt.round_all(exact.multiply(R, mirror)))
    return far, reflections
