"""chain.h: products of exponentials of six joints, and what follows from their Jacobians."""

from mpmath import mp, mpf, pi, sqrt

import chains
import exact
import sampling
from exact import norm, times
from sampling import direction, magnitude, point, sign, uniform
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear, all_outputs

JOINTS = 6
INPUTS = 6 * JOINTS + 16 + 1 + JOINTS  # screws, home, form, joint values
HOME, FORM, VALUES = 6 * JOINTS, 6 * JOINTS + 16, 6 * JOINTS + 17


def parts(x):
    """(screws, home, body, q) of a flat input."""
    screws = [x[6 * i : 6 * i + 6] for i in range(JOINTS)]
    return screws, exact.pose(x[HOME : HOME + 16]), x[FORM] == 1, x[VALUES:]


# Inputs


def line_screw(axis, place, pitch):
    return axis + exact.add(exact.cross(place, axis), times(pitch, axis))


def joint(fmt, rng, length, kind):
    """A screw axis: about an axis of the frame (half of them), any axis, a helix, a slide, one with a gear ratio."""
    axes = direction(rng, 1 if kind < 5 else None)
    place = sampling.vector(rng, length())
    if kind in (0, 1, 2, 3, 5, 6, 7):
        return fmt.round_all(line_screw(axes, place, mpf(0)))
    if kind in (4, 8):
        return fmt.round_all(line_screw(axes, place, sign(rng) * length()))
    if kind == 9:
        return fmt.round_all([mpf(0)] * 3 + direction(rng))
    ratio = magnitude(rng, 0.1, 10)
    return fmt.round_all(times(ratio, line_screw(axes, place, mpf(0))))


def chain(fmt, rng, band, k, odd=True):
    length = lambda: sampling.length(fmt, rng, band)
    screws = [joint(fmt, rng, length, rng.getrandbits(20) % (11 if odd else 10)) for _ in range(JOINTS)]
    home = sampling.pose_of(fmt, rng, sampling.random_rotation(fmt, rng), point(fmt, rng, band), k)
    return sum(screws, []) + home + [mpf(rng.getrandbits(1))]


def bands_of(counts):
    """Bands of lengths with ordinary angles, bands of angles with ordinary lengths."""

    def bands(fmt, rng):
        def of_lengths(band):
            def inputs(fmt, rng, k):
                return chain(fmt, rng, band, k) + fmt.round_all([uniform(rng, -pi, pi) for _ in range(JOINTS)])

            return inputs

        def of_angles(band):
            def inputs(fmt, rng, k):
                angles = [sign(rng) * sampling.ANGLES[band](fmt, rng) for _ in range(JOINTS)]
                return chain(fmt, rng, "ordinary", k, odd=band != "far") + fmt.round_all(angles)

            return inputs

        listed = [Band(name, count, of_lengths(name)) for name, count in counts.items() if name in sampling.LENGTHS]
        listed += [
            Band(name, count, of_angles(name), "angles_" + name)
            for name, count in counts.items()
            if name in sampling.ANGLES
        ]
        base = [mpf(x) for x in UR5_SCREWS + UR5_HOME + (0,)]
        base = fmt.round_all(base)
        values = fmt.round_all([mpf(x) / 10 for x in (3, -7, 11, 5, -9, 2)])
        listed.append(Listed("example", [base + [mpf(0)] * JOINTS, base + values], "ur5"))
        read = [0, 3, 8, 10, 14, 19, 30, 35, HOME, HOME + 3, HOME + 6, HOME + 11, VALUES, VALUES + 3, VALUES + 5]
        listed += sampling.spoilt(base + values, read)
        far = [list(base + values) for _ in range(2)]
        far[0][VALUES + 2] = fmt.round(5 * sampling.angle_max(fmt))
        far[1][VALUES + 5] = -fmt.round(1000 * sampling.angle_max(fmt))
        listed.append(Errors(-4, far, "angle_range"))
        huge = list(base + values)
        huge[3] = huge[9] = huge[15] = fmt.round(mpf(2) ** (fmt.greatest - 1))
        for i in range(3):
            huge[VALUES + i] = fmt.round(pi)
        return listed + [Errors(-3, [huge], "overflow")]

    return bands


# Lynch & Park, Modern Robotics, example 4.5: UR5.
UR5_SCREWS = (
    (0, 0, 1, 0, 0, 0)
    + (0, 1, 0, "-0.089", 0, 0)
    + (0, 1, 0, "-0.089", 0, "0.425")
    + (0, 1, 0, "-0.089", 0, "0.817")
    + (0, 0, -1, "-0.109", "0.817", 0)
    + (0, 1, 0, "0.006", 0, "0.817")
)
UR5_HOME = (-1, 0, 0, "0.817", 0, 0, 1, "0.191", 0, 1, 0, "-0.006", 0, 0, 0, 1)

