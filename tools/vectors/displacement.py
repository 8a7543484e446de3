"""The displacement of a body from three of its points, by the two methods of motion.h, in exact arithmetic.

On points that moved exactly rigidly both give the same rotation. On rounded points the result depends on what a
method chooses: the longest side, a pair of vectors, a column. The *_choices functions therefore give every rotation
that rounding could make a method choose, the method's own first, so that a case can be dropped when they are not the
same.
"""

from mpmath import ldexp, mpf, workprec

import exact
from exact import add, apply, cross, dot, norm, subtract, times

TIE = mpf("0.02")  # relative difference up to which a choice may fall either way
FINE_BITS = 1600  # keeps the digits of rotations by 1e-150


class Triangle:
    """Points by rows, and what the choices are made of."""

    def __init__(self, points):
        self.points = points
        self.sides = [norm(subtract(points[i - 1], points[i - 2])) for i in range(3)]  # side i is opposite point i
        self.longest = max(self.sides)
        normal = cross(subtract(points[1], points[0]), subtract(points[2], points[0]))
        self.condition = self.longest**2 / norm(normal)  # longest side over smallest height

    def pivots(self):
        """The points opposite a side that may count as the longest, the longest first."""
        order = sorted(range(3), key=lambda i: -self.sides[i])
        return [i for i in order if self.sides[i] >= self.longest * (1 - TIE)]

    def offset(self, other):
        """The squares of how far the centroid is and how far it goes."""
        c, d = (times(mpf(1) / 3, add(add(t.points[0], t.points[1]), t.points[2])) for t in (self, other))
        return dot(c, c) + dot(subtract(d, c), subtract(d, c))


def bottema_roth_choices(initial, final, eps):
    """Unit quaternions (d, n): by eq. 23 where that is well conditioned, and otherwise those of Laub & Shiflett."""
    a, c = from_first(initial)
    a_after, c_after = from_first(final)
    q = half_angle_quaternion(a, a_after, c, c_after)
    dd, nn = q[0] ** 2, dot(q[1:], q[1:])
    if nn == 0 or dd == 0:
        return laub_shiflett_choices(initial, final, eps)
    span = sum(s**2 for s in initial.sides + final.sides)
    areas = [dot(n, n) for n in (cross(a, c), cross(a_after, c_after))]
    reach = initial.offset(final) + span
    zone = (8 * eps * span) ** 2 / areas[0]
    clear = [  # each must be at least 1
        (dd + nn) ** 2 / (nn * areas[0]),
        min(areas) / (64 * eps * span**2),
        span / (4 * eps * reach),
        nn * span / (zone * reach * (dd + nn)),
        dd / (zone * nn),
    ]
    chosen = [exact.unit(q)] if min(clear) > mpf("0.5") else []
    others = laub_shiflett_choices(initial, final, eps) if min(clear) < 2 else []
    return chosen + others if min(clear) >= 1 else others + chosen


def from_first(triangle):
    """The sides from the first point to the second and from the third to the first."""
    p = triangle.points
    return subtract(p[1], p[0]), subtract(p[0], p[2])


def half_angle_quaternion(x, x_after, y, y_after):
    """(d, n), proportional to (cos(theta/2), sin(theta/2) e): n = dx x dy, d = dx . sy."""
    dx, dy, sy = subtract(x_after, x), subtract(y_after, y), add(y_after, y)
    return [dot(dx, sy)] + cross(dx, dy)


def laub_shiflett_choices(initial, final, eps):
    """Unit quaternions by the rotation matrix of the two triangles' frames and its largest quaternion column."""
    chosen = []
    with workprec(FINE_BITS):
        for pivot in initial.pivots():
            p, q = initial.points, final.points
            start, end = (pivot + 1) % 3, (pivot + 2) % 3
            R = frame_rotation(
                subtract(p[end], p[start]),
                subtract(p[pivot], p[start]),
                subtract(q[end], q[start]),
                subtract(q[pivot], q[start]),
            )
            K = exact.shepperd_matrix(R)
            order = sorted(range(4), key=lambda i: -K[i][i])
            chosen += [exact.unit(K[i]) for i in order if K[i][i] >= K[order[0]][order[0]] * (1 - TIE)]
        # A component that is zero but for rounding.
        return [[mpf(0) if abs(x) < ldexp(1, 64 - FINE_BITS) else x for x in q] for q in chosen]


def frame_rotation(a, c, a_after, c_after):
    """R0 = g1 f1^T + g2 f2^T + (g1 x g2) f3^T; a lies along the longest side."""
    size = norm(a)
    f1, f3 = exact.unit(a), exact.unit(cross(a, c))
    f2 = cross(f3, f1)
    g1 = [x / size for x in a_after]
    along, across = dot(c, f1), dot(c, f2)
    g2 = [(x - along * y) / across for x, y in zip(c_after, g1)]
    f, g = [f1, f2, f3], [g1, g2, cross(g1, g2)]
    with workprec(FINE_BITS):
        return [sum(g[k][i] * f[k][j] for k in range(3)) for i in range(3) for j in range(3)]


METHODS = {"motion_bottema_roth": bottema_roth_choices, "motion_laub_shiflett": laub_shiflett_choices}


class Displacement:
    """The displacement x -> R x + p and its screw; q is the quaternion of R, None without rotation."""

    def __init__(self, q, initial, final):
        third = mpf(1) / 3
        sum_before, sum_after = (add(add(t.points[0], t.points[1]), t.points[2]) for t in (initial, final))
        self.before, self.after = times(third, sum_before), times(third, sum_after)
        self.travel = times(third, subtract(sum_after, sum_before))
        self.R = list(exact.IDENTITY) if q is None else exact.quaternion_rotation(q)
        self.p = subtract(self.after, apply(self.R, self.before)) if q else self.travel
        if q is not None:
            self.axis, self.angle, self.gap = exact.quaternion_axis_angle(exact.standard_sign(q))
            midpoint = times(mpf("0.5"), add(self.before, self.after))
            self.point, self.translation = exact.screw_of_rotation(self.axis, self.angle, midpoint, self.travel)

    def screw(self):
        return self.axis + self.point + [self.translation, self.angle]


def quaternion(method, initial, final, eps):
    """(q, doubt): the method's quaternion, and how far the other choices that rounding could make are from it.

    q is None when the sides have not turned at all.
    """
    sides = [[subtract(t.points[j], t.points[0]) for j in (1, 2)] for t in (initial, final)]
    if sides[0] == sides[1]:
        return None, mpf(0)
    choices = METHODS[method](initial, final, eps)
    q = choices[0]
    doubt = max(min(norm(subtract(q, r)), norm(add(q, r))) for r in choices)
    return q, doubt
