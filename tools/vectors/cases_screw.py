"""screw.h: screw parameters of a pose and back, pitch. A screw is axis[3] point[3] translation angle."""

from mpmath import inf, ldexp, mpf, pi, sin, sqrt

import cases_se3
import cases_so3
import exact
import sampling
from exact import norm, pose
from sampling import direction, magnitude, pick, sign
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear, all_outputs

SCREW = [
    Group("axis", "norm", (0, 1, 2)),
    Group("point", "norm", (3, 4, 5)),
    Group("translation", "max", [6]),
    Group("angle", "max", [7]),
]
Z_AXIS = [mpf(0), mpf(0), mpf(1)]


def pure_translation(p):
    """(screw, status) of a displacement without rotation."""
    size = norm(p)
    if size == 0:
        return Z_AXIS + [mpf(0)] * 5, 3
    return exact.unit(p) + [mpf(0)] * 3 + [size, mpf(0)], 2


def evaluate_from_pose(fmt, T):
    R, p = pose(T)
    if sampling.close_to_far(R) or sampling.column_ties(fmt, R):
        raise Unclear
    axis, angle, gap = exact.axis_angle(R)
    if axis is not None:
        point, translation = exact.screw_of_rotation(axis, angle, exact.times(mpf("0.5"), p), p)
        point_scale = norm(p) / (2 * sin(angle / 2))
        if point_scale < ldexp(1, fmt.greatest - 8):
            scales = [mpf(1), point_scale, norm(p), angle]
            return Result(axis + point + [translation, angle], scales, sampling.log_status(fmt, R, axis, gap))
        if max(abs(a) for a in point) < ldexp(1, fmt.greatest + 8):
            raise Unclear
        # The point would overflow: to the format, this is a pure translation.
    screw, status = pure_translation(p)
    return Result(screw, [mpf(1), mpf(0), norm(p), mpf(0)], (status,))


def from_pose_bands(fmt, rng):
    def build_pose(fmt, rng, k, R):
        p = cases_se3.log_translation(fmt, rng, k, R)
        axis, angle, _ = exact.axis_angle(R)
        room = angle * fmt.pick(mpf("1e280"), mpf("1e35"))
        if norm(p) > room:
            least, greatest = (mpf(x) for x in fmt.pick(*sampling.LENGTHS["mixed"]))
            p = fmt.round_all(exact.times(magnitude(rng, min(least, room), min(room, greatest)), direction(rng)))
        return sampling.pose_of(fmt, rng, R, p, k)

    bands = cases_se3.pose_bands(cases_so3.LOG_BANDS, build_pose)
    identity = list(exact.IDENTITY)
    stretched = fmt.round_all(exact.add(identity, sampling.symmetric_noise(rng, mpf("0.001"))))
    still = [
        exact.pose_matrix(R, sampling.point(fmt, rng, "mixed", k)) for k in range(12) for R in (identity, stretched)
    ]
    still += [exact.pose_matrix(R, [mpf(0)] * 3) for R in (identity, stretched)]
    bands.append(Listed("tiny", still, "pure_translation"))
    theta, reach = fmt.pick((mpf("1e-300"), mpf("1e100")), (mpf("1e-37"), mpf("1e12")))
    turn = fmt.round_all(exact.exp(exact.times(theta, Z_AXIS)))
    away = [exact.pose_matrix(turn, fmt.round_all(p)) for p in ([reach, 0, 0], [0, -reach, 0], [-reach, reach / 2, 0])]
    bands.append(Listed("tiny", away, "point_out_of_range"))
    quarter = [mpf(x) for x in (0, -1, 0, 1, 0, 0, 0, 0, 1)]
    # A quarter turn about the line parallel to z through (1, 2, 0), and 3 along it.
    bands.append(
        Listed("example", cases_se3.example_poses(fmt) + [exact.pose_matrix(quarter, [mpf(3), mpf(1), mpf(3)])])
    )
    wrap = lambda R: exact.pose_matrix(R, [mpf(1), mpf(-2), mpf(3)])
    return bands + cases_so3.rotation_errors(fmt, rng, wrap, range(12))


def evaluate_to_pose(fmt, x):
    axis, point, translation, angle = x[0:3], x[3:6], x[6], x[7]
    if norm(axis) == 0:  # neither angle nor translation: the bands see to that
        return Result(exact.pose_matrix(list(exact.IDENTITY), [mpf(0)] * 3), [mpf(1), mpf(0), mpf(0)])
    R, p = exact.screw_pose(exact.unit(axis), point, translation, angle)
    reach = abs(translation) + min(abs(angle), mpf(2)) * norm(point)
    return Result(exact.pose_matrix(R, p), [mpf(1), reach, mpf(0)])


