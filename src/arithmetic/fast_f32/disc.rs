//! The disc kernels: both maps to an octant, and the octant to its place.

use super::functions::{Functions, gaps, normal_sqrt};
use crate::arithmetic::float::{FloatDisc, lowered};
use crate::square::fold;

/// A point of the disc, folded to the octant 0 <= y <= x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FastDisc {
    /// r, and r t with t = phi / (pi/4) in [0, 1].
    larger: f32,
    smaller: f32,
    t: f32,
    /// 1 - cos phi and 1 - sin phi / t.
    gaps: [f32; 2],
    pub(super) r2: f32,
    /// 1 - r^2.
    pub(super) rim: f32,
    /// All ones where x and y swap places.
    swap: u32,
    /// The sign bits of x and y.
    signs: [u32; 2],
}

const SIGN: u32 = 0x8000_0000;

/// n + 1/2 for n < 2^31. Every target converts signed integers alike, and in vectors.
#[inline(always)]
const fn centre(n: u32) -> f32 {
    n.cast_signed() as f32 + 0.5
}

/// (2k + 1) / 2^33 correctly rounded, in halves that conversions of signed integers hold; and what the
/// rounding has added, in units of 2^-32.
#[inline(always)]
const fn halves(k: u32) -> (f32, f32) {
    let high = (k >> 16).cast_signed() as f32 * 65_536.0;
    let low = centre(k & 0xffff);
    let sum = high + low;
    // Exact, for high is 0 or larger than low (T. Dekker, 1971).
    (sum * (1.0 / 4_294_967_296.0), (sum - high) - low)
}

/// (2k + 1) / 2^33 toward zero.
#[inline(always)]
pub(super) const fn centre_down(k: u32) -> f32 {
    let (nearest, added) = halves(k);
    f32::from_bits(nearest.to_bits() - (added > 0.0) as u32)
}

#[inline(always)]
const fn mask(condition: bool) -> u32 {
    (condition as u32).wrapping_neg()
}

/// The two words, exchanged where the mask is ones.
#[inline(always)]
const fn exchanged(mask: u32, [a, b]: [u32; 2]) -> [u32; 2] {
    let difference = (a ^ b) & mask;
    [a ^ difference, b ^ difference]
}

/// The next numbers toward zero of both, where they are within 2 eps of the circle or beyond it.
///
/// The square of the length is computed to 5/4 eps, so a point left alone is inside. One outside is so
/// by less than the step takes, which tests/fast_f32.rs proves on the rims.
#[inline(always)]
const fn inward([x, y]: [f32; 2]) -> [u32; 2] {
    let near = (x * x + y * y > 1.0 - f32::EPSILON) as u32;
    [x.to_bits() - near, y.to_bits() - near]
}

#[inline(always)]
const fn signed([x, y]: [u32; 2], signs: [u32; 2]) -> [f32; 2] {
    [f32::from_bits(x | signs[0]), f32::from_bits(y | signs[1])]
}

/// The square [-1, 1]^2, for coordinates inside the disc.
#[inline(always)]
pub(super) const fn centred([u, v]: [u32; 2]) -> [f32; 2] {
    const SCALE: f32 = 1.0 / 2_147_483_648.0;
    let ((m_u, sign_u), (m_v, sign_v)) = (fold(u), fold(v));
    let point = inward([centre(m_u) * SCALE, centre(m_v) * SCALE]);
    signed(point, [sign_u.cast_unsigned() & SIGN, sign_v.cast_unsigned() & SIGN])
}

#[inline(always)]
pub(super) const fn concentric([u, v]: [u32; 2]) -> FastDisc {
    const SCALE: f32 = 1.0 / 2_147_483_648.0;
    let ((m_u, sign_u), (m_v, sign_v)) = (fold(u), fold(v));
    let swap = mask(m_v.cast_signed() > m_u.cast_signed());
    let [major, minor] = exchanged(swap, [m_u, m_v]);
    let (a, b) = (centre(major), centre(minor));
    let t = b / a;
    let larger = a * SCALE;
    let to_rim = centre(0x7fff_ffff - major) * SCALE;
    FastDisc {
        larger,
        smaller: b * SCALE,
        t,
        gaps: gaps(t * t),
        r2: larger * larger,
        rim: to_rim * (2.0 - to_rim),
        swap,
        signs: [sign_u.cast_unsigned() & SIGN, sign_v.cast_unsigned() & SIGN],
    }
}

