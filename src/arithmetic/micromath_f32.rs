//! micromath f32: sine and cosine by a parabola, three digits, a few instructions with an FPU.
//!
//! The crate `micromath` gives the sine and the cosine (within 1.1e-3 and 7.7e-4 on [0, pi/4], the
//! length of the two within 1.0e-3 of 1) and the seeds of the square root and of the arc tangent.
//! The rest of it would break the maps. Largest errors of its functions over the ranges that
//! [`Float`] names, and of these, by the tests below (micromath 2.1.0):
//!
//! | function | micromath's | here |
//! | --- | --- | --- |
//! | sqrt | 6.1 % relative; sqrt(-0) = 2.8e19 | 2e-7 relative |
//! | ln | 0.118 below 1 | 3e-7 relative |
//! | ln(1 + x) | 0.118, and no digit near 0 | 2e-5 relative |
//! | exp | 2.4e-3 relative | 8e-6 relative |
//! | exp(x) - 1 | no digit near 0 | 8e-6 relative |
//! | atan | 2.9e-3; tan of it, by the same sine and cosine, 4e-3 | tan of it 2.5e-5 |
//!
//! and of the maps that they give, over the points of `tests/map/accuracy`, e in [0, 1e8] (with
//! sqrt(-0) made 0: as it is, the power lobe has no end):
//!
//! | map | position | norm | theta, relative | z, relative | density, relative | inverse |
//! | --- | --- | --- | --- | --- | --- | --- |
//! | disc, raw | 4.3e-2 | 4.5e-2 | | | | 4.4e-2 |
//! | disc, here | 1.1e-3 | 1.0e-3 | | | | 1.0e-3 |
//! | uniform, raw | 4.3e-2 | 3.2e-2 | 6.4e-2 | | | 8.3e-2 |
//! | uniform, here | 1.1e-3 | 1.0e-3 | 1.0e-3 | | | 1.2e-3 |
//! | cosine, raw | 4.3e-2 | 6.3e-2 | 6.4e-2 | 6.1e-2 | 6.1e-2 | 7.7e-2 |
//! | cosine, here | 1.1e-3 | 1.0e-3 | 1.0e-3 | 2.2e-7 | 2.2e-7 | 1.0e-3 |
//! | power, raw | 0.14 | 3.2e-2 | 300 | 0.11 | 3.2 | 0.26 |
//! | power, here | 1.1e-3 | 1.0e-3 | 1.0e-3 | 1.3e-5 | 6.2e-2 | 1.9e-3 |
//!
//! The density of a lobe falls with the square of theta, so at the rim it multiplies the error of
//! theta by a little more than 2 |ln(1 - r^2)|. The 6.2 % are at a point where the density is 2e-10
//! of its peak.
//!
//! **sqrt**: the seed is 0 to 6.1 % too large; times 0.9705 it is within 3 %, and two of Heron's
//! steps (e -> e^2 / 2) leave a rounding or two. **ln**: with s = (m - 1) / (m + 1), ln m = 2
//! artanh s = 2 (s + s^3 / 3 + s^5 / 5 + s^7 / 7), which keeps its digits at s = 0; for m in [1/2,
//! sqrt 2] the rest is below 2 s^9 / 9. **exp**: e^x = 2^k e^f with |f| <= ln(2) / 2, and e^f - 1
//! by its series to f^5. **atan**: one of Newton's steps from the seed, a + tan(b - a) = a + (t cos
//! a - sin a) / (cos a + t sin a). The sine and cosine are those of the maps, so it inverts them and
//! not the exact ones.

use super::Float;
use core::f32::consts::{FRAC_1_SQRT_2, LN_2, LOG2_E};
use micromath::F32;

/// `f32` with the sine and the cosine of the crate `micromath`: small, quick on a core with an FPU,
/// and good to three digits.
///
/// For firmware that has `micromath` already and draws lenses, not measurements. Where the coarse
/// functions would break a map (square root, logarithm, exponential) it has its own; no `libm`. The
/// same bits on every target for one version of `micromath`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MicromathF32;

/// 2 artanh s = ln((1 + s) / (1 - s)) for |s| <= 1/3.
#[inline(always)]
fn log_ratio(s: f32) -> f32 {
    let s2 = s * s;
    2.0 * s * (1.0 + s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0))))
}

/// exp(x) - 1 for |x| <= ln(2) / 2.
#[inline(always)]
fn exp_m1_near_0(x: f32) -> f32 {
    x * (1.0 + x * (1.0 / 2.0 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0)))))
}

impl Float for MicromathF32 {
    const NAME: &'static str = "micromath-f32";
    type Real = f32;

    #[inline]
    fn sqrt(x: f32) -> f32 {
        if x <= 0.0 {
            return 0.0;
        }
        let heron = |y: f32| 0.5 * (y + x / y);
        heron(heron(F32(x).sqrt().0 * 0.9705))
    }

    #[inline(always)]
    fn sin_cos(x: f32) -> (f32, f32) {
        (F32(x).sin().0, F32(x).cos().0)
    }

    #[inline]
    fn atan(x: f32) -> f32 {
        let seed = F32(x).atan().0;
        let (sin, cos) = Self::sin_cos(seed);
        seed + (x * cos - sin) / (cos + x * sin)
    }

    #[inline]
    fn ln(x: f32) -> f32 {
        // x = 2^k m with m in [sqrt(1/2), sqrt 2).
        let bits = x.to_bits().cast_signed();
        let k = (bits - FRAC_1_SQRT_2.to_bits().cast_signed()) >> 23;
        let m = f32::from_bits((bits - (k << 23)).cast_unsigned());
        k as f32 * LN_2 + log_ratio((m - 1.0) / (m + 1.0))
    }

