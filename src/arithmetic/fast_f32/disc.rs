//! The disc kernels: both maps to an octant, and the octant to its place.

use super::functions::{gaps, normal_sqrt};
use crate::coordinates::{Angle, fold, fold_angle};
use crate::target::BRANCHES;

/// A point of the disc, and how it came to its place from the octant 0 <= y <= x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FastDisc {
    /// As it is stored.
    pub(super) point: [f32; 2],
    /// phi / (pi/4) in the octant, in [0, 1].
    pub(super) t: f32,
    /// 1 - cos phi and 1 - sin phi / t.
    gaps: [f32; 2],
    /// r and r t: x and y are these less their gaps.
    pub(super) ends: [f32; 2],
    pub(super) place: Place,
    pub(super) r2: f32,
    pub(super) one_minus_r2: f32,
}

/// From the octant to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    /// All ones where x and y swap places.
    swap: u32,
    /// Words with the signs of x and y.
    signs: [u32; 2],
}

const SIGN: u32 = 0x8000_0000;

/// n + 1/2 for n < 2^31. Every target converts signed integers alike, and in vectors.
#[inline(always)]
const fn centre(n: u32) -> f32 {
    n.cast_signed() as f32 + 0.5
}

/// (2k + 1) / 2^33 with some low bits of 2k + 1 cleared, correctly rounded.
///
/// The halves of k are put where the mantissas of 2^7 and 2^-10 have these very bits, and the powers are taken
/// away before the one addition that rounds: no conversion, which few vector units have for 32 bits.
#[inline(always)]
const fn halves(k: u32, cleared: u32) -> f32 {
    let high = f32::from_bits(128_f32.to_bits() | k >> 16) - (128.0 + 1.0 / 1024.0);
    let low = f32::from_bits(((1.0 / 1024_f32).to_bits() | 1 | k << 1 & 0x1_ffff) & !cleared);
    high + low
}

/// (2k + 1) / 2^33 correctly rounded.
#[inline(always)]
const fn centre_nearest(k: u32) -> f32 {
    halves(k, 0)
}

/// (2k + 1) / 2^33 toward zero.
#[inline(always)]
pub(super) const fn centre_down(k: u32) -> f32 {
    // 24 bits are kept. Of the quotient by 2^24 the highest bit is where the first lost one is, which decides
    // the rounding: without it, it is down.
    halves(k, k >> 23)
}

#[inline(always)]
const fn mask(condition: bool) -> u32 {
    (condition as u32).wrapping_neg()
}

/// The two numbers, exchanged where the mask is ones.
#[inline(always)]
const fn exchanged(mask: u32, [a, b]: [f32; 2]) -> [f32; 2] {
    let difference = (a.to_bits() ^ b.to_bits()) & mask;
    [f32::from_bits(a.to_bits() ^ difference), f32::from_bits(b.to_bits() ^ difference)]
}

/// The next numbers toward zero of both, where they are within 2 eps of the circle or beyond it.
///
/// The square of the length is computed to 5/4 eps, so a point left alone is inside. One outside is so
/// by less than the step takes, which tests/arithmetic/fast_f32.rs proves on the rims.
#[inline(always)]
const fn inward([x, y]: [f32; 2]) -> [f32; 2] {
    let near = (x * x + y * y > 1.0 - f32::EPSILON) as u32;
    [f32::from_bits(x.to_bits() - near), f32::from_bits(y.to_bits() - near)]
}

/// Two magnitudes with the signs of two words.
#[inline(always)]
const fn signed<const BRANCHES: bool>([x, y]: [f32; 2], signs: [u32; 2]) -> [f32; 2] {
    // They have none yet; where Arm sees as much, it inserts a magnitude into a word at once.
    let (x, y) = if BRANCHES { (x.abs(), y.abs()) } else { (x, y) };
    [f32::from_bits(signs[0] & SIGN | x.to_bits()), f32::from_bits(signs[1] & SIGN | y.to_bits())]
}

impl Place {
    /// A point of the octant in its place.
    #[inline(always)]
    pub(super) const fn placed(self, point: [f32; 2]) -> [f32; 2] {
        signed::<false>(exchanged(self.swap, inward(point)), self.signs)
    }

    /// The point of larger - larger cos and smaller - smaller sin. Not `at_rim` means inside by more than all
    /// errors: a branch then spares it the exact test.
    #[inline(always)]
    const fn put<const BRANCHES: bool>(
        self,
        [larger, smaller]: [f32; 2],
        [cos, sin]: [f32; 2],
        at_rim: bool,
    ) -> [f32; 2] {
        let Self { swap, signs } = self;
        if !BRANCHES {
            return self.placed([larger - larger * cos, smaller - smaller * sin]);
        }
        // Formed in its place: to swap two results would cost Arm five instructions.
        let point = if swap == 0 {
            [larger - larger * cos, smaller - smaller * sin]
        } else {
            [smaller - smaller * sin, larger - larger * cos]
        };
        signed::<BRANCHES>(if at_rim { inward(point) } else { point }, signs)
    }
}

/// The square [-1, 1]^2, for coordinates inside the disc.
#[inline(always)]
pub(super) const fn centred([u, v]: [u32; 2]) -> [f32; 2] {
    const SCALE: f32 = 1.0 / 2_147_483_648.0;
    let ((m_u, _), (m_v, _)) = (fold(u), fold(v));
    let point = inward([centre(m_u) * SCALE, centre(m_v) * SCALE]);
    signed::<BRANCHES>(point, [u ^ SIGN, v ^ SIGN])
}

