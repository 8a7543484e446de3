"""motion.h: the displacement that fits n points. Inputs initial[18] final[18] weights[6] tolerance, outputs a screw, a
pose, and what is known of the fit."""

from mpmath import ldexp, mpf, pi, sin, sqrt, workprec

import cases_motion
import cases_screw
import exact
import sampling
from cases_motion import grid_scale, rounded_points, some_angle, some_offset, some_travel, turn
from exact import add, apply, dot, norm, subtract, times
from sampling import magnitude, noise, pick, uniform, vector
from vectors import Band, Errors, Function, Group, Result, Unclear

COUNT = 6
SCREW_AND_POSE = cases_motion.GROUPS[:-1]
FIT_GROUPS = SCREW_AND_POSE + [
    Group("residuals", "max", (24, 25)),
    Group("size", "max", [26]),
    Group("rigidity", "max", [27]),
    Group("growth", "max", [28]),
    Group("condition", "max", [29]),
    Group("exact", "max", (20, 21, 22, 23, 30, 31)),
]
FINISH_GROUPS = SCREW_AND_POSE + [Group("rms", "max", [24]), Group("last_row", "max", (20, 21, 22, 23))]
ANY = "inf"  # tolerance
FINE_BITS = 1024


# The exact result


class Cloud:
    """The points that are there, and their moments."""

    def __init__(self, x):
        points, moved, weights = triples(x[0:18]), triples(x[18:36]), x[36:42]
        there = [all(isinstance(c, mpf) for c in p + q) for p, q in zip(points, moved)]
        self.missing = sum(1 for t, w in zip(there, weights) if not t and w != 0)
        chosen = [i for i in range(COUNT) if there[i] and weights[i] != 0]
        self.points, self.moved = [points[i] for i in chosen], [moved[i] for i in chosen]
        self.weights = [weights[i] for i in chosen]
        with workprec(FINE_BITS):
            self.weight = sum(self.weights)
            self.before, self.after = self.mean(self.points), self.mean(self.moved)
            self.x = [subtract(p, self.before) for p in self.points]
            self.y = [subtract(p, self.after) for p in self.moved]
            self.squares = [self.sum(dot(a, a) for a in side) for side in (self.x, self.y)]
            self.H = [self.sum(b[i] * a[j] for a, b in zip(self.x, self.y)) for i in range(3) for j in range(3)]

    def sum(self, terms):
        return sum((w * t for w, t in zip(self.weights, terms)), mpf(0))

    def mean(self, points):
        return [self.sum(p[i] for p in points) / self.weight for i in range(3)]


def triples(x):
    return [x[i : i + 3] for i in range(0, len(x), 3)]


def curvature_inverse(R, H):
    """(trace(S) I - S)^-1, S = R^T H, symmetric at the best R."""
    S = exact.multiply(exact.transpose(R), H)
    trace = S[0] + S[4] + S[8]
    A = [(trace if i % 4 == 0 else 0) - s for i, s in enumerate(S)]
    rows = [exact.row(A, i) for i in range(3)]
    C = exact.cross(rows[1], rows[2]) + exact.cross(rows[2], rows[0]) + exact.cross(rows[0], rows[1])
    return times(1 / dot(rows[0], C[0:3]), exact.transpose(C))


def best_fit(x):
    """(cloud, q, R, k): q is None without rotation, k the condition number."""
    cloud = Cloud(x)
    with workprec(FINE_BITS):
        q = exact.nearest_quaternion(cloud.H)
        if norm(q[1:]) < ldexp(1, -200):
            q = None
        elif q[0] < ldexp(1, -200):
            q = exact.standard_sign([mpf(0)] + [mpf(0) if abs(n) < ldexp(1, -200) else n for n in q[1:]])
        R = exact.quaternion_rotation(q) if q else list(exact.IDENTITY)
        N = sqrt(cloud.squares[0] * cloud.squares[1])
        return cloud, q, R, N * norm(curvature_inverse(R, cloud.H))


