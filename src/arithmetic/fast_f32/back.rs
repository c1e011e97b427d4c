//! The way back of fast f32: inverses and densities by the generic kernels of floats, which are not
//! for the inner loop.

use super::disc::gaps;
use super::functions::{LN_MIN, exp, ln_complement, sqrt};
use crate::arithmetic::float::Float;
use crate::target::form::BRANCHES;

/// The functions as the generic kernels take them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Functions;

impl Float for Functions {
    const NAME: &'static str = "fast-f32";
    type Real = f32;

    #[inline]
    fn sqrt(x: f32) -> f32 {
        sqrt(x)
    }

    /// `Float` requires it, but no inverse or density calls it.
    #[inline]
    fn sin_cos(x: f32) -> (f32, f32) {
        let t = x * (4.0 * core::f32::consts::FRAC_1_PI);
        let [cos, sin] = gaps(t * t);
        (t - t * sin, 1.0 - cos)
    }

    /// x - x^3 P(x^2).
    #[inline]
    fn atan(x: f32) -> f32 {
        const ATAN: [f32; 9] = [
            0.333_333_3,
            -0.199_997_51,
            0.142_790_7,
            -0.110_385_83,
            0.086_774_774,
            -0.062_962_6,
            0.036_433_03,
            -0.013_860_541,
            2.476_516e-3,
        ];
        let q = x * x;
        let polynomial = ATAN.into_iter().rev().fold(0.0, |sum, c| c + q * sum);
        x - x * (q * polynomial)
    }

    #[inline]
    fn ln(x: f32) -> f32 {
        ln_complement::<BRANCHES>(1.0 - x, x)
    }

    #[inline]
    fn ln_1p(x: f32) -> f32 {
        ln_complement::<BRANCHES>(-x, 1.0 + x)
    }

    #[inline]
    fn exp(x: f32) -> f32 {
        if x < LN_MIN {
            0.0
        } else if x > 88.0 {
            // Halved, so that 2^k is in range up to the last.
            let [root, _] = exp(if x < 90.0 { x * 0.5 } else { 45.0 });
            root * root
        } else {
            exp(x)[0]
        }
    }

    #[inline]
    fn exp_m1(x: f32) -> f32 {
        -exp(if x > LN_MIN { x } else { LN_MIN })[1]
    }
}