    #[inline]
    fn ln_1p(x: f32) -> f32 {
        log_ratio(x / (2.0 + x))
    }

    #[inline]
    fn exp(x: f32) -> f32 {
        // The least and the greatest x for which e^x is a normal number.
        if x < -87.33 {
            return 0.0;
        }
        if x > 88.72 {
            return f32::INFINITY;
        }
        let turns = x * LOG2_E;
        // The nearest integer: the conversion is toward zero.
        let k = (turns + if x < 0.0 { -0.5 } else { 0.5 }) as i32;
        let mantissa = 1.0 + exp_m1_near_0(x - k as f32 * LN_2);
        f32::from_bits((mantissa.to_bits().cast_signed() + (k << 23)).cast_unsigned())
    }

    #[inline]
    fn exp_m1(x: f32) -> f32 {
        if x > -LN_2 / 2.0 { exp_m1_near_0(x) } else { Self::exp(x) - 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every `step`-th f32 from `from` to `to`, both positive.
    fn floats(from: f32, to: f32, step: usize) -> impl Iterator<Item = f32> {
        (from.to_bits()..=to.to_bits()).step_by(step).map(f32::from_bits)
    }

    /// The largest relative and the largest absolute error.
    fn errors(
        arguments: impl Iterator<Item = f32>,
        function: impl Fn(f32) -> f32,
        exact: impl Fn(f64) -> f64,
    ) -> [f64; 2] {
        let mut worst = [0.0_f64; 2];
        for x in arguments {
            let exact = exact(x.into());
            let error = (f64::from(function(x)) - exact).abs();
            for (worst, error) in worst.iter_mut().zip([error / exact.abs(), error]) {
                assert!(!error.is_nan(), "{x:e}");
                *worst = worst.max(error);
            }
        }
        worst
    }

    /// Asserts an error that the header names, from both sides.
    fn about(what: &str, error: f64, stated: f64) {
        assert!(error <= stated && error > stated / 2.0, "{what}: {error:e}, not {stated:e}");
    }

    #[test]
    fn errors_are_those_of_the_header() {
        let negative = |from, to| floats(from, to, 97).map(|x: f32| -x);
        let octant = || floats(1e-9, core::f32::consts::FRAC_PI_4, 97);
        about("sin", errors(octant(), |x| MicromathF32::sin_cos(x).0, f64::sin)[1], 1.1e-3);
        about("cos", errors(octant(), |x| MicromathF32::sin_cos(x).1, f64::cos)[1], 7.7e-4);
        let length = |x: f32| {
            let (sin, cos) = MicromathF32::sin_cos(x);
            sin.hypot(cos)
        };
        about("length", errors(octant(), length, |_| 1.0)[1], 1.0e-3);

        let positive = || floats(f32::MIN_POSITIVE, f32::MAX, 997);
        about("raw sqrt", errors(positive(), |x| F32(x).sqrt().0, f64::sqrt)[0], 0.061);
        about("sqrt", errors(positive(), MicromathF32::sqrt, f64::sqrt)[0], 2e-7);
        about("raw sqrt of -0", F32(-0.0).sqrt().0.into(), 2.8e19);
        assert_eq!([-0.0, 0.0].map(MicromathF32::sqrt), [0.0; 2]);

        let below_1 = || floats(f32::MIN_POSITIVE, 1.0 - f32::EPSILON, 97);
        about("raw ln", errors(below_1(), |x| F32(x).ln().0, f64::ln)[1], 0.118);
        about("ln", errors(below_1(), MicromathF32::ln, f64::ln)[0], 3e-7);
        assert_eq!(MicromathF32::ln(1.0), 0.0);
        let raw = errors(negative(1e-30, 0.5), |x| F32(1.0 + x).ln().0, f64::ln_1p);
        about("raw ln_1p", raw[1], 0.118);
        about("ln_1p", errors(negative(1e-30, 0.5), MicromathF32::ln_1p, f64::ln_1p)[0], 2e-5);

        let raw = errors(negative(1e-30, 87.0), |x| F32(x).exp().0, f64::exp);
        about("raw exp", raw[0], 2.4e-3);
        let both = negative(1e-30, 87.33).chain(floats(1e-30, 88.72, 97));
        about("exp", errors(both, MicromathF32::exp, f64::exp)[0], 8e-6);
        let raw = errors(negative(1e-30, 1e-8), |x| F32(x).exp().0 - 1.0, f64::exp_m1);
        about("raw exp_m1", raw[0], 1.0);
        let exp_m1 = errors(negative(1e-30, 100.0), MicromathF32::exp_m1, f64::exp_m1);
        about("exp_m1", exp_m1[0], 8e-6);
        assert_eq!(MicromathF32::exp_m1(f32::NEG_INFINITY), -1.0);
        assert_eq!([-88.0, 89.0].map(MicromathF32::exp), [0.0, f32::INFINITY]);

        let unit = || floats(1e-9, 1.0, 97);
        let back = |atan: fn(f32) -> f32| {
            move |x: f32| {
                let (sin, cos) = MicromathF32::sin_cos(atan(x));
                sin / cos
            }
        };
        about("raw atan", errors(unit(), |x| F32(x).atan().0, f64::atan)[1], 2.9e-3);
        about("raw inverse", errors(unit(), back(|x| F32(x).atan().0), |x| x)[1], 4e-3);
        about("inverse", errors(unit(), back(MicromathF32::atan), |x| x)[1], 2.5e-5);
    }
}
