"""Write src/coefficients.h: the polynomials behind the library's few transcendental kernels.

    python3 tools/coefficients/generate.py [--check]

Each kernel is a minimax polynomial in one variable x on [0, top]. Its head, which the library adds to exactly, is given;
what remains starts at some order, and its coefficients are rounded to the format one by one, lowest order first; those
that are still free are fitted again after each rounding, so that they absorb its error. The bound written beside each
polynomial is the largest weighted error of the rounded polynomial itself, in exact arithmetic, in eps of the format;
rounding errors of its evaluation come on top and are covered by the functions' own promises.

Polynomials are evaluated by Estrin's scheme, whose operations wait for one another the least, and those that take the
longest in two halves, so that the library may put the last product where it waits for nothing.

Where a singularity is near, a quotient of two polynomials takes fewer operations. It meets the function in Chebyshev's
points, which for the kind of function that it serves here is as good as minimax but for a factor of 2 or so.
"""

import argparse
import pathlib
import sys

from mpmath import acos, atan, cos, factorial, lu_solve, matrix, mp, mpf, pi, sin, sqrt

mp.dps = 50

HEADER = pathlib.Path(__file__).resolve().parents[2] / "src" / "coefficients.h"
GRID = 400


def half_sinc(t):
    """sin(x/2) / (x/2) at x = sqrt t"""
    return sin(sqrt(t) / 2) / (sqrt(t) / 2) if t else mpf(1)


def half_cosine(t):
    """cos(x/2) at x = sqrt t"""
    return cos(sqrt(t) / 2)


def sinc(t):
    """sin(x) / x at x = sqrt t"""
    return sin(sqrt(t)) / sqrt(t) if t else mpf(1)


def cosine(t):
    """cos(x) at x = sqrt t"""
    return cos(sqrt(t))


def power_series(coefficient, t):
    """The sum of coefficient(k) (-t)^k, an entire function: 40 terms are plenty below t = 10."""
    return sum(coefficient(k) * (-t) ** k for k in range(40))


def cosine_slope(t):
    """-d/dt (1 - cos x)/x^2 at x = sqrt t"""
    return power_series(lambda k: 1 / (2 * factorial(2 * k + 3)) - 1 / factorial(2 * k + 4), t)


def cubic_slope(t):
    """-d/dt (x - sin x)/x^3 at x = sqrt t"""
    return power_series(lambda k: (k + 1) / factorial(2 * k + 5), t)


def cotangent_slope(t):
    """4 (1 - cos x)/x^2 d/dt (1 - (x/2) cot(x/2))/x^2 at x = sqrt t"""
    difference = lambda k: 4 * (1 / factorial(2 * k + 4) - 1 / (2 * factorial(2 * k + 3))) + 1 / factorial(2 * k + 3)
    return power_series(lambda k: -difference(k + 1), t)


def cotangent(t):
    """(1 - (x/2) cot(x/2))/x^2 at x = sqrt t"""
    return (1 - sqrt(t) / 2 * cos(sqrt(t) / 2) / sin(sqrt(t) / 2)) / t if t > mpf("1e-20") else mpf(1) / 12


def arctangent(u):
    """atan(sqrt u) / sqrt u"""
    return atan(sqrt(u)) / sqrt(u) if u else mpf(1)


# z = u / (u + SPREAD) puts what is singular, u from -1 to -infinity, equally far from both ends of the interval.
SPREAD = mpf(39) / 16


def arc_ratio(z):
    """atan(sqrt u) / sqrt u at u = 39/16 z / (1 - z)"""
    return arctangent(SPREAD * z / (1 - z))


# The library's logarithm reads traces from 1/2 to 3 so; matrices that have drifted may go a little beyond.
TRACES = (mpf("0.49"), mpf("3.03"))


def turn(trace):
    """1/4 - (x/(2 sin x) - 1/2) / (3 - trace) at trace = 1 + 2 cos x"""
    x = acos((trace - 1) / 2)
    return mpf(1) / 4 - ((x / (2 * sin(x))).real - mpf(1) / 2) / (3 - trace) if trace != 3 else mpf(1) / 6


