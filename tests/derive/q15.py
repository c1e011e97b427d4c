#!/usr/bin/env python3
"""The tables and constants of Q15 (src/arithmetic/q15/tables.rs and lobes.rs), from their definitions.

    python3 tests/derive/q15.py            writes tests/derive/q15.txt
    python3 tests/derive/q15.py --check    compares with it: seconds
    python3 tests/derive/q15.py --search   also shows that a value chosen by a test is the last that passes

Unit tests of the crate compare the same file with the tables that the compiler built. It needs mpmath
(`pip install mpmath`, or Debian's python3-mpmath). All values are computed to 40 digits.

What decides each constant:

    BUCKETS           the most for which a crude quotient is below 64, the end of LINES
    RECIPROCAL_SHIFT  the largest for which RECIPROCAL has 16 bits
    ROOT_AT_RIM       the largest multiple of 0.05 half LSBs with every point of the uniform lobe inside
    INWARD            the least multiple of 0.05 LSBs with every point of the disc and the lobe inside
    SLOPES            how far a line looks for a slope: see `slopes` below
    TWICE_LN_2_Q30    2 ln 2 to the nearest
    LARGEST_SINE      the largest sine whose product stays below 2^32, less a reserve: see `sines` below

The searches find points outside among all coordinates of a map: a run of coordinates is skipped only
where the largest norm that it can have is inside. The test of the crate that has the last word is

    HEMIDISC_EXHAUSTIVE=1 cargo test --release --all-features --test q15
"""

import sys
from fractions import Fraction
from math import isqrt
from pathlib import Path

from mpmath import atanh, cos, floor, ln, log, mp, mpf, pi, sin, sqrt

mp.dps = 40
COMMITTED = Path(__file__).with_name("q15.txt")

# Half an LSB of 2^-15, and half of 2^-16, in 2^-32.
HALF, HALF_16 = 1 << 16, 1 << 15
BUCKETS, RECIPROCAL_SHIFT = 62, 22
ROOT_AT_RIM, INWARD, SLOPES = Fraction("-0.15"), Fraction("0.65"), 24
TWICE_LN_2_Q30, LARGEST_SINE = 1488522236, 0xFFFD


def real(x):
    return mpf(x.numerator) / x.denominator if isinstance(x, Fraction) else mpf(x)


# Where a quotient is 0/0 its neighbour stands in, as in the crate.
def pole(x):
    y = max(x, mpf("1e-6")) / 2
    return sqrt(-log(1 - y, 2) / y)


def bend(x):
    x = max(x, mpf("1e-6"))
    return sqrt((1 - mpf(4) ** -x) / (2 * ln(2) * x))


# Name: function, buckets, first bucket, scale, bias, biases at the first end and at 1; in 2^-32.
def chord_tables(at_rim=ROOT_AT_RIM):
    return {
        "ROOT": (sqrt, 128, 32, 1, HALF, (real(at_rim) * HALF, HALF)),
        "RECIPROCAL_ROOT": (lambda x: 1 / sqrt((1 + x) / 2), 128, 0, mpf(0.5), HALF_16, (HALF_16,) * 2),
        "LOG": (lambda x: log(1 + x, 2), 64, 0, 1, HALF_16, (HALF_16,) * 2),
        "EXP": (lambda x: mpf(2) ** -x, 64, 0, 1, HALF, (HALF,) * 2),
        "POLE": (pole, 64, 0, mpf(0.5), HALF_16, (HALF_16,) * 2),
        "BEND": (bend, 64, 0, 1, HALF_16, (HALF_16,) * 2),
    }


def chords(function, n, start, scale, bias, ends):
    """The words of `Chords::new`: value in bits 13 to 31, change in bits 1 to 12."""
    one, words = 1 << 32, [0] * start
    for i in range(start, n):
        at = lambda x: function(mpf(x)) * scale
        first, last = at(mpf(i) / n), at(mpf(i + 1) / n)
        gap = (first + last) / 2 - at((mpf(i) + 0.5) / n)
        first = (first - gap / 2) * one + (ends[0] if i == start else bias)
        last = (last - gap / 2) * one + (ends[1] if i == n - 1 else bias)
        first, last = min(first, mpf(one - 1)), min(last, mpf(one - 1))
        change = int(floor(abs(last - first) / 2**15 + 0.5))
        assert change < 1 << 12
        falls = last < first
        middle = (-1 if falls else 1) * 2**14 * change
        begin = int(floor((first + last) / 2 - middle - 2 * change + 2**12)) >> 13 << 13
        while begin + 2 * change + (0 if falls else change * (2**15 - 1)) >= one:
            begin -= 1 << 13
        words.append(begin | change << 1)
    return words


def read(words, x, sign):
    bits = len(words).bit_length() - 1
    word = words[x >> (32 - bits)]
    return word + sign * (word >> 1 & 0xFFF) * ((x << bits & 0xFFFFFFFF) >> 17)


