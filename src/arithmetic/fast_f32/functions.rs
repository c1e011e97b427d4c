//! The elementary functions of fast f32, on the ranges that the maps need, as `const fn`.
//!
//! A point alone is a chain of operations that wait for each other, and so many that two hardly fit
//! into what a processor has in sight. Sums are therefore formed in the order that makes the chain
//! short, which costs an operation or two.
//!
//! tests/derive/fast_f32.sollya derives the coefficients. The tests have the errors, over every f32
//! of each range.

use super::root::root;
use crate::target::CONVERSIONS_WAIT;
use crate::target::form::{BRANCHES, WORDS};

/// 2^-64: from here on every residual of a root is a normal number.
pub(super) const FAR_FROM_0: f32 = 1.0 / 18_446_744_073_709_551_616.0;

/// Square root of x in [0, MAX], correctly rounded; `core` has none.
#[inline]
pub(super) const fn sqrt(x: f32) -> f32 {
    // A subnormal number becomes a normal one, unless the processor takes it for 0.
    let up = x * (1.0 / FAR_FROM_0);
    if x >= FAR_FROM_0 {
        root(x)
    } else if up > 0.0 {
        root(up) * (1.0 / 4_294_967_296.0)
    } else {
        0.0
    }
}

/// ln 2 in two parts: multiples of the first up to 2^15 are exact.
const LN_2: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];

/// ln(1 - x) from x and 1 - x, both in [0, 1] but for rounding, each correct to a few eps of itself.
///
/// With 1 - x = 2^n (1 + g), 1 + g in [sqrt(1/2), sqrt 2): where n = 0, g = -x has the digits that
/// 1 - x has lost. ln(1 + g) = 2 atanh h, h = g / (2 + g), is g - h (g - h^2 P), h^2 P = 2/3 h^2 +
/// 2/5 h^4 + ..: g enters exactly, and the rounded terms are small beside it. What does not wait for
/// the division, or for P, is summed before.
#[inline(always)]
pub(super) const fn ln_complement<const FORM: u8>(x: f32, complement: f32) -> f32 {
    const ATANH: [f32; 3] = [0.666_666_87, 0.399_884_6, 0.295_913_3];
    const SQRT_HALF: u32 = core::f32::consts::FRAC_1_SQRT_2.to_bits();
    let above = complement.to_bits().wrapping_sub(SQRT_HALF);
    let n = above.cast_signed() >> 23;
    let mantissa = (above & 0x007f_ffff) + SQRT_HALF;
    let g = if FORM == BRANCHES {
        if n == 0 { -x } else { f32::from_bits(mantissa) - 1.0 }
    } else {
        // 0 - x or mantissa - 1. In words, and by the sign of n, which is not positive here: from a
        // comparison the compiler makes a branch, which three points of ten take.
        let far = (n >> 31).cast_unsigned();
        let one = (x.to_bits() ^ 1.0_f32.to_bits()) & far ^ x.to_bits();
        f32::from_bits(mantissa & far) - f32::from_bits(one)
    };
    let n = if FORM == WORDS && CONVERSIONS_WAIT {
        f32::from_bits(SHIFTER.to_bits().wrapping_add_signed(n)) - SHIFTER
    } else {
        n as f32
    };
    let h = g / (2.0 + g);
    let h2 = h * h;
    let p = (ATANH[0] + h2 * ATANH[1]) + h2 * h2 * ATANH[2];
    (g + n * LN_2[0]) - ((h * g - n * LN_2[1]) - h * h2 * p)
}

/// 2^(x (1 + d)) for x in [-126.1, 0] and d of at most an eps, as 2^k and what it is more.
///
/// With x = k + f, |f| <= 1/2, and p = 2^f - 1: 2^k and 2^k p. Near x = 0, k = 0 and p is accurate
/// to a few eps of itself, so 1 - 2^x = (1 - 2^k) - 2^k p does not cancel.
#[inline(always)]
pub(super) const fn exp_2(x: f32, d: f32) -> [f32; 2] {
    let shifted = x + SHIFTER;
    let power = f32::from_bits((shifted.to_bits() << 23).wrapping_add(0x3f80_0000));
    [power, power * exp_2_1((x - (shifted - SHIFTER)) + x * d)]
}

/// 2^f - 1 for |f| <= 1/2 and a little.
#[inline(always)]
pub(super) const fn exp_2_1(f: f32) -> f32 {
    const EXP_2: [f32; 6] = [
        core::f32::consts::LN_2,
        0.240_226_5,
        5.550_366_3e-2,
        9.618_323e-3,
        1.338_791_2e-3,
        1.537_677_6e-4,
    ];
    let f2 = f * f;
    let low = EXP_2[0] + f * EXP_2[1];
    let high = (EXP_2[2] + f * EXP_2[3]) + f2 * (EXP_2[4] + f * EXP_2[5]);
    f * low + f * f2 * high
}

/// An addition of 3/2 2^23 rounds to an integer and leaves it in the low bits.
const SHIFTER: f32 = 12_582_912.0;

/// exp x and 1 - exp x for x in [-87.3, 88].
///
/// With x = k ln 2 + f, |f| <= ln 2 / 2, and p = exp f - 1: 2^k + 2^k p and (1 - 2^k) - 2^k p. Near
/// x = 0, k = 0, so neither cancels.
#[inline(always)]
pub(super) const fn exp(x: f32) -> [f32; 2] {
    const EXP: [f32; 6] =
        [0.5, 0.166_666_67, 0.041_666_508, 8.333_177e-3, 1.393_086_5e-3, 1.997_230_7e-4];
    let shifted = x * core::f32::consts::LOG2_E + SHIFTER;
    let k = shifted - SHIFTER;
    let power = f32::from_bits((shifted.to_bits() << 23).wrapping_add(0x3f80_0000));
    let f = (x - k * LN_2[0]) - k * LN_2[1];
    let f2 = f * f;
    let (low, middle, high) = (EXP[0] + f * EXP[1], EXP[2] + f * EXP[3], EXP[4] + f * EXP[5]);
    let p = f + f2 * (low + f2 * (middle + f2 * high));
    [power + power * p, (1.0 - power) - power * p]
}

/// ln of the smallest normal number, toward 0.
pub(super) const LN_MIN: f32 = -87.336_54;
