//! The effects with any numbers. Invalid parameters give an error that names them. For valid ones
//! every result is finite, on the lit side, and agrees with the formula.

mod directions;
mod lens;
mod light;

use super::roots::{EachRoot, every_root, nearest, wide};
use crate::arithmetics::{Exponent, Tested};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::Frame;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{BelowHorizon, balance_heuristic, power_heuristic};

#[derive(Arbitrary, Debug)]
struct Input {
    uv: [u32; 2],
    other: [u32; 2],
    /// Of a lens or a light.
    radius: f64,
    distance: f64,
    /// Through the centre of a lens.
    ahead: [f64; 2],
    centre: [f64; 3],
    receiver: [f64; 3],
    /// Made unit vectors.
    normal: [f64; 3],
    arriving: [f64; 3],
    exponent: f32,
    below: BelowHorizon,
    rotation: u32,
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let mut input: Input = Unstructured::new(data).arbitrary()?;
    directions::refused(&input);
    every_root(&mut input);
    Ok(())
}

impl EachRoot for Input {
    fn each<A: Root<Real: Real> + Tested>(&mut self) {
        lens::lens::<A>(self);
        lens::blades::<A, 3>(self);
        lens::blades::<A, 5>(self);
        lens::blades::<A, 6>(self);
        light::check::<A>(self);
        directions::occlusion::<A>(self);
        if let Some(exponent) = A::Parameter::exactly(self.exponent.into())
            && A::exponent(exponent).is_ok()
        {
            directions::glossy::<A>(self, exponent);
        }
    }
}

/// The frame about a vector, or about the z axis where it has no direction.
fn frame<A: Root<Real: Real> + Tested>(vector: [f64; 3]) -> Frame<A::Real> {
    let up = nearest::<A, 3>([0.0, 0.0, 1.0]);
    Frame::normalized(nearest::<A, 3>(vector)).unwrap_or_else(|_| Frame::new(up).unwrap())
}

fn all_finite<R: Into<f64>, const N: usize>(numbers: [R; N]) -> bool {
    wide(numbers).into_iter().all(f64::is_finite)
}

/// Of any two densities, both heuristics give shares in [0, 1], and a delta distribution's is 1.
fn shares_a_direction<R: Real>(density: R, is_delta: bool, other: R) {
    for heuristic in [balance_heuristic, power_heuristic] {
        let [share, others] =
            wide([heuristic(density, is_delta, other), heuristic(other, false, density)]);
        let what = || format!("{density:?} {is_delta} {other:?}: {share} {others}");
        assert!((0.0..=1.0).contains(&share) && (0.0..=1.0).contains(&others), "{}", what());
        assert!(!is_delta || share == 1.0, "{}", what());
        if !is_delta && density > R::ZERO && other > R::ZERO {
            assert!((share + others - 1.0).abs() <= 4.0 * R::EPSILON.into(), "{}", what());
        }
    }
}
