//! The disc kernels: the concentric and the polar map, and the rounding of a point.

use crate::arithmetic::Q31;
use crate::arithmetic::fixed::root::root;
use crate::arithmetic::fixed::rotation::{cos_sin, rotate};
use crate::arithmetic::fixed::wide::product;
use crate::square::fold;

/// A point of the disc before it gets its signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Q31Disc {
    /// |x| in units of 2^-32; where an inverse begins, up to a factor that it has in common with |y|.
    pub(in crate::arithmetic) x: u32,
    /// |y| in the same units.
    pub(in crate::arithmetic) y: u32,
    /// For each -1 where it is positive, else 0: a coordinate's own sign, which needs no constant.
    pub(in crate::arithmetic) signs: [i32; 2],
    /// r^2 in units of 2^-64; not 0 at a sampled point.
    pub(in crate::arithmetic) r2: u64,
    /// 1 - r^2 in units of 2^-64.
    pub(in crate::arithmetic) rim: u64,
}

/// The number of a magnitude in LSBs, below 2^31, and a sign, -1 where it is positive.
#[inline(always)]
pub(super) const fn signed(magnitude: u32, sign: i32) -> Q31 {
    Q31::from_bits(sign.wrapping_sub(magnitude.cast_signed() ^ sign))
}

/// The nearest positive number to a count of 2^-32.
#[inline(always)]
pub(super) const fn nearest(z: u32) -> Q31 {
    let z = (z >> 1) + (z & 1);
    Q31::from_bits(if z == 0 {
        1
    } else if z > 0x7fff_ffff {
        0x7fff_ffff
    } else {
        z.cast_signed()
    })
}

/// floor(x by / 2^32) of two floors, which stand for half a unit more.
#[inline(always)]
const fn halfway(x: u32, by: u32) -> u32 {
    ((product(x, by) + (x as u64 + by as u64) / 2) >> 32) as u32
}

impl Q31Disc {
    #[inline(always)]
    const fn new(x: u32, y: u32, signs: [i32; 2], r2: u64) -> Self {
        // 2^64 - r2; an odd number's square is not 0.
        Self { x, y, signs, r2, rim: r2.wrapping_neg() }
    }

    #[inline(always)]
    pub(super) const fn store(self) -> [Q31; 2] {
        let [sign_x, sign_y] = self.signs;
        [signed(self.x >> 1, sign_x), signed(self.y >> 1, sign_y)]
    }
}

#[inline(always)]
pub(super) const fn concentric<const RIM: bool>([u, v]: [u32; 2]) -> Q31Disc {
    let ((u, sign_u), (v, sign_v)) = (fold(u), fold(v));
    let signs = [!sign_u, !sign_v];
    if v > u {
        let (y, x) = rotate(v, u);
        Q31Disc::new(x, y, signs, ring::<RIM>(v))
    } else {
        let (x, y) = rotate(u, v);
        Q31Disc::new(x, y, signs, ring::<RIM>(u))
    }
}

/// r^2 of a magnitude, where it is asked for.
#[inline(always)]
const fn ring<const RIM: bool>(m: u32) -> u64 {
    if RIM { product(2 * m + 1, 2 * m + 1) } else { 0 }
}

#[inline(always)]
pub(super) const fn polar([u, v]: [u32; 2]) -> Q31Disc {
    // u and !u are mirror images in the x axis: fold before rounding.
    let below = u.cast_signed() >> 31;
    let half = u ^ below.cast_unsigned();
    // 31 bits of a half turn: the quarter, the octant in it, 29 bits within.
    let left = (half << 1).cast_signed() >> 31;
    let quarter = half ^ (left.cast_unsigned() >> 1);
    let steep = quarter & 1 << 29 != 0;
    let within = if steep { quarter ^ 0x3fff_ffff } else { quarter };
    let (long, short) = cos_sin(2 * within + 1);
    let (cos, sin) = if steep { (short, long) } else { (long, short) };
    let r2 = (2 * v as u64 + 1) << 31;
    let r = root(r2);
    // The floor of the product, as of the others.
    let (x, y) = (halfway(cos, r), halfway(sin, r));
    Q31Disc::new(x, y, [!left, !below], r2)
}
