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
    if sampling.close_to_far(R) or sampling.log_ties(fmt, R):
        raise Unclear
    axis, angle, gap = exact.log_axis_angle(R)
    statuses = (0,) if axis is None else sampling.log_status(fmt, R, axis, gap)
    V = exact.pose_log(R, p)
    return Result(V, [angle, norm(V[3:6])], statuses)


def log_translation(fmt, rng, k, R):
    """A translation of any length and direction; sometimes along the axis of R, sometimes zero."""
    if k % 30 == 17:
        return [mpf(0)] * 3
    if k % 12 == 5:
        axis = exact.log_axis_angle(R)[0]
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


# Matrices of twists


def evaluate_hat(fmt, V):
    return Result(exact.twist_matrix(V), [mpf(0)])


def evaluate_vee(fmt, M):
    return Result([M[9], M[2], M[4], M[3], M[7], M[11]], [mpf(0)])


def vee_bands(fmt, rng):
    def inputs(fmt, rng, k):
        M = exact.twist_matrix(point(fmt, rng, "mixed", k) + point(fmt, rng, "mixed"))
        return M[0:12] + (["nan", "inf", mpf(3), mpf(1)] if k % 8 == 7 else M[12:16])

    return [Band("mixed", 300, inputs)]


def evaluate_ad(fmt, V):
    return Result(exact.ad(V), [mpf(0)])


def evaluate_ad_twist(fmt, x):
    V, U = x[0:6], x[6:12]
    return Result(exact.apply6(exact.ad(V), U), [norm(V) * norm(U)])


def evaluate_ad_wrench(fmt, x):
    V, F = x[0:6], x[6:12]
    return Result(exact.apply6(exact.transpose6(exact.ad(V)), F), [norm(V) * norm(F)])


# Rates and steps


def evaluate_body_twist(fmt, x):
    (R, p), (dR, dp) = pose(x[0:16]), pose(x[16:32])
    Rt = exact.transpose(R)
    return Result(exact.vee(exact.multiply(Rt, dR)) + exact.apply(Rt, dp), [norm(dR), norm(dp)])


def evaluate_space_twist(fmt, x):
    (R, p), (dR, dp) = pose(x[0:16]), pose(x[16:32])
    w = exact.vee(exact.multiply(dR, exact.transpose(R)))
    return Result(w + exact.subtract(dp, exact.cross(w, p)), [norm(dR), norm(dp) + norm(dR) * norm(p)])


def rate_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            R = sampling.random_rotation(fmt, rng)
            rate = exact.multiply(R, exact.hat(vector(rng, sampling.length(fmt, rng, band), k)))
            dT = exact.pose_matrix(fmt.round_all(rate), point(fmt, rng, band))
            return sampling.pose_of(fmt, rng, R, point(fmt, rng, band), k) + dT[0:12] + [mpf(0)] * (3 + (k % 2)) + (
                [] if k % 2 else ["nan"]
            )

        return inputs

    bands = [Band(name, count, build(name)) for name, count in ALGEBRA_BANDS.items()]
    dT = [mpf(x) for x in (0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 0)]
    errors = cases_so3.rotation_errors(fmt, rng, lambda R: exact.pose_matrix(R, [mpf(1)] * 3) + dT, range(12))
    return bands + errors + sampling.spoilt(exact.pose_matrix(list(exact.IDENTITY), [mpf(1)] * 3) + dT, range(16, 28))


def far_bands(fmt, rng):
    """Rates of nearly the greatest number along all axes, which a turn by 45 degrees lengthens."""
    turn = fmt.round_all(exact.about_z(pi / 4))
    g = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)
    x = exact.pose_matrix(turn, [mpf(0)] * 3) + exact.pose_matrix([mpf(0)] * 9, [g, g, mpf(0)])
    return rate_bands(fmt, rng) + [Errors(-3, [x], "overflow")]


