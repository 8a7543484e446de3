"""Every definition of exact.py against a second way to the same number, at a few hundred seeded random cases.

Run by `generate.py --self-test`. The two ways share only the elementary algebra: power series against closed forms,
Newton's iteration and the singular value decomposition against the quaternion, there and back again, finite
differences.
"""

import random
from fractions import Fraction

from mpmath import factorial, ldexp, mp, mpf, pi, sin, workprec

import cases_agile_eye
import cases_se3
import chains
import dh
import exact
import sampling
from displacement import METHODS, Displacement, Triangle, quaternion
from exact import IDENTITY, add, apply, cross, dot, hat, multiply, norm, row, subtract, times, transpose
from formats import FORMATS, parts, text
from sampling import direction, magnitude, uniform, vector

BOUND = mpf("1e-60")


def distance(a, b):
    return norm(subtract(a, b))


# The second ways


def square_matrix_power_series(W, n, coefficient):
    """sum of coefficient(k) W^k for an n x n matrix of moderate norm, row-major."""
    with workprec(2 * exact.BASE_BITS):
        total = [mpf(0)] * (n * n)
        power = [mpf(i // n == i % n) for i in range(n * n)]
        for k in range(160):
            total = [t + coefficient(k) * x for t, x in zip(total, power)]
            power = [sum(power[n * i + m] * W[n * m + j] for m in range(n)) for i in range(n) for j in range(n)]
        return total


def newton_polar(M):
    """X <- (X + X^-T) / 2, which converges to the orthogonal polar factor."""
    with workprec(3000):
        X = [x * 1 for x in M]
        while True:
            cofactors = cross(row(X, 1), row(X, 2)) + cross(row(X, 2), row(X, 0)) + cross(row(X, 0), row(X, 1))
            det = dot(row(X, 0), cofactors[0:3])
            following = [(x + c / det) / 2 for x, c in zip(X, cofactors)]
            step = max(abs(x - y) for x, y in zip(X, following))
            X = following
            if step < ldexp(1, -1400):
                return X


def svd_polar(M):
    U, _, V = mp.svd(mp.matrix([row(M, i) for i in range(3)]))
    turn = mp.det(U * V)
    R = U * mp.diag([1, 1, mp.sign(turn)]) * V
    return [R[i, j] for i in range(3) for j in range(3)]


def random_angle(rng):
    return magnitude(rng, "1e-200", 1) if rng.getrandbits(1) else uniform(rng, 0, 3.1)


def random_exact_rotation(rng):
    return exact.exp(vector(rng, uniform(rng, 0, 3.1)))


# The comparisons: each gives a relative error


def check_rounding(rng):
    """Against the division of integers, which Python rounds correctly, and the float that the text reads as."""
    x = magnitude(rng, "1e-322", "1e308") * sampling.sign(rng)
    sign, m, e = parts(x)
    fraction = Fraction(sign * m) * Fraction(2) ** e
    double = FORMATS[0].round(x)
    wrong = float(fraction) != float.fromhex(text(double)) or float(double) != float(fraction)
    single = FORMATS[1].round(magnitude(rng, "1e-44", "1e38"))
    wrong = wrong or float.fromhex(text(single)) != single
    return mpf(1 if wrong else 0)


def check_exp(rng):
    w = vector(rng, random_angle(rng))
    return distance(exact.exp(w), square_matrix_power_series(hat(w), 3, lambda k: 1 / factorial(k))) / max(
        norm(w), BOUND
    )


def check_exp_reduction(rng):
    """Large angles: the rotation by the angle modulo 2 pi, found with many digits."""
    axis, theta = direction(rng), magnitude(rng, 3, "1e12")
    with workprec(1000):
        rest = theta - 2 * pi * mp.floor(theta / (2 * pi))
    return distance(exact.exp(times(theta, axis)), exact.axis_rotation(axis, rest))


def check_pose_exp(rng):
    V = vector(rng, random_angle(rng)) + vector(rng, magnitude(rng, "1e-10", "1e10"))
    R, p = exact.pose_exp(V)
    series = square_matrix_power_series(exact.twist_matrix(V), 4, lambda k: 1 / factorial(k))
    return distance(exact.pose_matrix(R, p), series) / norm(V)


def check_jacobian(rng):
    w = vector(rng, random_angle(rng))
    return distance(exact.left_jacobian(w), square_matrix_power_series(hat(w), 3, lambda k: 1 / factorial(k + 1)))


def check_jacobian_difference(rng):
    """exp(w + h dw) exp(-w) = exp(h J dw) to first order, with a central difference."""
    w, dw, h = vector(rng, uniform(rng, 0.1, 6)), direction(rng), ldexp(1, -120)
    with workprec(3 * exact.BASE_BITS):
        back = exact.exp(times(-1, w))
        ahead, behind = (multiply(exact.exp(add(w, times(s * h, dw))), back) for s in (1, -1))
        slope = exact.vee(times(1 / (2 * h), subtract(ahead, behind)))
    return distance(slope, apply(exact.left_jacobian(w), dw))


def check_inverse_jacobian(rng):
    w = vector(rng, random_angle(rng) * 10)
    J = multiply(exact.left_jacobian_inverse(w), exact.left_jacobian(w))
    return distance(J, IDENTITY) * abs(sin(norm(w) / 2)) / norm(w)


def check_jacobian6(rng):
    """Against the power series of ad, and the inverse against the inverse."""
    V = vector(rng, random_angle(rng)) + vector(rng, magnitude(rng, "1e-10", "1e10"))
    zero, size = [mpf(0)] * 9, norm(V[3:6])
    J, Q = exact.left_jacobian6(V)
    series = square_matrix_power_series(exact.ad(V), 6, lambda k: 1 / factorial(k + 1))
    inverse, P = exact.left_jacobian6_inverse(V)
    rest = add(multiply(P, J), multiply(inverse, Q))
    return distance(exact.blocks(J, zero, Q, J), series) / max(1, size) + norm(rest) / size


def check_polar(rng):
    """A random matrix, a bad one, a rotation with drift; all with a positive determinant."""
    kind = rng.getrandbits(2)
    U, V = random_exact_rotation(rng), random_exact_rotation(rng)
    least = magnitude(rng, *((1e-12, 1e-6) if kind == 0 else (0.1, 1)))
    sigma = [mpf(1), mpf(1) if kind == 1 else least, least]
    M = multiply(U, multiply([sigma[i] if i == j else mpf(0) for i in range(3) for j in range(3)], V))
    M = [+x for x in times(magnitude(rng, "1e-100", "1e100"), M)]
    return max(
        distance(exact.nearest_rotation(M), newton_polar(M)),
        distance(exact.nearest_rotation(M), multiply(U, V)) * least,
    )


def check_polar_rank_two(rng):
    M = [mpf(rng.getrandbits(4) - 8) for _ in range(6)]
    M += add(M[0:3], times(2, M[3:6]))
    if norm(cross(M[0:3], M[3:6])) == 0:
        return mpf(0)
    return distance(exact.nearest_rotation(M), svd_polar(M))


def check_singular_values(rng):
    M = [uniform(rng, -1, 1) for _ in range(9)]
    sigma = sorted(mp.svd(mp.matrix([row(M, i) for i in range(3)]), compute_uv=False))
    small, large = exact.singular_sum(M)
    return abs(small - sigma[0] - sigma[1]) + abs(large - sigma[2])


def check_log(rng):
    """exp(log R) = R for an exact rotation R, with the skew part to its own digits."""
    fmt = FORMATS[rng.getrandbits(1)]
    band = sampling.pick(rng, ["tiny", "small", "moderate", "ordinary", "near_pi", "at_pi"])
    R = newton_polar(sampling.rotation_of_band(fmt, rng, rng.getrandbits(6), band))
    w = exact.log(R)
    with workprec(3000):
        S = exact.exp(w)
        return max(distance(S, R), distance(exact.vee(S), exact.vee(R)) / norm(w))


def check_pose_log(rng):
    V = vector(rng, random_angle(rng)) + vector(rng, magnitude(rng, "1e-10", "1e10"))
    with workprec(3000):
        R, p = exact.pose_exp(V)
    back = exact.pose_log(R, p)
    return max(distance(back[0:3], V[0:3]) / norm(V[0:3]), distance(back[3:6], V[3:6]) / norm(V[3:6]))


def check_angle(rng):
    A, w = random_exact_rotation(rng), vector(rng, uniform(rng, 0.001, 3.1))
    return abs(exact.angle_between(A, multiply(A, exact.exp(w))) - norm(w))


def check_deviation(rng):
    """Row products and the third row of the cofactor matrix."""
    R = [uniform(rng, -1, 1) for _ in range(9)]
    G = subtract(multiply(R, transpose(R)), IDENTITY)
    cofactors = [R[(j + 1) % 3] * R[3 + (j + 2) % 3] - R[(j + 2) % 3] * R[3 + (j + 1) % 3] for j in range(3)]
    terms = [G[0], G[4], G[1]] + subtract(row(R, 2), cofactors)
    return abs(exact.deviation(R) - max(abs(x) for x in terms))


def check_compose(rng):
    """A A^-1 is the identity for an exact rotation, and composition agrees with the matrix product of 4x4."""
    A, B = ((random_exact_rotation(rng), vector(rng, uniform(rng, 0, 2))) for _ in range(2))
    a, b = exact.pose_matrix(*A), exact.pose_matrix(*B)
    product = [sum(a[4 * i + k] * b[4 * k + j] for k in range(4)) for i in range(4) for j in range(4)]
    R, p = exact.compose(A, exact.inverse(A))
    return distance(exact.pose_matrix(*exact.compose(A, B)), product) + distance(R, IDENTITY) + norm(p)


def check_adjoint(rng):
    """[Ad V] = T [V] T^-1, Ad Ad^-1 = I."""
    R, p = random_exact_rotation(rng), vector(rng, uniform(rng, 0, 2))
    V = vector(rng, mpf(1)) + vector(rng, mpf(2))
    T, back, W = exact.pose_matrix(R, p), exact.pose_matrix(*exact.inverse((R, p))), exact.twist_matrix(V)
    product = lambda a, b: [sum(a[4 * i + k] * b[4 * k + j] for k in range(4)) for i in range(4) for j in range(4)]
    Ad, inverse = exact.adjoint(R, p), exact.adjoint_inverse(R, p)
    carried = exact.apply6(Ad, V)
    return distance(exact.twist_matrix(carried), product(product(T, W), back)) + distance(
        exact.apply6(inverse, carried), V
    )


def check_wrench(rng):
    """Moment and force carried by hand, and the power with a twist."""
    R, p = random_exact_rotation(rng), vector(rng, uniform(rng, 0, 2))
    F, V = (vector(rng, mpf(1)) + vector(rng, mpf(2)) for _ in range(2))
    carried = exact.apply6(cases_se3.wrench_matrix(R, p), F)
    force = apply(R, F[3:6])
    moment = add(apply(R, F[0:3]), cross(p, force))
    back = exact.apply6(cases_se3.inverse_wrench_matrix(R, p), carried)
    power = dot(carried, exact.apply6(exact.adjoint(R, p), V)) - dot(F, V)
    return distance(carried, moment + force) + distance(back, F) + abs(power)


def check_screw(rng):
    """Screw to pose to screw."""
    axis, angle = direction(rng), uniform(rng, 1e-3, 3.1)
    point = vector(rng, uniform(rng, 0, 2))
    point = subtract(point, times(dot(axis, point), axis))
    translation = uniform(rng, -2, 2)
    R, p = exact.screw_pose(axis, point, translation, angle)
    moved = add(apply(R, point), p)  # a point of the axis moves along it
    e, theta, _ = exact.axis_angle(R)
    A, u = exact.screw_of_rotation(e, theta, times(mpf("0.5"), p), p)
    errors = distance(e, axis) + abs(theta - angle) + distance(A, point) + abs(u - translation)
    return errors + distance(moved, add(point, times(translation, axis)))


def check_line(rng):
    """The common perpendicular by the screw that takes one line to the other, and the foot of a point."""
    a, angle, height = (direction(rng), vector(rng, uniform(rng, 0, 2))), uniform(rng, 0.1, 3), uniform(rng, 0.1, 2)
    a = a[0], cross(a[1], a[0])
    foot, normal = add(cross(*a), times(uniform(rng, -2, 2), a[0])), exact.unit(cross(a[0], direction(rng)))
    turn, shift = exact.screw_pose(normal, foot, height, angle)
    b = exact.apply6(exact.adjoint(turn, shift), a[0] + a[1])
    (d, m), h = exact.axis_line(times(uniform(rng, 1, 5), b))
    from_a, to_b = exact.line_gap(a, (d, m))
    errors = distance(from_a, foot) + distance(to_b, add(foot, times(height, normal))) + abs(h)
    errors += abs(exact.line_angle(a[0] + a[1], b) - angle)
    x = vector(rng, mpf(3))
    near = exact.nearest_point(a, x)
    return errors + norm(subtract(cross(near, a[0]), a[1])) + abs(dot(subtract(near, x), a[0]))


def check_dh(rng):
    """Axes to parameters to axes, in both conventions, some neighbours parallel or coincident."""
    lines, worst = [], mpf(0)
    for _ in range(4):
        kind = rng.getrandbits(3)
        d = lines[-1][0:3] if lines and kind < 2 else direction(rng)
        lines.append(d + (lines[-1][3:6] if lines and kind == 0 else cross(vector(rng, mpf(1)), d)))
    home = random_exact_rotation(rng), vector(rng, mpf(1))
    for modified in (False, True):
        chain = dh.Chain(modified, lines, home, mpf("1e-60"))
        try:
            rows, base, tool = chain.parameters()
        except sampling.Unclear:
            continue
        back, end = dh.from_rows(modified, base, rows, tool)
        errors = [distance(a + b, line) for (a, b), line in zip(back, lines)]
        errors += [distance(end[0], home[0]), distance(end[1], home[1])]
        worst = max([worst] + [e / chain.condition() for e in errors])
    return worst


def check_tilt(rng):
    """There and back, and the error angles against the angles of the relative rotation."""
    azimuth, tilt, torsion = uniform(rng, -3, 3), uniform(rng, 0.01, 3.1), uniform(rng, -3, 3)
    R = exact.tilt_to_rotation(azimuth, tilt, torsion)
    back = exact.tilt_from_rotation(R)
    nominal = random_exact_rotation(rng)
    alpha, beta = exact.tilt_error(nominal, multiply(nominal, R))
    turns = distance(back, [azimuth, tilt, torsion])
    return turns + abs(alpha - tilt) + abs(beta - abs(torsion))


def check_displacement(rng):
    """Both methods on points that moved exactly: the rotation, and where the screw takes each point."""
    height = magnitude(rng, 1e-6, 1)
    frame, R = random_exact_rotation(rng), random_exact_rotation(rng)
    if rng.getrandbits(2) == 0:
        R = exact.axis_rotation(direction(rng), pi)
    points = [apply(frame, [mpf(x), mpf(y), mpf(0)]) for x, y in ((0, 0), (1, 0), (rng.random(), height))]
    offset, travel = vector(rng, uniform(rng, 0, 5)), vector(rng, uniform(rng, 0, 5))
    points = [add(p, offset) for p in points]
    moved = [add(apply(R, p), travel) for p in points]
    worst = mpf(0)
    for method in METHODS:
        q, doubt = quaternion(method, Triangle(points), Triangle(moved), ldexp(1, -230))
        found = Displacement(q, Triangle(points), Triangle(moved))
        turned, shift = exact.screw_pose(found.axis, found.point, found.translation, found.angle)
        images = [add(apply(turned, p), shift) for p in points]
        errors = [distance(found.R, R), doubt, abs(dot(found.axis, found.point))]
        errors += [distance(a, b) for a, b in zip(images, moved)] + [distance(found.p, travel)]
        worst = max([worst] + errors)
    return worst * height


def check_agile_eye(rng):
    """The legs close, and the orientation is a rotation and that of the closed form."""
    legs = cases_agile_eye.Legs([uniform(rng, -3, 3) for _ in range(3)])
    R, closed = legs.platform(), [mpf(0)] * 9
    c, s, d = [w[(i + 2) % 3] for i, w in enumerate(legs.w)], [-w[(i + 1) % 3] for i, w in enumerate(legs.w)], legs.d
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        N, length = c[j] * s[k] - s[j] * s[i] * c[k] * c[i], d[j] * d[k]
        closed[3 * i + j], closed[3 * j + j], closed[3 * k + j] = (
            -N / length,
            c[i] * legs.D / length,
            s[i] * legs.D / length,
        )
    open_by = sum(abs(dot(legs.w[i], exact.column(R, (i + 1) % 3))) for i in range(3))
    return open_by + exact.deviation(R) + distance(R, closed)


def random_chain(rng):
    """(screws, home, q) of six joints, one of them a slide and one a helix."""
    screws = [
        w + add(cross(vector(rng, uniform(rng, 0, 2)), w), times(h, w))
        for w, h in zip((direction(rng) for _ in range(5)), (0, 0, mpf("0.3"), 0, 0))
    ] + [[mpf(0)] * 3 + direction(rng)]
    home = random_exact_rotation(rng), vector(rng, uniform(rng, 0, 2))
    return screws, home, [uniform(rng, -3, 3) for _ in screws]


def check_chain(rng):
    """Products of power series of 4x4 matrices, and the body form beside the space form."""
    fmt, (screws, home, q) = FORMATS[0], random_chain(rng)
    T = exact.pose_matrix(*exact.compose(home, chains.IDENTITY))
    for S, x in reversed(list(zip(screws, q))):
        E = square_matrix_power_series(exact.twist_matrix(times(x, S)), 4, lambda k: 1 / factorial(k))
        T = exact.pose_matrix(*exact.compose(exact.pose(E), exact.pose(T)))
    carry = exact.adjoint_inverse(*home)
    body = [exact.apply6(carry, S) for S in screws]
    forms = chains.forward(fmt, screws, home, False, q), chains.forward(fmt, body, home, True, q)
    return max(distance(T, exact.pose_matrix(*form)) for form in forms)


def check_chain_jacobian(rng):
    """The body Jacobian backwards from the tool: Ad(exp(-B_n q_n) ... exp(-B_(i+1) q_(i+1))) B_i."""
    fmt, (screws, home, q) = FORMATS[0], random_chain(rng)
    back, columns = chains.IDENTITY, []
    for S, x in reversed(list(zip(screws, q))):
        columns.insert(0, exact.apply6(exact.adjoint(*back), S))
        back = exact.compose(back, exact.pose_exp(times(-x, S)))
    return max(distance(a, b) for a, b in zip(columns, chains.body_columns(fmt, screws, home, True, q)))


CHECKS = [
    (check_rounding, 2000),
    (check_exp, 200),
    (check_exp_reduction, 200),
    (check_pose_exp, 200),
    (check_jacobian, 200),
    (check_jacobian_difference, 200),
    (check_inverse_jacobian, 200),
    (check_jacobian6, 200),
    (check_polar, 300),
    (check_polar_rank_two, 200),
    (check_singular_values, 100),
    (check_log, 400),
    (check_pose_log, 200),
    (check_angle, 300),
    (check_deviation, 300),
    (check_compose, 200),
    (check_adjoint, 200),
    (check_wrench, 200),
    (check_screw, 300),
    (check_line, 300),
    (check_dh, 100),
    (check_chain, 100),
    (check_chain_jacobian, 100),
    (check_tilt, 300),
    (check_displacement, 200),
    (check_agile_eye, 200),
]


def run():
    """Run every check, print its largest error; 1 if one is over the bound."""
    failed = 0
    for check, count in CHECKS:
        rng = random.Random(check.__name__)
        worst = max(check(rng) for _ in range(count))
        failed += worst > BOUND
        print(
            "%-28s %5d cases, largest error %-10s %s"
            % (check.__name__[6:], count, mp.nstr(worst, 3), "ok" if worst <= BOUND else "FAILED")
        )
    return 1 if failed else 0
