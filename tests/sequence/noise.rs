//! What has no strata: random points are uniform and uncorrelated, along indices and along seeds;
//! R2 visits every cell of an axis once in 2^32 points, and its discrepancy is low for every N.

use hemidisc::{
    bits::hash::mix,
    sequence::{R2, Random, Sobol},
};
use testkit::chi_square::assert_random;

const COUNT: u32 = 1 << 16;
const SEEDS: [u32; 8] = [0, 1, 2, 3, 0x8000_0000, 0x2000_0000, 0xdead_beef, u32::MAX];

fn unit(cell: u32) -> f64 {
    (f64::from(cell) + 0.5) / 4_294_967_296.0
}

/// Pairs are uniform over 16 x 16 cells by their high bits, and by their low bits.
fn assert_pairs(pairs: impl Fn(u32) -> [u32; 2], what: &str) {
    for (bits, shift) in [("high", 28), ("middle", 14), ("low", 0)] {
        let mut counts = [0; 256];
        for [a, b] in (0..COUNT).map(&pairs) {
            counts[((a >> shift & 15) << 4 | b >> shift & 15) as usize] += 1;
        }
        assert_random(&counts, &format!("{bits} bits of {what}"));
    }
    // The correlation of independent pairs is about normal, of variance 1/N.
    let product = |[a, b]: [u32; 2]| (unit(a) - 0.5) * (unit(b) - 0.5) * 12.0;
    let correlation = (0..COUNT).map(|i| product(pairs(i))).sum::<f64>() / f64::from(COUNT);
    let limit = 5.0 / f64::from(COUNT).sqrt();
    assert!(correlation.abs() < limit, "{what}: correlation {correlation}");
}

#[test]
fn random_is_uniform_along_indices() {
    for seed in SEEDS {
        let random = Random::new(seed);
        let what = |pair: &str| format!("{pair}, seed {seed:#x}");
        assert_pairs(|i| random.at(i), &what("u and v"));
        assert_pairs(|i| random.at(u32::MAX - i), &what("u and v, last indices"));
        assert_pairs(|i| random.at(i << 16), &what("u and v, every 65,536th"));
        for lag in [1, 2, 64, 4096] {
            for (axis, other) in [(0, 0), (1, 1), (0, 1), (1, 0)] {
                let pair = |i| [random.at(i)[axis], random.at(i + lag)[other]];
                assert_pairs(pair, &what(&format!("axes {axis}, {other} at lag {lag}")));
            }
        }
    }
}

#[test]
fn random_is_uniform_along_seeds() {
    for index in [0, 1, 0x8000_0000, u32::MAX] {
        let what = |pair: &str| format!("{pair}, point {index}");
        assert_pairs(|seed| Random::new(seed).at(index), &what("u and v"));
        assert_pairs(|i| Random::new(i << 16).at(index), &what("u and v, high seeds"));
        for axis in [0, 1] {
            let pair = |seed: u32| [0, 1].map(|next| Random::new(seed + next).at(index)[axis]);
            assert_pairs(pair, &what(&format!("axis {axis} of neighbouring seeds")));
        }
    }
}

/// A random walk finds the gaps that cells do not: the product of a bit of u and one of v.
#[test]
fn random_bits_are_independent() {
    for seed in SEEDS {
        let random = Random::new(seed);
        let mut agreements = [[0_u32; 32]; 32];
        for [u, v] in (0..COUNT / 4).map(|i| random.at(i)) {
            for (bit, row) in agreements.iter_mut().enumerate() {
                let agree = if u >> bit & 1 == 0 { !v } else { v };
                row.iter_mut().enumerate().for_each(|(b, count)| *count += agree >> b & 1);
            }
        }
        let half = f64::from(COUNT / 8);
        for (bit, row) in agreements.iter().enumerate() {
            for (other, &count) in row.iter().enumerate() {
                // 8,192 pairs of bits: 6 standard deviations, each half the root of the count.
                let z = (f64::from(count) - half) / (half / 2.0).sqrt();
                assert!(z.abs() < 6.0, "bits {bit} of u, {other} of v: z = {z}, seed {seed:#x}");
            }
        }
    }
}

