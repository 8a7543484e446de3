"""agile_eye.h: the Agile Eye, from the vectors of its legs and what they say of the platform."""

from mpmath import atan2, cos, mpf, pi, sin, sqrt, workprec

import cases_so3
import exact
import sampling
from sampling import magnitude, pick, sign, uniform
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear, all_outputs

NON_TRIVIAL = ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))  # signs of the columns, by assembly mode
LOCKED = [mpf(x) for x in (0, 1, 0, 0, 0, 1, 1, 0, 0)]


# The robot


class Legs:
    """The joints' vectors: u_i, w_i, and the distances d_i from the singular curves."""

    def __init__(self, q):
        s, c = [sin(x) for x in q], [cos(x) for x in q]
        self.u = [[mpf(i == r) for r in range(3)] for i in range(3)]
        self.w = [[mpf(0)] * 3 for _ in range(3)]
        for i in range(3):
            self.w[i][(i + 1) % 3], self.w[i][(i + 2) % 3] = -s[i], c[i]
        self.D = s[0] * s[1] * s[2] + c[0] * c[1] * c[2]
        self.d = [sqrt(s[(i + 1) % 3] ** 2 + (c[(i + 1) % 3] * c[(i + 2) % 3]) ** 2) for i in range(3)]
        self.size = max([mpf(1)] + [abs(x) for x in q])

    def platform(self):
        """The orientation of assembly mode 0.

        x is normal to w3: x = a e + b f, e and f normal to w3 and to each other. y is normal to w1 and x, so that z is
        along x x (w1 x x) = (x . x) w1 - (x . w1) x. Normal to w2 it is where (x . x)(w1 . w2) = (x . w1)(x . w2), a
        quadratic equation in a and b; with f = -u3 it has the root a = 0, the locked platform, and one other.
        """
        w1, w2, w3 = self.w
        e, f = exact.cross(w3, self.u[2]), exact.times(mpf(-1), self.u[2])
        dot = exact.dot
        a = dot(e, w1) * dot(f, w2) + dot(f, w1) * dot(e, w2)
        b = dot(w1, w2) - dot(e, w1) * dot(e, w2)
        x = exact.unit(exact.add(exact.times(a, e), exact.times(b, f)))
        y = exact.unit(exact.cross(w1, x))
        z = exact.cross(x, y)
        R = [t for r in range(3) for t in (x[r], y[r], z[r])]
        # Of the four, the one in which D and every (u_i x w_i) . v_i have the same sign.
        rates = [-dot(exact.cross(self.u[i], self.w[i]), exact.column(R, (i + 1) % 3)) * self.D for i in range(3)]
        signs = [rates[(m + 2) % 3] > 0 for m in range(3)]
        return [t if signs[i % 3] else -t for i, t in enumerate(R)]

    def statuses(self, fmt):
        """Those that may be right, or Unclear."""
        rounding, least = fmt.eps * self.size, min(self.d)
        if least < 4 * rounding:
            return (-7,)
        if least < 16 * rounding or 4 * rounding < abs(self.D) < 16 * rounding:
            raise Unclear
        if abs(self.D) < 4 * rounding:
            return (14,)
        limit = sqrt(fmt.eps) * self.size
        if limit / 2 < least < 2 * limit:
            raise Unclear
        return (4,) if least < limit else (0,)


def mode_of(x):
    return int(x)


def change(R, signs):
    return [x * signs[i % 3] for i, x in enumerate(R)]


# Joint angles


JOINT_BANDS = {"tiny": 50, "small": 60, "moderate": 60, "ordinary": 120, "near_pi": 50, "beyond_pi": 60, "far": 40}


def joints(fmt, rng, band):
    return fmt.round_all([sign(rng) * sampling.ANGLES[band](fmt, rng) for _ in range(3)])


