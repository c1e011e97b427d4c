//! Densities: each integrates to 1, is 0 outside, and is the density of the map's own samples.

use super::cases::{Case, every_case, every_lobe};
use hemidisc::sequence::SobolOwen;
use std::f64::consts::{PI, TAU};

const COUNT: u32 = 1 << 16;

/// Nodes and weights of Gauss and Legendre's rule on [-1, 1], by Newton's method on P_16.
fn gauss_legendre() -> Vec<[f64; 2]> {
    const N: usize = 16;
    (0..N)
        .map(|i| {
            let mut x = (PI * (i as f64 + 0.75) / (N as f64 + 0.5)).cos();
            let mut slope = 0.0;
            for _ in 0..20 {
                let (mut before, mut p) = (1.0, x);
                for k in 2..=N {
                    let k = k as f64;
                    (before, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * before) / k);
                }
                slope = N as f64 * (x * p - before) / (x * x - 1.0);
                x -= p / slope;
            }
            [x, 2.0 / ((1.0 - x * x) * slope * slope)]
        })
        .collect()
}

/// The integral of a function over [0, 1], on panels that halve towards both ends: w^2001 is as
/// good as a polynomial on each.
fn integral(function: impl Fn(f64) -> f64) -> f64 {
    let rule = gauss_legendre();
    let halves = (1..=20).map(|k| 0.5_f64.powi(k)).collect::<Vec<_>>();
    let edges = [0.0].into_iter().chain(halves.iter().rev().copied());
    let edges: Vec<f64> =
        edges.chain(halves[1..].iter().map(|half| 1.0 - half)).chain([1.0]).collect();
    let panel = |pair: &[f64]| {
        let (middle, half) = ((pair[0] + pair[1]) / 2.0, (pair[1] - pair[0]) / 2.0);
        rule.iter().map(|[x, weight]| weight * half * function(middle + half * x)).sum::<f64>()
    };
    edges.windows(2).map(panel).sum()
}

/// A direction of height z, and 1 - z without cancellation, at an angle.
fn direction(z: f64, below_1: f64, angle: f64) -> [f64; 3] {
    let sin = (below_1 * (1.0 + z)).sqrt();
    [sin * angle.cos(), sin * angle.sin(), z]
}

fn angles() -> impl Iterator<Item = f64> {
    (0..16).map(|i| TAU * (f64::from(i) + 0.3) / 16.0)
}

/// The mean of the density about a circle of the hemisphere or the disc.
fn about(case: &Case, point: impl Fn(f64) -> [f64; 3]) -> f64 {
    angles().map(|angle| (case.density)(point(angle))).sum::<f64>() / 16.0
}

/// On the disc over r^2, area pi dr^2 a turn. On the hemisphere over z = w^2, solid angle 2 pi dz a turn:
/// the density is then a polynomial in w for every multiple of 1/2 of the exponent.
#[test]
fn densities_integrate_to_1() {
    every_case(|case| {
        let total = match case.lobe {
            None => integral(|r2| {
                let r = r2.sqrt();
                PI * about(case, |angle| [r * angle.cos(), r * angle.sin(), 0.0])
            }),
            Some(_) => integral(|w| {
                let (z, below_1) = (w * w, (1.0 - w) * (1.0 + w));
                TAU * 2.0 * w * about(case, |angle| direction(z, below_1, angle))
            }),
        };
        assert!((total - 1.0).abs() < 8.0 * case.epsilon, "{}: {total}", case.name);
    });
}

/// The density is (e + 1) z^e / (2 pi), and 1 / pi on the disc, at every sample.
#[test]
fn densities_are_those_of_the_formulas() {
    every_case(|case| {
        let points = SobolOwen::new(7);
        for i in 0..COUNT {
            let point = (case.sample)(points.at(i));
            let expected = case.lobe.map_or(1.0 / PI, |e| {
                // z is as exact near the horizon as x and y are near the pole.
                let s2 = point[0] * point[0] + point[1] * point[1];
                let log = if s2 < 0.5 { (-s2).ln_1p() / 2.0 } else { point[2].ln() };
                (e + 1.0) * (e * log).exp() / TAU
            });
            let error = ((case.density)(point) - expected).abs() * PI;
            // Relative to the peak, which is the scale of what is averaged.
            let error = error / case.lobe.map_or(1.0, |e| e + 1.0) / case.epsilon;
            assert!(error < 3.0, "{}: {error} epsilon at {point:?}", case.name);
        }
    });
}