def screw_axis(fmt, rng, k):
    """An axis of unit length to rounding, or of any length."""
    size = mpf(1) if k % 3 else sampling.length(fmt, rng)
    return fmt.round_all(exact.times(size, direction(rng, k)))


def to_pose_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            angle = fmt.round(sign(rng) * sampling.ANGLES[band](fmt, rng))
            point = sampling.point(fmt, rng, "mixed", k // 10)
            translation = fmt.round(sign(rng) * sampling.length(fmt, rng))
            if k % 10 == 3:
                translation = mpf(0)
            if k % 10 == 6:
                point = [mpf(0)] * 3
            return screw_axis(fmt, rng, k // 2) + point + [translation, angle]

        return inputs

    bands = [Band(name, count, build(name)) for name, count in cases_so3.EXP_BANDS.items()]
    number = lambda *x: fmt.round_all([mpf(y) for y in x])
    greatest = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)
    least = ldexp(1, fmt.least)
    no_turn = [
        screw_axis(fmt, rng, k) + sampling.point(fmt, rng) + [fmt.round(sampling.length(fmt, rng)), mpf(0)]
        for k in range(6)
    ]
    odd_axes = [
        number(least, 0, 0, 1, 2, 3, 4, 1),
        number(0, -3 * least, 4 * least, 1, 2, 3, 4, 1),
        number(greatest, -greatest, greatest, 1, 2, 3, 4, 1),
        number(0, greatest, least, 1, 2, 3, 4, 1),
    ]
    bands += [
        Listed("tiny", no_turn, "pure_translation"),
        Listed("tiny", [number(0, 0, 0, 1, 2, 3, 0, 0)], "no_axis"),
        Listed("ordinary", odd_axes, "extreme_axis"),
    ]
    root = sqrt(mpf(2))
    bands.append(
        Listed(
            "example",
            [
                number(0, 1, 1, 0, 1, -1, 0, 2 * root),
                number(0, 0, 1, 1, 2, 0, 3, pi / 2),
                number(1, -1, 1, 1, 1, 0, sqrt(mpf(3)), 2 * pi / 3),
            ],
        )
    )
    bands += sampling.spoilt(number(0, 0, 1, 1, 2, 3, 4, 1), range(8))
    limit = sampling.angle_max(fmt)
    beyond = [number(1, 2, 3, 1, 1, 1, 1, s * f * limit) for s, f in ((1, 5), (-1, 5), (1, 1000), (-1, mpf(10) ** 20))]
    no_axis = [number(0, 0, 0, 1, 2, 3, 0, 1), number(0, 0, 0, 1, 2, 3, 1, 0), number(0, 0, 0, 0, 0, 0, -2, -3)]
    # A half-turn takes the origin to twice the point.
    overflow = [number(0, 0, 1, greatest, 0, 0, 0, pi), number(1, 0, 0, 0, 0, -greatest, 1, -pi)]
    return bands + [
        Errors(-4, beyond, "angle_range"),
        Errors(-7, no_axis, "no_axis_error"),
        Errors(-3, overflow, "overflow"),
    ]


def evaluate_pitch(fmt, x):
    translation, angle = x[6], x[7]
    if angle == 0:
        pitch = mpf(0) if translation == 0 else sign_of(translation) * inf
        return Result([pitch], [mpf(0)], (3 if translation == 0 else 2,))
    pitch = translation / angle
    return Result([pitch], [abs(pitch)])


def sign_of(x):
    return 1 if x > 0 else -1


def pitch_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            translation, angle = (sign(rng) * sampling.length(fmt, rng, band) for _ in range(2))
            if band != "mixed":
                angle = sign(rng) * magnitude(rng, 1e-6, 1000)
            axis = fmt.round_all(direction(rng, k))
            return axis + sampling.point(fmt, rng, band) + fmt.round_all([translation, angle])

        return inputs

    bands = [
        Band(name, count, build(name))
        for name, count in {"ordinary": 200, "large": 90, "small": 90, "mixed": 110}.items()
    ]
    base = [mpf(x) for x in (0, "0.75", 1, 1, 2, 3)]
    reach = fmt.pick(mpf("1e200"), mpf("1e25"))
    endless = [base + [fmt.round(u), zero] for u in (mpf(5), mpf(-5), reach, -1 / reach) for zero in (mpf(0), "-0")]
    still = [base + [u, t] for u in (mpf(0), "-0") for t in (mpf(0), "-0")]
    turns = [base + [mpf(0), t] for t in (mpf(1), mpf(-2))]
    bands += [
        Listed("degenerate", endless, "pure_translation"),
        Listed("degenerate", still, "no_motion"),
        Listed("ordinary", turns, "pure_rotation"),
    ]
    number = lambda *x: fmt.round_all([mpf(y) for y in x])
    bands.append(
        Listed(
            "example",
            [
                number(0, 1, 1, 0, 1, -1, 0, 2 * sqrt(mpf(2))),
                number(0, 0, 1, 1, 2, 0, 3, pi / 2),
                number(1, -1, 1, 1, 1, 0, sqrt(mpf(3)), 2 * pi / 3),
            ],
        )
    )
    overflow = [base + number(s * reach, t / reach) for s in (1, -1) for t in (1, -1)]
    return bands + [Errors(-3, overflow, "overflow")] + sampling.spoilt(base + [mpf(1), mpf(2)], (6, 7))


# Screw axes S = (omega; v)

AXIS = [Group("rotation", "norm", (0, 1, 2)), Group("translation", "norm", (3, 4, 5))]
SIZES = {"ordinary": 205, "large": 100, "small": 100, "mixed": 105}


def helical(q, s, h):
    e = exact.unit(s)
    return Result(e + exact.add(exact.cross(q, e), exact.times(h, e)), [mpf(1), norm(q) + abs(h)])


def prismatic(s, sense=1, status=2):
    return Result([mpf(0)] * 3 + exact.times(sense, exact.unit(s)), [mpf(0), mpf(1)], (status,))


def evaluate_helical(fmt, x):
    h = x[6]
    if h in ("inf", "-inf"):
        return prismatic(x[3:6], 1 if h == "inf" else -1)
    return helical(x[0:3], x[3:6], h)


def evaluate_revolute(fmt, x):
    return helical(x[0:3], x[3:6], mpf(0))


def evaluate_prismatic(fmt, x):
    return prismatic(x, 1, 0)


def joint_bands(points, pitch):
    """Bands of a joint: `points` points, a direction and, where there is one, a pitch."""

    def bands(fmt, rng):
        def build(band):
            def inputs(fmt, rng, k):
                x = [y for _ in range(points) for y in sampling.point(fmt, rng, band)] + screw_axis(fmt, rng, k)
                if pitch:
                    x.append(mpf(0) if k % 7 == 3 else fmt.round(sign(rng) * sampling.length(fmt, rng, band)))
                return x

            return inputs

        number = lambda *x: fmt.round_all([mpf(y) for y in x])
        q, h = number(1, -2, 3)[: 3 * points], number(2) if pitch else []
        greatest, least = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest), ldexp(1, fmt.least)
        odd = [q + d + h for d in (number(least, 0, -least), [greatest, -greatest, greatest], number(0, 0, 3 * least))]
        made = [Band(name, count, build(name)) for name, count in SIZES.items()]
        made.append(Listed("ordinary", odd, "extreme_axis"))
        made.append(Errors(-7, [q + [mpf(0)] * 3 + h, q + [mpf(0), "-0", mpf(0)] + h], "no_axis"))
        made += sampling.spoilt(q + number(2, -1, 2) + h, range(3 * points + 3))
        if points:
            far = [greatest, greatest, mpf(0)]
            made.append(Errors(-3, [far + number(1, -1, 0) + h, far + number(-1, 1, 0) + h], "overflow"))
        return made

    return bands


