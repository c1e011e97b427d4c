//! The concentric map with a division: with t = b/a and q = t^2, x = a C(q) and y = b S(q), where
//! C(q) = cos(pi/4 t) and S(q) = sin(pi/4 t) / t to degree 2.
//!
//! The coefficients are minimax on [0, 1], moved a little inward (tests/derive/q15_div.sollya).

use super::fixed::Q15;
use super::q15::arithmetic_on_q15;
use super::q15::disc::{Q15Disc, concentric_by};

/// The arithmetic of [`Q15`] with a concentric kernel for cores that divide: no table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Q15Div;

impl Q15Div {
    /// The concentric map, as [`Concentric`](crate::Concentric) stores it: for tables built at
    /// compile time.
    #[must_use]
    #[inline(always)]
    pub const fn concentric(uv: [u32; 2]) -> [Q15; 2] {
        Self::disc(uv).store()
    }

    /// The polar map, as [`Polar`](crate::Polar) stores it.
    #[must_use]
    #[inline(always)]
    pub const fn polar(uv: [u32; 2]) -> [Q15; 2] {
        Q15::polar(uv)
    }

    #[inline(always)]
    const fn disc(uv: [u32; 2]) -> Q15Disc {
        concentric_by!(rotate, uv)
    }
}

arithmetic_on_q15!(Q15Div, "q15-div", Q15Div::disc);

/// (a cos, a sin) of the angle pi/4 b/a, in 2^-31; a and b odd, b <= a < 2^16.
#[inline(always)]
const fn rotate(a: u32, b: u32) -> (u32, u32) {
    // b/a and its square in 2^-16, less than 1. An odd number is not 0, which the compiler may not
    // see.
    let t = ((b << 16) - 1) / (a | 1);
    let q = (t * t) >> 16;
    let cos = COSINE[0] - (((COSINE[1] - ((COSINE[2] * q) >> 16)) * q) >> 16);
    let sin = SINE[0] - (((SINE[1] - ((SINE[2] * q) >> 16)) * q) >> 16);
    ((a * cos) >> 1, (b * sin) >> 1)
}

/// In 2^-16.
const COSINE: [u32; 3] = [65_534, 20_199, 1_006];
/// In 2^-16.
const SINE: [u32; 3] = [51_468, 5_276, 148];