# The angle runs to pi; 1e-3 more leaves room for the rounding of the comparisons that choose the interval. "relative"
# divides the error by the function, "absolute" does not.
SLACK = mpf("1.001")
WITHIN_PI = SLACK * pi**2
WITHIN_QUARTER_PI = SLACK * (pi / 4) ** 2
HALVES, WHOLE = (4, 2), (0, 0)
KERNELS = [
    # macro, function and its form (P is the macro), top, weight, head, first order of P, degrees, and how many of P's
    # coefficients make its lower half, the last two in double and float
    ("SINC", half_sinc, "1 + t P", WITHIN_PI, "absolute", [mpf(1)], 1, (8, 4), HALVES),
    ("COSINE", half_cosine, "1 - 13 t/128 + t P", WITHIN_PI, "absolute", [mpf(1), mpf(-13) / 128], 1, (8, 5), HALVES),
    ("QUARTER_SINE", sinc, "1 + t P", WITHIN_QUARTER_PI, "relative", [mpf(1)], 1, (6, 3), WHOLE),
    ("QUARTER_COSINE", cosine, "1 - t/2 + t^2 P", WITHIN_QUARTER_PI, "absolute", [mpf(1), mpf(-1) / 2], 2, (7, 4), WHOLE),
    ("COSINE_SLOPE", cosine_slope, "P", WITHIN_PI, "relative", [], 0, (9, 5), WHOLE),
    ("CUBIC_SLOPE", cubic_slope, "P", WITHIN_PI, "relative", [], 0, (9, 5), WHOLE),
    ("COTANGENT_SLOPE", cotangent_slope, "P", WITHIN_PI, "relative", [], 0, (9, 5), WHOLE),
    ("COTANGENT", cotangent, "P", WITHIN_PI, "relative", [], 0, (13, 6), WHOLE),
    # An angle may be read a little beyond a quarter turn, u = 1, which divides the uses of this one.
    ("ARC_RATIO", arc_ratio, "1 + z P", mpf("1.1") / (mpf("1.1") + SPREAD), "relative", [mpf(1)], 1, (15, 7), WHOLE),
    ("ATAN_REST", arctangent, "1 + u P", SLACK / 4, "relative", [mpf(1)], 1, (13, 6), WHOLE),
]
TURN_DEGREES = (7, 3)
LIMITS = (16, 8)  # as powers of two
# So that (1 - cos x)/x^2 is 1/2 at 0.
EXACT = {(half_cosine, 1): mpf(-1) / 8}
# Bits of CHS_PI_SHORT behind the binary point: products with the number of turns are exact, and so are squares of what
# remains.
SHORT_PI = (16, 8)
FORMATS = [("double", 53, ""), ("float", 24, "F")]


def round_to(value, bits):
    """The nearest number of the format, ties to even (no coefficient is subnormal)."""
    if value == 0:
        return mpf(0)
    saved, mp.prec = mp.prec, bits
    try:
        return +value
    finally:
        mp.prec = saved


def hexfloat(value, bits):
    """C99 hexadecimal text of a number that the format holds exactly."""
    sign, mantissa, exponent, _ = value._mpf_
    mantissa, exponent = int(mantissa), int(exponent)
    shift = bits - mantissa.bit_length()
    mantissa, exponent = mantissa << shift, exponent - shift
    fraction_bits = bits - 1
    padding = -fraction_bits % 4
    fraction = (mantissa - (1 << fraction_bits)) << padding
    digits = f"{fraction:0{(fraction_bits + padding) // 4}x}".rstrip("0")
    return f"{'-' if sign else ''}0x1{'.' + digits if digits else ''}p{exponent + fraction_bits:+d}"


def evaluate(coefficients, x):
    value = mpf(0)
    for c in reversed(coefficients):
        value = value * x + c
    return value