def helical_bands(fmt, rng):
    endless = [
        sampling.point(fmt, rng, "mixed") + screw_axis(fmt, rng, k) + [pick(rng, ["inf", "-inf"])] for k in range(12)
    ]
    base = [mpf(x) for x in (1, 2, 3, 0, 1, 0)]
    bad = [base + ["nan"], base[:5] + ["inf", "nan"]]
    no_axis = [base[:3] + [mpf(0)] * 3 + ["inf"]]
    return joint_bands(1, True)(fmt, rng) + [
        Listed("degenerate", endless, "infinite_pitch"),
        Errors(-1, bad, "nan_pitch"),
        Errors(-7, no_axis, "no_axis_infinite_pitch"),
    ]


def axis_reach(S):
    """|v| / |omega|, the scale of all that is told of an axis's place."""
    return norm(S[3:6]) / norm(S[0:3])


def evaluate_axis_parts(fmt, S):
    if norm(S[0:3]) == 0:
        return Result([mpf(0)] * 3 + exact.unit(S[3:6]) + [inf], [mpf(0), mpf(1), mpf(0)], (2,))
    (d, m), h = exact.axis_line(S)
    return Result(exact.cross(d, m) + d + [h], [axis_reach(S), mpf(1), axis_reach(S)])


def evaluate_axis_pitch(fmt, S):
    full = evaluate_axis_parts(fmt, S)
    return Result(full.outputs[6:], full.scales[2:], full.statuses)


