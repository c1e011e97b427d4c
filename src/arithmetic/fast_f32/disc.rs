//! The disc kernels: both maps to an octant, and the octant's placement.

use crate::coordinates::{Angle, fold, fold_angle};
use crate::target::form::{BRANCHES, LANE, ONE, WORDS};
use crate::target::{CONVERSIONS_WAIT, HAS_FPU};

/// 1 - cos(pi/4 t) and 1 - sin(pi/4 t) / t from q = t^2 in [0, 1].
///
/// Both are below 0.3, so r - r gap has one rounding at full size: half the error of r cos.
#[inline(always)]
pub(super) const fn gaps(q: f32) -> [f32; 2] {
    const COS: [f32; 4] = [0.308_425_13, -0.015_854_267, 3.258_201_8e-4, -3.461_355_4e-6];
    const SIN: [f32; 4] = [0.214_601_84, 0.080_745_41, -2.489_921_4e-3, 3.590_579_2e-5];
    let cos = COS[0] + q * (COS[1] + q * (COS[2] + q * COS[3]));
    let sin = SIN[0] + q * (SIN[1] + q * (SIN[2] + q * SIN[3]));
    [q * cos, sin]
}

/// A point of the disc, and its place relative to the octant 0 <= y <= x.
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

/// (n + 1/2) / 2^BITS for n < 2^31. Every target converts signed integers alike, and in vectors.
#[inline(always)]
pub(super) const fn centre<const FORM: u8, const BITS: u32>(n: u32) -> f32 {
    let scale = 1.0 / (1_u64 << BITS) as f32;
    if FORM == WORDS && CONVERSIONS_WAIT {
        // The halves of n become mantissa bits of 2^(39 - BITS) and 2^(23 - BITS).
        let [high, low] = [(127 + 39 - BITS) << 23, (127 + 23 - BITS) << 23];
        let powers = f32::from_bits(high) + f32::from_bits(low);
        let high = f32::from_bits(high | n >> 16) - powers;
        return (high + f32::from_bits(low | n & 0xffff)) + 0.5 * scale;
    }
    (n.cast_signed() as f32 + 0.5) * scale
}

/// (2k + 1) / 2^33 with some low bits of 2k + 1 cleared, correctly rounded.
///
/// The halves of k become mantissa bits of 2^7 and 2^-10. Both powers are subtracted before the one
/// addition that rounds. No conversion is needed, which few vector units have for 32 unsigned bits.
#[inline(always)]
const fn halves(k: u32, cleared: u32) -> f32 {
    let high = f32::from_bits(128_f32.to_bits() | k >> 16) - (128.0 + 1.0 / 1024.0);
    let low = f32::from_bits(((1.0 / 1024_f32).to_bits() | 1 | k << 1 & 0x1_ffff) & !cleared);
    high + low
}

/// (2k + 1) / 2^33 correctly rounded.
#[inline(always)]
pub(super) const fn centre_nearest<const FORM: u8>(k: u32) -> f32 {
    if FORM == WORDS && !CONVERSIONS_WAIT {
        return (2 * k as i64 + 1) as f32 * (1.0 / 8_589_934_592.0);
    }
    if FORM != BRANCHES || HAS_FPU {
        return halves(k, 0);
    }
    // 2k + 1 where it fits, or else k, whose lowest bit stands for the half that it lacks. That bit
    // only says to which side of a float, or of the middle of two, the number is.
    let (n, exponent) = if k < 1 << 31 { (2 * k + 1, 33) } else { (k | 1, 32) };
    f32::from_bits((n as f32).to_bits() - (exponent << 23))
}

