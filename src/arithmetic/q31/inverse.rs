//! From a point or a direction back to coordinates: exact squares, roots and quotients of 128 bits.

use crate::arithmetic::fixed::Q31;
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

/// The input of the inverses: a point of the disc by its direction and r.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lowered {
    /// |x| and |y|, unnormalised.
    x: u32,
    y: u32,
    /// For x and for y, -1 where it is positive, else 0.
    positive: [i32; 2],
    /// r^2 in units of 2^-64.
    r2: u64,
}

impl Lowered {
    #[inline]
    pub(super) fn new(x: Q31, y: Q31, r2: u64) -> Self {
        let [x, y] = [x, y].map(Q31::to_bits);
        Self { x: x.unsigned_abs(), y: y.unsigned_abs(), positive: [!x >> 31, !y >> 31], r2 }
    }
}

/// Near the pole r^2 = s^2 / (1 + z), where x and y are more accurate than z; else r^2 = 1 - z.
pub(super) fn lower_uniform([x, y, z]: [Q31; 3]) -> Lowered {
    let r2 = if z.to_bits() >= 1 << 30 {
        let sum = (1 << 31) + u128::from(z.to_bits().unsigned_abs());
        // Below 2^64, because the sum is above 2^31.
        ((u128::from(length_squared(x, y)) << 31) / sum) as u64
    } else {
        complement(height(z))
    };
    Lowered::new(x, y, r2)
}

/// Near the pole r^2 = s^2; else r^2 = 1 - z^2.
pub(super) fn lower_cosine([x, y, z]: [Q31; 3]) -> Lowered {
    let s2 = length_squared(x, y);
    let r2 = if s2 >> 63 == 0 {
        s2
    } else {
        complement(u64::from(z.to_bits().max(0).cast_unsigned()).pow(2) << 2)
    };
    Lowered::new(x, y, r2)
}

/// The coordinate of a magnitude, -1 where it is positive: the inverse of `fold`.
#[inline]
pub(super) fn unfold(magnitude: u32, positive: i32) -> u32 {
    0x7fff_ffff_u32.saturating_sub(magnitude) ^ positive.cast_unsigned()
}

/// Whether |y| > |x|, and the angle from the nearer axis as a fraction of an octant in units of
/// 2^-62.
fn octant_fraction(lowered: Lowered) -> (bool, u64) {
    let steep = lowered.y > lowered.x;
    let (a, b) = if steep { (lowered.y, lowered.x) } else { (lowered.x, lowered.y) };
    (steep, if a == 0 { 0 } else { fraction(a, b) })
}

pub(super) fn concentric(lowered: Lowered) -> [u32; 2] {
    let (steep, t) = octant_fraction(lowered);
    let major = root(lowered.r2) >> 1;
    let minor = (u128::from(t) * u128::from(2 * major + 1)) >> 63;
    // On a diagonal, rounding must not exchange the minor and the larger one, which has the radius.
    let minor = (minor as u32).min(major);
    let (m_u, m_v) = if steep { (minor, major) } else { (major, minor) };
    let [u_positive, v_positive] = lowered.positive;
    [unfold(m_u, u_positive), unfold(m_v, v_positive)]
}

pub(super) fn polar(lowered: Lowered) -> [u32; 2] {
    let (steep, t) = octant_fraction(lowered);
    let octant = ((t >> 33) as u32).min(0x1fff_ffff);
    let quarter = if steep { octant ^ 0x3fff_ffff } else { octant };
    let [left, below] = lowered.positive.map(|positive| !positive.cast_unsigned());
    let half = quarter ^ (left >> 1);
    [half ^ below, (lowered.r2 >> 32) as u32]
}