def evaluate_axis_line(fmt, S):
    (d, m), _ = exact.axis_line(S)
    return Result(d + m, [mpf(1), axis_reach(S)])


def axis_bands(translations):
    """Screws of any pitch; `translations` says what becomes of those without rotation."""

    def bands(fmt, rng):
        def build(band):
            def inputs(fmt, rng, k):
                w = exact.times(1 if k % 3 else sampling.length(fmt, rng, band), direction(rng, k // 3))
                q, h = sampling.point(fmt, rng, band), sign(rng) * sampling.length(fmt, rng, band)
                along = mpf(0) if k % 5 == 2 else h  # pure rotations
                v = exact.add(exact.cross(q, w), exact.times(along, w))
                if k % 5 == 4:  # nearly nothing but pitch
                    v = exact.times(h, w)
                return fmt.round_all(w) + fmt.round_all(v)

            return inputs

        zero, reach = [mpf(0)] * 3, fmt.pick(mpf("1e200"), mpf("1e25"))
        least = ldexp(1, fmt.least)
        slow = [fmt.round_all([least * 2**k, 0, -3 * least * 2**k, 5 * least * 2**k, 2 * least, 7 * least * 2**k]) for k in range(0, 90, 8)]
        number = lambda *x: fmt.round_all([mpf(y) for y in x])
        root = 1 / sqrt(mpf(3))
        worked = [number(0, 2, 2, 4, 0, 0), number(root, -root, root, "1.0548150985", "-1.0548150985", "-0.6772357091")]
        worked.append(number(0, 1, 2, 3, 0, 0))
        travel = [zero + sampling.point(fmt, rng, "mixed", k) for k in range(12)]
        still, beyond = [zero + zero, ["-0"] * 6], [fmt.round_all([1 / reach, 0, 0, reach, 0, 1])]
        made = [Band(name, count, build(name)) for name, count in SIZES.items()]
        made.append(Listed("example", worked))
        made += sampling.spoilt(number(1, "0.5", -2, 3, 4, 5), range(6))
        return made + translations(travel, still, beyond, slow)

    return bands


def listed_translations(travel, still, beyond, slow):
    return [
        Listed("tiny", slow, "slow"),
        Listed("degenerate", travel, "pure_translation"),
        Errors(-7, still, "no_screw"),
        Errors(-3, beyond, "overflow"),
    ]


def refused_translations(travel, still, beyond, slow):
    slow_turn, _, _, speed, _, _ = beyond[0]
    beyond = [[slow_turn, mpf(0), mpf(0), mpf(0), speed, mpf(0)]]
    return [
        Listed("tiny", slow, "slow"),
        Errors(-7, travel + still, "no_line"), Errors(-3, beyond, "overflow")]


def normalized_translations(travel, still, beyond, slow):
    return [
        Listed("degenerate", travel, "pure_translation"),
        Listed("degenerate", still, "no_motion"),
        Listed("degenerate", beyond, "no_rotation_to_the_format"),
    ]


def evaluate_normalize(fmt, V):
    rate, speed = norm(V[0:3]), norm(V[3:6])
    if rate and speed / rate < ldexp(1, fmt.greatest - 8):
        S = [x / rate for x in V]
        return Result(S + [rate], [mpf(1), norm(S[3:6]), rate])
    if speed == 0:
        return Result([mpf(x) for x in (0, 0, 0, 0, 0, 1, 0)], [mpf(0), mpf(1), mpf(0)], (3,))
    return Result([mpf(0)] * 3 + exact.unit(V[3:6]) + [speed], [mpf(0), mpf(1), speed], (2,))


def evaluate_twist(fmt, x):
    V = exact.times(x[6], x[0:6])
    return Result(V, [norm(V)])


def with_share(bands):
    """The same cases followed by a number."""
    def more(fmt, rng):
        def build(inner):
            return lambda fmt, rng, k: inner(fmt, rng, k) + [fmt.round(sign(rng) * magnitude(rng, "1e-4", "1e4"))]

        return [Band(b.name, b.count, build(b.build), b.label) for b in bands(fmt, rng) if b.name in SIZES]

    return more


def evaluate_reciprocal(fmt, x):
    a, b, c, d = x[0:3], x[3:6], x[6:9], x[9:12]
    return Result([exact.dot(a, d) + exact.dot(b, c)], [norm(a) * norm(d) + norm(b) * norm(c)])


def evaluate_move(in_body):
    def evaluate(fmt, x):
        T, V = exact.pose(x[0:16]), exact.times(x[22], x[16:22])
        step = exact.pose_exp(V)
        moved = exact.compose(T, step) if in_body else exact.compose(step, T)
        turn = max(mpf(1), norm(V[0:3]))
        return Result(exact.pose_matrix(*moved), [turn, turn * (norm(T[1]) + norm(V[3:6])), mpf(0)])

    return evaluate


def move_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            R = sampling.random_rotation(fmt, rng)
            p = sampling.point(fmt, rng, "ordinary" if k % 3 else "mixed", k)
            w = fmt.round_all(direction(rng, k // 3))
            v = fmt.round_all(sampling.vector(rng, sampling.length(fmt, rng, "ordinary" if k % 3 else "mixed")))
            theta = fmt.round(sign(rng) * sampling.ANGLES[band](fmt, rng))
            return sampling.pose_of(fmt, rng, R, p, k) + w + v + [theta]

        return inputs

    made = [Band(name, count, build(name)) for name, count in cases_so3.EXP_BANDS.items()]
    number = lambda *x: fmt.round_all([mpf(y) for y in x])
    T = exact.pose_matrix(list(exact.IDENTITY), number(1, 2, 3))
    S = number(0, 0, 1, 2, -1, "0.5")
    travel = [T + [mpf(0)] * 3 + sampling.point(fmt, rng, "ordinary") + [mpf(k)] for k in range(4)]
    limit = sampling.angle_max(fmt)
    greatest = ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)
    made.append(Listed("tiny", travel, "pure_translation"))
    made += cases_so3.rotation_errors(fmt, rng, lambda R: exact.pose_matrix(R, number(1, 2, 3)) + S + number("0.5"), range(12))
    made += sampling.spoilt(T + S + number("0.5"), [16, 18, 19, 21, 22])
    far = [T + S + [fmt.round(f * limit)] for f in (5, -100)] + [T + number(4, 0, 0, 1, 0, 0) + [greatest]]
    over = [T + number(0, 0, 0, 4, 0, 0) + [greatest], exact.pose_matrix(list(exact.IDENTITY), [greatest] * 3) + number(0, 0, 0, 1, 1, 1) + [greatest]]
    return made + [Errors(-4, far, "angle_range"), Errors(-3, over, "overflow")]


JOINT_PARTS = [
    Group("point", "norm", (0, 1, 2)),
    Group("direction", "norm", (3, 4, 5)),
    Group("pitch", "max", [6]),
]
LINE = [Group("direction", "norm", (0, 1, 2)), Group("moment", "norm", (3, 4, 5))]

FUNCTIONS = [
    Function("screw_from_pose", 16, SCREW, evaluate_from_pose, from_pose_bands),
    Function("screw_to_pose", 8, cases_se3.POSE, evaluate_to_pose, to_pose_bands),
    Function("screw_pitch", 8, [Group("pitch", "max", [0])], evaluate_pitch, pitch_bands),
    Function("screw_helical", 7, AXIS, evaluate_helical, helical_bands),
    Function("screw_revolute", 6, AXIS, evaluate_revolute, joint_bands(1, False)),
    Function("screw_prismatic", 3, AXIS, evaluate_prismatic, joint_bands(0, False)),
    Function("screw_axis_parts", 6, JOINT_PARTS, evaluate_axis_parts, axis_bands(listed_translations)),
    Function("screw_axis_pitch", 6, [Group("pitch", "max", [0])], evaluate_axis_pitch, axis_bands(listed_translations)),
    Function("screw_axis_line", 6, LINE, evaluate_axis_line, axis_bands(refused_translations)),
    Function(
        "screw_normalize",
        6,
        AXIS + [Group("rate", "max", [6])],
        evaluate_normalize,
        axis_bands(normalized_translations),
    ),
    Function("screw_twist", 7, all_outputs("all", "norm", 6), evaluate_twist, with_share(cases_se3.twist_bands(1))),
    Function("screw_reciprocal", 12, [Group("product", "max", [0])], evaluate_reciprocal, cases_se3.twist_bands(2)),
    Function("screw_move_body", 23, cases_se3.POSE, evaluate_move(True), move_bands),
    Function("screw_move_space", 23, cases_se3.POSE, evaluate_move(False), move_bands),
]
