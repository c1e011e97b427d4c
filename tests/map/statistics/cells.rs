//! Points in 16 x 16 cells of equal probability: an angle about the axis, and what the map has made
//! uniform: r^2 on the disc, 1 - z^(e + 1) of a lobe of exponent e.

use super::cases::{Case, every_case};
use hemidisc::sequence::{Random, Sequence, SobolOwen};
use std::f64::consts::TAU;
use testkit::chi_square::{assert_random, statistic};

const COUNT: u32 = 1 << 16;
/// A coarse arithmetic adds up to 71 to a statistic that chance spreads by 23, which is as much as
/// the bound of random points leaves: a seed of which chance is 2 deviations out would be over it.
const SEEDS: [u32; 3] = [0, 1, 0xfeed_f00d];

/// The fraction of a turn about the z axis.
fn turn([x, y, _]: [f64; 3]) -> f64 {
    let turn = y.atan2(x) / TAU;
    if turn < 0.0 { turn + 1.0 } else { turn }
}

/// The fraction of points nearer to the axis: by x and y, and by z where it is accurate enough.
fn quantiles(case: &Case, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let s2 = x * x + y * y;
    match case.lobe {
        None => [s2; 2],
        // z^(e + 1), with ln z = ln(1 - s^2) / 2 from x and y.
        Some(e) => [(-s2).ln_1p() / 2.0, z.ln()].map(|log| -((e + 1.0) * log).exp_m1()),
    }
}

/// Whether z gives the fraction to well under a cell: near the pole that of fixed point has few
/// digits.
fn z_tells(case: &Case) -> bool {
    !case.fixed || case.lobe.is_none_or(|e| (e + 1.0) * case.position() < 2e-3)
}

/// Points in the cells by x and y, and by z.
fn counts(case: &Case, sequence: &impl Sequence) -> [[u32; 256]; 2] {
    let mut counts = [[0; 256]; 2];
    for i in 0..COUNT {
        let point = (case.sample)(sequence.at(i));
        let column = ((turn(point) * 16.0) as usize).min(15);
        for (counts, quantile) in counts.iter_mut().zip(quantiles(case, point)) {
            assert!((0.0..=1.0).contains(&quantile), "{}: {point:?}", case.name);
            counts[column * 16 + ((quantile * 16.0) as usize).min(15)] += 1;
        }
    }
    counts
}

#[test]
fn random_points_fill_cells_as_chance_does() {
    every_case(|case| {
        for seed in SEEDS {
            for (by, counts) in ["x, y", "z"].into_iter().zip(counts(case, &Random::new(seed))) {
                if by == "z" && !z_tells(case) {
                    continue;
                }
                assert_random(&counts, &format!("{} by {by}, seed {seed}", case.name));
            }
        }
    });
}

/// The largest error of the fraction that [`quantiles`] finds by x and y, or by z.
fn fraction_error(case: &Case, by: &str) -> f64 {
    let e = case.lobe.unwrap_or(0.0);
    if by == "z" && case.fixed && case.lobe.is_some() {
        return (e + 1.0) * case.position();
    }
    // At z = 1/16, the last edge of a uniform lobe, z from x and y is 16 times less accurate;
    // overall twice.
    let horizon = if by == "x, y" && case.lobe.is_some_and(|e| e < 0.5) { 2.2 } else { 1.0 };
    case.shift(e) * horizon
}

/// Chance gives a statistic of 255 or so. Over the polar map the cells are elementary intervals, so
/// only a point that z rounds across an edge counts (0.08 at e = 1000 in f32); over the concentric
/// map their edges cut elementary intervals (3). A coarse arithmetic moves points across edges:
/// with an error d of the fraction the 2^22 d points next to the 32 edges may change cells, at
/// 1/128 each, and all of one side of an edge are 4096 d of a cell's 256 (measured with
/// `micromath`: 2 by polar, 5 by concentric, 71 by x and y for e = 0).
#[test]
fn scrambled_points_fill_cells_far_more_evenly() {
    every_case(|case| {
        for seed in SEEDS {
            for (by, counts) in ["x, y", "z"].into_iter().zip(counts(case, &SobolOwen::new(seed))) {
                if by == "z" && !z_tells(case) {
                    continue;
                }
                let deviation = statistic(&counts);
                let error = fraction_error(case, by);
                let moved = 32_768.0 * error + (4096.0 * error).powi(2);
                let limit = (if case.polar { 0.2 } else { 6.0 }) + moved;
                let limit = limit.min(100.0);
                assert!(deviation <= limit, "{} by {by}, seed {seed}: {deviation}", case.name);
            }
        }
    });
}
