//! Points in 16 x 16 cells of equal probability: an angle about the axis, and what the map has made
//! uniform: r^2 on the disc, 1 - z^(e + 1) of a lobe of exponent e.

use super::cases::{Case, every_case};
use super::chi_square::{assert_random, statistic};
use hemidisc::sequence::{Random, Sequence, SobolOwen};
use std::f64::consts::TAU;

const COUNT: u32 = 1 << 16;
const SEEDS: [u32; 3] = [0, 1, 0xdead_beef];

/// The fraction of a turn about the z axis.
fn turn([x, y, _]: [f64; 3]) -> f64 {
    let turn = y.atan2(x) / TAU;
    if turn < 0.0 { turn + 1.0 } else { turn }
}

/// The fraction of points nearer to the axis: by x and y, and by z where it tells.
fn quantiles(case: &Case, [x, y, z]: [f64; 3]) -> [f64; 2] {
    let s2 = x * x + y * y;
    match case.lobe {
        None => [s2; 2],
        // z^(e + 1), with ln z = ln(1 - s^2) / 2 from x and y.
        Some(e) => [(-s2).ln_1p() / 2.0, z.ln()].map(|log| -((e + 1.0) * log).exp_m1()),
    }
}

/// Points in the cells by x and y, and by z.
fn counts(case: &Case, sequence: &impl Sequence) -> [[u32; 256]; 2] {
    let mut counts = [[0; 256]; 2];
    for i in 0..COUNT {
        let point = (case.sample)(sequence.point(i));
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
                assert_random(&counts, &format!("{} by {by}, seed {seed}", case.name));
            }
        }
    });
}

/// Chance gives a statistic of 255 or so. Over the polar map the cells are elementary intervals, so only
/// a point that z rounds across an edge counts (0.08 at e = 1000 in f32); over the concentric map
/// their edges cut elementary intervals (3).
#[test]
fn scrambled_points_fill_cells_far_more_evenly() {
    every_case(|case| {
        for seed in SEEDS {
            for (by, counts) in ["x, y", "z"].into_iter().zip(counts(case, &SobolOwen::new(seed))) {
                let deviation = statistic(&counts);
                let limit = if case.polar { 0.2 } else { 6.0 };
                assert!(deviation <= limit, "{} by {by}, seed {seed}: {deviation}", case.name);
            }
        }
    });
}
