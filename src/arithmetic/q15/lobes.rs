//! The lobes of Q15, with logarithms to base 2.
//!
//! **Power.** With L = -log2(1 - r^2) and lambda = L / (e + 1), z = 2^-lambda and
//! sin^2 theta = 1 - 4^-lambda, and what turns the disc point into x and y is sin theta / r. At the pole that
//! is 0/0, and 1 - z^2 has lost all digits; but with
//!
//! - l(r^2) = L / r^2, from 1 / ln 2 up, and
//! - g(lambda) = (1 - 4^-lambda) / (2 ln 2 lambda), from 1 down,
//!
//! (sin theta / r)^2 = (2 ln 2 / (e + 1)) l g: three factors without a singularity, whose roots are a
//! prepared number and two tables. Where r^2 >= 1/2, sin theta comes from lambda and 1 / r from a table.

use super::disc::{Q15Disc, root_of, signed};
use super::tables::{BEND, EXP, HALF, INVERSE_ROOT, LOG, POLE, ROOT};
use crate::arithmetic::fixed::{FixedExponent, Q15};
use crate::arithmetic::q31::Q31Exponent;

/// An exponent with what the power lobe needs of it.
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
        // e + 1 in 2^-32, from 2^32 to 2^64; its reciprocal in 2^-63, from 2^63 to 2^31.
        let e_plus_1 = e.to_bits() as u128 + (1 << 32);
        let inverse = ((1_u128 << 95) / e_plus_1) as u64;
        // 1, of e = 0, becomes 1 - 2^-16.
        let (scale, shift) = normal(if inverse >> 63 == 0 { inverse } else { inverse - 1 });
        // 2 ln 2 in 2^-30; its product with the reciprocal is in 2^-94, and the root in 2^-47.
        const TWICE_LN_2: u128 = 1_488_522_236;
        let (spread, spread_shift) = normal((2 * TWICE_LN_2 * inverse as u128).isqrt() as u64);
        // A quotient of 2^-32 is 0 after 31 shifts as well.
        let shift = if shift < 32 { shift - 1 } else { 31 };
        Self { e, scale, shift, spread, spread_shift: spread_shift - 16, wide: Q31Exponent::new(e) }
    }

    /// The exponent as the user gave it.
    pub const fn value(self) -> FixedExponent {
        self.e
    }

    /// L / (e + 1) in 2^-32, of an L < 1 in 2^-16.
    #[inline(always)]
    const fn divide_fraction(self, log: u32) -> u32 {
        (log * self.scale as u32) >> self.shift
    }

    /// L / (e + 1), both in 2^-16; L < 2^21.
    #[inline(always)]
    const fn divide(self, log: u32) -> u32 {
        let scale = self.scale as u32;
        ((log >> 16) * scale + (((log & 0xffff) * scale) >> 16)) >> self.shift
    }
}

impl From<Q15Exponent> for Q31Exponent {
    fn from(exponent: Q15Exponent) -> Self {
        exponent.wide
    }
}

/// The top 16 bits of a number, not 0, and how many zeros were above them.
const fn normal(x: u64) -> (u16, u8) {
    let zeros = x.leading_zeros();
    let rounded = ((x << zeros >> 47) + 1) >> 1;
    (if rounded > 0xffff { 0xffff } else { rounded as u16 }, zeros as u8)
}

/// A number from 2^-32.
#[inline(always)]
const fn height(z: u32) -> Q15 {
    Q15::from_bits((z >> 17) as i16)
}

/// A component from 2^-31 to the nearest LSB, for the narrowest lobes have few.
#[inline(always)]
const fn rounded(magnitude: u32, positive: i32) -> Q15 {
    signed((magnitude + 0x8000) >> 16, positive)
}

/// The disc point times a factor in 2^-15 2^-shift, and z. The product is below 2^32: the true one is at
/// most 1 without a shift; with one r^2 < 1/2, and the factor is below 2 sqrt 2.
#[inline(always)]
const fn lifted(disc: Q15Disc, factor: u32, shift: u32, z: Q15) -> [Q15; 3] {
    let ([x, y], [x_positive, y_positive]) = (disc.magnitude, disc.positive);
    let (x, y) = (((x >> 15) * factor) >> shift, ((y >> 15) * factor) >> shift);
    [rounded(x, x_positive), rounded(y, y_positive), z]
}

