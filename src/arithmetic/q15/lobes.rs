//! The lobes of Q15, with logarithms to base 2.
//!
//! **Power.** With L = -log2(1 - r^2) and lambda = L / (e + 1), the height is z = 2^-lambda, and
//! sin^2 theta = 1 - 4^-lambda. The disc point times sin theta / r gives x and y. At the pole that
//! factor is 0/0, and 1 - z^2 has lost all digits; but with
//!
//! - l(r^2) = L / r^2, from 1 / ln 2 up, and
//! - g(lambda) = (1 - 4^-lambda) / (2 ln 2 lambda), from 1 down,
//!
//! (sin theta / r)^2 = (2 ln 2 / (e + 1)) l g. No factor has a singularity. The root of the first
//! is prepared with the exponent, as `spread`; those of l and g are tables. The regimes are
//!
//! | where | sin theta / r | function |
//! | --- | --- | --- |
//! | r^2 < 1/2 | sqrt l sqrt g spread | [`factor_near_pole`] |
//! | r^2 >= 1/2, lambda < 1 | (1 / r) sqrt L sqrt g spread | [`sine_above_half`] |
//! | r^2 >= 1/2, lambda >= 1 | (1 / r) sqrt(1 - z^2) | [`sine_below_half`] |
//!
//! where "half" is z = 1/2. The second has three scales of sqrt L ([`root_of_log`]).
//!
//! **Units.** A suffix `_q16` says that a variable counts units of 2^-16, and so on; a number
//! without one is a count or a Q15. All products are of 16 x 16 bits. To shift by n after adding
//! 2^(n - 1) rounds to the nearest. A table gives 2^-32, of which `>> 16` keeps the top 16 bits.
//!
//! tests/derive/q15.py derives the constants.

use super::disc::{Q15Disc, root_of, signed};
use super::tables::{BEND, EXP, HALF, LOG, POLE, RECIPROCAL_ROOT, ROOT};
use crate::arithmetic::fixed::{FixedExponent, Q15};
use crate::arithmetic::q31::Q31Exponent;

/// 2 ln 2 in 2^-30, to the nearest.
const TWICE_LN_2_Q30: u128 = 1_488_522_236;

/// The largest sine of [`sine_above_half`], in the units that [`lifted_by_sine`] takes it in.
///
/// The true sine is below 2^16, and a rounded one may reach it. [`lifted_by_sine`] multiplies a
/// component by sine / r, which rounding makes up to 1.6 units larger: its product leaves its word
/// with 0xffff on some circle, and with 0xfffe on none. One unit is in reserve.
const LARGEST_SINE: u32 = 0xfffd;

/// Half an LSB of Q15 in 2^-30.
const HALF_LSB_Q30: u32 = 1 << 14;
/// Half an LSB of Q15 in 2^-31.
const HALF_LSB_Q31: u32 = 1 << 15;

/// An exponent with the power lobe's precomputed values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Q15Exponent {
    e: FixedExponent,
    /// 1 / (e + 1) = scale 2^-16 2^-shift, 2^15 <= scale < 2^16.
    scale: u16,
    shift: u8,
    /// sqrt(2 ln 2 / (e + 1)) = spread 2^-15 2^-spread_shift, 2^15 <= spread < 2^16.
    spread: u16,
    spread_shift: u8,
    /// For the density and the inverse.
    wide: Q31Exponent,
}