def remez(function, weight, top, fixed, degree):
    """Free coefficients fixed..degree of the weighted minimax polynomial whose first ones are given."""
    first, free = len(fixed), degree + 1 - len(fixed)
    # Extrema of a Chebyshev polynomial on [0, top] are a good first reference.
    reference = [top / 2 * (1 - cos(pi * (k + mpf(1) / 2) / (free + 1))) for k in range(free + 1)]
    grid = [top / 2 * (1 - cos(pi * k / GRID)) for k in range(1, GRID + 1)]
    wanted = {x: (function(x), weight(function(x))) for x in grid}

    def error(c, x):
        f, w = wanted[x] if x in wanted else (function(x), weight(function(x)))
        return (evaluate(c, x) - f) * w

    coefficients = []
    for _ in range(12):
        a, b = matrix(free + 1), matrix(free + 1, 1)
        for row, x in enumerate(reference):
            w = weight(function(x))
            for j in range(free):
                a[row, j] = x ** (first + j) * w
            a[row, free] = mpf(-1) ** row
            b[row] = (function(x) - evaluate(fixed, x)) * w
        solution = lu_solve(a, b)
        coefficients = fixed + [solution[j] for j in range(free)]
        level = abs(solution[free])
        errors = [error(coefficients, x) for x in grid]
        extrema = alternating_extrema(grid, errors)
        while len(extrema) > free + 1:
            extrema.pop(0 if abs(errors[extrema[0]]) < abs(errors[extrema[-1]]) else -1)
        if len(extrema) < free + 1:
            break
        worst = max(abs(errors[i]) for i in extrema)
        reference = [grid[i] for i in extrema]
        if worst < level * mpf("1.001"):
            break
    return coefficients


def alternating_extrema(grid, errors):
    """Indices of the largest error in each run of one sign."""
    runs = []
    for i, e in enumerate(errors):
        if runs and (errors[runs[-1]] > 0) == (e > 0):
            if abs(e) > abs(errors[runs[-1]]):
                runs[-1] = i
        else:
            runs.append(i)
    return runs


def fit(function, top, weight, head, first, degree, bits):
    """The rounded coefficients from the first order on, to which the head is added, and the error of it all. Those of
    the function's power series that are given in EXACT stay as they are."""
    whole, rest = head[:first], []
    while len(whole) <= degree:
        exact = head[len(whole)] if len(whole) < len(head) else mpf(0)
        fitted = EXACT.get((function, len(whole))) or remez(function, weight, top, whole, degree)[len(whole)]
        rest.append(round_to(fitted - exact, bits))
        whole.append(exact + rest[-1])
    points = [top * k / 2000 for k in range(1, 2001)]
    worst = max(abs((evaluate(whole, x) - function(x)) * weight(function(x))) for x in points)
    return rest, worst * mpf(2) ** (bits - 1)


def quotient(function, low, high, degree):
    """Two polynomials of that degree, the latter 1 at 0, whose quotient is the function in Chebyshev's points."""
    size = 2 * degree + 1
    a, b = matrix(size), matrix(size, 1)
    for row in range(size):
        x = (low + high - (high - low) * cos(pi * (2 * row + 1) / (2 * size))) / 2
        b[row] = function(x)
        for j in range(degree + 1):
            a[row, j] = x**j
        for j in range(1, degree + 1):
            a[row, degree + j] = -b[row] * x**j
    solution = lu_solve(a, b)
    return list(solution[: degree + 1]), [mpf(1)] + list(solution[degree + 1 :])


def turn_macros(degree, bits, suffix):
    """The macros of turn. What counts is the error of x/(2 sin x) = 1/2 + (3 - trace)(1/4 - turn)."""
    low, high = TRACES
    weight = lambda t: abs(3 - t) / (mpf(1) / 2 + (3 - t) * (mpf(1) / 4 - turn(t)))
    top, bottom = ([round_to(c, bits) for c in polynomial] for polynomial in quotient(turn, low, high, degree))
    points = [low + (high - low) * k / 2000 for k in range(2001)]
    worst = max(abs(evaluate(top, t) / evaluate(bottom, t) - turn(t)) * weight(t) for t in points)
    text = lambda polynomial: [hexfloat(c, bits) + suffix for c in polynomial]
    return [
        f"/* {turn.__doc__} = CHS_TURN_TOP / CHS_TURN_BOTTOM",
        f"   on [{mp.nstr(low, 5)}, {mp.nstr(high, 5)}], {mp.nstr(worst * mpf(2) ** (bits - 1), 2)} eps of x/(2 sin x) */",
        *macro("TURN_TOP", "trace", text(top)),
        *macro("TURN_BOTTOM", "trace", text(bottom)),
    ]


def split(value, bits, parts):
    """value as a sum of numbers of the format, each the rest rounded."""
    pieces = []
    for _ in range(parts):
        pieces.append(round_to(value, bits))
        value -= pieces[-1]
    return pieces


