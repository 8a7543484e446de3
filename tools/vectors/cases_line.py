"""line.h: Pluecker lines. A line is direction[3] moment[3]."""

from mpmath import ldexp, mpf, pi

import cases_so3
import dh
import exact
import sampling
from exact import cross, dot, norm
from sampling import direction, magnitude, pick, point, sign, uniform
from vectors import Band, Errors, Function, Group, Listed, Result, Unclear

BANDS = {"ordinary": 205, "large": 90, "small": 90, "mixed": 120}
LINE = [Group("direction", "norm", (0, 1, 2)), Group("moment", "norm", (3, 4, 5))]


def plane_bands(count, counts=BANDS):
    """Bands of `count` vectors, the lengths of the band's own."""

    def bands(fmt, rng):
        def build(band):
            return lambda fmt, rng, k: [x for i in range(count) for x in point(fmt, rng, band, k if i else None)]

        return [Band(name, n, build(name)) for name, n in counts.items()]

    return bands


def greatest(fmt):
    return ldexp(mpf(1) - ldexp(1, -fmt.digits), fmt.greatest)


def number(fmt, *x):
    return fmt.round_all([mpf(y) for y in x])


# Lines from points


def line_through(p, d):
    """(line, distance of the point from the origin)."""
    e = exact.unit(d)
    return e + cross(p, e), norm(p)


def evaluate_raw_from_points(fmt, x):
    a, b = x[0:3], x[3:6]
    d = exact.subtract(b, a)
    return Result(d + cross(a, b), [norm(d), norm(d) * min(norm(a), norm(b))])


def evaluate_from_points(fmt, x):
    a, b = x[0:3], x[3:6]
    line, _ = line_through(min(a, b, key=norm), exact.subtract(b, a))
    return Result(line, [mpf(1), min(norm(a), norm(b))])


def evaluate_from_direction(fmt, x):
    line, reach = line_through(x[0:3], x[3:6])
    return Result(line, [mpf(1), reach])


def from_points_bands(fmt, rng):
    def near(fmt, rng, k):
        """Points that lie near each other for their distance from the origin."""
        a = point(fmt, rng, "ordinary", k)
        while True:
            b = fmt.round_all([x * (1 + magnitude(rng, fmt.eps, 0.1) * sign(rng)) for x in a])
            if b != a:
                return a + b

    bands = plane_bands(2)(fmt, rng) + [Band("ordinary", 60, near, "near")]
    bands.append(Listed("example", [number(fmt, *x) for x in ((1, 0, 0, 1, 2, 0), (0, 0, 0, 0, 0, 3), (3, 4, 5, 0, 0, 0))]))
    return bands


def raw_from_points_bands(fmt, rng):
    counts = {"ordinary": 205, "large": 90, "small": 90}
    return plane_bands(2, counts)(fmt, rng) + from_points_bands(fmt, rng)[-2:]


def from_points_errors(fmt, rng):
    base = number(fmt, 1, 2, 3, "-0.5", 4, 7)
    same = [2 * point(fmt, rng, "mixed", k) for k in range(8)] + [[mpf(0), "-0", mpf(1), mpf(0), mpf(0), mpf(1)]]
    g = greatest(fmt)
    overflow = [[g, mpf(0), mpf(0), -g, mpf(0), mpf(0)], [g, g, g, g, -g, g]]
    return (
        from_points_bands(fmt, rng)
        + sampling.spoilt(base, range(6))
        + [Errors(-8, same, "coincident"), Errors(-3, overflow, "overflow")]
    )


def from_direction_bands(fmt, rng):
    base = number(fmt, 1, 2, 3, "-0.5", 4, 7)
    none = [point(fmt, rng, "mixed", k) + [mpf(0)] * 3 for k in range(4)]
    g, root = greatest(fmt), mpf("0.5")
    overflow = [[g, g, mpf(0), root, -root, mpf(0)], [g, mpf(0), -g, mpf(1), mpf(0), mpf(1)]]
    least = ldexp(1, fmt.least)
    odd = [point(fmt, rng, "ordinary") + d for d in ([least, mpf(0), -least], [g, -g, g], [3 * least, 4 * least, mpf(0)])]
    return (
        plane_bands(2)(fmt, rng)
        + [Listed("ordinary", odd, "extreme_direction")]
        + sampling.spoilt(base, range(6))
        + [Errors(-7, none, "no_direction"), Errors(-3, overflow, "overflow")]
    )