FEW = {
    "ordinary": 16,
    "large": 8,
    "small": 8,
    "mixed": 8,
    "tiny": 8,
    "moderate": 8,
    "near_pi": 8,
    "beyond_pi": 8,
    "far": 8,
}
COUNTS = {**{name: 2 * count for name, count in FEW.items()}, "at_pi": 16}


# The functions


def pose_groups(first, translation="norm", count=1):
    """The groups of `count` poses that start at the output `first`."""
    places = lambda indices: [first + 16 * k + i for k in range(count) for i in indices]
    return [
        Group("rotation", "max", places((0, 1, 2, 4, 5, 6, 8, 9, 10))),
        Group("translation", translation, places((3, 7, 11))),
        Group("last_row", "max", places((12, 13, 14, 15))),
    ]


def scales(fmt, screws, home, q):
    times_joints = chains.count(fmt, screws, q)
    return [times_joints, times_joints * chains.reach(fmt, screws, home, q), mpf(0)]


def evaluate_fk(fmt, x):
    screws, home, body, q = parts(x)
    return Result(exact.pose_matrix(*chains.forward(fmt, screws, home, body, q)), scales(fmt, screws, home, q))


def evaluate_links(fmt, x):
    screws, home, body, q = parts(x)
    rotation, translation, zero = scales(fmt, screws, home, q)
    further = rotation * norm(home[1]) if body else 0
    outputs = [entry for link in chains.links(fmt, screws, home, body, q) for entry in exact.pose_matrix(*link)]
    return Result(outputs, [rotation, translation + further, zero])


def evaluate_jacobian(columns):
    def evaluate(fmt, x):
        screws, home, body, q = parts(x)
        rotation, translation, zero = scales(fmt, screws, home, q)
        # The columns of a joint with a gear ratio are |omega| times as large.
        gear = max([mpf(1)] + [norm(S[0:3]) for S in screws])
        J = chains.matrix_of(columns(fmt, screws, home, body, q))
        T = exact.pose_matrix(*chains.forward(fmt, screws, home, body, q))
        return Result(J + T, [rotation * gear, translation * gear, rotation, translation, zero])

    return evaluate


JACOBIAN = [
    Group("angular", "max", range(0, 3 * JOINTS)),
    Group("linear", "max", range(3 * JOINTS, 6 * JOINTS)),
] + pose_groups(6 * JOINTS)


# Inverse kinematics


def regular_chain(fmt, rng, k):
    """A chain of six turning joints about half a metre apart: the UR5, or any axes."""
    if k % 3 == 0:
        return fmt.round_all([mpf(x) for x in UR5_SCREWS + UR5_HOME + (0,)])
    screws = [
        fmt.round_all(line_screw(direction(rng), sampling.vector(rng, mpf(1) / 2), mpf(0))) for _ in range(JOINTS)
    ]
    home = sampling.pose_of(fmt, rng, sampling.random_rotation(fmt, rng), fmt.round_all(direction(rng)))
    return sum(screws, []) + home + [mpf(k % 2)]


def ik_bands(far):
    """Poses that the chain has at joint values up to `far` from the start, none of them near a singularity."""

    def bands(fmt, rng):
        def build(fmt, rng, k):
            flat = regular_chain(fmt, rng, k)
            screws, home, body, _ = parts(flat + [mpf(0)] * JOINTS)
            q = [uniform(rng, -pi, pi) for _ in range(JOINTS)]
            columns = chains.body_columns(fmt, screws, home, body, q)
            if abs(determinant(chains.matrix_of(columns))) < 0.03:
                raise Unclear
            T = exact.pose_matrix(*chains.forward(fmt, screws, home, body, q))
            start = [x + fmt.pick(*far) * uniform(rng, -1, 1) for x in q]
            return flat + fmt.round_all(start + T)

        base = fmt.round_all([mpf(x) for x in UR5_SCREWS + UR5_HOME + (0, 1, -1, 1, 0, 1, 0)])
        T = [mpf(x) for x in (1, 0, 0, "0.3", 0, 1, 0, "0.2", 0, 0, 1, "0.4", 0, 0, 0, 1)]
        base += fmt.round_all(T)
        goal = VALUES + JOINTS
        reflected = list(base)
        reflected[goal + 10] = mpf(-1)
        stretched = list(base)
        stretched[goal] = mpf("1.125")
        read = [0, 3, 8, 35, HOME + 3, HOME + 11, VALUES, VALUES + 5, goal, goal + 3, goal + 11]
        far_turn = list(base)
        far_turn[VALUES + 1] = fmt.round(5 * sampling.angle_max(fmt))
        return (
            [Band("ordinary", 60, build)]
            + sampling.spoilt(base, read)
            + [Errors(-6, [reflected], "reflection"), Errors(-5, [stretched], "not_a_rotation")]
            + [Errors(-4, [far_turn], "angle_range")]
        )

    return bands