def line(height, slope, centre, slopes):
    """Of the slopes near `slope`, the first whose line, in whole 2^-15, is the nearest to `height`."""
    nearest = int(slope * 2**15)
    best = None
    for s in range(nearest - slopes, nearest + slopes + 1):
        exact = height * 2**15 - s * centre
        intercept = floor(exact + 0.5)
        error = abs(intercept - exact)
        if best is None or error < best[0]:
            best = (error, int(intercept), s)
    return best[1:]


def lines(inward=INWARD, slopes=SLOPES):
    """a, b, c, d of each bucket: cosine a - b t and sine c + d t."""
    table = []
    for i in range(64):
        centre = (mpf(i) + 0.5) / BUCKETS
        angle, within = pi / 4 * centre, 1 - real(inward) / 2**15
        a, b = line(cos(angle) * within, -pi / 4 * sin(angle), centre, slopes)
        c, d = line(sin(angle) * within, pi / 4 * cos(angle), centre, slopes)
        table.append((a, -b, c, d))
    return table


def reciprocals(buckets=BUCKETS, shift=RECIPROCAL_SHIFT):
    middles = [Fraction(256 * (2 * i + 1), 2) for i in range(256)]
    return [0] * 16 + [int((buckets << shift) / m + Fraction(1, 2)) for m in middles[16:]]


def committed():
    """The lines of the file: a name and its values."""
    for name, of in chord_tables().items():
        yield name, chords(*of)
    yield "LINES", [value for row in lines() for value in row]
    yield "RECIPROCAL", reciprocals()
    yield "BUCKETS", [BUCKETS]
    yield "RECIPROCAL_SHIFT", [RECIPROCAL_SHIFT]
    yield "TWICE_LN_2_Q30", [int(floor(2 * ln(2) * 2**30 + 0.5))]
    yield "LARGEST_SINE", [LARGEST_SINE]


def definitions():
    """What needs no search."""
    # A divisor of a row of RECIPROCAL is at most 256 i + 255 where the table has 256 i + 128.
    largest = max(Fraction(256 * i + 255, 256 * i + 128) for i in range(16, 256))
    assert BUCKETS * largest < 64 <= (BUCKETS + 1) * largest
    assert max(reciprocals()) < 1 << 16 <= max(reciprocals(shift=RECIPROCAL_SHIFT + 1))
    assert max(reciprocals()) * 0xFFFF < 1 << 32
    print(f"BUCKETS: a quotient is at most {float(largest):.4f} of the true one: the most is {BUCKETS}")


# The kernels of src/arithmetic/q15/disc.rs and lobes.rs, in whole numbers.


