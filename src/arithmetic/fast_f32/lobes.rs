//! The power lobe of fast f32, and its exponent.

use super::back::Functions;
use super::disc::{FastDisc, at_most_1};
use super::functions::{exp_2, exp_2_1, ln_complement, sqrt};
use crate::arithmetic::float::{PowerExponent, exponent};
use crate::error::Error;
use crate::target::form::{LANE, ONE};

/// An exponent e > -1 with the power lobe's precomputed values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FastExponent {
    exact: PowerExponent<f32>,
    /// 4^k log2(e) / (e + 1), e the base of ln, rounded, and its relative rounding error: ln(1 - r^2)
    /// times this is log2 z.
    rate: f32,
    lost: f32,
    /// 2^-k: 1 up to e + 1 = 2^42.
    pub(super) shrink: f32,
}

impl FastExponent {
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub(super) const fn new(e: f32) -> Result<Self, Error> {
        let parts = match exponent::f32::plus_1(e) {
            Ok(parts) => parts,
            Err(error) => return Err(error),
        };
        let [square, scale] = exponent::f32::spread(parts[0]);
        let exact = PowerExponent::of_parts(e, parts, sqrt(square) * scale);
        // From 2^42 on sin theta is proportional to 1 / sqrt(e + 1) in f32, and 1 - r^2 may be
        // 1 - 2^-64: the lobe is that of an exponent between 2^40 and 2^42, shrunk, so that nothing
        // underflows.
        let e_plus_1 = e as f64 + 1.0;
        let binade = e_plus_1.to_bits() >> 52;
        let k = binade.saturating_sub(1023 + 40) / 2;
        let power = f64::from_bits((1023 + 2 * k) << 52);
        let inverse = core::f64::consts::LOG2_E * power / e_plus_1;
        let rate = inverse as f32;
        let lost = ((inverse - rate as f64) / inverse) as f32;
        let shrink = 1.0 / (1_u64 << k) as f32;
        Ok(Self { exact, rate, lost, shrink })
    }

    /// The density of a sample of the lobe, from the 1 - r^2 that it was lifted from.
    #[inline(always)]
    pub(super) fn density_of_sample(self, one_minus_r2: f32, direction: [f32; 3]) -> f32 {
        self.exact.density_of_sample::<Functions>(one_minus_r2, direction)
    }

    /// The exponent as the user gave it.
    pub fn value(self) -> f32 {
        self.exact.value()
    }
}

impl From<FastExponent> for PowerExponent<f32> {
    fn from(exponent: FastExponent) -> Self {
        exponent.exact
    }
}

/// The power lobe: sin^2 theta 4^k, not above 1, and z.
#[inline(always)]
pub(super) const fn power(exponent: FastExponent, disc: FastDisc) -> [f32; 2] {
    elevation::<ONE>(exponent, ln_complement::<ONE>(disc.r2, disc.one_minus_r2))
}

/// Its direction, from z and the root of the square.
#[inline(always)]
pub(super) const fn powered(exponent: FastExponent, disc: FastDisc, root: f32, z: f32) -> [f32; 3] {
    let [x, y] = disc.place_at::<ONE>(root, exponent.shrink);
    [x, y, z]
}

/// Below the exponent of the smallest normal number by more than all errors, so that z becomes that
/// number, whether a processor flushes subnormal results to 0 or not.
const LOG_BELOW_MIN: f32 = -126.01;

/// sin^2 theta 4^k, not above 1, and z = cos theta, from ln(1 - r^2).
///
/// With z = 2^l, sin^2 theta = 1 - z^2 = (1 - z) (1 + z), and 1 - z is accurate near the pole.
#[inline(always)]
pub(super) const fn elevation<const FORM: u8>(exponent: FastExponent, ln: f32) -> [f32; 2] {
    let log = ln * exponent.rate;
    if FORM != LANE && log >= -0.5 {
        // 2^k = 1, and nothing under- or overflows. From e = 20 on hardly a point is elsewhere.
        let excess = exp_2_1(log + log * exponent.lost);
        return [-excess * (2.0 + excess), 1.0 + excess];
    }
    // Below e = 0 the exact z underflows in the last cells.
    let log = if log > LOG_BELOW_MIN { log } else { LOG_BELOW_MIN };
    let [power, excess] = exp_2(log, exponent.lost);
    let (gap, sum) = ((1.0 - power) - excess, (1.0 + power) + excess);
    let z = power + excess;
    [at_most_1(gap * sum), if z > f32::MIN_POSITIVE { z } else { f32::MIN_POSITIVE }]
}
