"""so3.h: rotations."""

from mpmath import mp, mpf, pi, sin, sqrt

import exact
import sampling
from exact import norm
from sampling import magnitude, noise, pick, uniform, vector
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear, all_outputs

DIAGONAL = Group("diagonal", "max", (0, 4, 8))
OFF_DIAGONAL = Group("off_diagonal", "max", (1, 2, 3, 5, 6, 7))
EXP_BANDS = {
    "tiny": 60,
    "small": 70,
    "moderate": 60,
    "ordinary": 90,
    "near_pi": 60,
    "at_pi": 40,
    "beyond_pi": 70,
    "far": 40,
}
ANGLE_BANDS = {"tiny": 60, "small": 80, "moderate": 70, "ordinary": 90, "near_pi": 75, "at_pi": 40}
LOG_BANDS = {"tiny": 65, "small": 75, "moderate": 70, "ordinary": 110, "near_pi": 90, "at_pi": 60}

# Exact copies


def exact_copy(function):
    """evaluate() of a function whose result must be exact."""
    return lambda fmt, x: Result(function(x), [mpf(0)])


def vector_bands(fmt, rng):
    """Vectors of every size; w[3]."""
    build = lambda band: lambda fmt, rng, k: sampling.point(fmt, rng, band, k)
    mixed = lambda fmt, rng, k: sampling.independent_sizes(fmt, rng, 3)
    zeros = [[pick(rng, [mpf(0), "-0", mpf(1), mpf(-1)]) for _ in range(3)] for _ in range(12)]
    return [
        Band("ordinary", 200, build("ordinary")),
        Band("large", 100, build("large")),
        Band("small", 100, build("small")),
        Band("mixed", 100, mixed),
        Listed("mixed", zeros, "signed_zero"),
    ]


def vee_bands(fmt, rng):
    """Skew-symmetric matrices; W[9]."""
    build = lambda band: lambda fmt, rng, k: exact.hat(sampling.point(fmt, rng, band, k))
    mixed = lambda fmt, rng, k: exact.hat(sampling.independent_sizes(fmt, rng, 3))
    return [
        Band("ordinary", 210, build("ordinary")),
        Band("large", 100, build("large")),
        Band("small", 100, build("small")),
        Band("mixed", 100, mixed),
    ]


def matrix_bands(fmt, rng, count=1, extra=lambda fmt, rng, band, k: []):
    """`count` matrices of any kind and what `extra` adds."""

    def build(band):
        def inputs(fmt, rng, k):
            matrices = []
            for _ in range(count):
                if k % 2:
                    matrices += sampling.random_rotation(fmt, rng)
                else:
                    matrices += fmt.round_all(noise(rng, 9, sampling.length(fmt, rng, band)))
            return matrices + extra(fmt, rng, band, k)

        return inputs

    mixed = lambda fmt, rng, k: sampling.independent_sizes(fmt, rng, 9 * count) + extra(fmt, rng, "mixed", k)
    return [
        Band("ordinary", 235, build("ordinary")),
        Band("large", 90, build("large")),
        Band("small", 90, build("small")),
        Band("mixed", 90, mixed),
    ]


# Algebra


def evaluate_multiply(fmt, x):
    A, B = x[0:9], x[9:18]
    return Result(exact.multiply(A, B), [norm(A) * norm(B)])


def evaluate_apply(fmt, x):
    R, v = x[0:9], x[9:12]
    return Result(exact.apply(R, v), [norm(R) * norm(v)])


# exp, log, Jacobians


def exp_scales(w):
    return [mpf(1), min(mpf(1), norm(w))]


def evaluate_exp(fmt, w):
    return Result(exact.exp(w), exp_scales(w))


def evaluate_jacobian(side):
    return lambda fmt, w: Result(exact.left_jacobian(exact.times(side, w)), exp_scales(w))


def evaluate_inverse_jacobian(side):
    def evaluate(fmt, w):
        theta = norm(w)
        growth = mpf(1)
        if theta:
            turns = mp.nint(theta / (2 * pi))
            if turns and abs(theta - 2 * pi * turns) < 64 * fmt.eps * theta:
                raise Unclear  # no inverse at a multiple of 2 pi
            growth = max(growth, abs(theta / 2 / sin(theta / 2)))
        J = exact.left_jacobian_inverse(exact.times(side, w))
        return Result(J, [growth * s for s in exp_scales(w)])

    return evaluate


