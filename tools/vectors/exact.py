"""The exact results: every function of the library from its definition, in mpmath.

Nothing here follows the library's algorithms. A vector is a list of 3 numbers, a matrix a row-major list of 9, a
quaternion a list [d, n0, n1, n2]. Trouble with cancellation is met with more digits, never with another formula.
"""

from mpmath import atan2, cot, ldexp, mp, mpf, pi, sin, sqrt, workprec

BASE_BITS = 256  # working precision, 77 digits
ALGEBRA_BITS = 6000  # sums of products of inputs are exact in it, whatever their exponents
mp.prec = BASE_BITS

IDENTITY = [mpf(x) for x in (1, 0, 0, 0, 1, 0, 0, 0, 1)]


# Algebra


def exactly(function):
    """Decorator: evaluate in a precision in which a polynomial of a few format numbers is exact."""

    def wrapped(*args):
        with workprec(ALGEBRA_BITS):
            return function(*args)

    wrapped.__doc__ = function.__doc__
    return wrapped


@exactly
def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), mpf(0))


@exactly
def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


@exactly
def add(a, b):
    return [x + y for x, y in zip(a, b)]


@exactly
def subtract(a, b):
    return [x - y for x, y in zip(a, b)]


@exactly
def times(s, a):
    return [s * x for x in a]


def norm(a):
    """Euclidean norm of a vector, Frobenius norm of a matrix."""
    return sqrt(dot(a, a))


def unit(a):
    length = norm(a)
    return [x / length for x in a]


def row(A, i):
    return A[3 * i : 3 * i + 3]


def column(A, j):
    return A[j::3]


def transpose(A):
    return column(A, 0) + column(A, 1) + column(A, 2)


def multiply(A, B):
    return [dot(row(A, i), column(B, j)) for i in range(3) for j in range(3)]


def apply(A, x):
    return [dot(row(A, i), x) for i in range(3)]


def hat(w):
    zero = mpf(0)
    return [zero, -w[2], w[1], w[2], zero, -w[0], -w[1], w[0], zero]


def skew_vector(A):
    """Twice the vector of the skew-symmetric part of A."""
    return subtract([A[7], A[2], A[3]], [A[5], A[6], A[1]])


def vee(A):
    return [ldexp(x, -1) for x in skew_vector(A)]


def determinant(A):
    return dot(row(A, 0), cross(row(A, 1), row(A, 2)))


# Rotations


def polynomial_of_hat(w, b, c):
    """I + b [w] + c [w]^2."""
    W = hat(w)
    return add(IDENTITY, add(times(b, W), times(c, multiply(W, W))))


def resolving(theta):
    """A precision in which what is left of theta^3 after cancellation keeps all the digits."""
    return workprec(BASE_BITS + 3 * max(0, -mp.mag(theta)))


def exp_coefficients(theta):
    """(b, c) of exp([w]) = I + b [w] + c [w]^2."""
    return sin(theta) / theta, 2 * (sin(theta / 2) / theta) ** 2


def jacobian_coefficients(theta):
    """(b, c) of the left Jacobian, the sum of [w]^k / (k + 1)!."""
    with resolving(theta):
        return 2 * (sin(theta / 2) / theta) ** 2, (theta - sin(theta)) / theta**3


def inverse_jacobian_coefficients(theta):
    """(b, c) of the inverse of the left Jacobian."""
    with resolving(theta):
        return mpf(-1) / 2, (1 - theta / 2 * cot(theta / 2)) / theta**2


def function_of_hat(coefficients, w):
    theta = norm(w)
    if theta == 0:
        return list(IDENTITY)
    return polynomial_of_hat(w, *coefficients(theta))


def exp(w):
    return function_of_hat(exp_coefficients, w)


def left_jacobian(w):
    return function_of_hat(jacobian_coefficients, w)


def left_jacobian_inverse(w):
    return function_of_hat(inverse_jacobian_coefficients, w)


def axis_rotation(axis, theta):
    """Rotation by theta about a unit axis."""
    return polynomial_of_hat(axis, sin(theta), 2 * sin(theta / 2) ** 2)


def trace(M):
    with workprec(ALGEBRA_BITS):
        return M[0] + M[4] + M[8]


