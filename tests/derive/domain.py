#!/usr/bin/env python3
"""The multiplier of a domain's step, s -> (s + k) M + 1 modulo 2^64 (src/bits/state.rs).

Two chains of d keys lead to the same state if and only if the differences of their keys are a vector of the lattice of
all (k_1, .., k_d) with k_1 M^(d-1) + .. + k_d = 0 modulo 2^64. So the shortest vector says how large keys must be to
collide; it cannot be longer than about 2^(64 / d) (spectral test: D. Knuth, "The Art of Computer Programming", vol. 2,
3.3.4; multipliers of half the width lose little: G. Steele and S. Vigna, "Computationally easy, spectrally good
multipliers for congruential pseudorandom number generators", 2022).

Draws multipliers of 32 bits that are 5 modulo 8, and prints the one whose worst dimension of 2 to 7 is best: for each d
the shortest vector as a power of 2, and its length over 2^(64 / d).
"""

import random
from fractions import Fraction
from math import log2

MODULUS = 1 << 64
DIMENSIONS = range(2, 8)


def reduced(basis):
    """A basis reduced by A. Lenstra, H. Lenstra and L. Lovasz's algorithm."""
    n, k = len(basis), 1
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))

    def orthogonal():
        stars, mu = [], [[Fraction(0)] * n for _ in range(n)]
        for i in range(n):
            star = [Fraction(x) for x in basis[i]]
            for j in range(i):
                mu[i][j] = dot(basis[i], stars[j]) / dot(stars[j], stars[j])
                star = [a - mu[i][j] * b for a, b in zip(star, stars[j])]
            stars.append(star)
        return stars, mu

    stars, mu = orthogonal()
    while k < n:
        for j in range(k - 1, -1, -1):
            q = round(mu[k][j])
            if q:
                basis[k] = [a - q * b for a, b in zip(basis[k], basis[j])]
                stars, mu = orthogonal()
        if dot(stars[k], stars[k]) >= (Fraction(99, 100) - mu[k][k - 1] ** 2) * dot(stars[k - 1], stars[k - 1]):
            k += 1
        else:
            basis[k], basis[k - 1] = basis[k - 1], basis[k]
            stars, mu = orthogonal()
            k = max(k - 1, 1)
    return basis


def shortest(multiplier, d):
    """The length of the shortest vector, of those that the reduction finds: up to d = 7 the shortest of all, or near it."""
    rows = [[MODULUS if i == d - 1 else 0 for i in range(d)]]
    for i in range(d - 1):
        row = [0] * d
        row[i], row[d - 1] = 1, -pow(multiplier, d - 1 - i, MODULUS)
        rows.append(row)
    return min(sum(x * x for x in row) for row in reduced(rows)) ** 0.5


def merit(multiplier, best=0.0):
    worst, lengths = 9.0, []
    for d in DIMENSIONS:
        length = shortest(multiplier, d)
        lengths.append(length)
        worst = min(worst, length / 2 ** (64 / d))
        if worst < best:
            break
    return worst, lengths


def main():
    generator, best, found = random.Random(1), 0.0, None
    for _ in range(2000):
        multiplier = generator.getrandbits(32) | 0x8000_0000
        multiplier = multiplier & ~7 | 5
        worst, lengths = merit(multiplier, best)
        if worst > best:
            best, found = worst, (multiplier, lengths)
    multiplier, lengths = found
    print(f"multiplier {multiplier:#010x}")
    for d, length in zip(DIMENSIONS, lengths):
        print(f"d = {d}: 2^{log2(length):.2f}, {length / 2 ** (64 / d):.3f}")


if __name__ == "__main__":
    main()