def near_a_curve(fmt, rng):
    """q_j near a multiple of pi, q_k near pi/2 or -pi/2, as far from them as anything the format has."""
    size = magnitude(rng, 64 * fmt.eps, "1e-2")
    i = rng.getrandbits(10) % 3
    q = [uniform(rng, -3, 3) for _ in range(3)]
    q[(i + 1) % 3] = pick(rng, [mpf(0), pi, -pi]) + size * uniform(rng, -1, 1)
    q[(i + 2) % 3] = pick(rng, [pi / 2, -pi / 2]) + size * uniform(rng, -1, 1)
    return fmt.round_all(q)


def near_locked(fmt, rng):
    """D small, the legs otherwise somewhere."""
    a, b = uniform(rng, 0.2, 1.4), uniform(rng, 0.2, 1.4)
    q = [sign(rng) * a, sign(rng) * b, mpf(0)]
    q[2] = atan2(-cos(q[0]) * cos(q[1]), sin(q[0]) * sin(q[1])) + pick(rng, [0, pi, -pi])
    q[2] += sign(rng) * magnitude(rng, 64 * fmt.eps, "1e-2")
    q = fmt.round_all(q)
    return q[1:] + q[:1] if rng.getrandbits(1) else q


def joint_bands(fmt, rng, extend, error_extend):
    """Bands of joint angles; extend(q) gives the whole input."""
    bands = [
        Band(name, count, (lambda band: lambda fmt, rng, k: extend(fmt, rng, joints(fmt, rng, band)))(name))
        for name, count in JOINT_BANDS.items()
    ]
    bands.append(Band("degenerate", 120, lambda fmt, rng, k: extend(fmt, rng, near_a_curve(fmt, rng)), "near_a_curve"))
    bands.append(Band("degenerate", 60, lambda fmt, rng, k: extend(fmt, rng, near_locked(fmt, rng)), "near_locked"))
    limit = sampling.angle_max(fmt)
    large = [error_extend([mpf(1) if i != j else s * 5 * limit for i in range(3)]) for j in range(3) for s in (1, -1)]
    right, straight = fmt.round(pi / 2), fmt.round(pi)
    curves = [[mpf("0.5"), mpf(0), right], [-right, mpf(1), straight], [straight, right, mpf(-2)]]
    return bands + [
        Errors(-4, large, "angle_range"),
        Errors(-7, [error_extend(q) for q in curves], "on_a_curve"),
    ]


# Inputs to outputs


def without_error(legs, fmt):
    statuses = legs.statuses(fmt)
    if statuses[0] < 0:
        raise Unclear  # these are listed
    return statuses


def evaluate_direct(fmt, x):
    mode = mode_of(x[3])
    if mode >= 4:
        return Result(change(LOCKED, NON_TRIVIAL[mode - 4]), [mpf(1)])
    legs = Legs(x[0:3])
    return Result(change(legs.platform(), NON_TRIVIAL[mode]), [mpf(1)], without_error(legs, fmt))


def evaluate_direct_working(fmt, x):
    mode = mode_of(x[3])
    legs = Legs(x[0:3])
    statuses = without_error(legs, fmt)
    flipped = [(mode >> i) & 1 for i in range(3)]
    odd = sum(flipped) % 2
    if statuses == (14,) or odd != (legs.D < 0):
        raise Unclear  # the orientation hangs on the sign of D; or there is none, which the tests check
    # Column (i + 1) % 3 belongs to leg i; in assembly mode 0 every leg has the sign of D.
    signs = [0] * 3
    for i in range(3):
        signs[(i + 1) % 3] = (-1) ** (flipped[i] + odd)
    return Result(change(legs.platform(), signs), [mpf(1)], statuses)


def evaluate_direct_near(fmt, x):
    last = x[3:12]
    if sampling.close_to_far(last):
        raise Unclear
    legs = Legs(x[0:3])
    R = legs.platform()
    found = sorted((exact.dot(change(R, signs), last), k) for k, signs in enumerate(NON_TRIVIAL))
    if found[3][0] - found[2][0] < 64 * fmt.eps:
        raise Unclear
    return Result(change(R, NON_TRIVIAL[found[3][1]]), [mpf(1)], without_error(legs, fmt))