def evaluate_normalize(fmt, S):
    (d, m), _ = exact.axis_line(S)
    return Result(d + m, [mpf(1), norm(S[3:6]) / norm(S[0:3])])


def normalize_bands(fmt, rng):
    def raw(fmt, rng, k):
        """A line of any length, its moment rounded."""
        d = sampling.vector(rng, sampling.length(fmt, rng), k)
        return fmt.round_all(d) + fmt.round_all(cross(point(fmt, rng, "ordinary"), d))

    tiny = ldexp(1, fmt.least)
    subnormal = [[tiny, mpf(0), -tiny] + fmt.round_all([x * tiny * 2**k for x in (5, 3, 2)]) for k in range(0, 100, 9)]
    bands = plane_bands(2)(fmt, rng) + [Band("ordinary", 120, raw, "raw"), Listed("tiny", subnormal, "subnormal")]
    steep = fmt.pick(
        "0x1.7e715215486p-2 -0x1.09fe9465ccd65p+1 -0x1.16241c292295dp-3"
        " 0x1.9033f0efd231bp-9 -0x1.188e16e8de60dp-4 0x1.4ab5ce3a7a5b2p-9",
        "0x1.01d68cp+8 -0x1.1d50ccp+4 -0x1.bffff8p-2 -0x1.0726c6p-3 -0x1.a5e52cp-8 -0x1.347946p-6",
    )
    # Nearly all of the moment lies along the line: 4.6 and 4.8 eps where what was off was taken out only once.
    bands.append(Listed("ordinary", [[mpf(float.fromhex(x)) for x in steep.split()]], "steep"))
    none = [[mpf(0)] * 3 + point(fmt, rng, "mixed", k) for k in range(4)]
    reach = fmt.pick(mpf("1e200"), mpf("1e25"))
    overflow = [fmt.round_all([1 / reach, mpf(0), mpf(0), mpf(1), reach, mpf(0)])]
    return (
        bands
        + sampling.spoilt(number(fmt, 1, 2, 3, "-0.5", 4, 7), range(6))
        + [Errors(-7, none, "no_direction"), Errors(-3, overflow, "overflow")]
    )


def evaluate_move(fmt, x):
    (R, p), L = exact.pose(x[0:16]), x[16:22]
    size = norm(R)
    moved = exact.apply6(exact.adjoint(R, p), L)
    return Result(moved, [size * norm(L[0:3]), size * (norm(L[3:6]) + norm(p) * norm(L[0:3]))])


def move_bands(fmt, rng):
    def build(band):
        return lambda fmt, rng, k: sampling.random_pose(fmt, rng, band, k) + unit_line(fmt, rng, band, k)

    return [Band(name, count, build(name)) for name, count in BANDS.items()]


# Unit lines


def unit_line(fmt, rng, band="ordinary", k=None):
    """A unit line of the format: mostly one with rounded entries, sometimes one whose direction is a hair off."""
    d = fmt.round_all(direction(rng, k))
    if k is not None and k % 9 == 4:
        d = fmt.round_all(exact.times(uniform(rng, mpf("0.997"), mpf("1.003")), d))
    return d + moment(fmt, point(fmt, rng, band), d)


def moment(fmt, p, d):
    return fmt.round_all(cross(p, d))


def bad_lines(fmt):
    """Directions clear of unit length."""
    lines = [(2, 0, 0, 0, 1, 0), (0, 0, 0, 0, 1, 0), ("0.9", 0, 0, 0, 0, 0), ("0.7", "0.7", "0.2", 0, 1, 0)]
    return [number(fmt, *x) for x in lines]


def evaluate_project(fmt, x):
    line, _ = exact.axis_line(x[0:6])
    foot = exact.nearest_point(line, x[6:9])
    reach = norm(x[6:9]) + norm(line[1])
    return Result(foot + [norm(exact.subtract(foot, x[6:9]))], [reach, reach])