def evaluate_ik(fmt, x):
    return Result([mpf(0) + y for y in x[VALUES + JOINTS :][:12]] + [mpf(0)] * 3 + [mpf(1)], [mpf(1), mpf(1), mpf(0)])


# Statics and joint rates: J, twists or wrenches, lengths and dampings


def random_orthogonal(rng, n):
    """Columns of an orthogonal matrix, by Gram and Schmidt."""
    columns = []
    while len(columns) < n:
        v = [sampling.gaussian_like(rng) for _ in range(n)]
        for c in columns:
            v = exact.subtract(v, times(exact.dot(v, c), c))
        if norm(v) > 0.1:
            columns.append(exact.unit(v))
    return columns


def conditioned(rng, n, smallest):
    """A 6 x n matrix whose singular values reach from 1 down to `smallest`, row-major."""
    U, V = random_orthogonal(rng, 6), random_orthogonal(rng, n)
    values = [mpf(1)] + [magnitude(rng, smallest, 1) for _ in range(min(n, 6) - 2)] + [mpf(smallest)]
    return [sum(s * u[i] * v[j] for s, u, v in zip(values, U, V)) for i in range(6) for j in range(n)]


UNITS = {"ordinary": ("1", "1"), "large": ("1e45", "1e5"), "small": ("1e-45", "1e-5")}


def unit_of_length(fmt, band):
    return mpf(fmt.pick(*UNITS[band]))


def jacobian(fmt, rng, n, band, k):
    """One with a large condition number, a general matrix, or that of a chain with unit axes; n is 6 or 7."""
    if k % 3 == 0:
        J = conditioned(rng, n, magnitude(rng, fmt.pick(1e-12, 1e-4), 1))
    elif k % 3 == 1:
        J = [sampling.gaussian_like(rng) for _ in range(6 * n)]
    else:
        screws, home, body, _ = parts(chain(fmt, rng, "ordinary", 0, odd=False) + [mpf(0)] * JOINTS)
        q = [uniform(rng, -pi, pi) for _ in screws]
        columns = chains.space_columns(fmt, [chains.normalised(fmt, S) for S in screws], home, body, q)
        J = chains.matrix_of(columns + [direction(rng) + direction(rng) for _ in range(n - JOINTS)])
    lengths = unit_of_length(fmt, band) * magnitude(rng, "0.1", "10")
    return fmt.round_all([x if i < 3 * n else lengths * x for i, x in enumerate(J)])


def twist(fmt, rng, band="ordinary"):
    lengths = unit_of_length(fmt, band) * magnitude(rng, "0.1", "10")
    return fmt.round_all(direction(rng) + sampling.vector(rng, lengths))


def statics_bands(n, tail, bad=(), counts=(("ordinary", 60), ("large", 21), ("small", 21))):
    """J of n joints and what `tail` adds to it; `bad` lists tails that must be refused as arguments."""

    def bands(fmt, rng):
        def build(band):
            return lambda fmt, rng, k: jacobian(fmt, rng, n, band, k) + tail(fmt, rng, band, k)

        base = jacobian(fmt, rng, n, "ordinary", 1) + tail(fmt, rng, "ordinary", 0)
        read = [0, n + 1, 6 * n - 1] + list(range(6 * n, len(base)))
        refused = [base[: 6 * n] + list(tail(fmt, rng, "ordinary", 0)[: -len(end)]) + list(end) for end in bad]
        listed = [Band(name, count, build(name)) for name, count in counts]
        listed += sampling.spoilt(base, read)
        return listed + ([Errors(-11, refused, "argument")] if bad else [])

    return bands


def plain_bands(n, tail):
    """Those of plain algebra, which has no errors."""
    return lambda fmt, rng: statics_bands(n, tail)(fmt, rng)[:3]


def length_tail(fmt, rng, band, k):
    return [
        mpf(1) if k % 2 and band == "ordinary" else fmt.round(unit_of_length(fmt, band) * magnitude(rng, "0.1", "10"))
    ]


def no_tail(fmt, rng, band, k):
    return []