#[test]
fn densities_are_0_outside() {
    every_case(|case| {
        let zero =
            |point: [f64; 3]| assert_eq!((case.density)(point), 0.0, "{}: {point:?}", case.name);
        for angle in angles() {
            let [x, y] = [angle.cos(), angle.sin()];
            if case.lobe.is_none() {
                for r in [1.0 + 4.0 * case.epsilon, 1.01, 2.0, 1e10] {
                    zero([r * x, r * y, 0.0]);
                }
                continue;
            }
            for z in [0.0, -0.0, -1e-30, -0.001, -0.6, -1.0] {
                let s = (1.0_f64 - z * z).sqrt();
                zero([s * x, s * y, z]);
            }
        }
        zero([f64::NAN; 3]);
        let [x, y, z] = (case.sample)([1 << 30, 3 << 30]);
        zero(if case.lobe.is_some() { [x, y, -z] } else { [x * 3.0, y * 3.0, z] });
    });
}

/// The bounds are about twice what Owen-scrambled points were measured to leave. Random points would
/// leave a hundred times as much.
fn mean(case: &Case, function: impl Fn([f64; 3]) -> f64) -> f64 {
    let points = SobolOwen::new(7);
    (0..COUNT).map(|i| function((case.sample)(points.at(i)))).sum::<f64>() / f64::from(COUNT)
}

/// The mean of 1 / density is the measure of the support: pi of the disc, 2 pi of the hemisphere. Its
/// variance is infinite for e >= 1, and there another lobe's density takes the place of the 1.
#[test]
fn samples_have_the_density() {
    every_case(|case| {
        let Some(e) = case.lobe else {
            let area = mean(case, |point| 1.0 / (case.density)(point));
            assert!(
                (area / PI - 1.0).abs() < 1e-11 + 8.0 * case.epsilon,
                "{}: area {area}",
                case.name
            );
            return;
        };
        if e < 1.0 {
            let angle = mean(case, |point| 1.0 / (case.density)(point));
            assert!((angle / TAU - 1.0).abs() < 4e-4, "{}: solid angle {angle}", case.name);
        }
        for narrow in [e, 1.5 * e + 0.5, 3.0 * e + 2.0] {
            // Also uneven about the axis, which a density that is not would leave uneven.
            for tilt in [0.0, 0.5, -1.0] {
                let other = |[x, y, z]: [f64; 3]| {
                    let s = x.hypot(y);
                    let log = if s < 0.7 { (-s * s).ln_1p() / 2.0 } else { z.ln() };
                    (narrow + 1.0) * (narrow * log).exp() / TAU * (1.0 + tilt * x / s)
                };
                let whole = mean(case, |point| other(point) / (case.density)(point));
                let what = format!("{}: {whole} of a lobe of {narrow}, tilt {tilt}", case.name);
                assert!((whole - 1.0).abs() < 1e-5, "{what}");
            }
        }
    });
}

/// The mean cosine of a lobe is (e + 1) / (e + 2), and its mean direction is the axis.
#[test]
fn mean_direction() {
    every_lobe(|case, e| {
        let [x, y, z] = [0, 1, 2].map(|axis: usize| mean(case, |point| point[axis]));
        let expected = (e + 1.0) / (e + 2.0);
        assert!((z - expected).abs() < 3e-6, "{}: mean cosine {z}, expected {expected}", case.name);
        assert!(x.abs() < 3e-6 && y.abs() < 3e-6, "{}: mean ({x}, {y}, z)", case.name);
    });
}
