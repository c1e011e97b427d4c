//! The disc kernels of Q15.
//!
//! **Coordinates.** The top 16 bits are the cell; its centre is 2u - 1 = +-a / 2^16 with an odd a < 2^16.
//!
//! **Concentric.** With a the larger magnitude, b the smaller and t = b/a, cos(pi/4 t) is a line in t on
//! each of 128 buckets, within 0.1 LSB, and so x = a (A - B t) = a A - b B: no quotient, only the bucket
//! of t, and a near neighbour's line does little harm. A table of 256 reciprocals finds it.
//!
//! **Polar.** The angle within the octant is exact, and so is its bucket; r is a root from a table.

use super::super::fixed::Q15;
use super::tables::{LINES, RECIPROCAL, ROOT};

/// A point of the disc before it is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Q15Disc {
    /// |x| and |y| in 2^-31; up to a common factor where an inverse begins.
    pub(in crate::arithmetic) magnitude: [u32; 2],
    /// 0 or -1 for each.
    pub(in crate::arithmetic) sign: [i32; 2],
    /// r^2 in 2^-32, not 0.
    pub(in crate::arithmetic) r2: u32,
}

impl Q15Disc {
    /// The point, to the nearest LSB of each component.
    #[inline(always)]
    pub(in crate::arithmetic) const fn store(self) -> [Q15; 2] {
        [rounded(self.magnitude[0], self.sign[0]), rounded(self.magnitude[1], self.sign[1])]
    }

    /// 1 - r^2 in 2^-32, exactly.
    #[inline(always)]
    pub(in crate::arithmetic) const fn rim(self) -> u32 {
        self.r2.wrapping_neg()
    }
}

/// The magnitude about the centre in 2^-16, odd, of the cell of a coordinate; and its sign, 0 or -1.
#[inline(always)]
pub(in crate::arithmetic) const fn fold(k: u32) -> (u32, i32) {
    let j = (k ^ 0x8000_0000).cast_signed() >> 16;
    let sign = j >> 31;
    (2 * (j ^ sign).cast_unsigned() + 1, sign)
}

/// Linear interpolation in a table: `position` counts nodes in its integer part, with 16 bits of fraction.
#[inline(always)]
pub(super) const fn interpolate<const N: usize>(table: &[u16; N], position: u32) -> u32 {
    let i = (position >> 16) as usize;
    if i + 1 >= N {
        return table[N - 1] as u32;
    }
    let (here, next) = (table[i] as i32, table[i + 1] as i32);
    let step = ((next - here) * ((position >> 1) & 0x7fff).cast_signed() + 0x4000) >> 15;
    (here + step).cast_unsigned()
}

/// The root of x in [1/4, 1), both in fractions of their words: 2^-32 to 2^-16.
#[inline(always)]
pub(super) const fn root(x: u32) -> u32 {
    interpolate(&ROOT, (x >> 8).wrapping_sub(64 << 16))
}

#[inline(always)]
pub(in crate::arithmetic) const fn concentric([u, v]: [u32; 2]) -> Q15Disc {
    let ((u, sign_u), (v, sign_v)) = (fold(u), fold(v));
    let (a, b) = if v > u { (v, u) } else { (u, v) };
    let (x, y) = turned(a, b);
    let magnitude = if v > u { [y, x] } else { [x, y] };
    Q15Disc { magnitude, sign: [sign_u, sign_v], r2: a * a }
}

/// (a cos, a sin) of the angle pi/4 b/a, in 2^-31; 0 < b <= a < 2^16.
#[inline(always)]
const fn turned(a: u32, b: u32) -> (u32, u32) {
    let (mut divisor, mut dividend) = (a, b);
    // One point in 64 is so near the centre that the top bits would not do.
    while divisor < 0x2000 {
        divisor <<= 3;
        dividend <<= 3;
    }
    let bucket = (dividend * RECIPROCAL[(divisor >> 8) as u8 as usize] as u32) >> 21;
    let lines = LINES[if bucket < LINES.len() as u32 { bucket as usize } else { 0 }];
    let x = a * lines.a as u32 - b * lines.b as u32;
    let y = a * lines.c as u32 + b * lines.d as u32;
    (x, y)
}

/// 1 in 2^-16, of 16 bits.
const ALMOST_1: u32 = 0xffff;

#[inline(always)]
pub(in crate::arithmetic) const fn polar([u, v]: [u32; 2]) -> Q15Disc {
    // u and !u are mirror images in the x axis: fold before rounding.
    let below = u.cast_signed() >> 31;
    let half = (u ^ below.cast_unsigned()) >> 16;
    // 15 bits of a half turn: the quarter, the octant in it, 13 bits within.
    let left = half & 1 << 14 != 0;
    let quarter = if left { half ^ 0x7fff } else { half };
    let steep = quarter & 1 << 13 != 0;
    let octant = if steep { quarter ^ 0x3fff } else { quarter };
    let t = 2 * octant + 1;
    let lines = LINES[(octant >> 6 & 0x7f) as usize];
    // From 2^-29 to 2^-16.
    let cos = (((lines.a as u32) << 14) - t * lines.b as u32 + (1 << 12)) >> 13;
    let sin = (((lines.c as u32) << 14) + t * lines.d as u32 + (1 << 12)) >> 13;
    let r2 = (v >> 16 << 16) | 0x8000;
    let cos = if cos < ALMOST_1 { cos } else { ALMOST_1 };
    let r = root_of(r2);
    let (x, y) = ((cos * r) >> 1, (sin * r) >> 1);
    Q15Disc {
        magnitude: if steep { [y, x] } else { [x, y] },
        sign: [if left { -1 } else { 0 }, below],
        r2,
    }
}

/// The root of any x > 0: 2^-32 to 2^-16.
#[inline(always)]
pub(super) const fn root_of(x: u32) -> u32 {
    let (mut x, mut shift) = (x, 0);
    while x < 1 << 30 {
        x <<= 2;
        shift += 1;
    }
    (root(x) + (1 << shift >> 1)) >> shift
}

/// A number from its magnitude in LSBs, below 2^15, and its sign, 0 or -1.
#[inline(always)]
pub(super) const fn signed(magnitude: u32, sign: i32) -> Q15 {
    Q15::from_bits(((magnitude.cast_signed() ^ sign) - sign) as i16)
}

/// A number from its magnitude in 2^-31, to the nearest LSB, and its sign.
#[inline(always)]
pub(super) const fn rounded(magnitude: u32, sign: i32) -> Q15 {
    signed((magnitude + 0x8000) >> 16, sign)
}