def exp_bands(fmt, rng):
    build = lambda band: lambda fmt, rng, k: sampling.rotation_vector(fmt, rng, k, band)
    bands = [Band(name, count, build(name)) for name, count in EXP_BANDS.items()]
    zeros = [[mpf(0)] * 3, ["-0"] * 3, [mpf(0), "-0", mpf(0)]]
    signed = [[mpf(1), "-0", mpf(0)], ["-0", mpf(-1), mpf(0)], ["-0", "-0", fmt.round(pi / 2)]]
    third = fmt.round(2 * pi / 3 / mp.sqrt(3))
    example = [
        [mpf(0), mpf(0), fmt.round(pi / 2)],
        [fmt.round(pi), mpf(0), mpf(0)],
        [third] * 3,
        [mpf(0), mpf(1), mpf(2)],
    ]
    bands += [Listed("tiny", zeros, "zero"), Listed("ordinary", signed, "signed_zero"), Listed("example", example)]
    if fmt.is_double:
        # Sums of squares that underflow or would overflow must do no harm where the angle itself is fine.
        bands.append(
            Band(
                "tiny",
                6,
                lambda fmt, rng, k: fmt.round_all(vector(rng, magnitude(rng, "1e-306", "1e-300"), k)),
                "tiniest",
            )
        )
    bands += sampling.spoilt([mpf(1), mpf("0.5"), mpf(-2)], range(3))
    limit = sampling.angle_max(fmt)
    large = [
        fmt.round_all(vector(rng, limit * factor, k))
        for k, factor in enumerate([5, 10, 1000, 10**6, mpf(10) ** fmt.pick(200, 20), mpf(10) ** fmt.pick(290, 30)])
    ]
    return bands + [Errors(-4, large, "angle_range")]


def evaluate_log(fmt, M):
    if sampling.close_to_far(M) or sampling.log_ties(fmt, M):
        raise Unclear
    axis, angle, gap = exact.log_axis_angle(M)
    if axis is None:
        return Result([mpf(0)] * 3, [mpf(0)])
    statuses = sampling.log_status(fmt, M, axis, gap)
    return Result(exact.times(angle, axis), [angle], statuses)


def rotation_errors(fmt, rng, wrap=lambda R: R, matrix_entries=range(9)):
    """Errors of a function of a rotation; wrap puts the matrix among the other inputs."""
    good = wrap(fmt.round_all(exact.exp([mpf("0.3"), mpf("-0.7"), mpf("1.1")])))
    far, reflections = sampling.not_rotations(fmt, rng)
    bands = sampling.spoilt(good, matrix_entries)
    zero = [mpf(0)] * 9
    spoilt_reflection = wrap(["nan"] + reflections[0][1:])
    return bands + [
        Errors(-5, [wrap(R) for R in far + [zero]], "not_rotation"),
        Errors(-6, [wrap(R) for R in reflections], "reflection"),
        Errors(-1, [spoilt_reflection], "reflection_with_nan"),
    ]


def log_bands(fmt, rng):
    build = lambda band: lambda fmt, rng, k: sampling.rotation_of_band(fmt, rng, k, band)
    bands = [Band(name, count, build(name)) for name, count in LOG_BANDS.items()]
    axes = Band("ordinary", 24, lambda fmt, rng, k: sampling.axes_rotation(rng), "axes")
    stretched = [
        fmt.round_all(exact.add(exact.IDENTITY, sampling.symmetric_noise(rng, mpf("0.001")))) for _ in range(4)
    ]
    cyclic = [mpf(x) for x in (0, 0, 1, 1, 0, 0, 0, 1, 0)]
    seed = [mpf(x) for x in (0, -1, 0, 0, 0, -1, 1, 0, 0)]
    quarter = [mpf(x) for x in (0, -1, 0, 1, 0, 0, 0, 0, 1)]
    bands += [
        axes,
        Listed("tiny", [list(exact.IDENTITY)] + stretched, "identity"),
        Listed("example", [cyclic, seed, quarter]),
    ]
    return bands + rotation_errors(fmt, rng)


# Angle, nearest, deviation


def evaluate_angle(fmt, x):
    A, B = x[0:9], x[9:18]
    return Result([exact.angle_between(A, B)], [exact.norm([b - a for a, b in zip(A, B)])])