#[inline(always)]
pub(super) const fn polar([u, v]: [u32; 2]) -> FastDisc {
    // u and !u are mirror images in the x axis: fold before rounding.
    let below = (u.cast_signed() >> 31).cast_unsigned();
    let half = u ^ below;
    // 31 bits of a half turn: the quarter, the octant in it, 29 bits within.
    let left = mask(half & 1 << 30 != 0);
    let quarter = half ^ (left & 0x7fff_ffff);
    let steep = mask(quarter & 1 << 29 != 0);
    let octant = quarter ^ (steep & 0x3fff_ffff);
    let t = centre(octant) * (1.0 / 536_870_912.0);
    let (r2, _) = halves(v);
    let (rim, _) = halves(!v);
    let r = normal_sqrt(r2);
    FastDisc {
        larger: r,
        smaller: r * t,
        t,
        gaps: gaps(t * t),
        r2,
        rim,
        swap: steep,
        signs: [left & SIGN, below & SIGN],
    }
}

impl FastDisc {
    /// The point at r and phi = pi/4 t.
    #[inline(always)]
    pub(super) const fn octant(r: f32, t: f32) -> Self {
        let (r2, rim) = (r * r, (1.0 - r) * (1.0 + r));
        let gaps = gaps(t * t);
        Self { larger: r, smaller: r * t, t, gaps, r2, rim, swap: 0, signs: [0; 2] }
    }

    /// The point at distance r.
    #[inline(always)]
    pub(super) const fn place(self) -> [f32; 2] {
        let Self { larger, smaller, gaps: [cos, sin], swap, signs, .. } = self;
        let point = inward([larger - larger * cos, smaller - smaller * sin]);
        signed(exchanged(swap, point), signs)
    }

    /// The point in the same direction at another distance.
    #[inline(always)]
    pub(super) const fn place_at(self, distance: f32) -> [f32; 2] {
        Self { larger: distance, smaller: distance * self.t, ..self }.place()
    }
}

/// Square root of what is at most 1 but for its rounding.
#[inline(always)]
pub(super) const fn root_to_1(square: f32) -> f32 {
    normal_sqrt(if square < 1.0 { square } else { 1.0 })
}

/// Where an inverse begins: a point of the generic kernels, whose direction is as long as it may be.
impl From<FloatDisc<f32>> for FastDisc {
    #[inline]
    fn from(disc: FloatDisc<f32>) -> Self {
        let [x, y] = disc.direction.map(f32::to_bits);
        let magnitudes = [x & !SIGN, y & !SIGN];
        // Magnitudes compare as their bits do.
        let swap = mask(magnitudes[1] > magnitudes[0]);
        let [larger, smaller] = exchanged(swap, magnitudes).map(f32::from_bits);
        // On an axis no step toward zero is left: keep off the rim. Only the ratio matters.
        let larger = if smaller == 0.0 { larger.min(1.0 - f32::EPSILON) } else { larger };
        let (r2, rim) = (disc.r2, disc.rim);
        let signs = [x & SIGN, y & SIGN];
        Self { larger, smaller, t: 0.0, gaps: [0.0; 2], r2, rim, swap, signs }
    }
}

impl From<FastDisc> for FloatDisc<f32> {
    #[inline]
    fn from(disc: FastDisc) -> Self {
        let FastDisc { larger, smaller, gaps: [cos, sin], swap, signs, r2, rim, .. } = disc;
        let point = [larger - larger * cos, smaller - smaller * sin].map(f32::to_bits);
        lowered::<Functions>(signed(exchanged(swap, point), signs), r2, rim)
    }
}