impl Q15Exponent {
    pub(in crate::arithmetic) const fn new(e: FixedExponent) -> Self {
        // From 1 to 2^32; its reciprocal from 1 to 2^-32.
        let e_plus_1_q32 = e.to_bits() as u128 + (1 << 32);
        let reciprocal_q63 = ((1_u128 << 95) / e_plus_1_q32) as u64;
        // 1, of e = 0, becomes 1 - 2^-16: 2^63 has one digit more than the others.
        let below_1_q63 =
            if reciprocal_q63 >> 63 == 0 { reciprocal_q63 } else { reciprocal_q63 - 1 };
        let (scale, zeros) = normal(below_1_q63);
        // 2^-30 2^-63 2^-1 = 2^-94, and the root of it 2^-47.
        let spread_q47 = (2 * TWICE_LN_2_Q30 * reciprocal_q63 as u128).isqrt() as u64;
        let (spread, spread_zeros) = normal(spread_q47);
        // The top bit of a word of 2^-63 is worth 1, and that of `scale` 1/2 without a shift. A
        // quotient of 2^-32 is 0 after 31 shifts as well.
        let shift = if zeros < 32 { zeros - 1 } else { 31 };
        // The top bit of a word of 2^-47 is worth 2^16, and that of `spread` 1 without a shift.
        let spread_shift = spread_zeros - 16;
        Self { e, scale, shift, spread, spread_shift, wide: Q31Exponent::new(e) }
    }

    /// The exponent as the user gave it.
    pub const fn value(self) -> FixedExponent {
        self.e
    }

    /// L / (e + 1) in 2^-32, of an L < 1 in 2^-16.
    #[inline(always)]
    const fn divide_fraction(self, log_q16: u32) -> u32 {
        (log_q16 * self.scale as u32) >> self.shift
    }

    /// L / (e + 1), both in 2^-16; L < 2^21 units.
    #[inline(always)]
    const fn divide(self, log_q16: u32) -> u32 {
        let scale = self.scale as u32;
        ((log_q16 >> 16) * scale + (((log_q16 & 0xffff) * scale) >> 16)) >> self.shift
    }
}

impl From<Q15Exponent> for Q31Exponent {
    fn from(exponent: Q15Exponent) -> Self {
        exponent.wide
    }
}

/// The top 16 bits of a number, not 0, to the nearest, and how many zeros were above them.
const fn normal(x: u64) -> (u16, u8) {
    let zeros = x.leading_zeros();
    // 17 bits, then 16.
    let rounded = ((x << zeros >> 47) + 1) >> 1;
    (if rounded > 0xffff { 0xffff } else { rounded as u16 }, zeros as u8)
}

/// A number from 2^-32, toward zero.
#[inline(always)]
const fn height(z_q32: u32) -> Q15 {
    Q15::from_bits((z_q32 >> 17) as i16)
}

/// A component from 2^-31 to the nearest LSB, because the narrowest lobes have few.
#[inline(always)]
const fn rounded(magnitude_q31: u32, positive: i32) -> Q15 {
    signed((magnitude_q31 + HALF_LSB_Q31) >> 16, positive)
}

/// The disc point times a factor in 2^-15 2^-shift, and z.
///
/// The product is below 2^32. Without a shift the true one is at most 1, half of that. With a shift
/// r^2 < 1/2, and the factor is below 2 sqrt 2.
#[inline(always)]
const fn lifted(disc: Q15Disc, factor: u32, shift: u32, z: Q15) -> [Q15; 3] {
    let ([x_q31, y_q31], [x_positive, y_positive]) = (disc.magnitude, disc.positive);
    let (x_q16, y_q16) = (x_q31 >> 15, y_q31 >> 15);
    let (x_q31, y_q31) = ((x_q16 * factor) >> shift, (y_q16 * factor) >> shift);
    [rounded(x_q31, x_positive), rounded(y_q31, y_positive), z]
}