def quaternion_matrix(M):
    """The symmetric 4x4 K with q^T K q = trace(R(q)^T M) for every unit quaternion q."""
    with workprec(ALGEBRA_BITS):
        s, t = skew_vector(M), trace(M)
        K = [[mpf(0)] * 4 for _ in range(4)]
        K[0][0] = t
        for i in range(3):
            K[0][i + 1] = K[i + 1][0] = s[i]
            for j in range(3):
                K[i + 1][j + 1] = M[3 * i + j] + M[3 * j + i] - (t if i == j else 0)
        return K


def minor(K, i, j):
    """Determinant of the 4x4 K without row i and column j."""
    return determinant([K[r][c] for r in range(4) if r != i for c in range(4) if c != j])


def nearest_quaternion(M):
    """The unit quaternion d >= 0 of the rotation nearest to M, that is, the one that maximises trace(R^T M).

    It is the eigenvector of the quaternion matrix K to the largest eigenvalue, lambda = sigma1 + sigma2 + sigma3, and
    the adjugate of K - lambda I is a multiple of q q^T. The precision makes up for singular values as small as
    1e-30 sigma1.
    """
    with workprec(2 * BASE_BITS):
        M = [ldexp(x, -max(mp.mag(y) for y in M if y)) for x in M]
        K = quaternion_matrix(M)
        square, det = dot(M, M), determinant(M)
        det_K = sum((K[0][j] * minor(K, 0, j) * (-1) ** j for j in range(4)), mpf(0))
        # Newton's iteration from above descends to the largest root of the characteristic polynomial.
        root = sqrt(3 * square)
        while True:
            p = ((root**2 - 2 * square) * root - 8 * det) * root + det_K
            step = p / (4 * root * (root**2 - square) - 8 * det)
            root -= step
            if abs(step) < ldexp(root, 40 - 2 * BASE_BITS):
                break
        with workprec(ALGEBRA_BITS):
            for i in range(4):
                K[i][i] -= root
        size = [abs(minor(K, i, i)) for i in range(4)]
        i = size.index(max(size))
        q = [(-1) ** (i + j) * minor(K, i, j) for j in range(4)]
        return standard_sign(unit(q))


def standard_sign(q):
    """q or -q: d >= 0; with d = 0, a half-turn, the first non-zero component of the axis is positive."""
    first = next(x for x in q if x != 0)
    return q if first > 0 else [-x for x in q]


def quaternion_rotation(q):
    """R of a unit quaternion."""
    d, n = q[0], q[1:]
    N = hat(n)
    return add(IDENTITY, add(times(2 * d, N), times(mpf(2), multiply(N, N))))


def quaternion_axis_angle(q):
    """(axis, angle, pi - angle) of a quaternion with d >= 0; the axis of no rotation is None."""
    size = norm(q[1:])
    if size == 0:
        return None, mpf(0), +pi
    return [x / size for x in q[1:]], 2 * atan2(size, q[0]), 2 * atan2(q[0], size)


def nearest_rotation(M):
    return quaternion_rotation(nearest_quaternion(M))


def shepperd_matrix(M):
    """4 q q^T, rows (d, n), from the entries of a rotation matrix M."""
    K = quaternion_matrix(M)
    for i in range(4):
        K[i][i] += 1
    return K


def column_quaternion(M):
    """The unit quaternion d >= 0 along the column of the Shepperd matrix with the largest diagonal entry.

    It is how the library reads a matrix: for a rotation that of the rotation, for one rounded to a format that of the
    nearest rotation to a fraction of eps.
    """
    return shepperd_quaternion(M, range(4))


def shepperd_quaternion(M, columns):
    K = shepperd_matrix(M)
    i = max(columns, key=lambda k: K[k][k])
    return standard_sign(unit(K[i]))


def axis_angle(M):
    """(axis, angle, pi - angle) of the rotation that M is read as."""
    return quaternion_axis_angle(column_quaternion(M))


def log_axis_angle(M):
    """The same as the library's logarithm reads M: up to 104 degrees, which it takes for a trace of at least 1/2, the
    sine's axis, whose length becomes the angle by a function of the trace; beyond, the largest column but the first."""
    t = trace(M)
    if t < mpf(1) / 2:
        return quaternion_axis_angle(shepperd_quaternion(M, range(1, 4)))
    s = skew_vector(M)
    if norm(s) == 0:
        return None, mpf(0), +pi
    with workprec(ALGEBRA_BITS):
        x = mp.acos((t - 1) / 2)  # imaginary where a matrix has drifted beyond the identity
        angle = norm(s) * (mp.re(x / mp.sin(x)) if x else mpf(1)) / 2
    return unit(s), +angle, pi - angle


