"""tilt.h: tilt and torsion, and the rotational error of an axisymmetric tool."""

from mpmath import atan2, cos, mpf, nint, pi

import cases_so3
import exact
import sampling
from sampling import magnitude, pick, sign, uniform
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear, all_outputs

TILT_BANDS = {"tiny": 60, "small": 70, "moderate": 70, "ordinary": 95, "near_pi": 70}


def evaluate_error(fmt, x):
    nominal, actual = x[0:9], x[9:18]
    alpha, beta = exact.tilt_error(nominal, actual)
    d0, d1 = exact.column(nominal, 2), exact.column(actual, 2)
    if exact.norm(exact.cross(d0, d1)) == 0 and exact.dot(d0, d1) < 0:
        return Result([+pi, mpf(0)], [+pi, +pi], (6,))
    r = exact.norm(exact.torsion_parts(nominal, actual))
    if r < 64 * fmt.eps:
        raise Unclear  # the torsion may or may not be resolved
    # The torsion of a tool that points backwards is badly conditioned: its sine and cosine are small.
    growth = max(mpf(1), 1 / r)
    moved = exact.norm([d - c for c, d in zip(d0, d1)])
    turned = exact.norm([a - n for n, a in zip(nominal, actual)])
    return Result([alpha, beta], [moved, turned * growth])


