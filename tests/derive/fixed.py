#!/usr/bin/env python3
"""The tables and constants of Q31 (src/arithmetic/fixed/{rotation,root,scaled}.rs), from their definitions.

    python3 tests/derive/fixed.py            writes tests/derive/fixed.txt
    python3 tests/derive/fixed.py --check    compares with it

Unit tests of the crate compare the same file with the tables that the compiler built. It needs mpmath
(`pip install mpmath`, or Debian's python3-mpmath).

The crate computes its tables in integers. Those whose entries are the true values to the nearest, or their
floors, are derived here by mpmath at 60 digits. Those of scaled.rs have 63 bits, of which the crate's
truncated series lose the last few: here the series is repeated, and mpmath says that an entry is at most
`LOST` units from the true value.

What decides each constant that is not a mathematical one:

    ARC_LESS      pi/4 delta^2 / 96 at the edge of a part, in 2^-26, to the nearest
    NEAREST_PART  half a part less 1/256: below half by more than the largest reciprocal is too large
    INWARD        the largest shift with which no rounded vector is longer than the true one: `too_long`
"""

import random
import sys
from pathlib import Path

from mpmath import floor, ln, mp, mpf, pi, sin, sqrt, tan

mp.dps = 60
COMMITTED = Path(__file__).with_name("fixed.txt")
PARTS, ARC_LESS, INWARD = 128, 5, 29
NEAREST_PART = (1 << 23) - (1 << 16)
MASK = 0xFFFFFFFF
# Of the entries of LOGARITHMS and POWERS, in units of 2^-63.
LOST = {"LOGARITHMS": 24, "POWERS": 24}


def nearest(x):
    return int(floor(x + mpf(0.5)))