def angle_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            if band == "tiny" or (band == "small" and k % 2) or (band == "at_pi" and k % 2):
                A, B = sampling.axes_rotation(rng), sampling.rotation_of_band(fmt, rng, k, band)
            else:
                A = sampling.random_rotation(fmt, rng)
                angle = sampling.ANGLES[band](fmt, rng)
                if band == "small":  # anything smaller is lost in the rounding of A
                    angle = magnitude(rng, 64 * fmt.eps, fmt.pick(1e-6, 1e-4))
                B = exact.exp(vector(rng, angle, k))
            return A + fmt.round_all(exact.multiply(A, B))

        return inputs

    def drifted(fmt, rng, k):
        A = sampling.random_rotation(fmt, rng)
        B = exact.multiply(A, exact.exp(vector(rng, magnitude(rng, 1e-3, 3.1), k)))
        return sampling.drift(fmt, rng, A, True) + sampling.drift(fmt, rng, B, True)

    bands = [Band(name, count, build(name)) for name, count in ANGLE_BANDS.items()]
    bands.append(Band("ordinary", 40, drifted, "drift"))
    same = [2 * sampling.random_rotation(fmt, rng) for _ in range(6)]
    bands.append(Listed("tiny", same, "same"))
    other = fmt.round_all(exact.exp([mpf("-1.2"), mpf("0.4"), mpf("0.9")]))
    bands += rotation_errors(fmt, rng, lambda R: other + R, (9, 13, 17))
    return bands + rotation_errors(fmt, rng, lambda R: R + other, (0, 4, 8))


def evaluate_nearest(fmt, M):
    small, large = exact.singular_sum(M)
    R = exact.nearest_rotation(M)
    return Result(R + [norm(exact.subtract(M, R))], [2 * large / small, norm(M) + sqrt(mpf(3))])


def with_singular_values(rng, sigma):
    U, V = (exact.exp(vector(rng, uniform(rng, 0, 3.1))) for _ in range(2))
    S = [sigma[i] if i == j else mpf(0) for i in range(3) for j in range(3)]
    return exact.multiply(U, exact.multiply(S, V))


def positive(M):
    """M if its determinant is positive beyond doubt, in exact arithmetic."""
    if exact.determinant(M) <= 0:
        raise Unclear
    return M


def nearest_bands(fmt, rng):
    least = fmt.pick("1e-12", "1e-5")

    def near(fmt, rng, k):
        R = exact.exp(vector(rng, uniform(rng, 0, 3.2), k))
        spread = magnitude(rng, fmt.eps, 0.1)
        return positive(fmt.round_all(exact.add(R, noise(rng, 9, spread))))

    def generic(fmt, rng, k):
        M = fmt.round_all(noise(rng, 9, mpf(3)))
        det = exact.determinant(M)
        if abs(det) < 0.05:
            raise Unclear
        return M if det > 0 else fmt.round_all(exact.times(mpf(-1), M))

    def ill(fmt, rng, k):
        small = magnitude(rng, least, 0.1)
        sigma = [[mpf(1), mpf(1), small], [mpf(1), small, small], [mpf(1), mp.sqrt(small), small]][k % 3]
        return positive(fmt.round_all(with_singular_values(rng, sigma)))

    def rank_two(fmt, rng, k):
        """Small integers, so that the determinant is zero in any arithmetic; or a zero row or column."""
        if k % 2:
            a, b = ([mpf(rng.getrandbits(4) - 8) for _ in range(3)] for _ in range(2))
            s, t = mpf(rng.getrandbits(2) - 2), mpf(rng.getrandbits(2) - 1)
            rows = [a, b, exact.add(exact.times(s, a), exact.times(t, b))]
            if norm(exact.cross(a, b)) == 0:
                raise Unclear
        else:
            rows = [fmt.round_all(noise(rng, 3, mpf(2))), fmt.round_all(noise(rng, 3, mpf(2))), [mpf(0)] * 3]
            if norm(exact.cross(rows[0], rows[1])) < 0.1:
                raise Unclear
        turn = rng.getrandbits(10) % 3
        M = sum(rows[turn:] + rows[:turn], [])
        return exact.transpose(M) if rng.getrandbits(1) else M

    def scaled(band):
        def inputs(fmt, rng, k):
            M = (near, generic, ill)[k % 3](fmt, rng, k)
            return positive(fmt.round_all(exact.times(sampling.length(fmt, rng, band), M)))

        return inputs

    bands = [
        Band("ordinary", 130, near),
        Band("generic", 100, generic),
        Band("ill_conditioned", 100, ill),
        Band("rank_two", 60, rank_two),
        Band("large", 50, scaled("large")),
        Band("small", 50, scaled("small")),
    ]
    rank_one = [
        [mpf(x * y) for x in a for y in b]
        for a, b in (((1, 2, 3), (2, -1, 5)), ((0, 0, 1), (1, 0, 0)), ((1, 1, 1), (1, 1, 1)), ((-2, 0, 4), (0, 3, 1)))
    ]
    rank_one.append([mpf(0)] * 9)
    _, reflections = sampling.not_rotations(fmt, rng)
    reflections += [fmt.round_all(exact.times(pick(rng, [mpf("1e-3"), mpf("1e3")]), R)) for R in reflections]
    bands += [Errors(-7, rank_one, "rank_one"), Errors(-6, reflections, "reflection")]
    return bands + sampling.spoilt([mpf(x) for x in (1, 2, 0, -1, 3, 1, 0, 1, 4)], range(9))