class Kernels:
    def __init__(self, at_rim=ROOT_AT_RIM, inward=INWARD, slopes=SLOPES):
        tables = chord_tables(at_rim)
        self.root = chords(*tables["ROOT"])
        self.lines, self.reciprocals = lines(inward, slopes), reciprocals()

    def root_of(self, x):
        shift = 0
        while x < 1 << 30:
            x, shift = (x << 2) | (shift == 0), shift + 1
        root = read(self.root, x, 1)
        return ((root - HALF) >> shift) + HALF if shift else root

    def concentric_runs(self, a):
        """For every bucket of an odd a: its lines, its first b and that of the next bucket."""
        reciprocal = self.reciprocals[a >> 8]
        b = 1
        while b <= a:
            bucket = b * reciprocal >> RECIPROCAL_SHIFT
            # The first b of the next bucket, odd.
            end = min(-(-((bucket + 1) << RECIPROCAL_SHIFT) // reciprocal) | 1, a + 2)
            if b < end:
                yield self.lines[bucket], b, end
                b = end

    def polar_directions(self):
        """Cosine and sine in 2^-16, by buckets."""
        buckets = {}
        for octant in range(1 << 13):
            t, bucket = 2 * octant + 1, octant * BUCKETS >> 13
            A, B, C, D = self.lines[bucket]
            c = min(((A << 14) - t * B + (1 << 12)) >> 13, 0xFFFF)
            buckets.setdefault(bucket, []).append((c, ((C << 14) + t * D + (1 << 12)) >> 13))
        return list(buckets.values())

    def outside(self, lobe):
        """The first point found outside; None if there is none. `lobe` is disc or uniform."""
        limit = 1 << 30
        # Rows from the rim inward, until 512 in a row have nothing that comes near.
        quiet = 0
        for a in range(0xFFFF, 1 << 12, -2):
            factor = self.factor(lobe, a * a)
            near = False
            for (A, B, C, D), first, end in self.concentric_runs(a):
                # A norm is convex along a line: the largest is at an end. Nothing is cut off yet.
                ends = ((a * A - b * B) ** 2 + (a * C + b * D) ** 2 for b in (first, end - 2))
                if max(ends) * factor**2 <= limit << 62:
                    continue
                near = True
                for b in range(first, end, 2):
                    x = self.lifted(lobe, a * A - b * B, factor)
                    y = self.lifted(lobe, a * C + b * D, factor)
                    if x * x + y * y > limit:
                        return "concentric", a, (x, y)
            quiet = 0 if near else quiet + 1
            if quiet == 512:
                break
        buckets = [(max(c * c + s * s for c, s in of), of) for of in self.polar_directions()]
        quiet = 0
        for v in range(0xFFFF, 0, -1):
            r2 = v << 16 | 0x8000
            r, factor = self.root_of(r2) >> 16, self.factor(lobe, r2)
            near = False
            for largest, points in buckets:
                if largest * r * r * factor**2 <= limit << 64:
                    continue
                near = True
                for c, s in points:
                    x, y = (self.lifted(lobe, k * r >> 1, factor) for k in (c, s))
                    if x * x + y * y > limit:
                        return "polar", v, (x, y)
            quiet = 0 if near else quiet + 1
            if quiet == 512:
                break
        return None

    def factor(self, lobe, r2):
        """In 2^-15."""
        if lobe == "disc":
            return 1 << 15
        return read(self.root, (1 << 30) + ((0xFFFFFFFF - r2) >> 2), 1) >> 16

    @staticmethod
    def lifted(lobe, magnitude, factor):
        return magnitude >> 16 if lobe == "disc" else (magnitude >> 15) * factor >> 16


def inside(**chosen):
    kernels = Kernels(**chosen)
    found = {lobe: kernels.outside(lobe) for lobe in ("disc", "uniform")}
    text = ", ".join(f"{lobe} {'inside' if at is None else f'outside at {at}'}" for lobe, at in found.items())
    print("   ", ", ".join(f"{name} {float(value):.2f}" for name, value in chosen.items()) + ":", text, flush=True)
    return not any(found.values())


def sines():
    """The largest sine for which x times the factor of `lifted_by_sine` is below 2^32 on every circle."""
    kernels, reciprocal_root = Kernels(), chords(*chord_tables()["RECIPROCAL_ROOT"])
    circles = []
    for a in range(isqrt(1 << 31) | 1, 1 << 16, 2):
        # By the lines, whose largest cosine is that of the first, and by Q15Div, whose cosine is at most 65534.
        circles.append((a * a, max(a * kernels.lines[0][0], a * 65534 >> 1)))
    for v in range(1 << 15, 1 << 16):
        r2 = v << 16 | 0x8000
        circles.append((r2, 0xFFFF * (kernels.root_of(r2) >> 16) >> 1))
    circles = [(read(reciprocal_root, r2 << 1 & 0xFFFFFFFF, -1) >> 16, x >> 15) for r2, x in circles]

    def fits(sine):
        return all(x * ((reciprocal * sine + (1 << 14)) >> 15) < 1 << 32 for reciprocal, x in circles)

    assert fits(LARGEST_SINE) and fits(LARGEST_SINE + 1) and not fits(LARGEST_SINE + 2)
    # Where z <= 1/2 the sine is not limited.
    largest = (read(kernels.root, 0xFFFFFFFF, 1) - HALF) >> 16
    assert largest == 0xFFFE
    print(f"LARGEST_SINE: 0xfffe fits its word, 0xffff does not; one unit is in reserve: {LARGEST_SINE:#x}")


def slopes():
    """The largest error of a component of a line within its bucket, in LSBs, for some SLOPES.

    From 4 to 32 INWARD may be 0.65; with 2 or 48 points are outside. Within that range a longer reach has
    smaller errors, so 24 is a choice, not an optimum; another value changes bytes."""
    for reach in (0, 4, 8, 16, 24, 32, 48, 64):
        worst = 0
        for i, (a, b, c, d) in enumerate(lines(slopes=reach)[:BUCKETS]):
            for eighth in range(9):
                t = (i + mpf(eighth) / 8) / BUCKETS
                of = (a - b * t - cos(pi / 4 * t) * 2**15, c + d * t - sin(pi / 4 * t) * 2**15)
                worst = max(worst, *map(abs, of))
        print(f"SLOPES {reach}: a line is within {float(worst):.2f} LSB")


def search():
    slopes()
    step = Fraction("0.05")
    print("INWARD: the least that passes")
    assert inside(inward=INWARD) and not inside(inward=INWARD - step)
    for reach in (4, 32):
        assert inside(inward=INWARD, slopes=reach)
    for reach in (2, 48):
        assert not inside(inward=INWARD, slopes=reach)
    print("ROOT_AT_RIM: the largest that passes")
    assert inside(at_rim=ROOT_AT_RIM) and not inside(at_rim=ROOT_AT_RIM + step)


def main(arguments):
    definitions()
    sines()
    text = "".join(f"{name} {' '.join(f'{v:x}' for v in values)}\n" for name, values in committed())
    if not arguments:
        COMMITTED.write_text(text)
    elif arguments in (["--check"], ["--search"]):
        assert COMMITTED.read_text() == text, f"{COMMITTED} is not what this script derives"
        print(f"{COMMITTED.name}: as derived")
        if arguments == ["--search"]:
            search()
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
