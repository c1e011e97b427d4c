//! The disc kernels: the concentric and the polar map, and the rounding of a point.

use crate::arithmetic::fixed::Q31;
use crate::arithmetic::fixed::root::root;
use crate::arithmetic::fixed::rotation::{cos_sin, rotate};
use crate::arithmetic::fixed::wide::product;
use crate::coordinates::{Quarter, fold, fold_to_quarter};

/// A point of the disc before it gets its signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Q31Disc {
    /// |x| in units of 2^-32.
    pub(super) x: u32,
    /// |y| in units of 2^-32.
    pub(super) y: u32,
    /// For x and for y, -1 where it is positive, else 0: a coordinate's highest bit, which needs no
    /// constant.
    pub(super) positive: [i32; 2],
    /// r^2 in units of 2^-64, not 0.
    pub(super) r2: u64,
    /// 1 - r^2 in units of 2^-64.
    pub(super) one_minus_r2: u64,
}

/// The number of a magnitude in LSBs, below 2^31, and a mask that is -1 where it is positive,
/// else 0.
#[inline(always)]
pub(super) const fn signed(magnitude: u32, positive: i32) -> Q31 {
    Q31::from_bits(positive.wrapping_sub(magnitude.cast_signed() ^ positive))
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
    const fn new(x: u32, y: u32, positive: [i32; 2], r2: u64) -> Self {
        // 2^64 - r2; an odd number's square is not 0.
        Self { x, y, positive, r2, one_minus_r2: r2.wrapping_neg() }
    }

    #[inline(always)]
    pub(super) const fn store(self) -> [Q31; 2] {
        let [x_positive, y_positive] = self.positive;
        [signed(self.x >> 1, x_positive), signed(self.y >> 1, y_positive)]
    }
}

/// With r^2 and 1 - r^2 where `R2` asks for them: the compiler does not always remove an unused
/// product.
#[inline(always)]
pub(super) const fn concentric<const R2: bool>([u, v]: [u32; 2]) -> Q31Disc {
    let ((u, sign_u), (v, sign_v)) = (fold(u), fold(v));
    let positive = [!sign_u, !sign_v];
    if v > u {
        let (y, x) = rotate(v, u);
        Q31Disc::new(x, y, positive, r2_of::<R2>(v))
    } else {
        let (x, y) = rotate(u, v);
        Q31Disc::new(x, y, positive, r2_of::<R2>(u))
    }
}

/// r^2 of a magnitude, where it is asked for.
#[inline(always)]
const fn r2_of<const R2: bool>(m: u32) -> u64 {
    if R2 { product(2 * m + 1, 2 * m + 1) } else { 0 }
}

#[inline(always)]
pub(super) const fn polar([u, v]: [u32; 2]) -> Q31Disc {
    let Quarter { below, left, quarter } = fold_to_quarter(u);
    let steep = quarter & 1 << 29 != 0;
    let within = if steep { quarter ^ 0x3fff_ffff } else { quarter };
    let (long, short) = cos_sin(2 * within + 1);
    let (cos, sin) = if steep { (short, long) } else { (long, short) };
    let r2 = (2 * v as u64 + 1) << 31;
    let r = root(r2);
    // The floor of the product, like the others.
    let (x, y) = (halfway(cos, r), halfway(sin, r));
    Q31Disc::new(x, y, [!left.cast_signed(), !below.cast_signed()], r2)
}
