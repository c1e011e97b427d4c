//! The disc kernels of Q15.
//!
//! **Coordinates.** The top 16 bits are the cell; its centre is 2u - 1 = +-a / 2^16 with an odd
//! a < 2^16.
//!
//! **Concentric.** With a the larger magnitude, b the smaller and t = b/a, cos(pi/4 t) is a line in
//! t on each of 62 buckets, within 0.8 LSB. So x = a (A - B t) = a A - b B, without a quotient:
//! only the bucket of t is needed. A neighbouring bucket's line does little harm. A table of 256
//! reciprocals finds the bucket.
//!
//! **Polar.** The angle within the octant is exact, and so is its bucket; r is a root from a table.

use super::tables::{BUCKETS, HALF, LINES, RECIPROCAL, RECIPROCAL_SHIFT, ROOT};
use crate::arithmetic::fixed::Q15;

/// A point of the disc before it is rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Q15Disc {
    /// |x| and |y| in 2^-31.
    pub(in crate::arithmetic) magnitude: [u32; 2],
    /// For x and for y, -1 where it is positive, else 0: a coordinate's highest bit, which needs no
    /// constant.
    pub(in crate::arithmetic) positive: [i32; 2],
    /// r^2 in 2^-32, not 0.
    pub(in crate::arithmetic) r2: u32,
}

impl Q15Disc {
    /// The point, each component toward zero. Truncation saves a constant and can never leave the
    /// disc.
    #[inline(always)]
    pub(in crate::arithmetic) const fn store(self) -> [Q15; 2] {
        let ([x, y], [x_positive, y_positive]) = (self.magnitude, self.positive);
        [signed(x >> 16, x_positive), signed(y >> 16, y_positive)]
    }

    /// 1 - r^2 in 2^-32, less one: the complement needs no constant.
    #[inline(always)]
    pub(in crate::arithmetic) const fn one_minus_r2(self) -> u32 {
        !self.r2
    }
}

/// The magnitude about the centre in 2^-16, odd, of the cell of a coordinate; and a mask that is -1
/// where it is positive, else 0.
#[inline(always)]
pub(in crate::arithmetic) const fn odd_magnitude(k: u32) -> (u32, i32) {
    let j = k.cast_signed() >> 16;
    let positive = j >> 31;
    (0xffff - 2 * (j ^ positive).cast_unsigned(), positive)
}

/// The concentric map of a pair of coordinates, by a function that rotates the larger magnitude by
/// the angle of the smaller. A macro, because a `const` function cannot call one that it is given.
macro_rules! concentric_by {
    ($rotate:ident, $uv:ident) => {{
        use $crate::arithmetic::q15::disc::{Q15Disc, odd_magnitude};
        let [u, v] = $uv;
        let ((u, u_positive), (v, v_positive)) = (odd_magnitude(u), odd_magnitude(v));
        let positive = [u_positive, v_positive];
        if v > u {
            let (y, x) = $rotate(v, u);
            Q15Disc { magnitude: [x, y], positive, r2: v * v }
        } else {
            let (x, y) = $rotate(u, v);
            Q15Disc { magnitude: [x, y], positive, r2: u * u }
        }
    }};
}
pub(in crate::arithmetic) use concentric_by;

#[inline(always)]
pub(super) const fn concentric(uv: [u32; 2]) -> Q15Disc {
    concentric_by!(rotate, uv)
}

/// The bucket of b/a by a crude quotient; none for an `a` whose top 4 bits are 0.
#[inline(always)]
const fn bucket(a: u32, b: u32) -> Option<u32> {
    match RECIPROCAL[(a >> 8) as usize & 255] {
        0 => None,
        reciprocal => Some(((b * reciprocal as u32) >> RECIPROCAL_SHIFT) & 63),
    }
}

/// One point in 256 is so near the centre that the top bits do not suffice.
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
const fn rotate(a: u32, b: u32) -> (u32, u32) {
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
        positive: [if left { 0 } else { -1 }, !below],
        r2,
    }
}

/// The root of any x, plus [`HALF`], both in 2^-32.
#[inline(always)]
pub(super) const fn root_of(x: u32) -> u32 {
    if x >= 1 << 30 {
        return ROOT.rising(x);
    }
    // The 1 ends the loop for any x.
    let (mut x, mut shift) = ((x << 2) | 1, 1);
    while x < 1 << 30 {
        x <<= 2;
        shift += 1;
    }
    ((ROOT.rising(x) - HALF) >> shift) + HALF
}

/// A number from its magnitude in LSBs, below 2^15, and a mask that is -1 where it is positive,
/// else 0.
#[inline(always)]
pub(in crate::arithmetic) const fn signed(magnitude: u32, positive: i32) -> Q15 {
    Q15::from_bits((positive - (magnitude.cast_signed() ^ positive)) as i16)
}
