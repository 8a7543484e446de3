"""The two floating-point formats under test, and how their numbers are rounded and written.

Numbers of a format are held as exact mpmath numbers. The values that mpmath does not have (a negative zero) or that
need no arithmetic here (not a number, infinities) are held as the strings that stand for them in a vector file: '-0',
'nan', 'inf', '-inf'. Rounding and writing work on integers only, so the bytes of a file depend on nothing but the
values.
"""

from mpmath import fsub, inf, ldexp, mpf

LO_BITS = 8  # significant bits of the second number of a pair, that is 0.001 of a unit in the last place of the first
SCALE_BITS = 16  # significant bits of a scale
LEAST_EXPONENT = -1074  # nothing finer than double's smallest number is written, in either precision


class Format:
    """A binary format of IEEE 754: `digits` significant bits, multiples of 2**least, below 2**greatest."""

    def __init__(self, name, suffix, digits, least, greatest):
        self.name = name
        self.suffix = suffix
        self.digits = digits
        self.least = least
        self.greatest = greatest
        self.eps = ldexp(1, 1 - digits)
        self.is_double = suffix == "f64"

    def pick(self, double, single):
        """The value that belongs to this format."""
        return double if self.is_double else single

    def round(self, x):
        """x rounded to the nearest number of the format, ties to even. Subnormal numbers included; no overflow."""
        rounded = round_bits(mpf(x), self.digits, self.least)
        if abs(rounded) >= ldexp(1, self.greatest):
            raise OverflowError("%s is beyond the range of %s" % (x, self.name))
        return rounded

    def round_all(self, xs):
        return [self.round(x) for x in xs]


DOUBLE = Format("double", "f64", 53, -1074, 1024)
SINGLE = Format("float", "f32", 24, -149, 128)
FORMATS = (DOUBLE, SINGLE)


def parts(x):
    """(sign, m, e) with x = sign m 2**e, m a Python int, odd or zero."""
    sign, m, e, _ = x._mpf_
    return (-1 if sign else 1), int(m), int(e)


def round_bits(x, digits, least):
    """x rounded, ties to even, to `digits` significant bits and to a multiple of 2**least."""
    sign, m, e = parts(x)
    drop = max(m.bit_length() - digits, least - e)
    if drop <= 0:
        return x
    quotient, rest = m >> drop, m & ((1 << drop) - 1)
    half = 1 << (drop - 1)
    if rest > half or (rest == half and quotient & 1):
        quotient += 1
    return ldexp(mpf(sign * quotient), e + drop)


def value(number):
    """The arithmetic value of a held number: a negative zero is zero."""
    return mpf(0) if number == "-0" else number


def text(number):
    """A number as a C99 hexadecimal constant 0x1.8p3, or 0, -0, nan, inf, -inf."""
    if isinstance(number, str):
        return number
    if number == inf or number == -inf:
        return "inf" if number > 0 else "-inf"
    sign, m, e = parts(number)
    if m == 0:
        return "0"
    exponent = e + m.bit_length() - 1
    fraction_bits = m.bit_length() - 1
    fraction = (m - (1 << fraction_bits)) << (-fraction_bits % 4)
    digits = "%0*x" % ((fraction_bits + 3) // 4, fraction) if fraction_bits else ""
    return "%s0x1%s%sp%d" % ("-" if sign < 0 else "", "." if digits else "", digits, exponent)


def short_text(number):
    """The same in its shortest form, an odd integer times a power of two, for the many low parts: 0x2fp-77."""
    sign, m, e = parts(number)
    return "0" if m == 0 else "%s0x%xp%d" % ("-" if sign < 0 else "", m, e)


def pair_text(fmt, exact, noise):
    """An exact result as `hi lo`. What is no larger than `noise` is rounding of this program and counts as zero."""
    if exact == inf or exact == -inf:
        return text(exact) + " 0"
    if abs(exact) <= noise:
        return "0 0"
    hi = fmt.round(exact)
    rest = fsub(exact, hi, exact=True)
    lo = mpf(0) if abs(rest) <= noise else round_bits(rest, LO_BITS, LEAST_EXPONENT)
    return text(hi) + " " + short_text(lo)


def scale_text(scale):
    return text(round_bits(scale, SCALE_BITS, LEAST_EXPONENT))
