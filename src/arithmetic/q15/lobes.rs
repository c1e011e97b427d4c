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

use super::super::Q31Exponent;
use super::super::fixed::{FixedExponent, Q15};
use super::disc::{Q15Disc, interpolate, root, root_of, rounded};
use super::tables::{BEND, EXP, INVERSE_ROOT, LOG, POLE};

/// An exponent with what the power lobe needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Q15Exponent {
    e: FixedExponent,
    /// 1 / (e + 1) = scale 2^-15 2^-shift, 2^15 <= scale < 2^16.
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
        let (scale, shift) = normal(inverse);
        // 2 ln 2 in 2^-30; its product with the reciprocal is in 2^-94, and the root in 2^-47.
        const TWICE_LN_2: u128 = 1_488_522_236;
        let (spread, spread_shift) = normal((2 * TWICE_LN_2 * inverse as u128).isqrt() as u64);
        // A quotient of 2^-32 is 0 after 31 shifts as well.
        let shift = if shift < 31 { shift } else { 31 };
        Self { e, scale, shift, spread, spread_shift: spread_shift - 16, wide: Q31Exponent::new(e) }
    }

    /// The exponent as the user gave it.
    pub const fn value(self) -> FixedExponent {
        self.e
    }

    pub(super) const fn wide(self) -> Q31Exponent {
        self.wide
    }

    /// L / (e + 1), both in 2^-16; L < 2^21.
    #[inline(always)]
    const fn divide(self, log: u32) -> u32 {
        let scale = self.scale as u32;
        ((((log >> 16) * scale) << 1) + (((log & 0xffff) * scale) >> 15)) >> self.shift
    }
}

/// The top 16 bits of a number, not 0, and how many zeros were above them.
const fn normal(x: u64) -> (u16, u8) {
    let zeros = x.leading_zeros();
    let rounded = ((x << zeros >> 47) + 1) >> 1;
    (if rounded > 0xffff { 0xffff } else { rounded as u16 }, zeros as u8)
}

/// z from 2^-16: to the nearest LSB, from 1 LSB to 1 - LSB.
#[inline(always)]
const fn height(z: u32) -> Q15 {
    let z = (z + 1) >> 1;
    if z == 0 {
        Q15::LSB
    } else if z > 0x7fff {
        Q15::MAX
    } else {
        Q15::from_bits(z as i16)
    }
}

/// A component in 2^-16, rounded.
#[inline(always)]
const fn halved(magnitude: u32) -> u32 {
    ((magnitude >> 14) + 1) >> 1
}

/// The disc point times a factor in 2^-15 2^-shift, and z. The product is below 2^32: the true one is at
/// most 1 without a shift; with one r^2 < 1/2, and the factor is below 2 sqrt 2.
#[inline(always)]
const fn lifted(disc: Q15Disc, factor: u32, shift: u32, z: Q15) -> [Q15; 3] {
    let [x, y] = disc.magnitude;
    let (x, y) = ((halved(x) * factor) >> shift, (halved(y) * factor) >> shift);
    [rounded(x, disc.sign[0]), rounded(y, disc.sign[1]), z]
}

/// The disc point times (1 / r) sin theta, of 1 / r = inverse 2^-15 and sin theta = sine 2^-12 2^-shift
/// < 1; and z. The product is below 2^32: with 1 / r exact it is at most 2^16 sine, and the three units that
/// sine is from 2^16, at least, are more than what rounding adds.
#[inline(always)]
const fn turned(disc: Q15Disc, inverse: u32, sine: u32, shift: u32, z: Q15) -> [Q15; 3] {
    let factor = (inverse * sine + (1 << 14)) >> 15;
    let [x, y] = disc.magnitude;
    let (x, y) = (halved(x) * factor, halved(y) * factor);
    let (x, y) = match shift.checked_sub(3) {
        Some(shift) => (x >> shift, y >> shift),
        // Two shifts at least: see `power`.
        None => (x << 1, y << 1),
    };
    [rounded(x, disc.sign[0]), rounded(y, disc.sign[1]), z]
}

/// z = 1 - r^2, sin theta / r = sqrt(1 + (1 - r^2)).
#[inline(always)]
pub(in crate::arithmetic) const fn uniform(disc: Q15Disc) -> [Q15; 3] {
    let rim = disc.rim();
    // (1 + rim) / 4 is in [1/4, 1/2); its root in 2^-16 is that of 1 + rim in 2^-15.
    let factor = root((1 << 30) + (rim >> 2));
    lifted(disc, factor - 1, 0, height(rim >> 16))
}

/// z = sqrt(1 - r^2).
#[inline(always)]
pub(in crate::arithmetic) const fn cosine(disc: Q15Disc) -> [Q15; 3] {
    let [x, y] = disc.magnitude;
    let z = height(root_of(disc.rim()));
    [rounded(x, disc.sign[0]), rounded(y, disc.sign[1]), z]
}

/// 2^-x of x in 2^-16; in 2^-16.
#[inline(always)]
const fn exp2_neg(x: u32) -> u32 {
    let whole = x >> 16;
    if whole > 16 { 0 } else { interpolate(&EXP, (x & 0xffff) << 6) >> whole }
}

/// z = (1 - r^2)^(1 / (e + 1)).
#[inline]
pub(in crate::arithmetic) const fn power(exponent: Q15Exponent, disc: Q15Disc) -> [Q15; 3] {
    let r2 = disc.r2;
    let spread = exponent.spread as u32;
    if r2 < 1 << 31 {
        // 128ths of r^2.
        let pole = interpolate(&POLE, r2 >> 9);
        // l = pole^2 in 2^-30, then L in 2^-16.
        let log = (((pole * pole) >> 15) * (((r2 >> 15) + 1) >> 1) + (1 << 14)) >> 15;
        let lambda = exponent.divide(log);
        let bend = interpolate(&BEND, lambda << 6);
        let factor = (((pole * bend + (1 << 15)) >> 16) * spread + (1 << 14)) >> 15;
        return lifted(disc, factor, exponent.spread_shift as u32, height(exp2_neg(lambda)));
    }
    let mut mantissa = disc.rim();
    let mut whole = 1;
    while mantissa < 1 << 31 {
        mantissa <<= 1;
        whole += 1;
    }
    // L = whole - log2 of a mantissa in [1, 2).
    let log = (whole << 16) - interpolate(&LOG, (mantissa << 1) >> 10);
    let lambda = exponent.divide(log);
    let inverse = interpolate(&INVERSE_ROOT, (r2 << 1) >> 9);
    let z = exp2_neg(lambda);
    if lambda < 1 << 16 {
        // sin theta = spread sqrt L sqrt g, with the root of L / 64: 2^-13 2^-shift. There are two shifts at
        // least: for L < 4 in the root; for L >= 16, where 1 / (e + 1) < 1/16, in the spread; else one in each.
        let bend = interpolate(&BEND, lambda << 6);
        let (mut part, mut shift) = (log << 10, exponent.spread_shift as u32);
        while part < 1 << 30 {
            part <<= 2;
            shift += 1;
        }
        let sine = (((root(part) * bend + (1 << 15)) >> 16) * spread + (1 << 15)) >> 16;
        let sine = if sine < 0xfffd { sine } else { 0xfffd };
        return turned(disc, inverse, sine, shift, height(z));
    }
    // z <= 1/2: nothing cancels. The root of 1 - 0 is the last of its table, for 2^32 is 0. Next to the rim
    // an LSB makes room for what rounding adds.
    let room = if z < 1 << 10 { 2 } else { 0 };
    turned(disc, inverse, root((z * z).wrapping_neg()) - room, 4, height(z))
}