def project_bands(fmt, rng):
    def build(band):
        def inputs(fmt, rng, k):
            L = unit_line(fmt, rng, band, k)
            x = point(fmt, rng, band)
            if k % 6 == 1:  # a point of the line, rounded
                x = fmt.round_all(exact.add(cross(L[0:3], L[3:6]), exact.times(norm(x), L[0:3])))
            if k % 30 == 17:
                x = [mpf(0)] * 3
            return L + x

        return inputs

    bands = [Band(name, count, build(name)) for name, count in BANDS.items()]
    g = greatest(fmt)
    overflow = [
        number(fmt, 1, 0, 0, 0, 0, 0) + [mpf(0), g, g],
        number(fmt, 0, 0, 1) + [g, mpf(0), mpf(0), mpf(0), -g, mpf(0)],
    ]
    return (
        bands
        + sampling.spoilt(number(fmt, 0, 0, 1, 2, 3, 0, 4, 5, 6), range(9))
        + [Errors(-11, [L + [mpf(1)] * 3 for L in bad_lines(fmt)], "not_unit"), Errors(-3, overflow, "overflow")]
    )


# Two lines


def second_direction(fmt, rng, d, kind):
    """A direction related to d: any, near it, or the same; the last two either way."""
    if kind == "skew":
        return fmt.round_all(direction(rng))
    way = sign(rng)
    if kind == "parallel":
        return exact.times(mpf(way), d)
    turn = sampling.vector(rng, magnitude(rng, 64 * fmt.eps, 0.1))
    return fmt.round_all(exact.times(mpf(way), exact.add(d, cross(turn, d))))


def two_lines(fmt, rng, band, k):
    """Any two lines, nearly or exactly parallel ones, some that meet and some that coincide."""
    A = unit_line(fmt, rng, band, k)
    kind = ("skew", "skew", "near", "parallel")[k % 4]
    d = second_direction(fmt, rng, A[0:3], kind)
    if k % 12 == 3:  # the same line, either way round
        return A + d + exact.times(mpf(1 if d == A[0:3] else -1), A[3:6])
    if k % 8 == 1:  # both through one point, so far as rounding lets them
        p = point(fmt, rng, band)
        return A[0:3] + moment(fmt, p, A[0:3]) + d + moment(fmt, p, d)
    return A + d + moment(fmt, point(fmt, rng, band), d)


def pair_bands(build_pair=two_lines):
    def bands(fmt, rng):
        build = lambda band: lambda fmt, rng, k: build_pair(fmt, rng, band, k)
        return [Band(name, count, build(name)) for name, count in {"ordinary": 240, "large": 96, "small": 96, "mixed": 96}.items()]

    return bands


EXAMPLES = [
    # x axis and the line parallel to y through (0, 0, 2); then z axis and x axis; two parallels 3 apart; twice the z axis
    ((1, 0, 0, 0, 0, 0), (0, 1, 0, -2, 0, 0)),
    ((0, 0, 1, 0, 0, 0), (1, 0, 0, 0, 0, 0)),
    ((0, 0, 1, 0, 0, 0), (0, 0, -1, 0, 3, 0)),
    ((0, 0, 1, 0, 0, 0), (0, 0, 1, 0, 0, 0)),
    ((0, "0.6", "0.8", 1, 0, 0), ("0.6", 0, "0.8", 0, 1, 0)),
]


def pair_errors(fmt, extra=()):
    A, B = number(fmt, 0, 0, 1, 2, 3, 0), number(fmt, 1, 0, 0, 0, "0.5", 4)
    extra = list(extra)
    bad = [L + B + extra for L in bad_lines(fmt)] + [A + L + extra for L in bad_lines(fmt)]
    return sampling.spoilt(A + B + extra, range(12)) + [Errors(-11, bad, "not_unit")]


def examples(fmt, extra=()):
    return Listed("example", [number(fmt, *a, *b, *extra) for a, b in EXAMPLES])


def evaluate_angle(fmt, x):
    angle = exact.line_angle(x[0:6], x[6:12])
    return Result([angle], [angle])


def angle_bands(fmt, rng):
    def fine(fmt, rng, k):
        """Angles far below eps: a coordinate axis, and one next to it."""
        A, i = [mpf(0)] * 3, k % 3
        A[i] = mpf(sign(rng))
        B = list(A)
        B[(i + 1) % 3] = fmt.round(sampling.tiny_angle(fmt, rng) if k % 2 else sampling.small_angle(fmt, rng))
        return A + [mpf(0)] * 3 + B + point(fmt, rng)

    extras = [Band("tiny", 60, fine, "fine"), examples(fmt)]
    return pair_bands()(fmt, rng) + extras + pair_errors(fmt)