#[inline(always)]
pub(super) const fn concentric<const BRANCHES: bool>([u, v]: [u32; 2]) -> FastDisc {
    let ((m_u, _), (m_v, _)) = (fold(u), fold(v));
    let signs = [u ^ SIGN, v ^ SIGN];
    let steep = m_v.cast_signed() > m_u.cast_signed();
    if !BRANCHES {
        let swap = mask(steep);
        let major = m_u ^ (m_u ^ m_v) & swap;
        // Rounding keeps the order, and the larger of two floats takes one operation.
        let (a, b) = (centre(m_u), centre(m_v));
        let magnitudes = [if a > b { a } else { b }, if a > b { b } else { a }];
        return at::<BRANCHES>(major, magnitudes, Place { swap, signs });
    }
    // Twice all of it, so that nothing is swapped.
    if steep {
        at::<BRANCHES>(m_v, [centre(m_v), centre(m_u)], Place { swap: !0, signs })
    } else {
        at::<BRANCHES>(m_u, [centre(m_u), centre(m_v)], Place { swap: 0, signs })
    }
}

/// The point of a larger and a smaller magnitude, as floats; and of the larger as it is.
#[inline(always)]
const fn at<const BRANCHES: bool>(major: u32, [a, b]: [f32; 2], place: Place) -> FastDisc {
    const SCALE: f32 = 1.0 / 2_147_483_648.0;
    let t = b / a;
    let gaps = gaps(t * t);
    let ends = [a * SCALE, b * SCALE];
    let [larger, _] = ends;
    let one_minus_r = centre(0x7fff_ffff - major) * SCALE;
    let (r2, one_minus_r2) = (larger * larger, one_minus_r * (2.0 - one_minus_r));
    // r >= 1 - 16 eps.
    let at_rim = major >= 0x7fff_f800;
    let point = place.put::<BRANCHES>(ends, gaps, at_rim);
    FastDisc { point, t, gaps, ends, place, r2, one_minus_r2 }
}

#[inline(always)]
pub(super) const fn polar<const BRANCHES: bool>([u, v]: [u32; 2]) -> FastDisc {
    let Angle { left, steep: swap, within, .. } = fold_angle(u);
    let t = centre(within) * (1.0 / 536_870_912.0);
    let (r2, one_minus_r2) = (centre_nearest(v), centre_nearest(!v));
    let r = normal_sqrt(r2);
    let gaps = gaps(t * t);
    let place = Place { swap, signs: [left, u] };
    // r^2 >= 1 - 16 eps.
    let at_rim = v >= 0xffff_f000;
    let ends = [r, r * t];
    let point = place.put::<BRANCHES>(ends, gaps, at_rim);
    FastDisc { point, t, gaps, ends, place, r2, one_minus_r2 }
}

impl FastDisc {
    /// The point at r and phi = pi/4 t.
    #[cfg(test)]
    pub(super) const fn at_fraction<const BRANCHES: bool>(r: f32, t: f32) -> [f32; 2] {
        let place = Place { swap: 0, signs: [0; 2] };
        place.put::<BRANCHES>([r, r * t], gaps(t * t), at_rim(r))
    }

    /// The point in the same direction at another distance.
    #[inline(always)]
    pub(super) const fn place_at<const BRANCHES: bool>(self, distance: f32) -> [f32; 2] {
        let ends = [distance, distance * self.t];
        self.place.put::<BRANCHES>(ends, self.gaps, at_rim(distance))
    }
}

#[inline(always)]
const fn at_rim(distance: f32) -> bool {
    distance > 1.0 - 8.0 * f32::EPSILON
}

/// Square root of what is at most 1 but for its rounding.
#[inline(always)]
pub(super) const fn root_to_1(square: f32) -> f32 {
    normal_sqrt(if square < 1.0 { square } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Words near powers of two from both ends and the middle, and across the tests for the rim.
    fn words() -> impl Iterator<Item = u32> + Clone {
        let steps = (0..31).flat_map(|bit| [1 << bit, (1 << bit) - 1, (1 << bit) + 5]);
        let rim = (0..1 << 13).step_by(61);
        steps.chain(rim).flat_map(|step: u32| [step, !step, step ^ 0x8000_0000, step ^ 0x7fff_ffff])
    }

    /// In f64 the centre of a cell is exact.
    #[test]
    fn centres_are_rounded_as_they_say() {
        for k in words().chain((0..1 << 20).map(|i: u32| i.wrapping_mul(0x9e37_79b1))) {
            let exact = (f64::from(k) + 0.5) / 4_294_967_296.0;
            let nearest = exact as f32;
            let down = if f64::from(nearest) > exact { nearest.next_down() } else { nearest };
            assert_eq!([centre_nearest(k), centre_down(k)], [nearest, down], "{k:x}");
        }
    }

    /// Both forms are compiled everywhere, though a target takes one of them.
    #[test]
    fn branches_do_not_change_a_bit() {
        for u in words() {
            for v in words() {
                let uv = [u, v];
                assert_eq!(concentric::<true>(uv), concentric::<false>(uv), "{u:x} {v:x}");
                assert_eq!(polar::<true>(uv), polar::<false>(uv), "{u:x} {v:x}");
            }
        }
        for (u, below) in words().zip((0..64).cycle()) {
            let distance = f32::from_bits(1.0_f32.to_bits() - below);
            for disc in [concentric::<true>([u, !u]), polar::<true>([u, u.rotate_left(9)])] {
                assert_eq!(disc.place_at::<true>(distance), disc.place_at::<false>(distance));
            }
        }
    }
}
