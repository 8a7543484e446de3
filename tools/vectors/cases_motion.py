"""motion.h: the displacement from three points. Inputs initial[9] final[9] tolerance, outputs a screw and a pose."""

from mpmath import ldexp, mpf, pi, sin, sqrt

import cases_screw
import exact
import sampling
from displacement import METHODS, Displacement, Triangle, quaternion, side_turned_most
from exact import add, apply, cross, dot, norm, subtract, times, unit
from sampling import direction, magnitude, noise, pick, sign, uniform, vector
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear

GROUPS = cases_screw.SCREW + [
    Group("rotation", "max", (8, 9, 10, 12, 13, 14, 16, 17, 18)),
    Group("position", "norm", (11, 15, 19)),
    Group("last_row", "max", (20, 21, 22, 23)),
]
TOLERANCE = mpf("0.001")


# The exact result


def evaluate(method):
    return lambda fmt, x: evaluate_points(method, fmt, rows(x[0:9]), rows(x[9:18]), x[18])


def rows(x):
    return [x[0:3], x[3:6], x[6:9]]


def side_change(initial, final):
    """Largest change of a squared side, over twice the square of the longest: what the tolerance is compared with."""
    return max(abs(f**2 - i**2) for i, f in zip(initial.sides, final.sides)) / (2 * initial.longest**2)


def evaluate_points(method, fmt, points, moved, tolerance):
    initial, final = Triangle(points), Triangle(moved)
    if side_change(initial, final) > tolerance / 4:
        raise Unclear
    kappa, rho = initial.condition, max(norm(p) for p in points + moved)
    if 16 * kappa * fmt.eps * rho > initial.longest:
        raise Unclear  # as good as collinear: the coordinates hardly resolve the smallest height
    q, doubt = quaternion(method, initial, final, fmt.eps)
    if doubt > fmt.eps * kappa / 64:
        raise Unclear
    found = Displacement(q, initial, final)
    pose = exact.pose_matrix(found.R, found.p)
    travel = norm(found.travel)
    if q is None:
        screw, status = cases_screw.pure_translation(found.travel)
        axis_scale, travel_scale = (4 * rho / travel, rho + kappa * travel) if travel else (mpf(0), mpf(0))
        return Result(screw + pose, [axis_scale, mpf(0), travel_scale, mpf(0), kappa, kappa * rho, mpf(0)], (status,))
    s = sin(found.angle / 2)
    scales = [
        kappa / s,
        kappa * (rho / s + travel / s**2),
        rho + kappa * travel / s,
        kappa,
        kappa,
        kappa * rho,
        mpf(0),
    ]
    return Result(found.screw() + pose, scales, statuses(fmt, found, kappa, rho / initial.longest, s))


def evaluate_order(fmt, x):
    points, moved = rows(x[0:9]), rows(x[9:18])
    found = evaluate_points("motion_bottema_roth", fmt, points, moved, x[18])
    order = side_turned_most(Triangle(points), Triangle(moved), fmt.eps)
    if order is None:
        raise Unclear
    return Result([mpf(order)], [mpf(0)], found.statuses)


def statuses(fmt, found, kappa, reach, s):
    """What a method may answer: the kind of motion, and 4 where half of the digits may be lost."""
    half = 1 / sqrt(fmt.eps)
    if kappa > 16 * half and found.gap >= 64 * kappa * fmt.eps:
        return (4,)
    lossy = kappa * reach / s > half / 16
    if found.gap == 0:
        return (1, 4) if lossy else (1,)
    if found.gap < 64 * kappa * fmt.eps:
        raise Unclear  # a half-turn or not: rounding decides
    if found.angle < 64 * kappa * reach * fmt.eps:
        if s > kappa * fmt.eps / 2:
            raise Unclear  # turned or not: rounding decides
        return (0, 2, 3, 4)  # and here it does not matter
    return (0, 4) if lossy else (0,)


# Triangles, about the origin and about 1 in size


def random_triangle(rng):
    while True:
        points = [vector(rng, uniform(rng, 0.3, 1)) for _ in range(3)]
        sides = [norm(subtract(points[i - 1], points[i - 2])) for i in range(3)]
        if norm(cross(subtract(points[1], points[0]), subtract(points[2], points[0]))) > 0.15 * max(sides) ** 2:
            return points


