"""se3.h: poses, twists and wrenches."""

from mpmath import ldexp, mpf, pi

import cases_so3
import exact
import sampling
from exact import norm, pose
from sampling import direction, point, random_pose, vector
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear, all_outputs

ALGEBRA_BANDS = {"ordinary": 205, "large": 100, "small": 100, "mixed": 100}
ROTATION = Group("rotation", "max", (0, 1, 2, 4, 5, 6, 8, 9, 10))
TRANSLATION = Group("translation", "norm", (3, 7, 11))
LAST_ROW = Group("last_row", "max", (12, 13, 14, 15))
POSE = [ROTATION, TRANSLATION, LAST_ROW]


def algebra_bands(poses, vectors=0):
    """Bands of `poses` poses followed by `vectors` vectors, each length of the band's own."""

    def bands(fmt, rng):
        def build(band):
            def inputs(fmt, rng, k):
                x = []
                for i in range(poses):
                    x += random_pose(fmt, rng, band, k + i)
                for _ in range(vectors):
                    x += point(fmt, rng, band)
                return x

            return inputs

        return [Band(name, count, build(name)) for name, count in ALGEBRA_BANDS.items()]

    return bands


def twist_bands(twists):
    """Bands of twists or wrenches, their halves of unrelated lengths of the band's own."""
    return algebra_bands(0, 2 * twists)


def evaluate_from_parts(fmt, x):
    return Result(exact.pose_matrix(x[0:9], x[9:12]), [mpf(0)])


def from_parts_bands(fmt, rng):
    def build(band):
        return lambda fmt, rng, k: sampling.random_rotation(fmt, rng) + point(fmt, rng, band, k)

    return [Band(name, count, build(name)) for name, count in ALGEBRA_BANDS.items()]


def evaluate_to_parts(fmt, x):
    R, p = pose(x)
    return Result(R + p, [mpf(0)])


def evaluate_compose(fmt, x):
    A, B = pose(x[0:16]), pose(x[16:32])
    size = norm(A[0])
    scales = [size * norm(B[0]), size * norm(B[1]) + norm(A[1]), mpf(0)]
    return Result(exact.pose_matrix(*exact.compose(A, B)), scales)


def evaluate_inverse(fmt, x):
    A = pose(x)
    return Result(exact.pose_matrix(*exact.inverse(A)), [mpf(0), norm(A[0]) * norm(A[1]), mpf(0)])


def evaluate_apply(fmt, x):
    (R, p), v = pose(x[0:16]), x[16:19]
    return Result(exact.add(exact.apply(R, v), p), [norm(R) * norm(v) + norm(p)])


def adjoint_size(R, p):
    return norm(R) * (1 + norm(p))


def evaluate_adjoint(matrix):
    def evaluate(fmt, x):
        R, p = pose(x)
        return Result(matrix(R, p), [adjoint_size(R, p)])

    return evaluate


def evaluate_adjoint_on(matrix):
    """A 6x6 matrix of a pose applied to a twist or wrench."""

    def evaluate(fmt, x):
        (R, p), V = pose(x[0:16]), x[16:22]
        return Result(exact.apply6(matrix(R, p), V), [adjoint_size(R, p) * norm(V)])

    return evaluate


def wrench_matrix(R, p):
    """F_a = Ad^-T F_b, so that power is the same in both frames."""
    return exact.transpose6(exact.adjoint_inverse(R, p))


def inverse_wrench_matrix(R, p):
    return exact.transpose6(exact.adjoint(R, p))


# exp and log


def evaluate_exp(fmt, V):
    w, v = V[0:3], V[3:6]
    R, p = exact.pose_exp(V)
    within_pi = norm(w) <= pi * (1 + 16 * fmt.eps)
    return Result(exact.pose_matrix(R, p), cases_so3.exp_scales(w) + [norm(p) if within_pi else norm(v), mpf(0)])


