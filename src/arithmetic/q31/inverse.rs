//! From a point or a direction back to coordinates: exact squares, roots and quotients of 128 bits.

use super::disc::Q31Disc;
use crate::arithmetic::Q31;
use crate::arithmetic::fixed::root::root;
use crate::arithmetic::fixed::rotation::fraction;

/// 1 - x in units of 2^-64, at most 1 less one of them.
#[inline]
pub(super) const fn complement(x: u64) -> u64 {
    if x == 0 { u64::MAX } else { x.wrapping_neg() }
}

/// x^2 + y^2 in units of 2^-64, at most 1 less one of them.
#[inline]
pub(super) fn length_squared(x: Q31, y: Q31) -> u64 {
    let square = |x: Q31| u64::from(x.to_bits().unsigned_abs()).pow(2);
    let sum = square(x) + square(y);
    if sum >> 62 == 0 { sum << 2 } else { u64::MAX }
}

/// Whether a direction is above the horizon.
#[inline]
pub(super) fn above(z: Q31) -> bool {
    z > Q31::ZERO
}

/// z in units of 2^-64; 0 below the horizon.
#[inline]
pub(super) fn height(z: Q31) -> u64 {
    u64::from(z.to_bits().max(0).cast_unsigned()) << 33
}

impl Q31Disc {
    /// Where an inverse begins: a direction and r^2.
    #[inline]
    pub(super) fn lowered(x: Q31, y: Q31, r2: u64) -> Self {
        let [x, y] = [x, y].map(Q31::to_bits);
        Self {
            x: x.unsigned_abs(),
            y: y.unsigned_abs(),
            signs: [!x >> 31, !y >> 31],
            r2,
            rim: complement(r2),
        }
    }
}

/// Near the pole r^2 = s^2 / (1 + z), of which x and y know more than z; else r^2 = 1 - z.
pub(super) fn lower_uniform([x, y, z]: [Q31; 3]) -> Q31Disc {
    let r2 = if z.to_bits() >= 1 << 30 {
        let sum = (1 << 31) + u128::from(z.to_bits().unsigned_abs());
        // Below 2^64, for the sum is above 2^31.
        ((u128::from(length_squared(x, y)) << 31) / sum) as u64
    } else {
        complement(height(z))
    };
    Q31Disc::lowered(x, y, r2)
}

/// Near the pole r^2 = s^2; else r^2 = 1 - z^2.
pub(super) fn lower_cosine([x, y, z]: [Q31; 3]) -> Q31Disc {
    let s2 = length_squared(x, y);
    let r2 = if s2 >> 63 == 0 {
        s2
    } else {
        complement(u64::from(z.to_bits().max(0).cast_unsigned()).pow(2) << 2)
    };
    Q31Disc::lowered(x, y, r2)
}

/// The coordinate of a magnitude and its sign: the inverse of `fold`.
#[inline]
pub(super) fn unfold(magnitude: u32, sign: i32) -> u32 {
    0x7fff_ffff_u32.saturating_sub(magnitude) ^ sign.cast_unsigned()
}

/// Whether |y| > |x|, and the angle from the nearer axis as a fraction of an octant in units of 2^-62.
fn octant(disc: Q31Disc) -> (bool, u64) {
    let steep = disc.y > disc.x;
    let (a, b) = if steep { (disc.y, disc.x) } else { (disc.x, disc.y) };
    (steep, if a == 0 { 0 } else { fraction(a, b) })
}

pub(super) fn concentric(disc: Q31Disc) -> [u32; 2] {
    let (steep, t) = octant(disc);
    let major = root(disc.r2) >> 1;
    let minor = (u128::from(t) * u128::from(2 * major + 1)) >> 63;
    // On a diagonal rounding must not make the minor the larger one, which has the radius.
    let minor = (minor as u32).min(major);
    let (m_u, m_v) = if steep { (minor, major) } else { (major, minor) };
    let [sign_u, sign_v] = disc.signs;
    [unfold(m_u, sign_u), unfold(m_v, sign_v)]
}

pub(super) fn polar(disc: Q31Disc) -> [u32; 2] {
    let (steep, t) = octant(disc);
    let octant = ((t >> 33) as u32).min(0x1fff_ffff);
    let quarter = if steep { octant ^ 0x3fff_ffff } else { octant };
    let [left, below] = disc.signs.map(|sign| !sign.cast_unsigned());
    let half = quarter ^ (left >> 1);
    [half ^ below, (disc.r2 >> 32) as u32]
}