def relative_log(fmt, A, B):
    """(log(A^-1 B), statuses) of two poses as they are read."""
    (RA, pA), (RB, pB) = pose(A), pose(B)
    if sampling.close_to_far(RA) or sampling.close_to_far(RB):
        raise Unclear
    At = exact.transpose(RA)
    R = exact.multiply(At, RB)
    if sampling.log_ties(fmt, R):
        raise Unclear
    axis, angle, gap = exact.log_axis_angle(R)
    if gap < 64 * fmt.eps and not (gap == 0 and exact.is_exact_turn(RA) and exact.is_exact_turn(RB)):
        raise Unclear  # the product is rounded, and with it the sense of the axis
    V = exact.pose_log(R, exact.apply(At, exact.subtract(pB, pA)))
    return V, ((1,) if gap == 0 else (0,))


def apart(x):
    """|R_B - R_A| of two poses, 2 sqrt(2) sin(theta/2) for rotations."""
    return norm(exact.subtract(pose(x[0:16])[0], pose(x[16:32])[0]))


def evaluate_between(in_body):
    def evaluate(fmt, x):
        V, statuses = relative_log(fmt, x[0:16], x[16:32])
        w, v, pA = apart(x), norm(V[3:6]), norm(pose(x[0:16])[1])
        reach = v
        if not in_body:
            V, reach = exact.apply6(exact.adjoint(*pose(x[0:16])), V), v + w * pA
        size = abs(x[32])
        return Result([y / x[32] for y in V], [w / size, reach / size], statuses)

    return evaluate


def two_poses(fmt, rng, k, band):
    """A pose, and one that is turned against it by an angle of the band and lies anywhere or near."""
    fine = band == "tiny" or (band == "small" and k % 2)  # below eps only a matrix with zeros can tell
    RA = sampling.axes_rotation(rng) if fine else sampling.random_rotation(fmt, rng)
    angle = sampling.ANGLES[band](fmt, rng)
    if band == "small" and not fine:
        angle = sampling.magnitude(rng, 64 * fmt.eps, fmt.pick(1e-6, 1e-4))
    RB = fmt.round_all(exact.multiply(RA, exact.exp(vector(rng, angle, k))))
    if band == "at_pi":
        RB = fmt.round_all(exact.multiply(RA, exact.axis_rotation([mpf(i == k % 3) for i in range(3)], pi)))
    if k % 7 == 5 and not fine:
        RA = sampling.drift(fmt, rng, RA, True)
    pA = point(fmt, rng, "ordinary" if k % 2 else "mixed")
    pB = point(fmt, rng, "ordinary" if k % 2 else "mixed")
    if k % 3 == 1:
        pB = fmt.round_all([x * (1 + sampling.magnitude(rng, fmt.eps, "0.1") * sampling.sign(rng)) for x in pA])
    return sampling.pose_of(fmt, rng, RA, pA, k) + sampling.pose_of(fmt, rng, RB, pB, k + 3)


STEP_BANDS = {"tiny": 60, "small": 80, "moderate": 70, "ordinary": 110, "near_pi": 75}


def pair_errors(fmt, rng, last):
    """Errors of a function of two poses and more numbers."""
    p = [mpf(1), mpf(-2), mpf(3)]
    good = exact.pose_matrix(fmt.round_all(exact.exp([mpf("0.3"), mpf("-0.7"), mpf("1.1")])), p)
    wraps = [lambda R: exact.pose_matrix(R, p) + good + last, lambda R: good + exact.pose_matrix(R, p) + last]
    entries = list(range(12))
    bands = cases_so3.rotation_errors(fmt, rng, wraps[0], entries)
    bands += [Errors(-5, [wraps[1](R) for R in sampling.not_rotations(fmt, rng)[0]], "second_not_rotation")]
    more = list(range(16, 28)) + list(range(32, 32 + len(last)))
    bands += sampling.spoilt(good + good + last, more)
    return bands


def far_apart(fmt, last):
    """Two origins whose distance is beyond the format."""
    g = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)
    poses = [exact.pose_matrix(list(exact.IDENTITY), [s * g, mpf(0), mpf(1)]) for s in (1, -1)]
    return Errors(-3, [poses[0] + poses[1] + last, poses[1] + poses[0] + last], "overflow")


