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

/// On the disc over r^2, area pi dr^2 a turn. On the hemisphere over z = w^2, solid angle 2 pi dz a
/// turn: the density is then a polynomial in w for every multiple of 1/2 of the exponent.
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
        let e = case.lobe.unwrap_or(0.0);
        // Nowhere is a density of fixed point below 1 LSB of the peak, e + 1 times the mean.
        let floor = if case.fixed { (e + 1.0) * case.density_error } else { 0.0 };
        let error = case.density_error(e) + floor;
        assert!((total - 1.0).abs() < 8.0 * error, "{}: {total}", case.name);
    });
}

/// The density is (e + 1) z^e / (2 pi), and 1 / pi on the disc, at every sample.
#[test]
fn densities_are_those_of_the_formulas() {
    every_case(|case| {
        let points = SobolOwen::new(7);
        for i in 0..COUNT {
            let point = (case.sample)(points.at(i));
            let expected = match case.lobe {
                None => [1.0 / PI; 2],
                Some(e) => {
                    // z is as exact near the horizon as x and y are near the pole, and a coarse
                    // point is not of unit length: the density is that of either.
                    let s2 = point[0] * point[0] + point[1] * point[1];
                    let logs = [(-s2).ln_1p() / 2.0, point[2].ln()];
                    logs.map(|log| (e + 1.0) * (e * log).exp() / TAU)
                }
            };
            let density = (case.density)(point);
            assert!(density > 0.0 && density.is_finite(), "{}: {density}", case.name);
            // Relative to the peak, which is the scale of what is averaged.
            let [by_xy, by_z] = expected.map(|expected| (density - expected).abs() * PI);
            let error = by_xy.min(by_z);
            let e = case.lobe.unwrap_or(0.0);
            let error = error / (e + 1.0) / case.density_error(e);
            assert!(error < 3.0, "{}: {error} times what is due at {point:?}", case.name);
        }
    });
}

#[test]
fn densities_are_0_outside() {
    every_case(|case| {
        // Fixed point has nothing beyond 1, and may round what is outside to inside.
        let inside = |[x, y, _]: [f64; 3]| case.lobe.is_none() && x * x + y * y <= 1.0;
        let zero = |point: [f64; 3]| {
            if !(case.fixed && inside((case.store)(point))) {
                assert_eq!((case.density)(point), 0.0, "{}: {point:?}", case.name);
            }
        };
        for angle in angles() {
            let [x, y] = [angle.cos(), angle.sin()];
            if case.lobe.is_none() {
                let near =
                    if case.fixed { 4.0 * case.position() } else { 4.0 * f64::from(f32::EPSILON) };
                for r in [1.0 + near, 1.01, 2.0, 1e10] {
                    zero([r * x, r * y, 0.0]);
                }
                continue;
            }
            for z in [0.0, -0.0, -1e-30, -0.001, -0.6, -1.0] {
                let s = (1.0_f64 - z * z).sqrt();
                zero([s * x, s * y, z]);
            }
        }
        if !case.fixed {
            zero([f64::NAN; 3]);
        }
        let [x, y, z] = (case.sample)([1 << 30, 3 << 30]);
        zero(if case.lobe.is_some() { [x, y, -z] } else { [x * 3.0, y * 3.0, z] });
    });
}

/// The bounds are about twice what Owen-scrambled points were measured to leave. Random points
/// would leave a hundred times as much.
fn mean(case: &Case, function: impl Fn([f64; 3]) -> f64) -> f64 {
    let points = SobolOwen::new(7);
    (0..COUNT).map(|i| function((case.sample)(points.at(i)))).sum::<f64>() / f64::from(COUNT)
}

/// The mean of 1 / density is the measure of the support: pi of the disc, 2 pi of the hemisphere.
/// Its variance is infinite for e >= 1, and there another lobe's density takes the place of the 1.
#[test]
fn samples_have_the_density() {
    every_case(|case| {
        let Some(e) = case.lobe else {
            let area = mean(case, |point| 1.0 / (case.density)(point));
            assert!(
                (area / PI - 1.0).abs() < 1e-11 + 8.0 * case.density_error,
                "{}: area {area}",
                case.name
            );
            return;
        };
        if e < 1.0 {
            let angle = mean(case, |point| 1.0 / (case.density)(point));
            let limit = 9e-4 + 2.0 * case.shift(e);
            assert!((angle / TAU - 1.0).abs() < limit, "{}: solid angle {angle}", case.name);
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
                assert!((whole - 1.0).abs() < 3e-5 + 2.0 * case.shift(narrow), "{what}");
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
        let limit = 3e-6 + case.position();
        assert!(
            (z - expected).abs() < limit,
            "{}: mean cosine {z}, expected {expected}",
            case.name
        );
        // Mirror images cancel.
        assert!(x.abs() < limit && y.abs() < limit, "{}: mean ({x}, {y}, z)", case.name);
    });
}