def evaluate_fit(fmt, x):
    cloud, q, R, k = best_fit(x)
    rho = max(norm(p) for p in cloud.points + cloud.moved)
    size, size_after = (sqrt(square / cloud.weight) for square in cloud.squares)
    if 64 * k * fmt.eps > 1 or min(size, size_after) < 64 * fmt.eps * rho:
        raise Unclear  # as good as singular, collinear or coincident
    residuals = [norm(subtract(b, apply(R, a))) for a, b in zip(cloud.x, cloud.y)]
    rms = sqrt(cloud.sum(r * r for r in residuals) / cloud.weight)
    if x[42] != ANY and rms / size > x[42] / 2:
        raise Unclear
    far = max(norm(a) for a in cloud.x + cloud.y)
    travel_vector = subtract(cloud.after, cloud.before)
    travel = norm(travel_vector)
    p = subtract(cloud.after, apply(R, cloud.before))
    growth = size_after / size - 1
    quality = [rms, max(residuals), size, rms / size, growth, k, mpf(len(cloud.points)), mpf(cloud.missing)]
    quality_scales = [k * far, size, k * far / size, 1 + abs(growth), k * k, mpf(0)]
    if q is None:
        screw, status = cases_screw.pure_translation(travel_vector)
        axis_scale, travel_scale = (4 * rho / travel, rho + k * travel) if travel else (mpf(0), mpf(0))
        scales = [axis_scale, mpf(0), travel_scale, mpf(0), k, k * rho]
        statuses = (status,)
    else:
        axis, angle, gap = exact.quaternion_axis_angle(q)
        midpoint = times(mpf("0.5"), add(cloud.before, cloud.after))
        point, translation = exact.screw_of_rotation(axis, angle, midpoint, travel_vector)
        screw = axis + point + [translation, angle]
        s = sin(angle / 2)
        scales = [k / s, k * (rho / s + travel / s**2), rho + k * travel / s, k, k, k * rho]
        statuses = statuses_of(fmt, gap, k, s, cloud.missing)
    return Result(screw + exact.pose_matrix(R, p) + quality, scales + quality_scales, statuses)


def statuses_of(fmt, gap, k, s, missing):
    if s < 16 * k * fmt.eps:
        raise Unclear  # turned or not: rounding decides
    half = 1 / sqrt(fmt.eps)
    if half / 2 < k < 2 * half:
        raise Unclear
    if k > half:
        return (4,)
    if 0 < gap < 64 * k * fmt.eps:
        raise Unclear  # a half-turn or not: rounding decides
    return (1,) if gap == 0 else (7,) if missing else (0,)


def evaluate_finish(fmt, x):
    """The same from sums: the rms by a difference of squares of the size."""
    fit = evaluate_fit(fmt, x)
    rms, size = fit.outputs[24], fit.outputs[26] * max(mpf(1), 1 + fit.outputs[28])
    rms_scale = size * min(size / rms, 1 / sqrt(fmt.eps)) if rms else size / sqrt(fmt.eps)
    return Result(fit.outputs[:25], fit.scales[:6] + [rms_scale, mpf(0)], fit.statuses)


# The covariance of the pose and of the screw


COVARIANCE_GROUPS, PAIRS = [], []  # of the pose 6x6, then of the screw 8x8, by the parts of their rows and columns
PARTS = {"axis": range(0, 3), "point": range(3, 6), "translation": range(6, 7), "angle": range(7, 8)}


def covariance_group(name, offset, size, rows, columns):
    entries = sorted({offset + size * i + j for r, c in ((rows, columns), (columns, rows)) for i in r for j in c})
    COVARIANCE_GROUPS.append(Group(name, "max", entries))


covariance_group("rotation", 0, 6, range(0, 3), range(0, 3))
covariance_group("rotation_position", 0, 6, range(0, 3), range(3, 6))
covariance_group("position", 0, 6, range(3, 6), range(3, 6))
for i, first in enumerate(PARTS):
    for second in list(PARTS)[i:]:
        covariance_group(first if first == second else first + "_" + second, 36, 8, PARTS[first], PARTS[second])
        PAIRS.append((first, second))


def screw_of_pose(w, R, shift, cloud):
    """The eight numbers of the screw whose rotation is exp([w]) R, taking the centroid to `shift` beside its image."""
    axis, angle, _ = exact.quaternion_axis_angle(exact.nearest_quaternion(exact.multiply(exact.exp(w), R)))
    travel = add(subtract(cloud.after, cloud.before), shift)
    midpoint = add(cloud.before, times(mpf("0.5"), travel))
    point, translation = exact.screw_of_rotation(axis, angle, midpoint, travel)
    return axis + point + [translation, angle]


def slopes(function, size, step):
    """The Jacobian by central differences in many digits: a column for each of the six errors."""
    columns = []
    for k in range(6):
        error = [step if i == k else mpf(0) for i in range(6)]
        ahead, behind = function(error), function([-e for e in error])
        columns.append([(a - b) / (2 * step) for a, b in zip(ahead, behind)])
    return [[columns[k][i] for k in range(6)] for i in range(size)]


