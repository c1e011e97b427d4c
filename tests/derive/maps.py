#!/usr/bin/env python3
"""Reference values of every map for hard coordinates and exponents, by mpmath at 120 digits.

Writes testkit/vectors/maps.csv and, for arithmetics that read 16 bits of a coordinate, maps_16.csv:
python3 tests/derive/maps.py

The formulas are the textbook's, on the exact centres (2k + 1) / 2^33, or (2c + 1) / 2^17 of cells of 16 bits,
with no thought for rounding:
    polar       r = sqrt v, phi = 2 pi u
    concentric  a = 2u - 1, b = 2v - 1, r the larger in magnitude, phi = pi/4 b/a or pi/2 - pi/4 a/b
    uniform     z = 1 - r^2;  cosine z = sqrt(1 - r^2);  power z = (1 - r^2)^(1 / (e + 1))
Each real is written as two doubles, hi + lo, as the 16 hex digits of their bits, and so is the exponent: most
are values of an f32, so that f32 and f64 are tested with the same one; the others are for f64 alone.
s2 is x^2 + y^2 of the point.
"""

import random
import struct
from pathlib import Path

from mpmath import mp, mpf, cos, sin, pi, sqrt

mp.dps = 120


def bits(x):
    return f"{struct.unpack('>Q', struct.pack('>d', x))[0]:016x}"


def pair(x):
    """hi + lo; below 1e-290, out of a double's normal range, lo is 0."""
    hi = float(x)
    lo = float(x - mpf(hi)) if abs(x) > mpf(10) ** -290 else 0.0
    return f"{bits(hi)},{bits(lo)}"


def f32(x):
    return struct.unpack(">f", struct.pack(">f", x))[0]


HALF = 1 << 31
TOP = (1 << 32) - 1
EDGES = [0, 1, 2, 255, 256, 1 << 16, 1 << 24, 1 << 29, 1 << 30, 3 << 29]
EDGES += [HALF - 257, HALF - 2, HALF - 1, HALF, HALF + 1, HALF + 256]
EDGES += [5 << 29, 3 << 30, 7 << 29, TOP - (1 << 24), TOP - 256, TOP - 2, TOP - 1, TOP]


# The worst of 150,000 random and hard coordinates for libm f64, for each map and kind of error; the
# first is that of the density, at e = 106.
WITNESSES = [
    (0xde81bfc5, 0xffffffff),
    (0x60faadb0, 0xfecbe64a),
    (0xe23df073, 0xcab224ff),
    (0xa2f3e8c4, 0xef432de6),
    (0x1e8444b2, 0xffef0fb5),
    (0xfffd1599, 0x35ef08ed),
    (0xfffb664c, 0x048c1fe9),
    (0x062fc885, 0x16974153),
    (0x00014c77, 0x130b9683),
    (0xedc7ac81, 0x5fd43586),
    (0x2acbaaca, 0x11930548),
    (0x185303c2, 0xffdd6a77),
    (0x1d56e69e, 0xd2d468ac),
    (0x237a30d8, 0xffffffe7),
    (0x58bacdf2, 0xe52d198a),
    (0xf8740bf1, 0x00000003),
    (0x276ded61, 0xfac7f40a),
    (0xf5385da3, 0xfffff16d),
    (0xe4e20474, 0x00000630),
    (0xd0961621, 0x00000062),
    (0xd95c1697, 0xfffffe84),
    (0x7bab800a, 0x0c49f759),
    (0xc55b4c8e, 0x2df425c6),
    (0xc2417220, 0x00000023),
    (0xf8f9ef7f, 0xfffffffd),
    (0x6577d010, 0x000005d0),
    (0x0f648b74, 0xffffe66a),
    (0x07b904ef, 0xffff9c8a),
    (0xfd7c2f8b, 0x24eb34de),
    (0xffff6da9, 0x56a96c36),
    (0xfff2cc8a, 0xdf7598ce),
    (0x94759d63, 0x9be5752e),
    (0x8b8a1191, 0x809a221d),
    (0x072ad765, 0x0008023a),
    (0x76b6751d, 0xfff7f98b),
]


def coordinates_32():
    """Corners, axes, diagonals, rings one cell apart, and random points."""
    chosen = [(a, b) for a in (0, HALF - 1, HALF, TOP) for b in (0, HALF - 1, HALF, TOP)]
    chosen += [(k, k) for k in EDGES] + [(k, TOP - k) for k in EDGES]
    chosen += WITNESSES
    source = random.Random(2007)
    chosen += [(source.choice(EDGES), source.getrandbits(32)) for _ in range(12)]
    chosen += [(source.getrandbits(32), source.choice(EDGES)) for _ in range(12)]
    chosen += [(source.getrandbits(32), source.getrandbits(32)) for _ in range(16)]
    return list(dict.fromkeys(chosen))


