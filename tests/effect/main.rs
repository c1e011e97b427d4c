//! The effects against closed forms and where their geometry degenerates, in every arithmetic of
//! floats.
//!
//! Means are of 4096 scrambled Sobol points, and in one case of random ones, within what chance
//! allows.
#![cfg(all(feature = "libm", feature = "micromath"))]

mod glossy;
mod heuristics;
mod lens;
mod light;
mod occlusion;
mod polygon;
mod statics;

use hemidisc::arithmetic::{Real, Root};
use hemidisc::sequence::{Sequence, SobolOwen};

/// Points of a mean.
const COUNT: u32 = 4096;

/// An arithmetic of floats with the accuracy of its results.
trait Float: Root {
    const EPS: f64;

    fn real(x: f64) -> Self::Real {
        x.to_string().parse().unwrap_or_default()
    }

    fn parameter(e: f64) -> Self::Parameter {
        e.to_string().parse().ok().unwrap()
    }

    fn vector(v: [f64; 3]) -> [Self::Real; 3] {
        v.map(Self::real)
    }
}

impl Float for hemidisc::LibmF64 {
    const EPS: f64 = 1e-12;
}
impl Float for hemidisc::LibmF32 {
    const EPS: f64 = 2e-6;
}
impl Float for hemidisc::FastF32 {
    const EPS: f64 = 2e-6;
}
impl Float for hemidisc::MicromathF32 {
    const EPS: f64 = 4e-3;
}

/// Tests of each arithmetic.
macro_rules! each_float {
    ($($test:ident)*) => {
        $(testkit::test_each_float!($test);)*
    };
}
use each_float;

fn wide<R: Real, const N: usize>(vector: [R; N]) -> [f64; N] {
    vector.map(Into::into)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Mean and its standard error over a sequence.
fn mean(sequence: impl Sequence, value: impl Fn([u32; 2]) -> f64) -> [f64; 2] {
    let values: Vec<f64> = (0..COUNT).map(|i| value(sequence.at(i))).collect();
    let n = f64::from(COUNT);
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (n - 1.0);
    [mean, (variance / n).sqrt()]
}

/// Fails for a value that is NaN or not within `tolerance` of `exact`.
#[track_caller]
fn assert_near(found: f64, exact: f64, tolerance: f64, what: &str) {
    assert!((found - exact).abs() <= tolerance, "{what}: {found}, not {exact} within {tolerance}");
}

/// The mean over scrambled Sobol points.
fn even_mean(value: impl Fn([u32; 2]) -> f64) -> f64 {
    mean(SobolOwen::new(5), value)[0]
}