def evaluate_covariance(fmt, x):
    sigma = x[42]
    cloud, q, R, k = best_fit(x)
    if q is None or q[0] == 0 or 64 * k * fmt.eps > 1:
        raise Unclear  # the sign of a half-turn's axis changes from one step to the next
    axis, angle, gap = exact.quaternion_axis_angle(q)
    s = sin(angle / 2)
    if 64 * k * fmt.eps > s or gap < 64 * k * fmt.eps:
        raise Unclear
    with workprec(FINE_BITS):
        inverse = exact.multiply(R, exact.multiply(curvature_inverse(R, cloud.H), exact.transpose(R)))
        step = ldexp(1, -300)
        image = apply(R, cloud.before)

        def pose_errors(e):
            turned = apply(exact.exp(e[0:3]), image)
            return e[0:3] + subtract(e[3:6], subtract(turned, image))

        def screw_errors(e):
            return screw_of_pose(e[0:3], R, e[3:6], cloud)

        def covariance(J):
            def entry(a, b):
                turn = sum(a[i] * inverse[3 * i + j] * b[j] for i in range(3) for j in range(3))
                return sigma**2 * (turn + dot(a[3:6], b[3:6]) / cloud.weight)

            return [entry(a, b) for a in J for b in J]

        pose = covariance(slopes(pose_errors, 6, step))
        of_screw = covariance(slopes(screw_errors, 8, step))
        a, b = sqrt(norm(inverse)), 1 / sqrt(cloud.weight)
    rho = max(norm(p) for p in cloud.points + cloud.moved)
    travel = norm(subtract(cloud.after, cloud.before))
    bound = {
        "axis": a / s,
        "point": a * (rho / s + travel / s**2) + b / s,
        "translation": a * travel / s + b,
        "angle": a,
    }
    scales = [a * a, a * (a * rho + b), (a * rho + b) ** 2]
    scales = [sigma**2 * k * scale for scale in scales]
    scales += [sigma**2 * k / s * bound[first] * bound[second] for first, second in PAIRS]
    doubt = max(pose[0] + pose[7] + pose[14], of_screw[0] + of_screw[9] + of_screw[18])
    if mpf("0.005") < doubt < mpf("0.02"):
        raise Unclear
    statuses = (4,) if doubt > mpf("0.01") else statuses_of(fmt, gap, k, s, cloud.missing)
    return Result(pose + of_screw, scales, statuses)


# Clouds, about the origin and about 1 in size


def round_cloud(rng):
    return [vector(rng, uniform(rng, 0.3, 1)) for _ in range(COUNT)]


def flattened(rng, heights):
    """A cloud of the given extents along axes of any direction."""
    along = exact.exp(vector(rng, uniform(rng, 0, 3)))
    return [apply(along, [h * c for h, c in zip(heights, p)]) for p in round_cloud(rng)]


def case_inputs(fmt, points, R, t, wobble=lambda p: p, weights=None, tolerance=ANY):
    """Inputs from rounded points and a displacement: the exact images, rounded."""
    moved = [fmt.round_all(wobble(add(apply(R, p), t))) for p in points]
    return sum(points + moved, []) + (weights or [mpf(1)] * COUNT) + [tolerance]


def some_weights(fmt, rng):
    return [fmt.round(magnitude(rng, 0.01, 100)) for _ in range(COUNT)]


def of_angle(band):
    def build(fmt, rng, k):
        angle = sampling.ANGLES[band](fmt, rng)
        if band == "near_pi":
            angle = pi - magnitude(rng, fmt.pick(1e-12, 1e-4), 0.14)
        if band == "small":
            angle = magnitude(rng, 1e4 * fmt.eps, fmt.pick(1e-6, 1e-2))
        points = rounded_points(fmt, round_cloud(rng), mpf(1), some_offset(rng))
        weights = some_weights(fmt, rng) if k % 3 == 0 else None
        return case_inputs(fmt, points, turn(rng, angle, k), some_travel(rng), weights=weights)

    return build


def of_extents(*ranges):
    def build(fmt, rng, k):
        heights = [mpf(1)] + [magnitude(rng, *fmt.pick(*r)) if r else mpf(0) for r in ranges]
        points = rounded_points(fmt, flattened(rng, heights), mpf(1), some_offset(rng))
        return case_inputs(fmt, points, turn(rng, some_angle(rng), k), some_travel(rng))

    return build