def coordinates_16():
    """Corners, axes, diagonals, rings, powers of two from the edges and the centre, and random points."""
    half, top = 1 << 15, (1 << 16) - 1
    edges = [0, top, half - 1, half]
    for bit in range(16):
        for base in (1 << bit, half + (1 << bit), half - (1 << bit), top + 1 - (1 << bit)):
            edges += [base - 1, base, base + 1]
    edges = sorted({k for k in edges if 0 <= k <= top})
    chosen = [(a, b) for a in (0, 1, half - 1, half, top) for b in (0, 1, half - 1, half, top)]
    source = random.Random(2007)
    anywhere = lambda: source.getrandbits(16)
    for n, k in enumerate(edges):
        # On a diagonal, on one of the two outer rings, or anywhere else, in turn.
        rest = (source.choice((k, top - k)), source.choice((0, 1, top - 1, top)), anywhere())[n % 3]
        chosen.append((k, rest) if source.getrandbits(1) else (rest, k))
    chosen += [(k, k) for k in (2, 3, half - 2, half + 1, top - 2)]
    chosen += [(anywhere(), anywhere()) for _ in range(64)]
    return list(dict.fromkeys(chosen))


EXPONENTS = [f32(e) for e in (-0.9, 0.0, 2.0**-149, 2.0**-24, 0.5, 1.0, 3.3, 10.0, 1e2, 106, 1e3, 1e4, 1e8)]
EXPONENTS += [f32(2.0**100), f32(3e38)]
# Where 1 + e rounds as badly as it can: in f32, then in f64.
EXPONENTS += [f32(1.7881393e-7), f32(1.7947187e-4), f32(0.03), 1e-3, 1 / 3, 5 * 2.0**-54]
# Fixed point: multiples of 2^-32 from 0 to below 2^32.
EXPONENTS_16 = [0.0, 2.0**-32, 0.5, 1.0, 10.0, 100.0, 1e4, 1e8, 2.0**32 - 2.0**-20]


def disc(name, u, v):
    """Direction, r^2 and 1 - r^2."""
    if name == "polar":
        phi = 2 * pi * u
        return cos(phi), sin(phi), v
    a, b = 2 * u - 1, 2 * v - 1
    if abs(a) >= abs(b):
        r, phi = a, pi / 4 * (b / a)
    else:
        r, phi = b, pi / 2 - pi / 4 * (a / b)
    sign = 1 if r > 0 else -1
    return sign * cos(phi), sign * sin(phi), r * r


def table(width, coordinates, exponents):
    """The lines of a table of coordinates of `width` bits."""
    yield "map,disc,exponent,u,v,x_hi,x_lo,y_hi,y_lo,z_hi,z_lo,s2_hi,s2_lo,density_hi,density_lo"
    for name in ("polar", "concentric"):
        for ku, kv in coordinates:
            u, v = (mpf(2 * k + 1) / 2 ** (width + 1) for k in (ku, kv))
            c, s, r2 = disc(name, u, v)
            rim = 1 - r2
            rows = [("disc", "", r2, None, 1 / pi)]
            rows.append(("uniform", "", 1 - rim * rim, rim, 1 / (2 * pi)))
            rows.append(("cosine", "", r2, sqrt(rim), sqrt(rim) / pi))
            for value in exponents:
                e = mpf(value)
                z = rim ** (1 / (e + 1))
                density = (e + 1) / (2 * pi) * rim ** (e / (e + 1))
                rows.append(("power", bits(value), 1 - z * z, z, density))
            digits = width // 4
            for kind, exponent, s2, z, density in rows:
                radius = sqrt(s2)
                z = pair(z) if z is not None else ","
                yield (
                    f"{kind},{name},{exponent},{ku:0{digits}x},{kv:0{digits}x},{pair(radius * c)},"
                    f"{pair(radius * s)},{z},{pair(s2)},{pair(density)}"
                )


def main():
    vectors = Path(__file__).parents[2] / "testkit" / "vectors"
    for name, *of in (
        ("maps.csv", 32, coordinates_32(), EXPONENTS),
        ("maps_16.csv", 16, coordinates_16(), EXPONENTS_16),
    ):
        (vectors / name).write_text("".join(f"{line}\n" for line in table(*of)))


main()
