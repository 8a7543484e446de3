"""screw.h: screw parameters of a pose and back, pitch. A screw is axis[3] point[3] translation angle."""

from mpmath import inf, ldexp, mpf, pi, sin, sqrt

import cases_se3
import cases_so3
import exact
import sampling
from exact import norm, pose
from sampling import direction, magnitude, sign
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear

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


FUNCTIONS = [
    Function("screw_from_pose", 16, SCREW, evaluate_from_pose, from_pose_bands),
    Function("screw_to_pose", 8, cases_se3.POSE, evaluate_to_pose, to_pose_bands),
    Function("screw_pitch", 8, [Group("pitch", "max", [0])], evaluate_pitch, pitch_bands),
]