def half_turns(fmt, rng, last):
    """Exact half-turns between exact rotations."""

    def inputs(fmt, rng, k):
        RA = sampling.axes_rotation(rng)
        flip = [mpf(0 if i % 4 else 1 if i == 4 * (k % 3) else -1) for i in range(9)]
        RB = exact.multiply(RA, flip)
        p = [point(fmt, rng, "ordinary") for _ in range(2)]
        return exact.pose_matrix(RA, p[0]) + exact.pose_matrix(RB, p[1]) + last(fmt, rng, k)

    return Band("at_pi", 30, inputs)


def between_bands(fmt, rng):
    step = lambda fmt, rng, k: [fmt.round(sampling.sign(rng) * sampling.magnitude(rng, "1e-4", 10))]

    def build(band):
        return lambda fmt, rng, k: two_poses(fmt, rng, k, band) + step(fmt, rng, k)

    bands = [Band(name, count, build(name)) for name, count in STEP_BANDS.items()] + [half_turns(fmt, rng, step)]
    still = exact.pose_matrix(sampling.random_rotation(fmt, rng), [mpf(1), mpf(2), mpf(3)])
    bands.append(Listed("tiny", [still + still + [mpf(1)]], "still"))
    stopped = [still + still + [zero] for zero in (mpf(0), "-0")]
    return bands + pair_errors(fmt, rng, [mpf(1)]) + [Errors(-11, stopped, "no_time"), far_apart(fmt, [mpf(1)])]


def evaluate_interpolate(fmt, x):
    s = x[32]
    V, statuses = relative_log(fmt, x[0:16], x[16:32])
    end, share = (pose(x[16:32]), s - 1) if s > mpf("0.5") else (pose(x[0:16]), s)
    turn = max(mpf(1), abs(share) * norm(V[0:3]))
    scales = [turn, turn * (norm(end[1]) + abs(share) * norm(V[3:6])), mpf(0)]
    return Result(exact.pose_matrix(*exact.compose(end, exact.pose_exp(exact.times(share, V)))), scales, statuses)