def is_exact_turn(R):
    """Are all entries 0 or 1 in size?"""
    return all(abs(x) in (0, 1) for x in R)


def log(M):
    axis, angle, _ = log_axis_angle(M)
    return [mpf(0)] * 3 if axis is None else [angle * x for x in axis]


def angle_between(A, B):
    s = [mpf(0)] * 3
    for k in range(3):
        s = add(s, cross(column(A, k), column(B, k)))
    with workprec(ALGEBRA_BITS):
        c = dot(A, B) - 1
    return atan2(norm(s), c)


def singular_sum(M):
    """sigma2 + sigma3 and sigma1 of M, det M >= 0, by the eigenvalues of M^T M."""
    with workprec(2 * BASE_BITS):
        S = multiply(transpose(M), M)
        values = mp.eigsy(mp.matrix([row(S, i) for i in range(3)]), eigvals_only=True)
        sigma = sorted(sqrt(abs(x)) for x in values)
        return sigma[0] + sigma[1], sigma[2]


def deviation(R):
    r1, r2, r3 = row(R, 0), row(R, 1), row(R, 2)
    one = mpf(1)
    with workprec(ALGEBRA_BITS):
        terms = [dot(r1, r1) - one, dot(r2, r2) - one, dot(r1, r2)] + subtract(r3, cross(r1, r2))
        return max(abs(x) for x in terms)


# Poses: a pair (R, p)


def pose(T):
    return T[0:3] + T[4:7] + T[8:11], [T[3], T[7], T[11]]


def pose_matrix(R, p):
    return row(R, 0) + [p[0]] + row(R, 1) + [p[1]] + row(R, 2) + [p[2]] + [mpf(0)] * 3 + [mpf(1)]


def compose(A, B):
    return multiply(A[0], B[0]), add(apply(A[0], B[1]), A[1])


def inverse(A):
    Rt = transpose(A[0])
    return Rt, times(mpf(-1), apply(Rt, A[1]))


def pose_exp(V):
    return exp(V[0:3]), apply(left_jacobian(V[0:3]), V[3:6])


def pose_log(R, p):
    w = log(R)
    return w + apply(left_jacobian_inverse(w), p)


def blocks(A, B, C, D):
    """The 6x6 matrix [A B; C D], row-major."""
    top = [x for i in range(3) for x in row(A, i) + row(B, i)]
    return top + [x for i in range(3) for x in row(C, i) + row(D, i)]


def adjoint(R, p):
    return blocks(R, [mpf(0)] * 9, multiply(hat(p), R), R)


def adjoint_inverse(R, p):
    Rt = transpose(R)
    return blocks(Rt, [mpf(0)] * 9, times(mpf(-1), multiply(Rt, hat(p))), Rt)


def twist_matrix(V):
    """[V], 4x4."""
    W = hat(V[0:3])
    return row(W, 0) + [V[3]] + row(W, 1) + [V[4]] + row(W, 2) + [V[5]] + [mpf(0)] * 4


def ad(V):
    W = hat(V[0:3])
    return blocks(W, [mpf(0)] * 9, hat(V[3:6]), W)


def left_jacobian6(V):
    """(J, Q) of [J 0; Q J], the left Jacobian of pose_exp; Q as in Barfoot, State Estimation for Robotics."""
    w, v = V[0:3], V[3:6]
    J, theta = left_jacobian(w), norm(w)
    W, U = hat(w), hat(v)
    if theta == 0:
        return J, times(mpf("0.5"), U)
    with workprec(BASE_BITS + 6 * max(0, -mp.mag(theta))):
        theta = norm(w)
        c = (theta - sin(theta)) / theta**3
        d = (1 - theta**2 / 2 - mp.cos(theta)) / theta**4
        e = (theta - sin(theta) - theta**3 / 6) / theta**5
    WU, UW, WUW = multiply(W, U), multiply(U, W), multiply(W, multiply(U, W))
    second = add(multiply(W, WU), subtract(multiply(UW, W), times(mpf(3), WUW)))
    third = add(multiply(WUW, W), multiply(W, WUW))
    terms = [times(mpf("0.5"), U), times(c, add(WU, add(UW, WUW))), times(-d, second), times((3 * e - d) / 2, third)]
    return J, [sum(x) for x in zip(*terms)]


