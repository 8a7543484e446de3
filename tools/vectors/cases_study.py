"""The searches that take a function: so3_solve and tilt_worst, each with one that functions_calls.h hands to it."""

from itertools import product

from mpmath import mpf

import cases_so3
import exact
import sampling
from cases_agile_eye import Legs, evaluate_tool
from sampling import magnitude, uniform
from vectors import Band, Errors, Function, Group, Result, Unclear, all_outputs


def evaluate_solve(fmt, x):
    """The equations say that R M^T is symmetric; near M that is where R is the rotation nearest to M."""
    return Result(exact.nearest_rotation(x[0:9]), [mpf(1)])


def solve_bands(fmt, rng):
    def near(fmt, rng, k):
        M = sampling.random_rotation(fmt, rng)
        if k % 4 == 3:
            M = sampling.drift(fmt, rng, M, True)
        turn = exact.exp(sampling.vector(rng, magnitude(rng, 1e-3, 1), k))
        return M + fmt.round_all(exact.multiply(turn, exact.nearest_rotation(M)))

    other = fmt.round_all(exact.exp([mpf("-1.2"), mpf("0.4"), mpf("0.9")]))
    return [Band("ordinary", 200, near)] + cases_so3.rotation_errors(fmt, rng, lambda R: other + R, range(9, 18))


def tool(fmt, q):
    return evaluate_tool(fmt, Legs(q).platform()).outputs


def evaluate_worst(fmt, x):
    """The largest errors at the corners of the error box; Unclear where a point between them might be worse."""
    q, e = x[0:3], x[3:6]
    legs = Legs(q)
    if min(legs.d) < 0.2 or abs(legs.D) < 0.2:
        raise Unclear
    nominal = tool(fmt, q)
    corners, others = [], []
    for parts in product((-1, 0, 1), repeat=3):
        errors = exact.tilt_error(nominal, tool(fmt, [fmt.round(t + s * u) for t, s, u in zip(q, parts, e)]))
        (others if 0 in parts else corners).append(errors)
    worst = [max(errors[m] for errors in corners) for m in range(2)]
    if any(worst[m] - max(errors[m] for errors in others) < 256 * fmt.eps for m in range(2)):
        raise Unclear
    return Result(worst + [mpf(0)], [mpf(1), mpf(1)])


def worst_bands(fmt, rng):
    def build(low, high):
        def inputs(fmt, rng, k):
            q = [uniform(rng, -3, 3) for _ in range(3)]
            return fmt.round_all(q + [magnitude(rng, low, high) for _ in range(3)])

        return inputs

    least = fmt.pick("1e-9", "1e-3")
    base = fmt.round_all([mpf("0.5"), mpf("-0.25"), mpf(1), mpf("0.01"), mpf("0.02"), mpf("0.01")])
    negative = [base[0:3] + [-u if i == j else u for j, u in enumerate(base[3:6])] for i in range(3)]
    bands = [Band("ordinary", 40, build("1e-2", "5e-2")), Band("small", 40, build(least, "1e-2"))]
    return bands + [Errors(-11, negative, "negative")] + sampling.spoilt(base, range(6))


FUNCTIONS = [
    Function("so3_solve", 18, all_outputs("rotation", "max", 9), evaluate_solve, solve_bands),
    Function(
        "tilt_worst",
        6,
        [Group("angles", "max", [0, 1]), Group("distance", "max", [2])],
        evaluate_worst,
        worst_bands,
    ),
]