def evaluate_signed_angle(fmt, x):
    n, about = cross(x[0:3], x[6:9]), x[12:15]
    side = dot(n, about)
    if side != 0 and abs(side) < 64 * fmt.eps * norm(n) * norm(about):
        raise Unclear
    angle = exact.line_angle(x[0:6], x[6:12])
    return Result([-angle if side < 0 else angle], [angle])


def signed_angle_bands(fmt, rng):
    with_normal = lambda fmt, rng, band, k: two_lines(fmt, rng, band, k) + point(fmt, rng, "mixed")
    none = [two_lines(fmt, rng, "ordinary", 4 * k) + [mpf(0)] * 3 for k in range(3)]
    bands = pair_bands(with_normal)(fmt, rng) + [examples(fmt, (0, 0, 1)), Listed("ordinary", none, "no_normal")]
    return bands + pair_errors(fmt, number(fmt, 1, 2, 3))


def line_pair(fmt, x):
    """(a, b, status, sine, M, whether the normal points from a to b) of two lines that are clear of all thresholds."""
    a, b = exact.axis_line(x[0:6])[0], exact.axis_line(x[6:12])[0]
    sine = norm(cross(a[0], b[0]))
    if 2 * fmt.eps < sine < 32 * fmt.eps:
        raise Unclear
    far = norm(a[1]) + norm(b[1])
    if sine < 8 * fmt.eps:
        gap = exact.apply(exact.cross_twice(a[0]), exact.subtract(cross(*b), cross(*a)))
        if 2 * fmt.eps * far < norm(gap) < 64 * fmt.eps * far:
            raise Unclear
        return a, b, 9 if norm(gap) <= 8 * fmt.eps * far else 8, sine, far, gap
    turned = dot(a[0], b[1]) + dot(b[0], a[1])
    if 2 * fmt.eps * far < abs(turned) < 64 * fmt.eps * far:
        raise Unclear
    return a, b, 10 if abs(turned) <= 8 * fmt.eps * far else 0, sine, far, turned


def pair_distance(status, sine, far, gap):
    """(distance, scale of its error)."""
    return (norm(gap), far) if status in (8, 9) else (abs(gap) / sine, far / sine)


def evaluate_distance(fmt, x):
    a, b, status, sine, far, gap = line_pair(fmt, x)
    distance, scale = pair_distance(status, sine, far, gap)
    return Result([distance], [scale], (status,))


def least_axis(d):
    """What the coordinate axis of the smallest component of d, the first of equals, has across d."""
    k = min(range(3), key=lambda i: abs(d[i]))
    return exact.unit(exact.apply(exact.cross_twice(exact.unit(d)), [mpf(i == k) for i in range(3)]))


def evaluate_perpendicular(fmt, x):
    a, b, status, sine, far, gap = line_pair(fmt, x)
    distance, scale = pair_distance(status, sine, far, gap)
    angle = exact.line_angle(x[0:6], x[6:12])
    scales = [mpf(1), scale, scale, angle, scale]
    if status in (8, 9):
        normal = exact.unit(gap) if status == 8 else least_axis(x[0:3])
        foot_a = cross(*a)
        foot_b = exact.add(foot_a, gap) if status == 8 else foot_a
        if status == 8:
            scales[0] = max(mpf(1), far / distance)
            scales[1] = far * scales[0]
    else:
        normal, signed = exact.unit(cross(a[0], b[0])), angle
        if status == 0 and gap > 0:
            normal, angle = exact.times(mpf(-1), normal), -angle
        foot_a, foot_b = exact.line_gap(a, b)
    return Result(normal + cross(foot_a, normal) + foot_a + foot_b + [angle, distance], scales, (status,))


PERPENDICULAR = LINE + [
    Group("foot", "norm", range(6, 12)),
    Group("angle", "max", [12]),
    Group("distance", "max", [13]),
]


def perpendicular_bands(fmt, rng):
    g = greatest(fmt)
    # Two distances of nearly the greatest number, of parallel lines on either side of the origin.
    overflow = [number(fmt, 0, 0, 1) + [g, mpf(0), mpf(0)] + number(fmt, 0, 0, 1) + [-g, mpf(0), mpf(0)]]
    return pair_bands()(fmt, rng) + [examples(fmt)] + pair_errors(fmt) + [Errors(-3, overflow, "overflow")]