def evaluate_deviation(fmt, R):
    return Result([exact.deviation(R)], [max(mpf(1), norm(R) ** 2)])


def deviation_bands(fmt, rng):
    def near(fmt, rng, k):
        R = sampling.random_rotation(fmt, rng)
        return R if k % 3 == 0 else fmt.round_all(exact.add(R, noise(rng, 9, magnitude(rng, fmt.eps, 0.1))))

    def scaled(band):
        return lambda fmt, rng, k: fmt.round_all(noise(rng, 9, sampling.length(fmt, rng, band)))

    far, reflections = sampling.not_rotations(fmt, rng)
    bands = [
        Band("ordinary", 280, near),
        Band("large", 100, scaled("large")),
        Band("small", 100, scaled("small")),
        Listed("ordinary", far, "far"),
        Listed("ordinary", reflections, "reflection"),
        Listed("ordinary", [list(exact.IDENTITY), [mpf(0)] * 9], "exact"),
    ]
    return bands + sampling.spoilt(list(exact.IDENTITY), range(9))


def evaluate_check(fmt, x):
    R, tolerance = x[0:9], x[9]
    found = exact.deviation(R)
    if exact.determinant(R) <= 0 or found > tolerance / 4:
        raise Unclear
    return Result([], [])


def check_bands(fmt, rng):
    def accepted(fmt, rng, k):
        R = sampling.random_rotation(fmt, rng)
        if k % 2:
            R = sampling.drift(fmt, rng, R, True)
        return R + [fmt.round(max(exact.deviation(R), fmt.eps) * magnitude(rng, 5, 1e4))]

    def rejected(k):
        R = sampling.drift(fmt, rng, sampling.random_rotation(fmt, rng), True)
        if k % 4 == 0:
            R = fmt.round_all(exact.times(magnitude(rng, 1e-3, 0.9), R))
        found = exact.deviation(R)
        if found < 64 * fmt.eps:
            return rejected(k)
        return R + [fmt.round(found / magnitude(rng, 5, 1e3))]

    def mirrored(k):
        _, reflections = sampling.not_rotations(fmt, rng)
        return reflections[k % 8] + [fmt.round(magnitude(rng, 1e-6, 10))]

    bands = [
        Band("ordinary", 280, accepted),
        Errors(-5, [rejected(k) for k in range(170)], "rejected", "ordinary"),
        Errors(-6, [mirrored(k) for k in range(40)], "reflection"),
    ]
    return bands + sampling.spoilt(list(exact.IDENTITY) + [mpf(1) / 1024], range(9))


def jacobian(name, evaluate):
    return Function(name, 3, [DIAGONAL, OFF_DIAGONAL], evaluate, exp_bands)


FUNCTIONS = [
    Function("so3_hat", 3, all_outputs("all", "max", 9), exact_copy(exact.hat), vector_bands),
    Function("so3_vee", 9, all_outputs("all", "max", 3), exact_copy(exact.vee), vee_bands),
    Function("so3_exp", 3, [DIAGONAL, OFF_DIAGONAL], evaluate_exp, exp_bands),
    Function("so3_log", 9, all_outputs("rotation_vector", "norm", 3), evaluate_log, log_bands),
    jacobian("so3_left_jacobian", evaluate_jacobian(1)),
    jacobian("so3_right_jacobian", evaluate_jacobian(-1)),
    jacobian("so3_left_jacobian_inverse", evaluate_inverse_jacobian(1)),
    jacobian("so3_right_jacobian_inverse", evaluate_inverse_jacobian(-1)),
    Function(
        "so3_multiply", 18, all_outputs("all", "max", 9), evaluate_multiply, lambda fmt, rng: matrix_bands(fmt, rng, 2)
    ),
    Function("so3_transpose", 9, all_outputs("all", "max", 9), exact_copy(exact.transpose), matrix_bands),
    Function(
        "so3_apply",
        12,
        all_outputs("all", "norm", 3),
        evaluate_apply,
        lambda fmt, rng: matrix_bands(fmt, rng, 1, lambda fmt, rng, band, k: sampling.point(fmt, rng, band, k)),
    ),
    Function("so3_angle", 18, all_outputs("angle", "max", 1), evaluate_angle, angle_bands),
    Function(
        "so3_nearest",
        9,
        [Group("rotation", "max", range(9)), Group("distance", "max", [9])],
        evaluate_nearest,
        nearest_bands,
    ),
    Function("so3_deviation", 9, all_outputs("deviation", "max", 1), evaluate_deviation, deviation_bands),
    Function("so3_check", 10, [], evaluate_check, check_bands),
]
