//! The concentric map with a division: with t = b/a and q = t^2, x = a C(q) and y = b S(q), where
//! C(q) = cos(pi/4 t) and S(q) = sin(pi/4 t) / t to degree 2.
//!
//! The coefficients are minimax on [0, 1], moved a little inward (tests/derive/q15_div.sollya).

use super::fixed::Q15;
use super::q15::{Q15Disc, fold};

/// The arithmetic of [`Q15`] with a concentric kernel for cores that divide: no table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Q15Div;

impl Q15Div {
    /// The concentric map, as [`Concentric`](crate::Concentric) stores it: for tables built at compile time.
    #[inline(always)]
    pub const fn concentric(uv: [u32; 2]) -> [Q15; 2] {
        concentric(uv).store()
    }

    /// The polar map, as [`Polar`](crate::Polar) stores it.
    #[inline(always)]
    pub const fn polar(uv: [u32; 2]) -> [Q15; 2] {
        Q15::polar(uv)
    }
}

#[inline(always)]
pub(super) const fn concentric([u, v]: [u32; 2]) -> Q15Disc {
    let ((u, sign_u), (v, sign_v)) = (fold(u), fold(v));
    let (a, b) = if v > u { (v, u) } else { (u, v) };
    // t and q in 2^-16, at most 1; a magnitude is odd, so a is not 0.
    let t = match (b << 16).checked_div(a) {
        Some(t) => t,
        None => 0,
    };
    let q = if t > 0xffff { 0xffff } else { (t * t) >> 16 };
    let cos = COSINE[0] - (((COSINE[1] - ((COSINE[2] * q) >> 16)) * q) >> 16);
    let sin = SINE[0] - (((SINE[1] - ((SINE[2] * q) >> 16)) * q) >> 16);
    let (x, y) = ((a * cos) >> 1, (b * sin) >> 1);
    let magnitude = if v > u { [y, x] } else { [x, y] };
    Q15Disc { magnitude, sign: [sign_u, sign_v], r2: a * a }
}

/// In 2^-16.
const COSINE: [u32; 3] = [65_533, 20_200, 1_007];
/// In 2^-16.
const SINE: [u32; 3] = [51_470, 5_291, 160];