def thin_triangle(rng, height):
    """A longest side of length 1 and a smallest height."""
    along = exact.exp(vector(rng, uniform(rng, 0, 3)))
    foot = uniform(rng, 0.1, 0.9)
    return [apply(along, [mpf(x), mpf(y), mpf(0)]) for x, y in ((0, 0), (1, 0), (foot, height))]


def triangle_on_axes(rng):
    """One point on each coordinate axis: rotations below eps change zeros, and are not lost."""
    points = [[uniform(rng, 0.5, 2) * sign(rng) if i == j else mpf(0) for j in range(3)] for i in range(3)]
    return shuffled(rng, points)


def shuffled(rng, items):
    order = pick(rng, [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)])
    return [items[i] for i in order]


# Motions


def case_inputs(fmt, points, R, t, wobble=lambda p: p):
    """Inputs from rounded points and a displacement: the exact images, rounded."""
    moved = [fmt.round_all(wobble(add(apply(R, p), t))) for p in points]
    change = side_change(Triangle(points), Triangle(moved))
    tolerance = TOLERANCE if change < TOLERANCE / 8 else 16 * change
    return sum(points + moved, []) + [fmt.round(tolerance)]


def rounded_points(fmt, points, scale=mpf(1), offset=None):
    return [fmt.round_all(times(scale, add(p, offset or [mpf(0)] * 3))) for p in points]


def some_offset(rng):
    return vector(rng, uniform(rng, 0, 2))


def some_travel(rng, scale=mpf(1)):
    """Usually of the size of the triangle; sometimes none, or much smaller or larger."""
    kind = rng.getrandbits(3)
    size = mpf(0) if kind == 0 else magnitude(rng, 1e-4, 30) if kind == 1 else uniform(rng, 0.1, 3)
    return vector(rng, scale * size)


def turn(rng, angle, k=None):
    return exact.axis_rotation(direction(rng, k), angle)