def twist_tail(fmt, rng, band, k):
    return twist(fmt, rng, band)


def rates_tail(fmt, rng, band, k):
    return twist(fmt, rng, band) + length_tail(fmt, rng, band, k)


def damped_tail(fmt, rng, band, k):
    near = mpf(0) if k % 2 else magnitude(rng, 1e-4, 1)
    return rates_tail(fmt, rng, band, k) + fmt.round_all([magnitude(rng, 1e-4, 1) * (near or 1), near])


def divided(J, n, length):
    """J with its last three rows divided by the length, as an mpmath matrix."""
    return mp.matrix([[J[n * i + j] / (length if i >= 3 else 1) for j in range(n)] for i in range(6)])


def singular_values(A):
    """Descending; for a wide or tall matrix the min(6, n) of them."""
    with mp.workprec(2 * exact.BASE_BITS):
        wide = A.cols > A.rows
        return sorted(mp.svd_r(A.T if wide else A, compute_uv=False), reverse=True)


def noise_of(fmt, n):
    return 8 * max(n, 6) * fmt.eps


def rank_of(fmt, n, sigma):
    limit = noise_of(fmt, n) * sigma[0]
    if any(limit / 4 < s < 4 * limit for s in sigma):
        raise Unclear
    return sum(s > limit for s in sigma)


def row_lengths(J, n):
    return [norm(J[n * i : n * i + n]) for i in range(6)]


def evaluate_torques(fmt, x):
    J, F = x[:36], x[36:]
    return Result([exact.dot(J[j::6], F) for j in range(6)], [max(norm(J[j::6]) for j in range(6)) * norm(F)])


def evaluate_twist(fmt, x):
    J, rates = x[:36], x[36:]
    return Result(exact.apply6(J, rates), [6 * max(row_lengths(J, 6)) * norm(rates)])


def evaluate_singular_values(fmt, x):
    sigma = singular_values(divided(x[:36], 6, x[36]))
    return Result(sigma, [sigma[0]])


def evaluate_rank(fmt, x):
    return Result([mpf(rank_of(fmt, 6, singular_values(divided(x[:36], 6, x[36]))))], [mpf(0)])


def evaluate_manipulability(fmt, x):
    sigma = singular_values(divided(x[:36], 6, x[36]))
    others = mp.fprod(max(s, 16 * fmt.eps * sigma[0]) for s in sigma[:-1])
    return Result([mp.fprod(sigma)], [others * sigma[0]])


def evaluate_condition(fmt, x):
    sigma = singular_values(divided(x[:36], 6, x[36]))
    if rank_of(fmt, 6, sigma) < 6:
        raise Unclear
    condition = sigma[0] / sigma[-1]
    return Result([condition], [condition**2])


def determinant(J):
    """By Laplace's expansion: that of the first rows and any as many columns from those of a row less."""
    with mp.workprec(exact.ALGEBRA_BITS):
        minors = {(): mpf(1)}
        for i in range(6):
            larger = {}
            for columns, minor in minors.items():
                for j in set(range(6)) - set(columns):
                    crossed = sum(c > j for c in columns)
                    chosen = tuple(sorted(columns + (j,)))
                    larger[chosen] = larger.get(chosen, 0) + (-1) ** crossed * minor * J[6 * i + j]
            minors = larger
        return minors[tuple(range(6))]


def evaluate_determinant(fmt, J):
    return Result([determinant(J)], [mp.fprod(norm(J[j::6]) for j in range(6))])


def evaluate_rates_inverse(fmt, x):
    with mp.workprec(2 * exact.BASE_BITS):
        # Elimination does not care in which unit lengths are; the condition number does.
        every = [singular_values(divided(x[:36], 6, unit)) for unit in units_of(x[:36])]
        if all(sigma[-1] * 1000 < sigma[0] * fmt.eps * 1000**2 for sigma in every):
            raise Unclear
        condition = min(sigma[0] / sigma[-1] for sigma in every if sigma[-1] > 0)
        rates = list(mp.lu_solve(divided(x[:36], 6, 1), mp.matrix(x[36:])))
        return Result(rates, [condition * norm(rates)])


def units_of(J):
    rows = row_lengths(J, 6)
    return [mpf(1), max(rows[3:]) / max(rows[:3])]


def damped_solution(A, V, weight):
    """x = sum of weight(sigma_i) v_i (u_i . V), A = sum of sigma_i u_i v_i^T, from the eigenvectors of A A^T."""
    with mp.workprec(4 * exact.BASE_BITS):
        values, U = mp.eigsy(A * A.T)
        x = mp.matrix(A.cols, 1)
        for i in range(6):
            u = U[:, i]
            sigma = sqrt(abs(values[i]))
            factor = weight(sigma)
            if factor:
                x += (A.T * u) * (factor / sigma * (u.T * V)[0])
        return list(x)


