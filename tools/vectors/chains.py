"""Serial chains in exact arithmetic: products of exponentials, Jacobians, and the reach that errors are relative to.

A chain is (screws, home, body): lists of six numbers, a pose (R, p), and whether the screws are those of the tool.
"""

from mpmath import mpf

import exact
from exact import add, cross, dot, norm, times

IDENTITY = (exact.IDENTITY, [mpf(0)] * 3)


def is_unit(fmt, S):
    """Is omega so near to a unit vector that it is read as one?"""
    return abs(dot(S[0:3], S[0:3]) - 1) <= 8 * fmt.eps


def normalised(fmt, S):
    """S as the library moves by it."""
    return times(1 / norm(S[0:3]), S) if is_unit(fmt, S) else list(S)


def joint_pose(fmt, S, q):
    return exact.pose_exp(times(q, normalised(fmt, S)))


def places(fmt, screws, home, body, q):
    """The poses on the way: before joint 1, ..., before joint n, and the tool's."""
    way = [home if body else IDENTITY]
    for S, x in zip(screws, q):
        way.append(exact.compose(way[-1], joint_pose(fmt, S, x)))
    if not body:
        way[-1] = exact.compose(way[-1], home)
    return way


def forward(fmt, screws, home, body, q):
    return places(fmt, screws, home, body, q)[-1]


def links(fmt, screws, home, body, q):
    """The displacements of the links, (R, p) each."""
    way = [IDENTITY]
    for S, x in zip(screws, q):
        way.append(exact.compose(way[-1], joint_pose(fmt, S, x)))
    if not body:
        return way[1:]
    return [exact.compose(exact.compose(home, step), exact.inverse(home)) for step in way[1:]]


def space_columns(fmt, screws, home, body, q):
    """Of the axes as they stand, moved by poses of unit ones."""
    way = places(fmt, screws, home, body, q)
    return [exact.apply6(exact.adjoint(*place), S) for place, S in zip(way, screws)]


def body_columns(fmt, screws, home, body, q):
    back = exact.adjoint_inverse(*forward(fmt, screws, home, body, q))
    return [exact.apply6(back, column) for column in space_columns(fmt, screws, home, body, q)]


def matrix_of(columns):
    """6 x n, row-major."""
    return [column[i] for i in range(6) for column in columns]


def joint_reach(fmt, S, q):
    w, v = normalised(fmt, S)[0:3], normalised(fmt, S)[3:6]
    travel = max(mpf(1), abs(q))
    if norm(w) == 0:
        return travel * norm(v)
    pitch = dot(w, v) / dot(w, w)
    return norm(cross(w, v)) / dot(w, w) + abs(pitch) * max(mpf(1), norm(w) * abs(q))


def reach(fmt, screws, home, q):
    return norm(home[1]) + sum(joint_reach(fmt, S, x) for S, x in zip(screws, q))


def count(fmt, screws, q):
    """How many joints' errors count: an odd omega counts more often."""
    total = mpf(0)
    for S, x in zip(screws, q):
        w = norm(S[0:3])
        total += 1 if w == 0 or is_unit(fmt, S) else max(mpf(1), w * abs(x))
    return total
