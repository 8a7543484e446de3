"""What a vector file is made of: a function under test, its bands of cases, and the text of the file.

    chasles-vectors 1
    function so3_exp
    precision double
    inputs 3
    outputs 9
    group diagonal max 0 4 8
    group off_diagonal max 1 2 3 5 6 7
    case tiny_0001 tiny 0
    in 0x1.8p-700 0 -0x1p-701
    out 0x1p0 0 0x1.8p-700 -0x1p-760 ...     pairs hi lo, one pair an output: the exact result is hi + lo
    scale 0x1p0 0x1.8p-700                   one a group: the error is divided by eps times this

The status is an integer, or several joined by | where rounding decides. With a negative status there is no result, so
`out` and `scale` are absent. A function without outputs, whose answer is its status, never has them.
"""

import random

from mpmath import ldexp

from exact import BASE_BITS
from formats import pair_text, scale_text, text, value

ATTEMPTS = 400  # to build one case that is clear of thresholds
NOISE_BITS = BASE_BITS - 96  # what is smaller than 2**-NOISE_BITS of its scale is rounding of this program


class Unclear(Exception):
    """The case lies where the specification leaves the answer open; build another."""


class Group:
    """Outputs whose errors share a scale: `kind` is max (largest entry) or norm (Euclidean)."""

    def __init__(self, name, kind, indices):
        self.name = name
        self.kind = kind
        self.indices = list(indices)


def all_outputs(name, kind, count):
    return [Group(name, kind, range(count))]


class Result:
    """Exact outputs, one scale a group, and the statuses any of which is right."""

    def __init__(self, outputs, scales, statuses=(0,)):
        self.outputs = outputs
        self.scales = scales
        self.statuses = tuple(sorted(statuses))


class Band:
    """`count` cases named `label`_0001 and so on: build(fmt, rng, k) gives the inputs of the k-th."""

    def __init__(self, name, count, build, label=None):
        self.name = name
        self.count = count
        self.build = build
        self.label = label or name
        self.status = None


class Errors(Band):
    """Cases that must answer `status`, negative; the function has no result there."""

    def __init__(self, status, inputs, label, band="degenerate"):
        super().__init__(band, len(inputs), lambda fmt, rng, k: inputs[k], label)
        self.status = status


class Listed(Band):
    """Cases whose inputs are written down."""

    def __init__(self, name, inputs, label=None):
        super().__init__(name, len(inputs), lambda fmt, rng, k: inputs[k], label)


class Function:
    """A function under test: evaluate(fmt, inputs) gives its Result, bands(fmt, rng) its Bands."""

    def __init__(self, name, inputs, groups, evaluate, bands):
        self.name = name
        self.inputs = inputs
        self.groups = groups
        self.outputs = sum(len(group.indices) for group in groups)
        self.evaluate = evaluate
        self.bands = bands

    def file_name(self, fmt):
        return "%s.%s.txt" % (self.name, fmt.suffix)

    def file_text(self, fmt):
        """The whole vector file of one precision."""
        rng = random.Random("chasles %s %s" % (self.name, fmt.suffix))
        lines = ["chasles-vectors 1", "function " + self.name, "precision " + fmt.name]
        lines += ["inputs %d" % self.inputs, "outputs %d" % self.outputs]
        for group in self.groups:
            lines.append("group %s %s %s" % (group.name, group.kind, " ".join(str(i) for i in group.indices)))
        for band in self.bands(fmt, rng):
            for k in range(band.count):
                lines += self.record("%s_%04d" % (band.label, k + 1), band, fmt, *self.case(band, fmt, rng, k))
        return "\n".join(lines) + "\n"

    def case(self, band, fmt, rng, k):
        """(inputs, Result or None) of the k-th case of a band."""
        for _ in range(ATTEMPTS):
            try:
                inputs = band.build(fmt, rng, k)
                assert len(inputs) == self.inputs, (self.name, band.label, len(inputs))
                if band.status is not None:
                    return inputs, None
                result = self.evaluate(fmt, [value(x) for x in inputs])
                if all(self.resolved(fmt, scale) for scale in result.scales):
                    return inputs, result
            except Unclear:
                pass
        raise RuntimeError("%s %s: no clear case %s_%04d" % (self.name, fmt.name, band.label, k + 1))

    @staticmethod
    def resolved(fmt, scale):
        """Does the format resolve eps times the scale, and hold the scale?"""
        return scale == 0 or ldexp(4, fmt.least) / fmt.eps <= scale < ldexp(1, fmt.greatest)

    def record(self, name, band, fmt, inputs, result):
        """The lines of one case."""
        statuses = (band.status,) if result is None else result.statuses
        lines = ["case %s %s %s" % (name, band.name, "|".join(str(s) for s in statuses))]
        lines.append("in " + " ".join(text(x) for x in inputs))
        if statuses[0] >= 0 and self.groups:
            scale_of = {i: s for group, s in zip(self.groups, result.scales) for i in group.indices}
            pairs = [pair_text(fmt, x, ldexp(scale_of[i], -NOISE_BITS)) for i, x in enumerate(result.outputs)]
            lines.append("out " + " ".join(pairs))
            lines.append("scale " + " ".join(scale_text(s) for s in result.scales))
        return lines