def scaled_twist(V, length):
    return mp.matrix(V[:3] + [v / length for v in V[3:]])


def evaluate_rates_pseudoinverse(fmt, x):
    n, V, length = 7, x[42:48], x[48]
    A, scaled = divided(x[:42], n, length), scaled_twist(V, length)
    sigma = singular_values(A)
    rank = rank_of(fmt, n, sigma)
    limit = noise_of(fmt, n) * sigma[0]
    rates = damped_solution(A, scaled, lambda s: 1 / s if s > limit else 0)
    scale = sigma[0] * norm(list(scaled)) / sigma[rank - 1] ** 2
    return Result(rates, [scale], (0,) if rank == 6 else (13,))


def evaluate_rates_damped(fmt, x):
    n, V, length, damping, near = 7, x[42:48], *x[48:51]
    A, scaled = divided(x[:42], n, length), scaled_twist(V, length)
    sigma = singular_values(A)
    square, statuses, growth = damping**2, (0,), mpf(1)
    if near:
        gap = 1 - (sigma[-1] / near) ** 2
        if abs(gap) < mpf(1) / 1000:
            raise Unclear
        square = square * gap if gap > 0 else mpf(0)
        statuses = (13,) if gap > 0 else (0,)
        growth += (damping / near) ** 2
    rates = damped_solution(A, scaled, lambda s: s / (s**2 + square))
    scale = sigma[0] * norm(list(scaled)) / (sigma[-1] ** 2 + square)
    return Result(rates, [growth * scale], statuses)


BAD_LENGTHS = [(mpf(0),), (mpf(-1),)]
BAD_DAMPINGS = [
    (mpf(0), mpf(0)),
    (mpf(-1), mpf(0)),
    (mpf(1), mpf(-1)),
    (mpf(0), mpf(1), mpf(1)),
    (mpf(-2), mpf(1), mpf(1)),
]
J_AND_LENGTH = statics_bands(6, length_tail, BAD_LENGTHS)

FUNCTIONS = [
    Function("chain_fk", INPUTS, pose_groups(0), evaluate_fk, bands_of(COUNTS)),
    Function("chain_links", INPUTS, pose_groups(0, "max", JOINTS), evaluate_links, bands_of(FEW)),
    Function("chain_space_jacobian", INPUTS, JACOBIAN, evaluate_jacobian(chains.space_columns), bands_of(FEW)),
    Function("chain_body_jacobian", INPUTS, JACOBIAN, evaluate_jacobian(chains.body_columns), bands_of(FEW)),
    Function("chain_ik", INPUTS + 16, pose_groups(0), evaluate_ik, ik_bands((0.2, 0.2))),
    Function("chain_ik_step", INPUTS + 16, pose_groups(0), evaluate_ik, ik_bands((1e-7, 1e-3))),
    Function("chain_torques", 42, all_outputs("torques", "max", 6), evaluate_torques, plain_bands(6, twist_tail)),
    Function("chain_twist", 42, all_outputs("twist", "max", 6), evaluate_twist, plain_bands(6, twist_tail)),
    Function("chain_singular_values", 37, all_outputs("sigma", "max", 6), evaluate_singular_values, J_AND_LENGTH),
    Function("chain_rank", 37, [Group("rank", "max", [0])], evaluate_rank, J_AND_LENGTH),
    Function("chain_manipulability", 37, [Group("product", "max", [0])], evaluate_manipulability, J_AND_LENGTH),
    Function("chain_condition", 37, [Group("condition", "max", [0])], evaluate_condition, J_AND_LENGTH),
    Function(
        "chain_determinant", 36, [Group("determinant", "max", [0])], evaluate_determinant, statics_bands(6, no_tail)
    ),
    Function(
        "chain_rates_inverse", 42, all_outputs("rates", "norm", 6), evaluate_rates_inverse, statics_bands(6, twist_tail)
    ),
    Function(
        "chain_rates_pseudoinverse",
        49,
        all_outputs("rates", "norm", 7),
        evaluate_rates_pseudoinverse,
        statics_bands(7, rates_tail, BAD_LENGTHS),
    ),
    Function(
        "chain_rates_damped",
        51,
        all_outputs("rates", "norm", 7),
        evaluate_rates_damped,
        statics_bands(7, damped_tail, BAD_DAMPINGS),
    ),
]