/// The disc point times (1 / r) sin theta, for r^2 >= 1/2 and sin theta = sine 2^-14 2^-shift < 1; and z. The
/// product is below 2^32: with 1 / r exact it is at most 2^16 sine, and the three units that sine is from
/// 2^16, at least, are more than what rounding adds. At last `half` is added, in 2^-30: half an LSB, or nothing
/// where the rim is near.
#[inline(always)]
const fn turned(disc: Q15Disc, sine: u32, shift: u32, half: u32, z: Q15) -> [Q15; 3] {
    let inverse = INVERSE_ROOT.falling(disc.r2 << 1) >> 16;
    let factor = (inverse * sine + (1 << 14)) >> 15;
    let ([x, y], [x_positive, y_positive]) = (disc.magnitude, disc.positive);
    // In 2^-30.
    let (x, y) = (((x >> 15) * factor) >> shift, ((y >> 15) * factor) >> shift);
    [signed((x + half) >> 15, x_positive), signed((y + half) >> 15, y_positive), z]
}

/// z = 1 - r^2, sin theta / r = sqrt(1 + (1 - r^2)).
#[inline(always)]
pub(in crate::arithmetic) const fn uniform(disc: Q15Disc) -> [Q15; 3] {
    let ([x, y], [x_positive, y_positive]) = (disc.magnitude, disc.positive);
    // (1 + (1 - r^2)) / 4 is in [1/4, 1/2); its root in 2^-16 is that of 1 + (1 - r^2) in 2^-15.
    let factor = ROOT.rising((1 << 30) + (disc.one_minus_r2() >> 2)) >> 16;
    let (x, y) = ((x >> 15) * factor, (y >> 15) * factor);
    // From 1 - LSB to LSB: an LSB less at the pole, and none less at the rim.
    let z = 0x7fff - ((disc.r2 - (disc.r2 >> 15)) >> 17);
    [signed(x >> 16, x_positive), signed(y >> 16, y_positive), Q15::from_bits(z as i16)]
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
    let r2 = disc.r2;
    let spread = exponent.spread as u32;
    if r2 >> 31 == 0 {
        let pole = POLE.rising(r2 << 1) >> 16;
        // l = pole^2 in 2^-30, then L in 2^-16.
        let log = (((pole * pole) >> 15) * (r2 >> 16) + (1 << 14)) >> 15;
        let lambda = exponent.divide_fraction(log);
        let bend = BEND.falling(lambda) >> 16;
        let factor = (((pole * bend) >> 16) * spread) >> 15;
        return lifted(disc, factor, exponent.spread_shift as u32, height(EXP.falling(lambda)));
    }
    // The 1, of 2^-32, ends the loop whatever r^2 is.
    let (mut mantissa, mut whole) = ((disc.one_minus_r2() << 1) | 1, 2);
    while mantissa >> 31 == 0 {
        mantissa <<= 1;
        whole += 1;
    }
    // L = whole - log2 of a mantissa in [1, 2).
    let log = (whole << 16) - (LOG.rising(mantissa << 1) >> 16);
    let lambda = exponent.divide(log);
    let z = EXP.falling(lambda << 16);
    let whole = lambda >> 16;
    if whole == 0 {
        // sin theta = spread sqrt L sqrt g.
        let bend = BEND.falling(lambda << 16) >> 16;
        // sqrt L = root 2^scale. L >= 4 takes e > 3 to be here, and the spread has a shift; L >= 16 takes e > 15,
        // and it has two.
        let (part, scale) = match log >> 18 {
            0 => (log << 14, 1),
            1..4 => (log << 12, 2),
            _ => (log << 10, 3),
        };
        let root = ROOT.rising(part) >> 16;
        let sine = (((root * bend + (1 << 15)) >> 16) * spread + (1 << 15)) >> 16;
        let sine = if sine < 0xfffd { sine } else { 0xfffd };
        return turned(disc, sine, exponent.spread_shift as u32 + 1 - scale, 0x4000, height(z));
    }
    // z <= 1/2: nothing cancels. Where e is small, sin theta is 1 but for the last digits over a wide rim.
    let z = (z - HALF) >> whole;
    let square = (z >> 16) * (z >> 16);
    let sine = (ROOT.rising(!square) - HALF) >> 16;
    let z = height(z + HALF);
    turned(disc, sine, 2, 0, if z.to_bits() == 0 { Q15::LSB } else { z })
}
