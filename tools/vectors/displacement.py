"""The displacement of a body from three of its points, by the methods of motion.h, in exact arithmetic.

On points that moved exactly rigidly all give the same rotation. On rounded points the result depends on what a
method chooses: a formula, the longest side, a column. The *_choices functions therefore give every rotation
that rounding could make a method choose, the method's own first, so that a case can be dropped when they are not the
same.
"""

import itertools

from mpmath import ldexp, mpc, mpf, sqrt, workprec

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
        area = norm(cross(subtract(points[1], points[0]), subtract(points[2], points[0])))
        self.condition = self.longest**2 / area if area else mpf("inf")  # longest side over smallest height

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
    q, clear = half_angles(initial, final, eps)
    chosen = [exact.unit(q)] if clear > mpf("0.5") else []
    others = laub_shiflett_choices(initial, final, eps) if clear < 2 else []
    return chosen + others if clear >= 1 else others + chosen


def half_angles(initial, final, eps):
    """Eq. 23 for two sides, and a figure that is at least 1 where the method trusts it."""
    a, c = from_first(initial)
    a_after, c_after = from_first(final)
    q = half_angle_quaternion(a, a_after, c, c_after)
    dd, nn = q[0] ** 2, dot(q[1:], q[1:])
    if nn == 0 or dd == 0:
        return q, mpf(0)
    span = sum(s**2 for s in initial.sides + final.sides)
    areas = [dot(n, n) for n in (cross(a, c), cross(a_after, c_after))]
    reach = initial.offset(final) + span
    zone = (8 * eps * span) ** 2 / areas[0]
    sides = [dot(x, x) for x in (a, c)]
    changes = [dot(x, x) for x in (subtract(a_after, a), subtract(c_after, c))]
    return q, min(
        (dd + nn) ** 2 / (nn * areas[0]),
        min(areas) / (64 * eps * span**2),
        span / (4 * eps * reach),
        nn * span / (zone * reach * (dd + nn)),
        dd / (zone * nn),
        16 * sum(sides) * nn / ((dd + nn) * sum(changes)),
    )


def side_turned_most(initial, final, eps):
    """The order of the points by the paper's rule, or -1; None where rounding could decide."""
    _, clear = half_angles(initial, final, eps)
    if clear < mpf("0.5"):
        return -1
    moved = [subtract(g, p) for p, g in zip(initial.points, final.points)]
    changes = [norm(subtract(moved[k - 2], moved[k])) for k in range(3)]  # of the side from point k to the next
    first, second = sorted(range(3), key=lambda k: -changes[k])[:2]
    return None if clear < 2 or changes[second] > changes[first] * (1 - TIE) else first


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
            chosen += column_choices(
                frame_rotation(
                    subtract(p[end], p[start]),
                    subtract(p[pivot], p[start]),
                    subtract(q[end], q[start]),
                    subtract(q[pivot], q[start]),
                )
            )
        return without_noise(chosen)


def column_choices(R):
    """Unit quaternions of a matrix near a rotation, the largest column first and any that rounding could prefer."""
    K = exact.shepperd_matrix(R)
    order = sorted(range(4), key=lambda i: -K[i][i])
    return [exact.unit(K[i]) for i in order if K[i][i] >= K[order[0]][order[0]] * (1 - TIE)]


def without_noise(quaternions):
    """A component that is zero but for rounding is made zero."""
    return [[mpf(0) if abs(x) < ldexp(1, 64 - FINE_BITS) else x for x in q] for q in quaternions]


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


def beggs_choices(initial, final, eps):
    """Each row by its quadratic, or by orthogonality where its part along the normal is below one half."""
    with workprec(FINE_BITS):
        a, c = from_first(initial)
        a_after, c_after = from_first(final)
        N, N_after = cross(a, c), cross(a_after, c_after)
        square, size = dot(N, N), norm(N)
        a_dual, c_dual = times(1 / square, cross(c, N)), times(1 / square, cross(N, a))
        P = [[x * u + y * v for u, v in zip(a_dual, c_dual)] for x, y in zip(a_after, c_after)]
        squared = [1 - dot(row, row) for row in P]
        largest = max(abs(x) for x in N_after)
        chosen = []
        for best in sorted(range(3), key=lambda i: -abs(N_after[i])):
            if abs(N_after[best]) < largest * (1 - TIE):
                continue
            other = sqrt(max(squared[best], mpf(0))) / abs(N_after[best])
            rows = []
            for i in range(3):
                own = sqrt(max(squared[i], mpf(0))) * (-1 if N_after[i] < 0 else 1)
                along = [own, other * N_after[i]]
                near = abs(squared[i] - mpf("0.25")) < TIE
                if squared[i] < mpf("0.25"):
                    along.reverse()
                rows.append([add(P[i], times(x / size, N)) for x in along[: 2 if near else 1]])
            chosen += [q for R in itertools.product(*rows) for q in column_choices(sum(R, []))]
        return without_noise(chosen)


def spoor_veldpaus_choices(initial, final, eps):
    """The least-squares rotation."""
    with workprec(FINE_BITS):
        before, after = (planar(*from_first(t)) for t in (initial, final))
        return without_noise(column_choices(turned_rotation(before, after, least_squares_turn(before, after))))


def angeles_choices(initial, final, eps):
    """By the principal axes in the plane, or the least-squares rotation where the moments are nearly equal."""
    with workprec(FINE_BITS):
        before, after = (planar(*from_first(t)) for t in (initial, final))
        moments = [sum(z * z for z in shape) for _, shape in (before, after)]
        sums = [sum(abs(z) ** 2 for z in shape) for _, shape in (before, after)]
        unequal = min(abs(m) / s for m, s in zip(moments, sums)) * 4
        turns = []
        if unequal > 1 - TIE:
            turns.append(sqrt(moments[1] / moments[0]))  # the root with a positive real part
        if unequal < 1 + TIE:
            turns.append(least_squares_turn(before, after))
        if unequal < 1:
            turns.reverse()
        return without_noise([q for z in turns for q in column_choices(turned_rotation(before, after, z))])


def planar(a, c):
    """A frame, a along its first axis and the normal along its third, and the sides in it as complex numbers."""
    f1, f3 = exact.unit(a), exact.unit(cross(a, c))
    f2 = cross(f3, f1)
    za, zc = mpc(dot(a, f1), 0), mpc(dot(c, f1), dot(c, f2))
    return (f1, f2, f3), (za, zc, -za - zc)


def least_squares_turn(before, after):
    return sum(w * z.conjugate() for z, w in zip(before[1], after[1]))


def turned_rotation(before, after, turn):
    """The rotation from one frame to the other, turned in its plane by the argument of a complex number."""
    turn /= abs(turn)
    g1, g2, g3 = after[0]
    g = [
        add(times(turn.real, g1), times(turn.imag, g2)),
        subtract(times(turn.real, g2), times(turn.imag, g1)),
        g3,
    ]
    return [sum(g[k][i] * before[0][k][j] for k in range(3)) for i in range(3) for j in range(3)]


METHODS = {
    "motion_bottema_roth": bottema_roth_choices,
    "motion_laub_shiflett": laub_shiflett_choices,
    "motion_angeles": angeles_choices,
    "motion_spoor_veldpaus": spoor_veldpaus_choices,
    "motion_beggs": beggs_choices,
}


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