def interpolate_bands(fmt, rng):
    def share(fmt, rng, k):
        kind = k % 5
        if kind == 0:
            return [sampling.pick(rng, [mpf(0), mpf(1), mpf("0.5"), "-0"])]
        if kind == 1:
            return [fmt.round(sampling.sign(rng) * sampling.magnitude(rng, 1, 100))]
        return [fmt.round(sampling.uniform(rng, 0, 1))]

    def build(band):
        return lambda fmt, rng, k: two_poses(fmt, rng, k, band) + share(fmt, rng, k // 3)

    bands = [Band(name, count, build(name)) for name, count in STEP_BANDS.items()] + [half_turns(fmt, rng, share)]
    quarter = exact.pose_matrix([mpf(x) for x in (0, -1, 0, 1, 0, 0, 0, 0, 1)], [mpf(1), mpf(0), mpf(2)])
    start = exact.pose_matrix(list(exact.IDENTITY), [mpf(0)] * 3)
    limit = sampling.angle_max(fmt)
    far = [start + quarter + [fmt.round(s * limit)] for s in (10, -10)]
    return bands + pair_errors(fmt, rng, [mpf("0.25")]) + [
        Listed("example", [start + quarter + [mpf(k) / 4] for k in range(-2, 8)]),
        Errors(-4, far, "angle_range"),
        far_apart(fmt, [mpf("0.25")]),
    ]


def evaluate_distance(fmt, x):
    (RA, pA), (RB, pB) = pose(x[0:16]), pose(x[16:32])
    if sampling.close_to_far(RA) or sampling.close_to_far(RB):
        raise Unclear
    angle, length = exact.angle_between(RA, RB), norm(exact.subtract(pA, pB))
    return Result([angle, length], [apart(x), length])


def evaluate_weighted_distance(fmt, x):
    angle, length = evaluate_distance(fmt, x).outputs
    return Result([norm([x[32] * angle, length])], [norm([x[32] * apart(x), length])])


def distance_bands(scales):
    def bands(fmt, rng):
        scale = lambda fmt, rng, k: [fmt.round(sampling.length(fmt, rng, "ordinary")) if k % 9 else mpf(0)][:scales]

        def build(band):
            return lambda fmt, rng, k: two_poses(fmt, rng, k, band) + scale(fmt, rng, k)

        last, still = [mpf(2)][:scales], exact.pose_matrix(sampling.random_rotation(fmt, rng), [mpf(1), mpf(2), mpf(3)])
        made = [Band(name, count, build(name)) for name, count in cases_so3.ANGLE_BANDS.items()]
        made += [Listed("tiny", [still + still + last], "still"), far_apart(fmt, last)]
        if scales:
            made.append(Errors(-11, [still + still + [mpf(-1)]], "negative_scale"))
        return made + pair_errors(fmt, rng, last)

    return bands


# Jacobians


def jacobian_result(rotation, coupling, scales):
    return Result(exact.blocks(rotation, [mpf(0)] * 9, coupling, rotation), scales)


def evaluate_jacobian(side):
    def evaluate(fmt, V):
        w, v = V[0:3], V[3:6]
        J, Q = exact.left_jacobian6(exact.times(side, V))
        return jacobian_result(J, Q, cases_so3.exp_scales(w) + [norm(v), mpf(0)])

    return evaluate


def evaluate_inverse_jacobian(side):
    def evaluate(fmt, V):
        w, v = V[0:3], V[3:6]
        rotation = cases_so3.evaluate_inverse_jacobian(side)(fmt, w)
        growth = rotation.scales[0]
        P = exact.left_jacobian6_inverse(exact.times(side, V))[1]
        return jacobian_result(rotation.outputs, P, rotation.scales + [growth**2 * norm(v), mpf(0)])

    return evaluate


def jacobian_bands(fmt, rng):
    return [band for band in exp_bands(fmt, rng) if band.label != "overflow"]


def entries(rows, columns):
    return [6 * i + j for i in rows for j in columns]


JACOBIAN = [
    Group("diagonal", "max", [7 * i for i in range(6)]),
    Group("off_diagonal", "max", [6 * (3 * b + i) + 3 * b + j for b in (0, 1) for i in range(3) for j in range(3) if i != j]),
    Group("coupling", "max", entries(range(3, 6), range(3))),
    Group("zero", "max", entries(range(3), range(3, 6))),
]


def jacobian(name, evaluate):
    return Function(name, 6, JACOBIAN, evaluate, jacobian_bands)


TWIST = [Group("rotation", "norm", (0, 1, 2)), Group("translation", "norm", (3, 4, 5))]
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
    Function("se3_hat", 6, all_outputs("all", "max", 16), evaluate_hat, twist_bands(1)),
    Function("se3_vee", 16, all_outputs("all", "max", 6), evaluate_vee, vee_bands),
    Function("se3_ad", 6, ADJOINT, evaluate_ad, twist_bands(1)),
    Function("se3_ad_twist", 12, SIX, evaluate_ad_twist, twist_bands(2)),
    Function("se3_ad_wrench", 12, SIX, evaluate_ad_wrench, twist_bands(2)),
    Function("se3_body_twist", 32, TWIST, evaluate_body_twist, far_bands),
    Function("se3_space_twist", 32, TWIST, evaluate_space_twist, rate_bands),
    Function("se3_body_twist_between", 33, TWIST, evaluate_between(True), between_bands),
    Function("se3_space_twist_between", 33, TWIST, evaluate_between(False), between_bands),
    Function("se3_interpolate", 33, POSE, evaluate_interpolate, interpolate_bands),
    Function(
        "se3_distance",
        32,
        [Group("angle", "max", [0]), Group("length", "max", [1])],
        evaluate_distance,
        distance_bands(0),
    ),
    Function(
        "se3_weighted_distance", 33, [Group("distance", "max", [0])], evaluate_weighted_distance, distance_bands(1)
    ),
    jacobian("se3_left_jacobian", evaluate_jacobian(1)),
    jacobian("se3_right_jacobian", evaluate_jacobian(-1)),
    jacobian("se3_left_jacobian_inverse", evaluate_inverse_jacobian(1)),
    jacobian("se3_right_jacobian_inverse", evaluate_inverse_jacobian(-1)),
]
