//! The disc kernels of Q15.
//!
//! **Coordinates.** The top 16 bits are the cell; its centre is 2u - 1 = +-a / 2^16 with an odd a < 2^16.
//!
//! **Concentric.** With a the larger magnitude, b the smaller and t = b/a, cos(pi/4 t) is a line in t on
//! each of 62 buckets, within 0.7 LSB, and so x = a (A - B t) = a A - b B: no quotient, only the bucket of
//! t, and a near neighbour's line does little harm. A table of 256 reciprocals finds it.
//!
//! **Polar.** The angle within the octant is exact, and so is its bucket; r is a root from a table.

use super::super::fixed::Q15;
use super::super::q15_div;
use super::tables::{BUCKETS, HALF, LINES, RECIPROCAL, RECIPROCAL_SHIFT, ROOT};

/// A point of the disc before it is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Q15Disc {
    /// |x| and |y| in 2^-31; up to a common factor where an inverse begins.
    pub(in crate::arithmetic) magnitude: [u32; 2],
    /// For each -1 where it is positive, else 0: a coordinate's own sign, which needs no constant.
    pub(in crate::arithmetic) sign: [i32; 2],
    /// r^2 in 2^-32, not 0.
    pub(in crate::arithmetic) r2: u32,
}

impl Q15Disc {
    /// The point, each component toward zero: that needs no constant, and no room to the rim.
    #[inline(always)]
    pub(in crate::arithmetic) const fn store(self) -> [Q15; 2] {
        let ([x, y], [sign_x, sign_y]) = (self.magnitude, self.sign);
        [signed(x >> 16, sign_x), signed(y >> 16, sign_y)]
    }

    /// 1 - r^2 in 2^-32, less one: the complement needs no constant.
    #[inline(always)]
    pub(in crate::arithmetic) const fn rim(self) -> u32 {
        !self.r2
    }
}

/// The magnitude about the centre in 2^-16, odd, of the cell of a coordinate; and its sign, -1 where positive.
#[inline(always)]
pub(super) const fn fold(k: u32) -> (u32, i32) {
    let j = k.cast_signed() >> 16;
    let sign = j >> 31;
    (0xffff - 2 * (j ^ sign).cast_unsigned(), sign)
}

/// By the table, or by Q15Div's division.
#[inline(always)]
pub(in crate::arithmetic) const fn concentric<const DIVIDES: bool>([u, v]: [u32; 2]) -> Q15Disc {
    let ((u, sign_u), (v, sign_v)) = (fold(u), fold(v));
    if v > u {
        let (y, x) = turned::<DIVIDES>(v, u);
        Q15Disc { magnitude: [x, y], sign: [sign_u, sign_v], r2: v * v }
    } else {
        let (x, y) = turned::<DIVIDES>(u, v);
        Q15Disc { magnitude: [x, y], sign: [sign_u, sign_v], r2: u * u }
    }
}

/// The bucket of b/a by a crude quotient; none for an `a` whose top 4 bits are 0.
#[inline(always)]
const fn bucket(a: u32, b: u32) -> Option<u32> {
    match RECIPROCAL[(a >> 8) as usize & 255] {
        0 => None,
        reciprocal => Some(((b * reciprocal as u32) >> RECIPROCAL_SHIFT) & 63),
    }
}

/// One point in 256 is so near the centre that the top bits would not do.
#[cold]
#[inline(never)]
const fn bucket_near_centre(a: u32, b: u32) -> u32 {
    let (a, b) = if a >> 8 == 0 { (a << 8, b << 8) } else { (a, b) };
    let (a, b) = if a >> 12 == 0 { (a << 4, b << 4) } else { (a, b) };
    match bucket(a, b) {
        Some(bucket) => bucket,
        None => 0,
    }
}

/// (a cos, a sin) of the angle pi/4 b/a, in 2^-31; 0 < b <= a < 2^16.
#[inline(always)]
const fn turned<const DIVIDES: bool>(a: u32, b: u32) -> (u32, u32) {
    if DIVIDES {
        return q15_div::rotate(a, b);
    }
    let bucket = match bucket(a, b) {
        Some(bucket) => bucket,
        None => bucket_near_centre(a, b),
    };
    let lines = LINES[bucket as usize & 63];
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
    let lines = LINES[((octant * BUCKETS) >> 13) as usize & 63];
    // From 2^-29 to 2^-16.
    let cos = (((lines.a as u32) << 14) - t * lines.b as u32 + (1 << 12)) >> 13;
    let sin = (((lines.c as u32) << 14) + t * lines.d as u32 + (1 << 12)) >> 13;
    let r2 = (v >> 16 << 16) | 0x8000;
    let cos = if cos < ALMOST_1 { cos } else { ALMOST_1 };
    let r = root_of(r2) >> 16;
    let (x, y) = ((cos * r) >> 1, (sin * r) >> 1);
    Q15Disc {
        magnitude: if steep { [y, x] } else { [x, y] },
        sign: [if left { 0 } else { -1 }, !below],
        r2,
    }
}

/// The root of any x, plus [`HALF`], both in 2^-32.
#[inline(always)]
pub(super) const fn root_of(x: u32) -> u32 {
    if x >= 1 << 30 {
        return ROOT.rising(x);
    }
    // The 1 ends the loop whatever x is.
    let (mut x, mut shift) = ((x << 2) | 1, 1);
    while x < 1 << 30 {
        x <<= 2;
        shift += 1;
    }
    ((ROOT.rising(x) - HALF) >> shift) + HALF
}

/// A number from its magnitude in LSBs, below 2^15, and its sign, -1 where it is positive.
#[inline(always)]
pub(super) const fn signed(magnitude: u32, sign: i32) -> Q15 {
    Q15::from_bits((sign - (magnitude.cast_signed() ^ sign)) as i16)
}