def of_angle(band):
    """A well-shaped triangle turned by an angle of the band."""

    def build(fmt, rng, k):
        angle = sampling.ANGLES[band](fmt, rng)
        if band == "near_pi":
            angle = pi - magnitude(rng, fmt.pick(1e-13, 1e-5) * 4, 0.14)
        if band == "small" and k % 2:
            angle = magnitude(rng, 1000 * fmt.eps, fmt.pick(1e-6, 1e-3))
        if band == "tiny" or (band == "small" and k % 2 == 0):
            angle = max(angle, fmt.pick(mpf("1e-140"), mpf("1e-17")))
            points = rounded_points(fmt, triangle_on_axes(rng))
            return case_inputs(fmt, points, turn(rng, angle, k // 2), vector(rng, angle))
        points = rounded_points(fmt, random_triangle(rng), mpf(1), some_offset(rng))
        return case_inputs(fmt, points, turn(rng, angle, k), some_travel(rng))

    return build


def some_angle(rng):
    return uniform(rng, 0.2, 3)


def thin(fmt, rng, k):
    points = rounded_points(
        fmt, thin_triangle(rng, magnitude(rng, fmt.pick(1e-6, 1e-3), 0.1)), mpf(1), some_offset(rng)
    )
    return case_inputs(fmt, shuffled(rng, points), turn(rng, some_angle(rng), k), some_travel(rng))


def ill_conditioned(fmt, rng, k):
    points = rounded_points(fmt, thin_triangle(rng, magnitude(rng, *fmt.pick((1e-11, 1e-9), (4e-6, 1e-5)))))
    return case_inputs(fmt, shuffled(rng, points), turn(rng, some_angle(rng), k), some_travel(rng))


def about_a_side(fmt, rng, k):
    """The body turns about the line through two of the points."""
    points = rounded_points(fmt, random_triangle(rng), mpf(1), some_offset(rng))
    i = k % 3
    R = exact.axis_rotation(unit(subtract(points[i - 1], points[i - 2])), some_angle(rng))
    return case_inputs(fmt, points, R, subtract(points[i - 1], apply(R, points[i - 1])))


def axis_in_plane(fmt, rng, k):
    points = rounded_points(fmt, random_triangle(rng), mpf(1), some_offset(rng))
    a, c = subtract(points[1], points[0]), subtract(points[2], points[0])
    axis = unit(add(times(uniform(rng, -1, 1), a), times(uniform(rng, -1, 1), c)))
    return case_inputs(fmt, points, exact.axis_rotation(axis, some_angle(rng)), some_travel(rng))


def plane_through_origin(fmt, rng, k):
    """The plane of the points holds the origin: a coordinate plane, or another one as nearly as the format can."""
    points = random_triangle(rng)
    if k % 2:
        points = [[x if j != k % 3 else mpf(0) for j, x in enumerate(p)] for p in points]
    else:
        s = uniform(rng, -2, 2)
        points[2] = add(times(s, points[0]), times(1 - s + sign(rng), points[1]))
    points = rounded_points(fmt, points)
    if Triangle(points).condition > 12:
        raise Unclear
    return case_inputs(fmt, points, turn(rng, some_angle(rng), k), some_travel(rng))


def far_from_origin(shape, inputs_of):
    """Points of a random shape far away; for three points as for any number, which differ in how inputs are laid out."""

    def build(fmt, rng, k):
        offset = vector(rng, magnitude(rng, *fmt.pick((1e3, 1e6), (1e1, 1e3))), k)
        points = rounded_points(fmt, shape(rng), mpf(1), offset)
        R = turn(rng, some_angle(rng), k)
        travel = some_travel(rng)
        if k % 2:  # about the body itself, not about the origin
            travel = add(travel, subtract(offset, apply(R, offset)))
        return inputs_of(fmt, points, R, travel)

    return build


def scaled(band, shape, inputs_of):
    def build(fmt, rng, k):
        scale = sampling.length(fmt, rng, band)
        points = rounded_points(fmt, shape(rng), scale, some_offset(rng))
        return inputs_of(fmt, points, turn(rng, some_angle(rng), k), some_travel(rng, scale))

    return build


def noisy(fmt, rng, k):
    """Measured points: the sides differ, and the two methods do not agree."""
    points = rounded_points(fmt, random_triangle(rng), mpf(1), some_offset(rng))
    size = magnitude(rng, 1e-5, 1e-2)
    return case_inputs(
        fmt, points, turn(rng, some_angle(rng), k), some_travel(rng), lambda p: add(p, noise(rng, 3, size))
    )


def disturbed(fmt, rng, k):
    """A body that hardly turned and one measured point of it that is off by more."""
    points = rounded_points(fmt, random_triangle(rng), mpf(1), some_offset(rng))
    size = magnitude(rng, 1e-4, 3e-3)
    wrong = points[k % 3]
    return case_inputs(
        fmt,
        points,
        turn(rng, size * magnitude(rng, 1e-3, 1), k),
        some_travel(rng),
        lambda p: add(p, vector(rng, size)) if p is wrong else p,
    )


# Points on a grid, whose images under some displacements are exact


def grid_triangle(rng, reach, step):
    """Integers up to reach, times step; well shaped."""
    while True:
        points = [[step * (rng.getrandbits(30) % (2 * reach + 1) - reach) for _ in range(3)] for _ in range(3)]
        if norm(cross(subtract(points[1], points[0]), subtract(points[2], points[0]))) > 0:
            if Triangle(points).condition < 6:
                return [[mpf(x) for x in p] for p in points]


def grid_scale(fmt, rng):
    """A power of two, often 1."""
    return ldexp(1, sign(rng) * (rng.getrandbits(5) if rng.getrandbits(1) else 0))


def half_turn(fmt, rng, k):
    """An exact half-turn: the axis is rational, and the points are multiples of what its matrix is divided by."""
    axes = [
        (1, 0, 0),
        (0, 1, 0),
        (0, 0, 1),
        (1, 1, 0),
        (0, -1, 1),
        (1, 0, -1),
        (1, 1, 1),
        (1, -1, 1),
        (1, 2, 2),
        (-2, 1, 2),
    ]
    axis = [
        mpf(x) for x in (axes + [(2, 3, 6), (1, 4, 8)] if fmt.is_double else axes)[k % (12 if fmt.is_double else 10)]
    ]
    square = dot(axis, axis)
    scale = grid_scale(fmt, rng)
    points = [times(scale, p) for p in grid_triangle(rng, 3, int(square))]
    travel = [scale * (rng.getrandbits(4) - 8) for _ in range(3)]
    moved = [add(subtract(times(2 * dot(p, axis) / square, axis), p), travel) for p in points]
    return sum(points + moved, []) + [fmt.round(TOLERANCE)]


def pure_translation(fmt, rng, k):
    scale = grid_scale(fmt, rng)
    points = [times(scale, p) for p in grid_triangle(rng, fmt.pick(1 << 20, 1 << 10), 1)]
    bits = fmt.pick(24, 12)
    travel = [scale * (rng.getrandbits(bits) - (1 << (bits - 1))) for _ in range(3)]
    if k % 4 == 0:
        travel = [x if i == k % 3 else mpf(0) for i, x in enumerate(travel)]
    return sum(points + [add(p, travel) for p in points], []) + [fmt.round(TOLERANCE)]


def no_motion(fmt, rng, k):
    points = rounded_points(fmt, random_triangle(rng), sampling.length(fmt, rng) if k % 2 else mpf(1), some_offset(rng))
    return 2 * sum(points, []) + [fmt.round(TOLERANCE)]


def equilateral(fmt, rng, k):
    """Three equal sides; the image is exact, so that it does not matter which one counts as the longest."""
    scale = grid_scale(fmt, rng)
    corners = [
        [mpf(x) for x in p]
        for p in pick(
            rng,
            [[(1, 0, 0), (0, 1, 0), (0, 0, 1)], [(1, 1, 0), (1, 0, 1), (0, 1, 1)], [(0, 0, 0), (1, 1, 0), (1, 0, 1)]],
        )
    ]
    offset = [mpf(rng.getrandbits(5) - 16) for _ in range(3)]
    points = [times(scale, add(p, offset)) for p in shuffled(rng, corners)]
    travel = [scale * (rng.getrandbits(5) - 16) for _ in range(3)]
    return case_inputs(fmt, points, sampling.axes_rotation(rng), travel)


def permuted():
    """The same displacement of the same points, given in each order."""
    last = {}

    def build(fmt, rng, k):
        if last.get("k") == k or k % 6 == 0:
            last["inputs"] = of_angle("ordinary")(fmt, rng, k // 6)
        last["k"] = k
        x = last["inputs"]
        order = [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)][k % 6]
        return sum([rows(x[0:9])[i] for i in order] + [rows(x[9:18])[i] for i in order], []) + x[18:]

    return build


# Degenerate triangles and pairs of triangles


def points_of(*rows_of_numbers):
    return [[mpf(x) for x in p] for p in rows_of_numbers]


def spoilt_pairs(fmt, rng, bad_triangles):
    """Each bad triangle as the initial one and, turned, as the final one, at several sizes."""
    cases = []
    good = points_of((1, 0, 0), (0, 2, 0), (0, 0, 1))
    for scale in (mpf(1), ldexp(1, fmt.pick(300, 30))):
        for bad in bad_triangles:
            for pair in ((bad, bad), (good, bad), (bad, good)):
                cases.append([scale * x for triangle in pair for p in triangle for x in p] + [fmt.round(TOLERANCE)])
    return cases


def not_rigid(fmt, rng, k):
    """A side that differs by at least ten times what the tolerance allows."""
    while True:
        points = rounded_points(fmt, random_triangle(rng), grid_scale(fmt, rng))
        tolerance = magnitude(rng, 1e-3, 1e-2)
        moved = [apply(exact.exp(vector(rng, some_angle(rng))), p) for p in points]
        moved = (
            [times(uniform(rng, 0.4, 0.8) if k % 2 else uniform(rng, 1.3, 3), p) for p in moved]
            if k % 3
            else [moved[0], moved[1], times(mpf(2), moved[2])]
        )
        moved = [fmt.round_all(p) for p in moved]
        initial, final = Triangle(points), Triangle(moved)
        if side_change(initial, final) > 10 * tolerance and final.condition < 100:
            return sum(points + moved, []) + [fmt.round(tolerance)]


def appendix(fmt):
    """Fenton & Shi 1990, equations A1 and A2, whose columns are the points."""
    before = (("3.51542", "0.48235", "3.43593"), ("3.18322", "0.69586", "1.23011"), ("1.66537", "2.29896", "0.97893"))
    after = (("3.44738", "2.94288", "5.02296"), ("2.99723", "2.91118", "2.82798"), ("0.78293", "2.91222", "2.64402"))
    return fmt.round_all([mpf(x) for points in (before, after) for p in points for x in p] + [TOLERANCE])


def examples(fmt):
    """The appendix, and displacements found by hand, exact in either precision."""
    corners, one = points_of((1, 0, 0), (0, 1, 0), (0, 0, 1)), [mpf(1)] * 3
    cyclic = corners[1:] + corners[:1]  # 2 pi / 3 about (1, 1, 1)
    triangle = points_of((0, 0, 0), (1, 0, 0), (0, 2, 0))
    quarter = points_of(
        (3, 1, 3), (3, 2, 3), (1, 1, 3)
    )  # about the line parallel to z through (1, 2, 0), and 3 along it
    pairs = [(corners, cyclic), (corners, [add(p, one) for p in cyclic]), (triangle, quarter)]
    return [appendix(fmt)] + [sum(a + b, []) + [fmt.round(TOLERANCE)] for a, b in pairs]


def bands(fmt, rng):
    result = [
        Band(name, count, of_angle(name))
        for name, count in {"tiny": 24, "small": 36, "moderate": 36, "ordinary": 48, "near_pi": 28}.items()
    ]
    result += [
        Band("at_pi", 36, half_turn),
        Band("thin", 36, thin),
        Band("ill_conditioned", 10, ill_conditioned),
        Band("axis_through_points", 24, about_a_side),
        Band("axis_in_plane", 20, axis_in_plane),
        Band("plane_through_origin", 20, plane_through_origin),
        Band("far_from_origin", 28, far_from_origin(random_triangle, case_inputs)),
        Band("large", 20, scaled("large", random_triangle, case_inputs)),
        Band("small_scale", 20, scaled("small", random_triangle, case_inputs)),
        Band("equilateral", 16, equilateral),
        Band("permuted", 18, permuted()),
        Band("noisy", 18, noisy),
        Band("disturbed", 24, disturbed),
        Band("pure_translation", 18, pure_translation),
        Band("no_motion", 12, no_motion),
        Listed("example", examples(fmt)),
    ]
    coincident = [
        points_of((1, 2, 3), (1, 2, 3), (0, 0, 1)),
        points_of((0, 0, 1), (1, 2, 3), (1, 2, 3)),
        points_of((1, 2, 3), (4, 0, 1), (1, 2, 3)),
        points_of((0, 0, 0), (0, 0, 0), (0, 0, 0)),
    ]
    collinear = [
        points_of((0, 0, 0), (1, 1, 0), (3, 3, 0)),
        points_of((3, 0, 3), (1, 2, 3), (-1, 4, 3)),
        points_of((5, 0, 0), (-1, 0, 0), (2, 0, 0)),
    ]
    strained = [not_rigid(fmt, rng, k) for k in range(20)]
    result += [
        Errors(-8, spoilt_pairs(fmt, rng, coincident), "coincident"),
        Errors(-9, spoilt_pairs(fmt, rng, collinear), "collinear"),
        Errors(-10, strained, "not_rigid"),
    ]
    return result + sampling.spoilt(examples(fmt)[0], range(0, 18))


BY_NUMBER = dict(
    enumerate(["spoor_veldpaus", "angeles", "laub_shiflett", "spoor_veldpaus", "bottema_roth", "beggs"])
)


def evaluate_by_number(fmt, x):
    return evaluate("motion_" + BY_NUMBER[int(x[19])])(fmt, x)


def bands_by_number(fmt, rng):
    """Some cases for each method by its number, and numbers of none."""

    def numbered(build):
        return lambda fmt, rng, k: build(fmt, rng, k) + [mpf(k % 6)]

    result = [
        Band("ordinary", 36, numbered(of_angle("ordinary"))),
        Band("at_pi", 12, numbered(half_turn)),
        Band("noisy", 36, numbered(noisy)),
        Band("pure_translation", 6, numbered(pure_translation)),
    ]
    result.append(Errors(-11, [examples(fmt)[0] + [mpf(n)] for n in (-1, 6, 100)], "no_method"))
    result.append(Errors(-10, [numbered(not_rigid)(fmt, rng, k) for k in range(6)], "not_rigid"))
    return result + sampling.spoilt(examples(fmt)[0] + [mpf(0)], range(0, 18))


def order_bands(fmt, rng):
    """Those in which rounding does not decide, and the errors."""
    undecided = ("equilateral", "example")
    return [band for band in bands(fmt, rng) if band.label not in undecided]


FUNCTIONS = [Function(name, 19, GROUPS, evaluate(name), bands) for name in METHODS]
FUNCTIONS.append(
    Function("motion_bottema_roth_order", 19, [Group("order", "max", (0,))], evaluate_order, order_bands)
)
FUNCTIONS.append(Function("motion_from_three", 20, GROUPS, evaluate_by_number, bands_by_number))