# Denavit and Hartenberg, three joints

JOINTS = 3
FROM_DH = [
    Group("direction", "max", [6 * i + j for i in range(JOINTS) for j in range(3)]),
    Group("moment", "max", [6 * i + j for i in range(JOINTS) for j in range(3, 6)]),
    Group("rotation", "max", [18 + i for i in (0, 1, 2, 4, 5, 6, 8, 9, 10)]),
    Group("position", "norm", [18 + i for i in (3, 7, 11)]),
    Group("last_row", "max", range(30, 34)),
]


def evaluate_from_dh(modified):
    def evaluate(fmt, x):
        base, rows, tool = exact.pose(x[0:16]), [x[16 + 4 * i : 20 + 4 * i] for i in range(JOINTS)], exact.pose(x[28:44])
        lines, home = dh.from_rows(modified, base, rows, tool)
        reach = norm(base[1]) + sum(abs(r[0]) + abs(r[2]) for r in rows) + norm(tool[1])
        return Result([y for d, m in lines for y in d + m] + exact.pose_matrix(*home), [mpf(JOINTS) * y for y in (1, reach, 1, reach, 0)])

    return evaluate


def from_dh_bands(fmt, rng):
    quarters = lambda: pick(rng, [0, 1, -1, 2]) * pi / 2

    def build(band):
        def inputs(fmt, rng, k):
            length = lambda: mpf(0) if rng.getrandbits(2) == 0 else sign(rng) * sampling.length(fmt, rng, band)
            angle = lambda: quarters() if k % 3 == 0 else uniform(rng, -4, 4) * (10 if k % 7 == 5 else 1)
            rows = [y for _ in range(JOINTS) for y in (length(), angle(), length(), angle())]
            return sampling.random_pose(fmt, rng, band, k) + fmt.round_all(rows) + sampling.random_pose(fmt, rng, band, k + 1)

        return inputs

    bands = [Band(name, count, build(name)) for name, count in BANDS.items()]
    one = exact.pose_matrix(list(exact.IDENTITY), [mpf(1), mpf(2), mpf(3)])
    rows, limit, g = number(fmt, *[1, "0.5", 2, "-0.25"] * JOINTS), sampling.angle_max(fmt), greatest(fmt)
    far = [one + rows[0:i] + [fmt.round(8 * limit)] + rows[i + 1 :] + one for i in (1, 3, 11)]
    long = [one + [g, mpf(0), mpf(0), mpf(0)] * 2 + rows[8:] + one]
    errors = cases_so3.rotation_errors(fmt, rng, lambda R: exact.pose_matrix(R, [mpf(1)] * 3) + rows + one, range(12))
    errors += sampling.spoilt(one + rows + one, list(range(16, 40)))
    return bands + errors + [Errors(-4, far, "angle_range"), Errors(-3, long, "overflow")]


TO_DH = [
    Group("lengths", "max", [4 * i + j for i in range(JOINTS) for j in (0, 2)]),
    Group("angles", "max", [4 * i + j for i in range(JOINTS) for j in (1, 3)]),
    Group("rotation", "max", [12 + 16 * b + i for b in range(2) for i in (0, 1, 2, 4, 5, 6, 8, 9, 10)]),
    Group("position", "max", [12 + 16 * b + i for b in range(2) for i in (3, 7, 11)]),
    Group("last_rows", "max", [12 + 16 * b + i for b in range(2) for i in range(12, 16)]),
]


def evaluate_to_dh(modified):
    def evaluate(fmt, x):
        lines, home = [x[6 * i : 6 * i + 6] for i in range(JOINTS)], exact.pose(x[18:34])
        chain = dh.Chain(modified, lines, home, max(x[34], 8 * fmt.eps))
        rows, base, tool = chain.parameters()
        k = chain.condition()
        scales = [mpf(JOINTS + 1) * y for y in (k * chain.reach, k, k, k * chain.reach, 0)]
        outputs = [y for row in rows for y in row] + exact.pose_matrix(*base) + exact.pose_matrix(*tool)
        return Result(outputs, scales, (chain.status(),))

    return evaluate