def evaluate_jacobian(fmt, q):
    """The derivatives of w_i . v_i solved for the angular velocity."""
    legs = Legs(q)
    statuses = without_error(legs, fmt)
    if legs.D == 0:
        raise Unclear
    R = legs.platform()
    v = [exact.times(mpf(-1), exact.column(R, (i + 1) % 3)) for i in range(3)]
    a = [exact.cross(v[i], legs.w[i]) for i in range(3)]
    with workprec(4 * exact.BASE_BITS):
        determinant = exact.dot(a[0], exact.cross(a[1], a[2]))
        columns = []
        for i in range(3):
            b = exact.dot(exact.cross(legs.u[i], legs.w[i]), v[i])
            columns.append(exact.times(-b / determinant, exact.cross(a[(i + 1) % 3], a[(i + 2) % 3])))
    scales = [1 / (legs.d[(i + 1) % 3] * legs.d[(i + 2) % 3]) for i in range(3)]
    return Result([columns[i % 3][i // 3] for i in range(9)], scales, statuses)


def leg_of(R, i):
    """(along u_i, cosine, sine) of column i + 1."""
    j, k = (i + 1) % 3, (i + 2) % 3
    return R[3 * i + j], R[3 * j + j], R[3 * k + j]


def sines(fmt, R):
    """b_i; Unclear where rounding decides whether a leg is free."""
    if sampling.close_to_far(R):
        raise Unclear
    b = [exact.norm(leg_of(R, i)[1:]) for i in range(3)]
    if any(fmt.eps < x < 16 * fmt.eps for x in b):
        raise Unclear
    return b


def leg_angle(R, i, flipped):
    _, c, s = leg_of(R, i)
    if flipped:
        c, s = -c, -s
    if s == 0 and c < 0:
        return +pi
    return atan2(s, c)


def inverse_result(fmt, R, modes):
    b = sines(fmt, R)
    free = [x <= fmt.eps for x in b]
    if all(free):
        raise Unclear  # listed
    q = [mpf(0) if free[i] else leg_angle(R, i, (mode >> i) & 1) for mode in modes for i in range(3)]
    return q, (14,) if any(free) else (0,)


def evaluate_inverse(fmt, x):
    q, statuses = inverse_result(fmt, x[0:9], [mode_of(x[9])])
    return Result(q, [abs(t) for t in q], statuses)


def evaluate_inverse_all(fmt, R):
    q, statuses = inverse_result(fmt, R, range(8))
    return Result(q, [abs(t) for t in q[0:3] + q[21:24]], statuses)


def evaluate_jacobian_inverse(fmt, R):
    b = sines(fmt, R)
    if min(b) <= fmt.eps:
        raise Unclear
    rows = []
    for i in range(3):
        along, c, s = leg_of(R, i)
        row = [mpf(0)] * 3
        row[i], row[(i + 1) % 3], row[(i + 2) % 3] = mpf(1), -along * c / b[i] ** 2, -along * s / b[i] ** 2
        rows.append(row)
    return Result(rows[0] + rows[1] + rows[2], [exact.norm(row) for row in rows])


def evaluate_distance(fmt, R):
    if sampling.close_to_far(R):
        raise Unclear
    angle = min(atan2(exact.norm(leg_of(R, i)[1:]), abs(leg_of(R, i)[0])) for i in range(3))
    return Result([angle], [angle])


def tool_axes():
    """The tool's frames on the base and on the platform, from what the header says of them."""
    z = exact.unit([mpf(1)] * 3)
    u1 = [mpf(1), mpf(0), mpf(0)]
    x0 = exact.unit(exact.subtract(u1, exact.times(exact.dot(u1, z), z)))
    x1 = exact.unit([mpf(1), mpf(1), mpf(-2)])
    return [[t for r in range(3) for t in (x[r], exact.cross(z, x)[r], z[r])] for x in (x0, x1)]


def evaluate_tool(fmt, R):
    C0, C1 = tool_axes()
    return Result(exact.multiply(exact.transpose(C0), exact.multiply(R, C1)), [exact.norm(R)])


def evaluate_platform(fmt, tool):
    C0, C1 = tool_axes()
    return Result(exact.multiply(C0, exact.multiply(tool, exact.transpose(C1))), [exact.norm(tool)])


# Orientations


def curve_orientation(rng, i, angle):
    """v_i along u_i or against it, and turned about it."""
    j, k = (i + 1) % 3, (i + 2) % 3
    e, c, s = mpf(sign(rng)), cos(angle), sin(angle)
    R = [mpf(0)] * 9
    R[3 * i + j] = e
    R[3 * j + k], R[3 * k + k] = c, s
    R[3 * j + i], R[3 * k + i] = -e * s, e * c
    return R


def orientation_bands(fmt, rng, extend, curves=True):
    def general(fmt, rng, k):
        R = fmt.round_all(exact.exp(sampling.vector(rng, uniform(rng, 0, 3.1), k)))
        return extend(rng, sampling.drift(fmt, rng, R, True) if k % 4 == 3 else R)

    def close(fmt, rng, k):
        R = curve_orientation(rng, k % 3, uniform(rng, 0.1, 1.4) + pi / 2 * rng.getrandbits(2))
        turn = exact.exp(sampling.vector(rng, magnitude(rng, 64 * fmt.eps, "1e-2")))
        return extend(rng, fmt.round_all(exact.multiply(turn, R)))

    def on_curve(fmt, rng, k):
        R = curve_orientation(rng, k % 3, uniform(rng, 0.1, 1.4) + pi / 2 * rng.getrandbits(2))
        return extend(rng, fmt.round_all(R))

    bands = [Band("ordinary", 300, general), Band("degenerate", 150, close, "near_a_curve")]
    if curves:
        bands.append(Band("degenerate", 60, on_curve, "on_a_curve"))
    return bands


def locked(extend, rng):
    return [extend(rng, change(LOCKED, signs)) for signs in NON_TRIVIAL]


def alone(rng, R):
    return R


def with_mode(rng, R):
    return R + [mpf(rng.getrandbits(3))]


def inverse_bands(fmt, rng):
    bands = orientation_bands(fmt, rng, with_mode) + [Errors(-13, locked(with_mode, rng), "locked")]
    none = [list(exact.IDENTITY) + [mpf(m)] for m in (-1, 8, 100)]
    bands.append(Errors(-11, none, "no_such_mode"))
    return bands + cases_so3.rotation_errors(fmt, rng, lambda R: R + [mpf(3)])


def inverse_all_bands(fmt, rng):
    bands = orientation_bands(fmt, rng, alone) + [Errors(-13, locked(alone, rng), "locked")]
    return bands + cases_so3.rotation_errors(fmt, rng)


def jacobian_inverse_bands(fmt, rng):
    bands = orientation_bands(fmt, rng, alone, curves=False) + [Errors(-13, locked(alone, rng), "locked")]
    singular = [fmt.round_all(curve_orientation(rng, k % 3, uniform(rng, 0.1, 1.4))) for k in range(12)]
    return bands + [Errors(-7, singular, "on_a_curve")] + cases_so3.rotation_errors(fmt, rng)


def distance_bands(fmt, rng):
    bands = orientation_bands(fmt, rng, alone) + [Listed("degenerate", locked(alone, rng), "locked")]
    return bands + cases_so3.rotation_errors(fmt, rng)


def direct_bands(modes, fmt, rng):
    bands = joint_bands(
        fmt, rng, lambda fmt, rng, q: q + [mpf(pick(rng, modes))], lambda q: q + [mpf(modes[0])]
    )
    none = [[mpf(1), mpf("0.5"), mpf(-2), mpf(m)] for m in (-1, 8, 100)]
    return bands + [Errors(-11, none, "no_such_mode")] + sampling.spoilt([mpf(1), mpf("0.5"), mpf(-2), mpf(0)], range(3))


def near_bands(fmt, rng):
    def extend(fmt, rng, q):
        last = exact.exp(sampling.vector(rng, uniform(rng, 0, 3.1)))
        if rng.getrandbits(1):
            turn = exact.exp(sampling.vector(rng, magnitude(rng, "1e-3", "0.5")))
            last = exact.multiply(turn, change(Legs(q).platform(), pick(rng, NON_TRIVIAL)))
        return q + fmt.round_all(last)

    other = fmt.round_all(exact.exp([mpf("-1.2"), mpf("0.4"), mpf("0.9")]))
    q = fmt.round_all([mpf(1), mpf("0.5"), mpf(-2)])
    bands = joint_bands(fmt, rng, extend, lambda q: q + other)
    bands += cases_so3.rotation_errors(fmt, rng, lambda R: q + R, (3, 7, 11))
    return bands + sampling.spoilt(q + other, range(3))


def jacobian_bands(fmt, rng):
    bands = joint_bands(fmt, rng, lambda fmt, rng, q: q, lambda q: q)
    return bands + sampling.spoilt([mpf(1), mpf("0.5"), mpf(-2)], range(3))


def matrix_bands(fmt, rng):
    def rotation(fmt, rng, k):
        return sampling.random_rotation(fmt, rng)

    def any_matrix(fmt, rng, k):
        return fmt.round_all(sampling.noise(rng, 9, sampling.length(fmt, rng)))

    listed = [list(exact.IDENTITY), fmt.round_all(tool_axes()[0]), fmt.round_all(tool_axes()[1])]
    return [
        Band("ordinary", 300, rotation, "rotation"),
        Band("mixed", 100, any_matrix, "any"),
        Listed("example", listed),
    ]


def columns(name):
    return [Group("%s_%d" % (name, i + 1), "norm", range(i, 9, 3)) for i in range(3)]


def rows(name):
    return [Group("%s_%d" % (name, i + 1), "norm", range(3 * i, 3 * i + 3)) for i in range(3)]


def joint_groups():
    return [Group("joint_%d" % (i + 1), "max", [i]) for i in range(3)]


def every_mode():
    """The joint angles of mode 0 and those of mode 7, each in the modes that share it."""
    return [
        Group("%s_%d" % (name, i + 1), "max", [3 * m + i for m in range(8) if (m >> i) & 1 == flipped])
        for flipped, name in enumerate(("joint", "opposite"))
        for i in range(3)
    ]


FUNCTIONS = [
    Function("agile_eye_inverse", 10, joint_groups(), evaluate_inverse, inverse_bands),
    Function("agile_eye_inverse_all", 9, every_mode(), evaluate_inverse_all, inverse_all_bands),
    Function(
        "agile_eye_direct",
        4,
        all_outputs("rotation", "max", 9),
        evaluate_direct,
        lambda fmt, rng: direct_bands((0, 0, 1, 2, 3, 4, 5, 6, 7), fmt, rng),
    ),
    Function(
        "agile_eye_direct_working",
        4,
        all_outputs("rotation", "max", 9),
        evaluate_direct_working,
        lambda fmt, rng: direct_bands(tuple(range(8)), fmt, rng),
    ),
    Function("agile_eye_direct_near", 12, all_outputs("rotation", "max", 9), evaluate_direct_near, near_bands),
    Function("agile_eye_jacobian", 3, columns("column"), evaluate_jacobian, jacobian_bands),
    Function("agile_eye_jacobian_inverse", 9, rows("row"), evaluate_jacobian_inverse, jacobian_inverse_bands),
    Function("agile_eye_distance", 9, [Group("distance", "max", [0])], evaluate_distance, distance_bands),
    Function("agile_eye_tool", 9, all_outputs("all", "max", 9), evaluate_tool, matrix_bands),
    Function("agile_eye_platform", 9, all_outputs("all", "max", 9), evaluate_platform, matrix_bands),
]
