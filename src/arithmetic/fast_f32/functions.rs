//! The elementary functions of fast f32, on the ranges that the maps need, as `const fn`.
//!
//! tests/derive/fast_f32.sollya derives the coefficients. The tests have the errors, over every f32
//! of each range.

/// Square root of x in [0, MAX]; `core` has none.
#[inline]
pub(super) const fn sqrt(x: f32) -> f32 {
    // 2^64: above it the residual of the root is a normal number.
    const UP: f32 = 18_446_744_073_709_551_616.0;
    if x < 1.0 / UP { normal_sqrt(x * UP) * (1.0 / 4_294_967_296.0) } else { normal_sqrt(x) }
}

/// Square root of x in [2^-110, MAX], and of 0.
///
/// y = 1 / sqrt x from below to 1.4e-3, by a magic constant and one Newton step with tuned
/// constants (J. Kadlec, 2010, shows how far they beat the plain step). Then s = x y is below the
/// root, so s^2 does not overflow. The residual x - s^2 of the rounded s gives the correction: with
/// h = (x - s^2) y^2, sqrt x = s (1 + h / 2 + 3/8 h^2 + ..), short of the truth by 5/16 h^3 < 1e-8.
#[inline(always)]
pub(super) const fn normal_sqrt(x: f32) -> f32 {
    // Wraps outside the function's range, where the result is unspecified.
    let y = f32::from_bits(0x5f20_0000_u32.wrapping_sub(x.to_bits() >> 1));
    let y = y * (1.680_819_6 - 0.703_494 * x * y * y);
    let s = x * y;
    let residual = (x - s * s) * y;
    s + residual * (0.5 + 0.375 * (residual * y))
}

/// ln 2 in two parts: multiples of the first up to 2^15 are exact.
const LN_2: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];

/// ln(1 - x) from x and 1 - x, both in [0, 1], each correct to a few eps of itself.
///
/// With 1 - x = 2^n (1 + g), 1 + g in [sqrt(1/2), sqrt 2): where n = 0, g = -x has the digits that
/// 1 - x has lost. ln(1 + g) = 2 atanh h, h = g / (2 + g), is g - h (g - R), R = 2/3 h^2 + 2/5
/// h^4 + ..: g enters exactly, and the rounded terms are small beside it.
#[inline(always)]
pub(super) const fn ln_complement(x: f32, complement: f32) -> f32 {
    const ATANH: [f32; 3] = [0.666_666_87, 0.399_884_6, 0.295_913_3];
    const SQRT_HALF: u32 = core::f32::consts::FRAC_1_SQRT_2.to_bits();
    let above = complement.to_bits().wrapping_sub(SQRT_HALF);
    let n = above.cast_signed() >> 23;
    let mantissa = f32::from_bits((above & 0x007f_ffff) + SQRT_HALF);
    let g = if n == 0 { -x } else { mantissa - 1.0 };
    let h = g / (2.0 + g);
    let h2 = h * h;
    let r = h2 * (ATANH[0] + h2 * (ATANH[1] + h2 * ATANH[2]));
    let n = n as f32;
    (g - (h * (g - r) - n * LN_2[1])) + n * LN_2[0]
}

/// exp(x (1 + d)) and 1 - exp(x (1 + d)) for x in [-87.3, 88], d at most an eps.
///
/// With x = k ln 2 + f, |f| <= ln 2 / 2, and p = exp f - 1: 2^k + 2^k p and (1 - 2^k) - 2^k p. Near
/// x = 0, k = 0, so neither cancels. k comes from an addition of 3/2 2^23, which rounds to an
/// integer and leaves it in the low bits.
#[inline(always)]
pub(super) const fn exp(x: f32, d: f32) -> [f32; 2] {
    const EXP: [f32; 6] =
        [0.5, 0.166_666_67, 0.041_666_508, 8.333_177e-3, 1.393_086_5e-3, 1.997_230_7e-4];
    const SHIFTER: f32 = 12_582_912.0;
    let shifted = x * core::f32::consts::LOG2_E + SHIFTER;
    let k = shifted - SHIFTER;
    let power = f32::from_bits((shifted.to_bits() << 23).wrapping_add(0x3f80_0000));
    let f = (x - k * LN_2[0]) - (k * LN_2[1] - x * d);
    let f2 = f * f;
    let (low, middle, high) = (EXP[0] + f * EXP[1], EXP[2] + f * EXP[3], EXP[4] + f * EXP[5]);
    let p = f + f2 * (low + f2 * (middle + f2 * high));
    [power + power * p, (1.0 - power) - power * p]
}

/// ln of the smallest normal number, toward 0.
pub(super) const LN_MIN: f32 = -87.336_54;