def tool_axis(rng, k):
    """Turns that change the direction of the tool only, its torsion only, or both."""
    if k % 4 == 0:
        return exact.unit([uniform(rng, -1, 1), uniform(rng, -1, 1), mpf(0)])
    if k % 4 == 1:
        return [mpf(0), mpf(0), mpf(sign(rng))]
    return sampling.direction(rng, k // 4)


def error_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            # Errors below eps can only be seen against an orientation whose matrix has zeros.
            fine = band == "tiny" or (band == "small" and k % 2)
            nominal = sampling.axes_rotation(rng) if fine else sampling.random_rotation(fmt, rng)
            angle = sampling.ANGLES[band](fmt, rng)
            if band == "small" and not fine:
                angle = magnitude(rng, 64 * fmt.eps, fmt.pick(1e-6, 1e-4))
            turn = exact.exp(exact.times(angle, tool_axis(rng, k)))
            return nominal + fmt.round_all(exact.multiply(nominal, turn))

        return inputs

    def near_pi(fmt, rng, k):
        """The tool almost turned round, with any torsion."""
        nominal = sampling.random_rotation(fmt, rng)
        turn = exact.tilt_to_rotation(uniform(rng, -3, 3), sampling.near_pi_angle(fmt, rng), uniform(rng, -3, 3))
        return nominal + fmt.round_all(exact.multiply(nominal, turn))

    def at_pi(fmt, rng, k):
        """The tool exactly turned round."""
        nominal = sampling.random_rotation(fmt, rng)
        actual = fmt.round_all(exact.multiply(nominal, exact.multiply(exact.about_z(uniform(rng, -3, 3)), flip())))
        return nominal + [-nominal[i] if i % 3 == 2 else actual[i] for i in range(9)]

    def drifted_near_pi(fmt, rng, k):
        """Drift that counts for more than the tilt does."""
        both = near_pi(fmt, rng, k)
        return sampling.drift(fmt, rng, both[:9], True) + sampling.drift(fmt, rng, both[9:], True)

    def drifted(fmt, rng, k):
        nominal = sampling.random_rotation(fmt, rng)
        actual = exact.multiply(nominal, exact.exp(exact.times(magnitude(rng, 1e-3, 2.5), tool_axis(rng, k))))
        return sampling.drift(fmt, rng, nominal, True) + sampling.drift(fmt, rng, actual, True)

    bands = [Band(name, count, near_pi if name == "near_pi" else build(name)) for name, count in TILT_BANDS.items()]
    bands += [Band("at_pi", 30, at_pi), Band("ordinary", 40, drifted, "drift")]
    bands.append(Band("near_pi", 40, drifted_near_pi, "drift"))
    bands.append(Listed("tiny", [2 * sampling.random_rotation(fmt, rng) for _ in range(6)], "same"))
    other = fmt.round_all(exact.exp([mpf("-1.2"), mpf("0.4"), mpf("0.9")]))
    bands += cases_so3.rotation_errors(fmt, rng, lambda R: other + R, (0, 13, 17))
    return bands + cases_so3.rotation_errors(fmt, rng, lambda R: R + other, (0, 4, 8))


def flip():
    """Ry(pi)."""
    return [mpf(x) for x in (-1, 0, 0, 0, 1, 0, 0, 0, -1)]


def evaluate_to_rotation(fmt, x):
    return Result(exact.tilt_to_rotation(*x), [mpf(1)])


def to_rotation_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            """Each angle from the band or ordinary, the one that k says surely from the band."""
            angles = [
                sampling.ANGLES[band](fmt, rng) if rng.getrandbits(1) or i == k % 3 else uniform(rng, 0, 3)
                for i in range(3)
            ]
            return fmt.round_all([sign(rng) * angle for angle in angles])

        return inputs

    bands = [Band(name, count, build(name)) for name, count in cases_so3.EXP_BANDS.items()]
    right, straight = fmt.round(pi / 2), fmt.round(pi)
    zero = mpf(0)
    bands.append(Listed("tiny", [[zero] * 3, ["-0"] * 3, [mpf(1), zero, zero], [zero, zero, mpf(1)]], "zero"))
    bands.append(
        Listed("example", [[zero, right, zero], [right, right, right], [right, straight, zero], [zero, zero, right]])
    )
    limit = sampling.angle_max(fmt)
    large = [[mpf(1) if i != j else s * 5 * limit for i in range(3)] for j in range(3) for s in (1, -1)]
    return bands + sampling.spoilt([mpf(1), mpf("0.5"), mpf(-2)], range(3)) + [Errors(-4, large, "angle_range")]


def evaluate_from_rotation(fmt, R):
    if sampling.close_to_far(R):
        raise Unclear
    azimuth, tilt, torsion = exact.tilt_from_rotation(R)
    statuses = (0,)
    if R[2] == 0 and R[5] == 0:
        if R[8] > 0:
            azimuth, statuses = mpf(0), (5,)
        else:
            s, c = -(R[1] + R[3]), R[4] - R[0]  # R = Rz(psi) Ry(pi), psi = 2 azimuth - torsion
            if s == 0 and c < 0:
                raise Unclear  # psi is pi or -pi
            azimuth, torsion, statuses = atan2(s, c) / 2, mpf(0), (6,)
    elif R[8] < 0 and abs(R[3] - R[1]) + abs(R[0] + R[4]) < mpf(1) / 16:
        # Near a tilt of pi the torsion comes from psi; the library changes over at 1/64.
        if abs(R[3] - R[1]) + abs(R[0] + R[4]) > mpf(1) / 256:
            raise Unclear
        torsion = 2 * azimuth - atan2(-(R[1] + R[3]), R[4] - R[0])
        torsion -= 2 * pi * nint(torsion / (2 * pi))
        if pi - abs(torsion) < 16 * fmt.eps:
            raise Unclear  # pi or -pi
        return Result([azimuth, tilt, torsion], [abs(azimuth), tilt, 2 * pi], statuses)
    return Result([azimuth, tilt, torsion], [abs(azimuth), tilt, abs(torsion)], statuses)


def free_angle(fmt, rng):
    """An azimuth or torsion: anything in (-pi, pi), also zero, tiny, a right angle, nearly pi."""
    kinds = [
        mpf(0),
        sign(rng) * sampling.tiny_angle(fmt, rng),
        sign(rng) * sampling.small_angle(fmt, rng),
        pi / 2,
        -pi / 2,
        sign(rng) * sampling.near_pi_angle(fmt, rng),
    ]
    return pick(rng, kinds) if rng.getrandbits(1) else uniform(rng, -3, 3)


def from_rotation_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            R = exact.tilt_to_rotation(free_angle(fmt, rng), sampling.ANGLES[band](fmt, rng), free_angle(fmt, rng))
            if k % 3 == 2 and band in ("moderate", "ordinary"):
                return sampling.drift(fmt, rng, R, True)
            return fmt.round_all(R)

        return inputs

    def upright(fmt, rng, k):
        return fmt.round_all(exact.about_z(free_angle(fmt, rng)))

    def inverted(fmt, rng, k):
        return fmt.round_all(exact.multiply(exact.about_z(free_angle(fmt, rng)), flip()))

    bands = [Band(name, count, build(name)) for name, count in TILT_BANDS.items()]
    bands += [
        Band("tiny", 40, upright, "upright"),
        Band("at_pi", 40, inverted),
        Band("ordinary", 24, lambda fmt, rng, k: sampling.axes_rotation(rng), "axes"),
    ]
    return bands + cases_so3.rotation_errors(fmt, rng)


FUNCTIONS = [
    Function("tilt_error", 18, [Group("alpha", "max", [0]), Group("beta", "max", [1])], evaluate_error, error_bands),
    Function("tilt_to_rotation", 3, all_outputs("rotation", "max", 9), evaluate_to_rotation, to_rotation_bands),
    Function(
        "tilt_from_rotation",
        9,
        [Group("azimuth", "max", [0]), Group("tilt", "max", [1]), Group("torsion", "max", [2])],
        evaluate_from_rotation,
        from_rotation_bands,
    ),
]
