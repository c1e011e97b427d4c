//! Square roots of fast f32, correctly rounded: the bits of every processor's own instruction.
//!
//! An instruction takes the time of four or five operations, so [`now`] is that where safe Rust has
//! it: `f32::sqrt` of the feature `std`, which is IEEE 754's on every target. (`core::arch` has it
//! too, but its functions are unsafe to call outside a function that lists the feature, whatever the
//! build enables.) [`root`] is the same number by other operations, for constants and for the rest.
//! No bit depends on which of them ran, so a later version may use the instruction more often.
//!
//! **With an FPU.** Half of the bits of x, moved, are those of a root to 3.5 %. Two of Heron's steps,
//! s + x / s, leave an ulp. The residual x - s^2, in integers, says which of three is the nearest. A
//! small core divides in the time of fourteen products, and takes the root from its reciprocal.
//!
//! **Without.** A digit of a root takes seven instructions, and an operation of floats a hundred.

use crate::target::HAS_FPU;
use crate::target::form::{BRANCHES, ONE};

const MANTISSA: u32 = 0x007f_ffff;

/// Square root of x in [2^-110, MAX], at run time.
#[cfg(feature = "std")]
#[inline(always)]
pub(super) fn now(x: f32) -> f32 {
    x.sqrt()
}

/// Square root of x in [2^-110, MAX], at run time.
#[cfg(not(feature = "std"))]
#[inline(always)]
pub(super) fn now(x: f32) -> f32 {
    root(x)
}

/// Square root of x in [2^-110, MAX], in constants as well.
#[inline(always)]
pub(super) const fn root(x: f32) -> f32 {
    if !HAS_FPU {
        by_digits(x)
    } else if ONE == BRANCHES {
        by_products(x)
    } else {
        by_floats(x)
    }
}

/// By two divisions and an integer residual.
#[inline(always)]
pub(super) const fn by_floats(x: f32) -> f32 {
    // tests/derive/fast_f32.sollya: from 3.4 % below the root to 3.5 % above.
    let start = f32::from_bits((x.to_bits() >> 1) + 0x1fbb_67b3);
    // A step leaves 6.0e-4 and less, above the root: half of that on both sides.
    let root = (start + x / start) * 0.499_849_8;
    let twice = root + x / root;
    nearest(x, twice.to_bits() - (MANTISSA + 1))
}

/// By products and an integer residual, for x in [2^-110, MAX].
///
/// y = 1 / sqrt x from below to 1.4e-3, by a magic constant and one Newton step with tuned
/// constants (J. Kadlec, 2010, shows how far they beat the plain step). Then s = x y is below the
/// root, so s^2 does not overflow. The residual x - s^2 of the rounded s gives the correction: with
/// h = (x - s^2) y^2, sqrt x = s (1 + h / 2 + 3/8 h^2 + ..), short of the truth by 5/16 h^3 < 1e-8.
#[inline(always)]
pub(super) const fn by_products(x: f32) -> f32 {
    // Wraps outside the function's range, where the result is unspecified.
    let y = f32::from_bits(0x5f20_0000_u32.wrapping_sub(x.to_bits() >> 1));
    let y = y * (1.680_819_6 - 0.703_494 * x * y * y);
    let s = x * y;
    let residual = (x - s * s) * y;
    nearest(x, (s + residual * (0.5 + 0.375 * (residual * y))).to_bits())
}

/// The correctly rounded root, from the bits of one that differs by an ulp at most.
///
/// As integers of 24 bits, x = X 4^k and s^2 - s < X <= s^2 + s for the nearest root s 2^k. X and s^2
/// have 48 bits; those of their difference fit 32.
#[inline(always)]
const fn nearest(x: f32, root: u32) -> f32 {
    let bits = x.to_bits();
    let s = root & MANTISSA | (MANTISSA + 1);
    // The mantissa times 2^23 where the exponent is even, which as stored is odd, or else 2^24: by a
    // mask, since vectors of SSE2 have no shift by a lane's own number.
    let (low, odd) = (bits << 23, (!bits << 8).cast_signed() >> 31);
    let low = low.wrapping_add(low & odd.cast_unsigned());
    let rest = low.wrapping_sub(s.wrapping_mul(s)).cast_signed();
    let s = s.cast_signed();
    // Each -1 or 0.
    let (below, above) = ((s - rest) >> 31, (rest + s - 1) >> 31);
    f32::from_bits(root.wrapping_add_signed(above - below))
}

/// Digit by digit, as fdlibm's `e_sqrtf.c` (1993), with the digits in one place.
#[inline]
pub(super) const fn by_digits(x: f32) -> f32 {
    let bits = x.to_bits();
    // Twice the mantissa, or four times where the exponent is odd, which as stored is even.
    let mut rest = (bits & MANTISSA | (MANTISSA + 1)) << (1 + (!bits >> 23 & 1));
    // Twice the root so far, and its next digit. The last of 25 rounds.
    let (mut twice, mut digit) = (0, 1 << 24);
    while digit != 0 {
        let next = twice + digit;
        if next <= rest {
            rest -= next;
            twice = next + digit;
        }
        rest <<= 1;
        digit >>= 1;
    }
    // No root has 25 digits, so none is half way.
    let exponent = ((bits + (MANTISSA + 1)) >> 1 & !MANTISSA) + 0x1f80_0000;
    f32::from_bits(exponent - (MANTISSA + 1) + ((twice + 2) >> 2))
}