def to_dh_bands(fmt, rng):
    def related(fmt, rng, band, L):
        """A line that meets L, is parallel to it, is the same, or is unrelated."""
        kind = rng.getrandbits(3)
        d = L[0:3] if kind in (1, 2) else fmt.round_all(direction(rng))
        if kind == 2:
            return list(L)
        if kind == 3:  # through the foot of L, so far as rounding lets it
            return d + moment(fmt, cross(L[0:3], L[3:6]), d)
        if kind == 1 and rng.getrandbits(1):
            d = exact.times(mpf(-1), d)
        return d + moment(fmt, point(fmt, rng, band), d)

    def build(band):
        def inputs(fmt, rng, k):
            lines = [unit_line(fmt, rng, band, k % 9)]
            for _ in range(JOINTS - 1):
                lines.append(related(fmt, rng, band, lines[-1]))
            tolerance = [mpf(0), fmt.pick(mpf("1e-12"), mpf("1e-5"))][k % 2]
            return [y for L in lines for y in L] + sampling.random_pose(fmt, rng, band, k) + [fmt.round(tolerance)]

        return inputs

    # An arm whose axes are those of the coordinate system: most of its neighbours are parallel or meet.
    def aligned(fmt, rng, k):
        lines = []
        for _ in range(JOINTS):
            d = [mpf(0)] * 3
            d[rng.getrandbits(10) % 3] = mpf(sign(rng))
            lines += d + cross([mpf(rng.getrandbits(2)) for _ in range(3)], d)
        home = exact.pose_matrix(sampling.axes_rotation(rng), [mpf(rng.getrandbits(2)) for _ in range(3)])
        return lines + home + [mpf(0)]

    bands = [Band(name, count, build(name)) for name, count in {"ordinary": 240, "large": 80, "small": 80}.items()]
    bands.append(Band("ordinary", 100, aligned, "aligned"))
    axes = number(fmt, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 1, 0, 1, 0, 3)
    home = exact.pose_matrix(list(exact.IDENTITY), [mpf(1), mpf(2), mpf(3)])
    bad = [L + axes[6:] + home + [mpf(0)] for L in bad_lines(fmt)] + [axes[:12] + bad_lines(fmt)[0] + home + [mpf(0)]]
    g = greatest(fmt)
    far = [number(fmt, 0, 0, 1) + [g, mpf(0), mpf(0)] + number(fmt, 0, 0, 1) + [-g, mpf(0), mpf(0)] + axes[12:] + home + [mpf(0)]]
    errors = cases_so3.rotation_errors(fmt, rng, lambda R: axes + exact.pose_matrix(R, [mpf(1)] * 3) + [mpf(0)], range(18, 30))
    errors += sampling.spoilt(axes + home + [mpf(0)], list(range(18)) + [34])
    return bands + errors + [
        Errors(-11, bad + [axes + home + [mpf(-1)]], "argument"),
        Errors(-3, far, "overflow"),
    ]


FUNCTIONS = [
    Function("line_raw_from_points", 6, LINE, evaluate_raw_from_points, raw_from_points_bands),
    Function("line_from_points", 6, LINE, evaluate_from_points, from_points_errors),
    Function("line_from_direction", 6, LINE, evaluate_from_direction, from_direction_bands),
    Function("line_normalize", 6, LINE, evaluate_normalize, normalize_bands),
    Function("line_move", 22, LINE, evaluate_move, move_bands),
    Function(
        "line_project",
        9,
        [Group("foot", "norm", (0, 1, 2)), Group("distance", "max", [3])],
        evaluate_project,
        project_bands,
    ),
    Function("line_angle", 12, [Group("angle", "max", [0])], evaluate_angle, angle_bands),
    Function("line_signed_angle", 15, [Group("angle", "max", [0])], evaluate_signed_angle, signed_angle_bands),
    Function("line_distance", 12, [Group("distance", "max", [0])], evaluate_distance, perpendicular_bands),
    Function("line_perpendicular", 12, PERPENDICULAR, evaluate_perpendicular, perpendicular_bands),
    Function("line_from_dh_standard", 44, FROM_DH, evaluate_from_dh(False), from_dh_bands),
    Function("line_from_dh_modified", 44, FROM_DH, evaluate_from_dh(True), from_dh_bands),
    Function("line_to_dh_standard", 35, TO_DH, evaluate_to_dh(False), to_dh_bands),
    Function("line_to_dh_modified", 35, TO_DH, evaluate_to_dh(True), to_dh_bands),
]