def left_jacobian6_inverse(V):
    """(J^-1, P) of [J^-1 0; P J^-1]."""
    inverse, Q = left_jacobian_inverse(V[0:3]), left_jacobian6(V)[1]
    return inverse, times(mpf(-1), multiply(inverse, multiply(Q, inverse)))


def apply6(A, x):
    return [dot(A[6 * i : 6 * i + 6], x) for i in range(6)]


def transpose6(A):
    return [A[6 * j + i] for i in range(6) for j in range(6)]


# Screws


def screw_of_rotation(axis, angle, midpoint, displacement):
    """(point, translation): the screw with this rotation that takes midpoint -+ displacement / 2 to each other.

    The point is the one nearest to the origin, e . A = 0.
    """
    turned = cross(axis, displacement)
    A = [m + t / (2 * mp.tan(angle / 2)) for m, t in zip(midpoint, turned)]
    along = dot(axis, A)
    return [a - along * e for a, e in zip(A, axis)], dot(axis, displacement)


def screw_pose(axis, point, translation, angle):
    """(R, p) of a screw with a unit axis: p = (I - R) A + u e."""
    turn = cross(axis, point)
    s, c = sin(angle), 2 * sin(angle / 2) ** 2
    twice = cross(axis, turn)
    p = [translation * e - s * a - c * b for e, a, b in zip(axis, turn, twice)]
    return axis_rotation(axis, angle), p


# Lines: pairs (d, m)


def axis_line(S):
    """(line, pitch) of a screw (omega; v): unit direction, and moment at a right angle to it."""
    size = norm(S[0:3])
    d, v = unit(S[0:3]), [x / size for x in S[3:6]]
    h = dot(d, v)
    return (d, [x - h * y for x, y in zip(v, d)]), h


def nearest_point(line, x):
    """The point of the line nearest to x."""
    d, m = line
    p = add(cross(d, m), x)
    return [a - b for a, b in zip(p, apply(cross_twice(d), x))]


def cross_twice(d):
    """I - d d^T of a unit vector: what lies across it."""
    D = hat(d)
    return times(mpf(-1), multiply(D, D))


def line_angle(A, B):
    """The angle of the directions of two raw lines."""
    return atan2(norm(cross(A[0:3], B[0:3])), dot(A[0:3], B[0:3]))


def line_gap(a, b):
    """(foot on a, foot on b) of two lines that are not parallel: the least squares of a_0 + s a - b_0 - t b."""
    p, q = cross(*a), cross(*b)
    c, gap = dot(a[0], b[0]), subtract(q, p)
    square = dot(cross(a[0], b[0]), cross(a[0], b[0]))
    u, v = dot(a[0], gap), dot(b[0], gap)
    s, t = (u - c * v) / square, (c * u - v) / square
    return [x + s * y for x, y in zip(p, a[0])], [x + t * y for x, y in zip(q, b[0])]


# Tilt and torsion


def about_z(angle):
    return axis_rotation([mpf(0), mpf(0), mpf(1)], angle)


def about_y(angle):
    return axis_rotation([mpf(0), mpf(1), mpf(0)], angle)


def tilt_to_rotation(azimuth, tilt, torsion):
    with workprec(ALGEBRA_BITS):
        last = torsion - azimuth
    return multiply(about_z(azimuth), multiply(about_y(tilt), about_z(last)))


def torsion_parts(nominal, actual):
    """Sine and cosine of the torsion between two orientations, both times 1 + cos of the tilt."""
    x0, y0 = (column(nominal, j) for j in range(2))
    x1, y1 = (column(actual, j) for j in range(2))
    with workprec(ALGEBRA_BITS):
        return dot(y0, x1) - dot(x0, y1), dot(x0, x1) + dot(y0, y1)


def tilt_error(nominal, actual):
    d0, d1 = column(nominal, 2), column(actual, 2)
    return atan2(norm(cross(d0, d1)), dot(d0, d1)), abs(atan2(*torsion_parts(nominal, actual)))


def tilt_from_rotation(R):
    with workprec(ALGEBRA_BITS):
        s, c = R[3] - R[1], R[0] + R[4]
    return atan2(R[5], R[2]), atan2(sqrt(dot(R[2:6:3], R[2:6:3])), R[8]), atan2(s, c)