QUARTER_PI = int(floor(pi / 4 * 2**62))
ARC = nearest(pi / 4 * 2**26 * (1 - (pi / 4 / (2 * PARTS)) ** 2 / 96))
TANGENTS = [nearest(tan(pi / 8 * j / PARTS) * 2**32) for j in range(PARTS + 1)]
SINES = [nearest(sin(pi / 4 * j / PARTS) * 2**32) for j in range(PARTS + 1)]
# 2^42 / m in the middle of [k, k + 1) 2^23.
RECIPROCALS = [int(floor(mpf(2) ** 42 / ((k + mpf(0.5)) * 2**23))) for k in range(32, 256)]
# 1 / sqrt x in 2^-15 in the middle of [k, k + 1) / 128, of 16 bits.
SEEDS = [0] * 32 + [
    min(int(floor(2**15 / sqrt((k + mpf(0.5)) / 128))), 0xFFFF) for k in range(32, 128)
]
LN_2, LOG2_E = int(floor(ln(2) * 2**64)), int(floor(2**63 / ln(2)))
# 1 / m, in 2^-15, for the lowest m of a part of [1/2, 1), rounded up.
FACTORS = [-(-(1 << 22) // (64 + part)) for part in range(64)]


def logarithms():
    """ln c in 2^-63 as 2 atanh w, w = (c - 1) / (c + 1)."""
    table, one = [], 1 << 15
    for c in FACTORS:
        w = ((c - one) << 63) // (c + one)
        power, total, odd = w << 1, 0, 1
        while power > 0:
            total += power // odd
            odd += 2
            power = (power * w >> 63) * w >> 63
        assert abs(total - ln(mpf(c) / one) * 2**63) <= LOST["LOGARITHMS"]
        table.append(total)
    return table


def toward_zero(a, b):
    return a // b if a >= 0 else -(-a // b)


def powers():
    """2^(-j/32) in 2^-63 by the series of exp."""
    table = []
    for j in range(32):
        x = (LN_2 >> 1) * j // 32
        power, total, order = 1 << 63, 0, 1
        while power != 0:
            total += power
            power = toward_zero(-power * x, order << 63)
            order += 1
        assert abs(total - mpf(2) ** (63 - mpf(j) / 32)) <= LOST["POWERS"]
        table.append(total)
    return table


def committed():
    yield "QUARTER_PI", [QUARTER_PI]
    yield "FOUR_OVER_PI", [int(floor(4 / pi * 2**62))]
    yield "ARC", [ARC]
    yield "NEAREST_PART", [NEAREST_PART]
    yield "INWARD", [INWARD]
    yield "TANGENTS", TANGENTS
    yield "SINES", SINES
    yield "RECIPROCALS", RECIPROCALS
    yield "SEEDS", SEEDS
    yield "LN_2", [LN_2]
    yield "LOG2_E", [LOG2_E]
    yield "FACTORS", FACTORS
    yield "LOGARITHMS", logarithms()
    yield "POWERS", powers()


# The rotation of rotation.rs in whole numbers.


def reciprocal(m):
    crude = RECIPROCALS[(m >> 23) - 32]
    two_less = -((m >> 11) * crude) & MASK
    return crude * (two_less >> 15) >> 12


def rotate(m, n, inward):
    r = reciprocal(m)
    part = ((n >> 15) * r + NEAREST_PART) >> 24
    d = ((n << 7) - m * part) & MASK
    d -= (d >> 31) << 32
    arc = d * ARC >> 32
    delta = (arc >> 8) * r >> 15
    sagitta = (arc >> 8) * delta >> 17
    cube = sagitta * delta
    q = arc - ((cube + (cube >> 2)) >> 26)
    p = 2 * m - sagitta - (m >> inward)
    across = (p * TANGENTS[part] >> 32) + q
    x = p - (across * SINES[part] >> 32)
    return x, (x * TANGENTS[part] >> 32) + across


def too_long(inward, count):
    """By how much a vector at the rim is longer than m + 1/2 at most, in 2^-32."""
    source = random.Random(1)
    worst = mpf(-9)
    for _ in range(count):
        m = 0x7FFFFFFF - source.getrandbits(source.randrange(1, 24))
        x, y = rotate(m, source.randrange(m + 1), inward)
        # x^2 + y^2 - l^2 = (length - l) (length + l), and the sum is nearly 2 l.
        l = 2 * m + 1
        worst = max(worst, mpf(x * x + y * y - l * l) / (2 * l))
    return worst


def definitions():
    assert ARC == (QUARTER_PI >> 36) - ARC_LESS
    # How far a reciprocal is too large, in parts at the diagonal; each serves all m of the same upper 20 bits.
    excess = max(
        (mpf(reciprocal(m)) * m / 2**46 - 1) * PARTS
        for m in ((upper << 11) + 0x7FF for upper in range(1 << 17, 1 << 20, 61))
    )
    assert excess < mpf(1) / 256
    print(f"NEAREST_PART: a quotient is too large by at most 2^{float(mp.log(excess, 2)):.1f} parts")
    short, long = too_long(INWARD, 20_000), too_long(INWARD + 1, 20_000)
    assert short < 0 < long
    print(f"INWARD: with {INWARD} a vector is {float(short):+.2f} units from the rim, with {INWARD + 1} {float(long):+.2f}")
    # The residual over two roots is within a unit of the root only if a seed is good to 2^-6 or so.
    worst = max(
        abs(seed * sqrt(mpf(x) / 128) / 2**15 - 1)
        for k, seed in enumerate(SEEDS)
        if k >= 32
        for x in (k, k + 1)
    )
    # Two Newton steps, e -> 3/2 e^2.
    after = mpf(1.5) * (mpf(1.5) * worst**2) ** 2
    assert after < mpf(2) ** -24
    print(f"SEEDS: within 2^{float(mp.log(worst, 2)):.1f}, after two Newton steps 2^{float(mp.log(after, 2)):.1f}")


def main(arguments):
    definitions()
    text = "".join(f"{name} {' '.join(f'{v:x}' for v in values)}\n" for name, values in committed())
    if not arguments:
        COMMITTED.write_text(text)
    elif arguments == ["--check"]:
        assert COMMITTED.read_text() == text, f"{COMMITTED} is not what this script derives"
        print(f"{COMMITTED.name}: as derived")
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