/// Each axis is a bijection of the index, because its step is odd: an inverse of the step gives the
/// index back.
#[test]
fn r2_has_the_full_period() {
    for seed in SEEDS {
        let r2 = R2::new(seed);
        let ends = (0..1000).flat_map(|i| [i, u32::MAX - i]);
        let indices: Vec<u32> = ends.chain((0..10_000).map(mix)).collect();
        for axis in [0, 1] {
            let origin = r2.at(u32::MAX)[axis];
            let step = r2.at(0)[axis].wrapping_sub(origin);
            assert_eq!(step % 2, 1, "axis {axis} has a short period");
            // Newton's iteration doubles the correct bits; an odd number is its own inverse to 3.
            let inverse = (0..4).fold(step, |inverse, _| {
                inverse.wrapping_mul(2_u32.wrapping_sub(step.wrapping_mul(inverse)))
            });
            for &i in &indices {
                let steps = r2.at(i)[axis].wrapping_sub(origin).wrapping_mul(inverse);
                assert_eq!(steps, i.wrapping_add(1), "axis {axis}, seed {seed:#x}");
            }
        }
    }
}

/// No seed but 0 shifts both axes of Sobol alike, which would put the first point on the diagonal.
/// All 2^32 seeds are tried.
#[test]
fn shifts_differ_between_axes() {
    const RUN: u32 = 1 << 12;
    for start in (0..=u32::MAX / RUN).map(|run| run * RUN) {
        // Counted without a branch, for speed.
        let alike = (0..RUN)
            .map(|i| Sobol::new(start | i).at(0))
            .fold(0_u32, |count, [u, v]| count.wrapping_add(u32::from(u == v)));
        assert_eq!(alike, u32::from(start == 0), "seeds from {start:#x}");
    }
}

/// A seed shifts all points of R2 alike, and its two axes differently.
#[test]
fn r2_is_shifted() {
    for seed in SEEDS.into_iter().chain((0..100_000).map(|i| mix(!i))) {
        let shift = |index| {
            let (moved, still) = (R2::new(seed).at(index), R2::new(0).at(index));
            [moved[0].wrapping_sub(still[0]), moved[1].wrapping_sub(still[1])]
        };
        let [u, v] = shift(9);
        assert_eq!(shift(u32::MAX), [u, v], "seed {seed:#x}");
        assert_eq!(u == v, seed == 0, "seed {seed:#x}");
    }
}

/// Root mean square star discrepancies of the first 1 ..= N points (T. Warnock, 1972), each a sum
/// that the next point adds to.
fn discrepancies(points: &[[u32; 2]]) -> Vec<f64> {
    let points: Vec<_> = points.iter().map(|point| point.map(unit)).collect();
    let (mut single, mut double) = (0.0, 0.0);
    let mut all = Vec::new();
    for (n, &[x, y]) in points.iter().enumerate() {
        single += (1.0 - x * x) * (1.0 - y * y) / 2.0;
        double += (1.0 - x) * (1.0 - y);
        for &[a, b] in &points[..n] {
            double += 2.0 * (1.0 - x.max(a)) * (1.0 - y.max(b));
        }
        let count = (n + 1) as f64;
        all.push((1.0 / 9.0 - single / count + double / (count * count)).sqrt());
    }
    all
}

/// Over N = 16 ..= 2048 and random shifts, N times the discrepancy was at most 3.5, and from 256 on
/// 0.52 of that of random points; a lattice's would be constant, random points' grows as sqrt N.
#[test]
fn r2_has_low_discrepancy_for_every_count() {
    const LONGEST: u32 = 2048;
    // Independent points: sqrt(5 / 36 / N).
    let random = |n: usize| (5.0 / 36.0 / n as f64).sqrt();
    for seed in SEEDS {
        let r2: Vec<_> = (0..LONGEST).map(|i| R2::new(seed).at(i)).collect();
        for (n, discrepancy) in (1..).zip(discrepancies(&r2)) {
            let what = format!("{n} points, seed {seed:#x}: {discrepancy}");
            assert!(n < 16 || discrepancy < 4.0 / n as f64, "{what}");
            assert!(n < 256 || discrepancy < 0.6 * random(n), "{what}");
        }
    }
    // The measure itself: Sobol's is as low, random points' is what it should be.
    let sobol: Vec<_> = (0..LONGEST).map(|i| Sobol::new(0).at(i)).collect();
    assert!(discrepancies(&sobol)[LONGEST as usize - 1] < 0.1 * random(LONGEST as usize));
    let noise: Vec<_> = (0..LONGEST).map(|i| Random::new(1).at(i)).collect();
    let ratio = discrepancies(&noise)[LONGEST as usize - 1] / random(LONGEST as usize);
    assert!((0.4..2.0).contains(&ratio), "random points: {ratio} of their discrepancy");
}