/// The disc point times (1 / r) sin theta, for r^2 >= 1/2 and sin theta = sine 2^-14 2^-shift < 1;
/// and z.
///
/// The product is below 2^32: with 1 / r exact it is at most 2^16 sine, and the two units that sine
/// is from 2^16, at least, are more than what rounding adds. At last `half_q30` is added: half an
/// LSB, or nothing where the rim is near.
#[inline(always)]
const fn lifted_by_sine(disc: Q15Disc, sine: u32, shift: u32, half_q30: u32, z: Q15) -> [Q15; 3] {
    // The table is of the half of 1 / r, over r^2 = 1/2 + x / 2.
    let reciprocal_q15 = RECIPROCAL_ROOT.falling(disc.r2 << 1) >> 16;
    // 2^-15 2^-14 2^-shift, then 2^-14 2^-shift, to the nearest.
    let factor = (reciprocal_q15 * sine + (1 << 14)) >> 15;
    let ([x_q31, y_q31], [x_positive, y_positive]) = (disc.magnitude, disc.positive);
    let (x_q16, y_q16) = (x_q31 >> 15, y_q31 >> 15);
    let (x_q30, y_q30) = ((x_q16 * factor) >> shift, (y_q16 * factor) >> shift);
    [signed((x_q30 + half_q30) >> 15, x_positive), signed((y_q30 + half_q30) >> 15, y_positive), z]
}

/// z = 1 - r^2, sin theta / r = sqrt(1 + (1 - r^2)).
#[inline(always)]
pub(in crate::arithmetic) const fn uniform(disc: Q15Disc) -> [Q15; 3] {
    let ([x_q31, y_q31], [x_positive, y_positive]) = (disc.magnitude, disc.positive);
    // (1 + (1 - r^2)) / 4 is in [1/4, 1/2); its root in 2^-16 is that of 1 + (1 - r^2) in 2^-15.
    let factor_q15 = ROOT.rising((1 << 30) + (disc.one_minus_r2() >> 2)) >> 16;
    let (x_q31, y_q31) = ((x_q31 >> 15) * factor_q15, (y_q31 >> 15) * factor_q15);
    // From 1 - LSB to LSB: an LSB less at the pole, and none less at the rim.
    let z = 0x7fff - ((disc.r2 - (disc.r2 >> 15)) >> 17);
    [signed(x_q31 >> 16, x_positive), signed(y_q31 >> 16, y_positive), Q15::from_bits(z as i16)]
}

/// z = sqrt(1 - r^2).
#[inline(always)]
pub(in crate::arithmetic) const fn cosine(disc: Q15Disc) -> [Q15; 3] {
    let [x, y] = disc.store();
    [x, y, height(root_of(disc.one_minus_r2()))]
}

/// z = (1 - r^2)^(1 / (e + 1)).
#[inline]
pub(in crate::arithmetic) const fn power(exponent: Q15Exponent, disc: Q15Disc) -> [Q15; 3] {
    let r2_q32 = disc.r2;
    let spread = exponent.spread as u32;
    if r2_q32 >> 31 == 0 {
        let (factor, lambda_q32) = factor_near_pole(exponent, r2_q32, spread);
        return lifted(disc, factor, exponent.spread_shift as u32, height(EXP.falling(lambda_q32)));
    }
    let log_q16 = log_of_complement(disc);
    let lambda_q16 = exponent.divide(log_q16);
    // 2^-(the fraction of lambda), plus HALF.
    let power_q32 = EXP.falling(lambda_q16 << 16);
    let whole = lambda_q16 >> 16;
    if whole == 0 {
        // sqrt g and sqrt L.
        let bend_q16 = BEND.falling(lambda_q16 << 16) >> 16;
        let (root, scale) = root_of_log(log_q16);
        let sine = sine_above_half(root, bend_q16, spread);
        let shift = exponent.spread_shift as u32 + 1 - scale;
        return lifted_by_sine(disc, sine, shift, HALF_LSB_Q30, height(power_q32));
    }
    // z <= 1/2. 2^-16 is 2^-14 2^-2. Where e is small, sin theta is 1 but for the last digits over
    // a wide rim: all is rounded toward zero.
    let z_q32 = (power_q32 - HALF) >> whole;
    let sine_q16 = sine_below_half(z_q32);
    let z = height(z_q32 + HALF);
    lifted_by_sine(disc, sine_q16, 2, 0, if z.to_bits() == 0 { Q15::LSB } else { z })
}