def exp_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            w = sampling.rotation_vector(fmt, rng, k, band)
            v = fmt.round_all(exact.times(sampling.length(fmt, rng), direction(rng, k // 10)))
            if k % 12 == 5 and norm(w):  # nearly along the axis
                v = fmt.round_all(exact.times(sampling.length(fmt, rng) / norm(w), w))
            if k % 30 == 17:
                v = [mpf(0)] * 3
            return w + v

        return inputs

    bands = [Band(name, count, build(name)) for name, count in cases_so3.EXP_BANDS.items()]
    zero = [mpf(0)] * 3
    translations = [zero + point(fmt, rng, "mixed", k) for k in range(10)] + [zero + zero, ["-0"] * 6]
    bands.append(Listed("tiny", translations, "pure_translation"))
    quarter = fmt.round(pi / 2)
    example = [[0, 1, 2, 3, 0, 0], [0, 2, 2, 4, 0, 0], [0, 0, quarter, 1, 0, 0], [0, 0, 1, 0, 0, 5]]
    bands.append(Listed("example", [[mpf(x) for x in V] for V in example]))
    bands += sampling.spoilt([mpf(x) for x in (1, "0.5", -2, 3, 4, 5)], range(6))
    limit = sampling.angle_max(fmt)
    large = [fmt.round_all(vector(rng, limit * f, k)) + point(fmt, rng) for k, f in enumerate([5, 100, 10**6])]
    greatest = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)
    # |J v| = 0.9 |v|, and it points along y: 1.27 times the greatest number.
    overflow = [
        [mpf(0), mpf(0), quarter, greatest, greatest, mpf(0)],
        [mpf(0), quarter, mpf(0), greatest, mpf(0), -greatest],
    ]
    return bands + [Errors(-4, large, "angle_range"), Errors(-3, overflow, "overflow")]


def evaluate_log(fmt, T):
    R, p = pose(T)
    if sampling.close_to_far(R) or sampling.column_ties(fmt, R):
        raise Unclear
    axis, angle, gap = exact.axis_angle(R)
    statuses = (0,) if axis is None else sampling.log_status(fmt, R, axis, gap)
    V = exact.pose_log(R, p)
    return Result(V, [angle, norm(V[3:6])], statuses)


def log_translation(fmt, rng, k, R):
    """A translation of any length and direction; sometimes along the axis of R, sometimes zero."""
    if k % 30 == 17:
        return [mpf(0)] * 3
    if k % 12 == 5:
        axis = exact.axis_angle(R)[0]
        if axis:
            return fmt.round_all(exact.times(sampling.length(fmt, rng), axis))
    return point(fmt, rng, "mixed", k // 10)


def pose_bands(counts, build_pose):
    """Bands of poses with a rotation of the band."""

    def build(band):
        def inputs(fmt, rng, k):
            return build_pose(fmt, rng, k, sampling.rotation_of_band(fmt, rng, k, band))

        return inputs

    return [Band(name, count, build(name)) for name, count in counts.items()]


def log_bands(fmt, rng):
    def build_pose(fmt, rng, k, R):
        return sampling.pose_of(fmt, rng, R, log_translation(fmt, rng, k, R), k)

    bands = pose_bands(cases_so3.LOG_BANDS, build_pose)
    identity = list(exact.IDENTITY)
    translations = [exact.pose_matrix(identity, point(fmt, rng, "mixed", k)) for k in range(12)]
    translations.append(exact.pose_matrix(identity, [mpf(0)] * 3))
    bands.append(Listed("tiny", translations, "pure_translation"))
    bands.append(Listed("example", example_poses(fmt)))
    p = [mpf(1), mpf(-2), mpf(3)]
    bands += cases_so3.rotation_errors(
        fmt, rng, lambda R: exact.pose_matrix(R, p), (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11)
    )
    greatest = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)
    half = [mpf(x) for x in (-1, 0, 0, 0, -1, 0, 0, 0, 1)]
    # The half-turn stretches what is across its axis by pi / 2.
    overflow = [
        exact.pose_matrix(half, [greatest, mpf(0), mpf(0)]),
        exact.pose_matrix(half, [mpf(0), -greatest, mpf(0)]),
    ]
    return bands + [Errors(-3, overflow, "overflow")]


def example_poses(fmt):
    """Poses with a screw that can be found by hand."""
    cyclic = [mpf(x) for x in (0, -1, 0, 0, 0, -1, 1, 0, 0)]
    quarter = [mpf(x) for x in (0, -1, 0, 1, 0, 0, 0, 0, 1)]
    half = [mpf(x) for x in (-1, 0, 0, 0, -1, 0, 0, 0, 1)]
    number = lambda *p: [mpf(x) for x in p]
    # The worked example of a screw from a pose: 2 pi / 3 about (1, -1, 1); then turns about a line parallel to z.
    return [
        exact.pose_matrix(cyclic, number(3, 0, 0)),
        exact.pose_matrix(quarter, number(1, 0, 0)),
        exact.pose_matrix(quarter, number(2, 0, 5)),
        exact.pose_matrix(half, number(4, 2, 1)),
    ]


ADJOINT = all_outputs("all", "max", 36)
SIX = all_outputs("all", "norm", 6)

FUNCTIONS = [
    Function("se3_from_parts", 12, all_outputs("all", "max", 16), evaluate_from_parts, from_parts_bands),
    Function("se3_to_parts", 16, all_outputs("all", "max", 12), evaluate_to_parts, algebra_bands(1)),
    Function("se3_compose", 32, POSE, evaluate_compose, algebra_bands(2)),
    Function("se3_inverse", 16, POSE, evaluate_inverse, algebra_bands(1)),
    Function("se3_apply", 19, all_outputs("all", "norm", 3), evaluate_apply, algebra_bands(1, 1)),
    Function(
        "se3_exp",
        6,
        [Group("diagonal", "max", (0, 5, 10)), Group("off_diagonal", "max", (1, 2, 4, 6, 8, 9)), TRANSLATION, LAST_ROW],
        evaluate_exp,
        exp_bands,
    ),
    Function(
        "se3_log",
        16,
        [Group("rotation_vector", "norm", (0, 1, 2)), Group("translation", "norm", (3, 4, 5))],
        evaluate_log,
        log_bands,
    ),
    Function("se3_adjoint", 16, ADJOINT, evaluate_adjoint(exact.adjoint), algebra_bands(1)),
    Function("se3_adjoint_inverse", 16, ADJOINT, evaluate_adjoint(exact.adjoint_inverse), algebra_bands(1)),
    Function("se3_adjoint_twist", 22, SIX, evaluate_adjoint_on(exact.adjoint), algebra_bands(1, 2)),
    Function("se3_adjoint_inverse_twist", 22, SIX, evaluate_adjoint_on(exact.adjoint_inverse), algebra_bands(1, 2)),
    Function("se3_adjoint_wrench", 22, SIX, evaluate_adjoint_on(wrench_matrix), algebra_bands(1, 2)),
    Function("se3_adjoint_inverse_wrench", 22, SIX, evaluate_adjoint_on(inverse_wrench_matrix), algebra_bands(1, 2)),
]