/// (2k + 1) / 2^33 toward zero.
#[inline(always)]
pub(super) const fn centre_down(k: u32) -> f32 {
    // 24 bits are kept. The highest bit of the quotient by 2^24 is at the first lost bit, which
    // decides the rounding: without it, down.
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
/// The square of the length is computed to 5/4 eps, so a point left alone is inside. A point
/// outside is so by less than the step, as the test of the rims proves.
#[inline(always)]
pub(super) const fn inward([x, y]: [f32; 2]) -> [f32; 2] {
    let near = (x * x + y * y > 1.0 - f32::EPSILON) as u32;
    [f32::from_bits(x.to_bits() - near), f32::from_bits(y.to_bits() - near)]
}

#[inline(always)]
const fn joined([low, high]: [u32; 2]) -> u64 {
    (high as u64) << 32 | low as u64
}

/// Two magnitudes with the signs of two words.
#[inline(always)]
const fn signed<const FORM: u8>([x, y]: [f32; 2], signs: [u32; 2]) -> [f32; 2] {
    // They have no sign yet. If the compiler sees that, Arm inserts a magnitude into a word in one
    // instruction.
    let (x, y) = if FORM == BRANCHES { (x.abs(), y.abs()) } else { (x, y) };
    [f32::from_bits(signs[0] & SIGN | x.to_bits()), f32::from_bits(signs[1] & SIGN | y.to_bits())]
}

impl Place {
    /// A point of the octant in its place. If not `at_rim`, it is inside by more than all errors, and
    /// a branch skips the exact test.
    #[inline(always)]
    pub(super) const fn placed<const FORM: u8>(self, point: [f32; 2], at_rim: bool) -> [f32; 2] {
        let Self { swap, signs } = self;
        if FORM == LANE {
            return signed::<FORM>(exchanged(swap, inward(point)), signs);
        }
        let [x, y] = if at_rim { inward(point) } else { point };
        // Both components in a word: one rotation, and one store.
        let word = joined([x.to_bits(), y.to_bits()]).rotate_left(swap & 32)
            | joined([signs[0] & SIGN, signs[1] & SIGN]);
        [f32::from_bits(word as u32), f32::from_bits((word >> 32) as u32)]
    }

    /// The point of larger - larger cos and smaller - smaller sin.
    #[inline(always)]
    const fn put<const FORM: u8>(
        self,
        [larger, smaller]: [f32; 2],
        [cos, sin]: [f32; 2],
        at_rim: bool,
    ) -> [f32; 2] {
        if FORM != BRANCHES {
            let point = [larger - larger * cos, smaller - smaller * sin];
            return self.placed::<FORM>(point, at_rim);
        }
        // Computed in its place: swapping two results would cost Arm five instructions.
        let point = if self.swap == 0 {
            [larger - larger * cos, smaller - smaller * sin]
        } else {
            [smaller - smaller * sin, larger - larger * cos]
        };
        self.branched(point, at_rim)
    }

    /// The point at a distance in a direction of the octant.
    #[inline(always)]
    const fn at<const FORM: u8>(self, distance: f32, [x, y]: [f32; 2], at_rim: bool) -> [f32; 2] {
        if FORM != BRANCHES {
            return self.placed::<FORM>([distance * x, distance * y], at_rim);
        }
        let point = if self.swap == 0 {
            [distance * x, distance * y]
        } else {
            [distance * y, distance * x]
        };
        self.branched(point, at_rim)
    }

    /// A point that was computed in its place, with its signs.
    #[inline(always)]
    const fn branched(self, point: [f32; 2], at_rim: bool) -> [f32; 2] {
        signed::<BRANCHES>(if at_rim { inward(point) } else { point }, self.signs)
    }
}

/// The square [-1, 1]^2, for coordinates inside the disc.
#[inline(always)]
pub(super) const fn centred([u, v]: [u32; 2]) -> [f32; 2] {
    let ((m_u, _), (m_v, _)) = (fold(u), fold(v));
    let point = inward([centre::<ONE, 31>(m_u), centre::<ONE, 31>(m_v)]);
    signed::<ONE>(point, [u ^ SIGN, v ^ SIGN])
}

#[inline(always)]
pub(super) const fn concentric<const FORM: u8>([u, v]: [u32; 2]) -> FastDisc {
    let ((m_u, _), (m_v, _)) = (fold(u), fold(v));
    let signs = [u ^ SIGN, v ^ SIGN];
    let steep = m_v.cast_signed() > m_u.cast_signed();
    if FORM != BRANCHES {
        let swap = mask(steep);
        let major = m_u ^ (m_u ^ m_v) & swap;
        // Rounding is monotonic, and the larger of two floats takes one operation.
        let (a, b) = (centre::<FORM, 31>(m_u), centre::<FORM, 31>(m_v));
        let magnitudes = [if a > b { a } else { b }, if a > b { b } else { a }];
        return at::<FORM>(major, magnitudes, Place { swap, signs });
    }
    // The code is there twice, so that nothing is swapped.
    if steep {
        let magnitudes = [centre::<FORM, 31>(m_v), centre::<FORM, 31>(m_u)];
        at::<FORM>(m_v, magnitudes, Place { swap: !0, signs })
    } else {
        let magnitudes = [centre::<FORM, 31>(m_u), centre::<FORM, 31>(m_v)];
        at::<FORM>(m_u, magnitudes, Place { swap: 0, signs })
    }
}

/// The point of a larger and a smaller magnitude, as floats, and of the larger as an integer.
#[inline(always)]
const fn at<const FORM: u8>(major: u32, [a, b]: [f32; 2], place: Place) -> FastDisc {
    let t = b / a;
    let gaps = gaps(t * t);
    let ends = [a, b];
    let one_minus_r = centre::<FORM, 31>(0x7fff_ffff - major);
    let (r2, one_minus_r2) = (a * a, one_minus_r * (2.0 - one_minus_r));
    // r >= 1 - 16 eps.
    let at_rim = major >= 0x7fff_f800;
    let point = place.put::<FORM>(ends, gaps, at_rim);
    FastDisc { point, t, gaps, ends, place, r2, one_minus_r2 }
}

/// r^2 and 1 - r^2 of the polar map.
#[inline(always)]
pub(super) const fn squares<const FORM: u8>([_, v]: [u32; 2]) -> [f32; 2] {
    [centre_nearest::<FORM>(v), centre_nearest::<FORM>(!v)]
}

/// The polar map from r^2, 1 - r^2 and r. The root is the caller's, who knows whether it is for a
/// constant.
#[inline(always)]
pub(super) const fn polar<const FORM: u8>(
    [u, v]: [u32; 2],
    [r2, one_minus_r2]: [f32; 2],
    r: f32,
) -> FastDisc {
    let Angle { left, steep: swap, within, .. } = fold_angle(u);
    let t = centre::<FORM, 29>(within);
    let gaps = gaps(t * t);
    let place = Place { swap, signs: [left, u] };
    // r^2 >= 1 - 16 eps.
    let at_rim = v >= 0xffff_f000;
    let ends = [r, r * t];
    let point = place.put::<FORM>(ends, gaps, at_rim);
    FastDisc { point, t, gaps, ends, place, r2, one_minus_r2 }
}

impl FastDisc {
    /// The point at r and phi = pi/4 t.
    #[cfg(test)]
    pub(super) const fn at_fraction<const FORM: u8>(r: f32, t: f32) -> [f32; 2] {
        let place = Place { swap: 0, signs: [0; 2] };
        place.put::<FORM>([r, r * t], gaps(t * t), at_rim(r))
    }

    /// The same of a lobe.
    #[cfg(test)]
    pub(super) const fn lobe_at_fraction<const FORM: u8>(r: f32, t: f32) -> [f32; 2] {
        Place { swap: 0, signs: [0; 2] }.at::<FORM>(r, direction(t, gaps(t * t)), at_rim(r))
    }

    /// sin^2 theta of the uniform lobe, 1 - (1 - r^2)^2 = r^2 (1 + (1 - r^2)), not above 1.
    #[inline(always)]
    pub(super) const fn uniform_square(self) -> f32 {
        at_most_1(self.r2 * (1.0 + self.one_minus_r2))
    }

    /// The direction of the uniform lobe, from sin theta.
    #[inline(always)]
    pub(super) const fn uniform_at(self, sin: f32) -> [f32; 3] {
        let [x, y] = self.place_at::<ONE>(sin, 1.0);
        [x, y, self.one_minus_r2]
    }

    /// The point in the same direction at another distance, which is a product. One factor, a power
    /// of two, is at hand before the other, as the direction is.
    #[inline(always)]
    pub(super) const fn place_at<const FORM: u8>(self, distance: f32, shrink: f32) -> [f32; 2] {
        let Self { t, gaps, place, .. } = self;
        let [x, y] = direction(t, gaps);
        if FORM == BRANCHES {
            let distance = distance * shrink;
            return place.at::<FORM>(distance, [x, y], at_rim(distance));
        }
        place.at::<FORM>(distance, [x * shrink, y * shrink], at_rim(distance))
    }
}

#[inline(always)]
const fn at_rim(distance: f32) -> bool {
    distance > 1.0 - 8.0 * f32::EPSILON
}

/// A square that exceeds 1 by rounding at most, so that its root does not.
#[inline(always)]
pub(super) const fn at_most_1(square: f32) -> f32 {
    if square < 1.0 { square } else { 1.0 }
}

/// The direction in the octant of t = phi / (pi/4), from its gaps.
#[inline(always)]
pub(super) const fn direction(t: f32, [cos, sin]: [f32; 2]) -> [f32; 2] {
    [1.0 - cos, t - t * sin]
}