/// r^2 < 1/2, so L < 1: sin theta / r = sqrt l sqrt g spread in 2^-15 2^-spread_shift, and lambda.
#[inline(always)]
const fn factor_near_pole(exponent: Q15Exponent, r2_q32: u32, spread: u32) -> (u32, u32) {
    // sqrt l; the table is of its half, over r^2 = x / 2.
    let pole_q15 = POLE.rising(r2_q32 << 1) >> 16;
    let l_q15 = (pole_q15 * pole_q15) >> 15;
    // 2^-15 2^-16, then 2^-16, to the nearest.
    let log_q16 = (l_q15 * (r2_q32 >> 16) + (1 << 14)) >> 15;
    let lambda_q32 = exponent.divide_fraction(log_q16);
    // sqrt g.
    let bend_q16 = BEND.falling(lambda_q32) >> 16;
    let root_q15 = (pole_q15 * bend_q16) >> 16;
    ((root_q15 * spread) >> 15, lambda_q32)
}

/// L = -log2(1 - r^2) in 2^-16, of r^2 >= 1/2.
#[inline(always)]
const fn log_of_complement(disc: Q15Disc) -> u32 {
    // 1 - r^2 = mantissa 2^-whole with a mantissa in [1, 2) when the loop has ended. The 1, of
    // 2^-32, ends it for any r^2.
    let (mut mantissa_q31, mut whole) = ((disc.one_minus_r2() << 1) | 1, 2);
    while mantissa_q31 >> 31 == 0 {
        mantissa_q31 <<= 1;
        whole += 1;
    }
    // The shift drops the mantissa's 1: what is left of it is in 2^-32.
    (whole << 16) - (LOG.rising(mantissa_q31 << 1) >> 16)
}

/// sqrt L = root 2^-16 2^scale: root and scale; of an L >= 1 in 2^-16.
///
/// [`ROOT`] takes L / 4^scale, in [1/4, 1), in 2^-32. L >= 4 takes e > 3 to be here, and the spread
/// has a shift; L >= 16 takes e > 15, and it has two: spread_shift + 1 is never below scale.
#[inline(always)]
const fn root_of_log(log_q16: u32) -> (u32, u32) {
    let (part_q32, scale) = match log_q16 >> 18 {
        0 => (log_q16 << 14, 1),
        1..4 => (log_q16 << 12, 2),
        _ => (log_q16 << 10, 3),
    };
    (ROOT.rising(part_q32) >> 16, scale)
}

/// Where z > 1/2: sin theta = sqrt L sqrt g spread. `root` is sqrt L in 2^-16 2^scale, and the sine
/// is in 2^-14 2^-(spread_shift + 1 - scale).
#[inline(always)]
const fn sine_above_half(root: u32, bend_q16: u32, spread: u32) -> u32 {
    // 2^-16 2^-16 2^scale, then 2^-16 2^scale, to the nearest.
    let product = (root * bend_q16 + (1 << 15)) >> 16;
    // 2^-16 2^-15 2^-spread_shift 2^scale, then 2^-15 2^-spread_shift 2^scale, to the nearest.
    let sine = (product * spread + (1 << 15)) >> 16;
    if sine < LARGEST_SINE { sine } else { LARGEST_SINE }
}

/// Where z <= 1/2, nothing cancels in sin^2 theta = 1 - z^2: sin theta in 2^-16, toward zero.
#[inline(always)]
const fn sine_below_half(z_q32: u32) -> u32 {
    let z2_q32 = (z_q32 >> 16) * (z_q32 >> 16);
    // 1 - z^2, less 2^-32: the complement needs no constant.
    (ROOT.rising(!z2_q32) - HALF) >> 16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::fixed::derived::{Q15_TABLES, assert_derived};

    #[test]
    fn constants_are_those_of_the_script() {
        assert_derived(Q15_TABLES, "TWICE_LN_2_Q30", &[TWICE_LN_2_Q30 as u64]);
        assert_derived(Q15_TABLES, "LARGEST_SINE", &[LARGEST_SINE]);
    }
}