def noisy(least, most):
    def build(fmt, rng, k):
        points = rounded_points(fmt, round_cloud(rng), mpf(1), some_offset(rng))
        size = magnitude(rng, least, most)
        weights = some_weights(fmt, rng) if k % 2 else None
        wobble = lambda p: add(p, noise(rng, 3, size))
        return case_inputs(fmt, points, turn(rng, some_angle(rng), k), some_travel(rng), wobble, weights)

    return build


def mirrored(fmt, rng, k):
    """The image of a mirror, or a flat cloud whose measuring errors make it one: the best rotation all the same."""
    heights = [mpf(1), uniform(rng, 0.5, 0.8), uniform(rng, 0.1, 0.3) if k % 2 else mpf(0)]
    points = rounded_points(fmt, flattened(rng, heights), mpf(1), some_offset(rng))
    mirror = [mpf(x) for x in (1, 0, 0, 0, 1, 0, 0, 0, -1)]
    wobble = (lambda p: p) if k % 2 else (lambda p: add(p, noise(rng, 3, mpf("0.01"))))
    return case_inputs(fmt, points, exact.multiply(turn(rng, some_angle(rng), k), mirror), some_travel(rng), wobble)


def outlying(fmt, rng, k):
    """One point, in any place, is far from all the others or outweighs them."""
    points = round_cloud(rng)
    points[k % COUNT] = times(magnitude(rng, 3, 30), points[k % COUNT])
    weights = [mpf(1)] * COUNT
    if k % 2:
        weights[k % COUNT] = fmt.round(magnitude(rng, 1e-3, 1e3))
    points = rounded_points(fmt, points, mpf(1), some_offset(rng))
    return case_inputs(fmt, points, turn(rng, some_angle(rng), k), some_travel(rng), weights=weights)


def some_missing(fmt, rng, k):
    x = of_angle("ordinary")(fmt, rng, k)
    for i in range(1 + k % 3):
        x[3 * ((k + i) % COUNT) + rng.getrandbits(4) % 3 + 18 * rng.getrandbits(1)] = pick(rng, ["nan", "inf", "-inf"])
    return x


def some_weightless(fmt, rng, k):
    x = of_angle("ordinary")(fmt, rng, k)
    for i in range(1 + k % 3):
        x[36 + (k + i) % COUNT] = mpf(0)
    return x


# Points on a grid, whose images under some displacements are exact


def grid_cloud(rng, reach, step):
    while True:
        points = [[mpf(step * (rng.getrandbits(30) % (2 * reach + 1) - reach)) for _ in range(3)] for _ in range(COUNT)]
        if norm(exact.cross(subtract(points[1], points[0]), subtract(points[2], points[0]))) > reach * step**2:
            return points


def half_turn(fmt, rng, k):
    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (0, -1, 1), (1, 1, 1), (1, -1, 1), (1, 2, 2), (-2, 1, 2)]
    axis = [mpf(x) for x in axes[k % len(axes)]]
    square = dot(axis, axis)
    scale = grid_scale(fmt, rng)
    points = [times(scale, p) for p in grid_cloud(rng, 3, int(square))]
    travel = [scale * (rng.getrandbits(4) - 8) for _ in range(3)]
    moved = [add(subtract(times(2 * dot(p, axis) / square, axis), p), travel) for p in points]
    return sum(points + moved, []) + [mpf(1)] * COUNT + [ANY]


def pure_translation(fmt, rng, k):
    scale = grid_scale(fmt, rng)
    points = [times(scale, p) for p in grid_cloud(rng, fmt.pick(1 << 20, 1 << 10), 1)]
    travel = [scale * (rng.getrandbits(10) - 512) for _ in range(3)] if k % 4 else [mpf(0)] * 3
    return sum(points + [add(p, travel) for p in points], []) + [mpf(1)] * COUNT + [ANY]


# Errors