def estrin(constants, x):
    """The text of a polynomial in x by Estrin's scheme, a pair of coefficients a line."""
    if len(constants) == 1:
        return constants[0]
    half = 1
    while 2 * half < len(constants):
        half *= 2
    power = f"({x})" if half == 1 else f"CHS_POWER_{half}({x})"
    gap = " " if half == 1 else " \\\n   "
    return f"({estrin(constants[:half], x)} +{gap}{power} * {estrin(constants[half:], x)})"


def macro(name, x, constants):
    """The macro that evaluates a polynomial, as lines."""
    return f"#define CHS_{name}({x}) \\\n  {estrin(constants, x)}".split("\n")


def section(precision, bits, suffix):
    choice = 0 if precision == "double" else 1
    lines = [f"#define CHS_HIGH(x) CHS_POWER_{HALVES[choice]}(x)"]
    for name, function, form, top, kind, head, first, degrees, lower in KERNELS:
        weight = (lambda f: 1 / abs(f)) if kind == "relative" else (lambda f: mpf(1))
        coefficients, bound = fit(function, top, weight, head, first, degrees[choice], bits)
        x, low = function.__code__.co_varnames[0], lower[choice]
        constants = [hexfloat(c, bits) + suffix for c in coefficients]
        value = f"CHS_{name}_LOW + CHS_HIGH CHS_{name}_HIGH" if low else f"CHS_{name}"
        lines.append(f"/* {function.__doc__} = {form}, P = {value}")
        lines.append(f"   on [0, {mp.nstr(top, 5)}], {kind} error {mp.nstr(bound, 2)} eps */")
        if low:
            lines += macro(f"{name}_LOW", x, constants[:low]) + macro(f"{name}_HIGH", x, constants[low:])
        else:
            lines += macro(name, x, constants)
    lines += turn_macros(TURN_DEGREES[choice], bits, suffix)
    lines.append(f"#define CHS_ARC_SPREAD {hexfloat(SPREAD, bits)}{suffix}")
    for name, value in [("PI", pi), ("HALF_PI", pi / 2), ("QUARTER_PI", pi / 4)]:
        for letter, piece in zip("AB", split(value, bits, 2)):
            lines.append(f"#define CHS_{name}_{letter} {hexfloat(piece, bits)}{suffix}")
    # So few digits in the first part that its products with integers up to the limit are exact.
    limit = LIMITS[choice]
    high = round_to(pi / 2, bits - limit)
    for letter, piece in [("A", high), ("B", round_to(pi / 2 - high, bits))]:
        lines.append(f"#define CHS_RIGHT_ANGLE_{letter} {hexfloat(piece, bits)}{suffix}")
    lines.append(f"#define CHS_RIGHT_ANGLE_LIMIT {hexfloat(mpf(2) ** limit, bits)}{suffix}")
    fraction = mpf(2) ** SHORT_PI[choice]
    short = round(pi * fraction) / fraction
    for letter, piece in [("SHORT", short), ("REST", round_to(pi - short, bits))]:
        lines.append(f"#define CHS_PI_{letter} {hexfloat(mpf(piece), bits)}{suffix}")
    return lines


def header():
    lines = [
        "/* Written by tools/coefficients/generate.py; do not edit.",
        " * Polynomials by Estrin's scheme, those in two halves with CHS_HIGH for the power between; constants as unevaluated",
        " * sums A + B, pi also as SHORT + REST. */",
        "#ifndef CHASLES_COEFFICIENTS_H",
        "#define CHASLES_COEFFICIENTS_H",
        "",
        "/* clang-format off */",
        "#define CHS_POWER_2(x) ((x) * (x))",
        "#define CHS_POWER_4(x) (CHS_POWER_2(x) * CHS_POWER_2(x))",
        "#define CHS_POWER_8(x) (CHS_POWER_4(x) * CHS_POWER_4(x))",
    ]
    for precision, bits, suffix in FORMATS:
        lines += ["#ifndef CHS_SINGLE" if precision == "double" else "#else"] + section(precision, bits, suffix)
    return "\n".join(lines + ["#endif", "/* clang-format on */", "", "#endif", ""])


def main():
    parser = argparse.ArgumentParser(description="write src/coefficients.h")
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 if the committed file differs")
    if parser.parse_args().check:
        same = HEADER.read_text() == header()
        print(f"{HEADER.name}: {'same' if same else 'differs'}")
        return 0 if same else 1
    HEADER.write_text(header())
    return 0


if __name__ == "__main__":
    sys.exit(main())
