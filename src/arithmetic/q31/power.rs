//! The power lobe: the exponent, the lift, its inverse and its density.

use super::disc::{Q31Disc, nearest, signed};
use super::inverse::{Lowered, above, complement, height, length_squared};
use crate::arithmetic::fixed::root::root;
use crate::arithmetic::fixed::scaled::{Scaled, exp, fall, log};
use crate::arithmetic::fixed::wide::{high_64, product};
use crate::arithmetic::fixed::{FixedExponent, Q31};

/// An exponent with the power lobe's precomputed values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Q31Exponent {
    value: FixedExponent,
    /// 1 / (e + 1).
    reciprocal: Scaled,
}

impl Q31Exponent {
    pub(in crate::arithmetic) const fn new(value: FixedExponent) -> Self {
        Self { value, reciprocal: plus_1(value).reciprocal() }
    }

    /// The exponent as the user gave it.
    pub const fn value(self) -> FixedExponent {
        self.value
    }
}

/// e + 1.
const fn plus_1(e: FixedExponent) -> Scaled {
    match e.to_bits().checked_add(1 << 32) {
        Some(bits) => Scaled::new(bits, 32),
        // Above 2^32 the last bit is lost.
        None => Scaled::new((e.to_bits() >> 1) + (1 << 31), 33),
    }
}

#[inline]
pub(super) const fn lift(exponent: Q31Exponent, disc: Q31Disc) -> [Q31; 3] {
    let log_z = log(disc.r2, disc.one_minus_r2).times(exponent.reciprocal);
    let z = exp(log_z);
    let s2 = fall(log_z.doubled(), high_64(z, z));
    let r2 = Scaled::new(disc.r2, 0);
    // (s/r)^2 = quotient 2^(twice - 32), below 4, and the root of it: ratio 2^(twice / 2 - 32).
    // The bit is set except for r^2 = 0, which no map gives. It removes the check of the divisor.
    let quotient = (s2.mantissa >> 1) / (r2.mantissa >> 32 | 1 << 31);
    let twice = s2.exponent - r2.exponent + 1;
    let ratio = root(quotient << (32 - (twice & 1)));
    // A product with the ratio is in LSBs after this.
    let shift = (33 - ((twice + 1) >> 1)).cast_unsigned();
    let shift = if shift < 63 { shift } else { 63 };
    // To the nearest, but toward zero where z < 1/2: no point may leave the hemisphere.
    let half = (z >> 63) << (shift - 1);
    let x = ((product(disc.x, ratio) + half) >> shift) as u32;
    let y = ((product(disc.y, ratio) + half) >> shift) as u32;
    let [x_positive, y_positive] = disc.positive;
    [signed(x, x_positive), signed(y, y_positive), nearest((z >> 32) as u32)]
}

/// -ln z of a direction: from z near the horizon, from x and y near the pole, where z has rounded
/// to 1.
fn log_z([x, y, z]: [Q31; 3]) -> Scaled {
    let s2 = length_squared(x, y);
    if s2 >> 63 == 0 {
        // -ln(1 - s^2) / 2
        let log = log(s2, complement(s2));
        Scaled { exponent: log.exponent - 1, ..log }
    } else {
        let z = height(z).max(1 << 33);
        log(complement(z), z)
    }
}

pub(super) fn lower(exponent: Q31Exponent, direction: [Q31; 3]) -> Lowered {
    let log = log_z(direction).times(plus_1(exponent.value));
    let r2 = fall(log, exp(log)).floor(64);
    Lowered::new(direction[0], direction[1], r2)
}

/// z^e.
pub(super) fn density(exponent: Q31Exponent, direction: [Q31; 3]) -> Q31 {
    if !above(direction[2]) {
        return Q31::ZERO;
    }
    let e = Scaled::new(exponent.value.to_bits(), 32);
    nearest((exp(log_z(direction).times(e)) >> 32) as u32)
}