def faults(fmt, rng):
    points = lambda *rows: [[mpf(c) for c in p] for p in rows]
    good = points((1, 0, 0), (0, 2, 0), (0, 0, 1), (1, 1, 3), (2, 0, 1), (-1, 0, 2))
    point = points(*[(1, 2, 3)] * COUNT)
    line = points(*[(k, 2 * k + 1, 3) for k in (0, 1, 3, -2, 5, 4)])
    corners = points((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
    mirror = [times(mpf(-1), p) for p in corners]

    def inputs(before, after, scale=mpf(1), weights=None, tolerance=ANY):
        coordinates = [scale * c for p in before + after for c in p]
        return coordinates + (weights or [mpf(1)] * COUNT) + [tolerance]

    scales = (mpf(1), ldexp(1, fmt.pick(100, 20)), ldexp(1, -fmt.pick(100, 20)))
    pairs = lambda bad: [inputs(*pair, scale) for scale in scales for pair in ((bad, bad), (good, bad), (bad, good))]
    weights = lambda *w: [fmt.round(mpf(x)) if not isinstance(x, str) else x for x in w]
    few = [inputs(good, good, weights=weights(1, 0, 0, 0, 2, 0)), inputs(good, good, weights=[mpf(0)] * COUNT)]
    gap = inputs(good, good)
    for i in range(4):
        gap[3 * i] = "nan"
    bad_weights = [
        inputs(good, good, weights=[bad if i == k else mpf(1) for i in range(COUNT)])
        for k in range(COUNT)
        for bad in (mpf(-1), "nan", "inf", "-inf")
    ]
    strained = [inputs(good, [times(mpf(s), p) for p in good], tolerance=fmt.round(mpf("0.1"))) for s in (2, "0.5", "1.5")]
    negative = [inputs(good, good, tolerance=t) for t in (mpf(-1), "nan")]
    return [
        Errors(-12, few + [gap], "too_few"),
        Errors(-11, bad_weights, "bad_weight"),
        Errors(-8, pairs(point), "coincident"),
        Errors(-9, pairs(line), "collinear"),
        Errors(-7, [inputs(corners, mirror, s) for s in scales], "mirrored_round"),
        Errors(-10, strained + negative, "not_rigid"),
    ]


def bands(fmt, rng):
    thin = ((1e-4, 0.1), (0.03, 0.1))
    counts = {"small": 24, "moderate": 24, "ordinary": 48, "near_pi": 24}
    result = [Band(name, count, of_angle(name)) for name, count in counts.items()]
    result += [
        Band("at_pi", 27, half_turn),
        Band("flat", 20, of_extents(((0.5, 1), (0.5, 1)), None)),
        Band("flat", 20, of_extents(((0.5, 1), (0.5, 1)), thin), "nearly_flat"),
        Band("thin", 30, of_extents(thin, thin)),
        Band("ill_conditioned", 12, of_extents(((1e-6, 3e-5), (3e-3, 6e-3)), ((1e-6, 3e-5), (3e-3, 6e-3)))),
        Band("far_from_origin", 24, cases_motion.far_from_origin(round_cloud, case_inputs)),
        Band("large", 16, cases_motion.scaled("large", round_cloud, case_inputs)),
        Band("small_scale", 16, cases_motion.scaled("small", round_cloud, case_inputs)),
        Band("noisy", 24, noisy(1e-5, 1e-2)),
        Band("noisy", 24, noisy(1e-2, 1), "very_noisy"),
        Band("mirrored", 24, mirrored),
        Band("outlying", 24, outlying),
        Band("missing", 24, some_missing),
        Band("missing", 12, some_weightless, "weightless"),
        Band("pure_translation", 16, pure_translation),
    ]
    return result + faults(fmt, rng)


def with_sigma(build):
    def inputs(fmt, rng, k):
        x = build(fmt, rng, k)
        finite = [abs(c) for c in x[0:18] if isinstance(c, mpf)]
        return x[:42] + [fmt.round(max(finite) * magnitude(rng, 1e-6, 1e-2))]

    return inputs


def covariance_bands(fmt, rng):
    result = []
    for band in bands(fmt, rng):
        if band.status is None and band.name not in ("pure_translation", "at_pi", "large", "small_scale"):
            result.append(Band(band.name, max(6, band.count // 3), with_sigma(band.build), band.label))
    good = of_angle("ordinary")(fmt, rng, 1)
    still = [good[:18] + good[:18] + good[36:42] + [mpf(1)]]
    bad = [good[:42] + [sigma] for sigma in (mpf(-1), "nan", "inf")]
    few = [good[:36] + [mpf(0)] * COUNT + [mpf(1)]]
    return result + [
        Errors(-7, still, "no_rotation"),
        Errors(-11, bad, "bad_sigma"),
        Errors(-12, few, "too_few"),
    ]


FUNCTIONS = [
    Function("motion_fit", 43, FIT_GROUPS, evaluate_fit, bands),
    Function("motion_finish", 43, FINISH_GROUPS, evaluate_finish, bands),
    Function("motion_covariance", 43, COVARIANCE_GROUPS, evaluate_covariance, covariance_bands),
]
