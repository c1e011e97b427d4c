//! The disc kernels: both maps, their inverses, and the rounding that stays inside.

use super::{Float, Real};
use crate::square::fold;

#[inline(always)]
fn signed<R: Real>(magnitude: R, sign: i32) -> R {
    if sign < 0 { -magnitude } else { magnitude }
}

#[inline(always)]
fn sorted<R: Real>(a: R, b: R) -> (R, R) {
    if b > a { (b, a) } else { (a, b) }
}

/// Moves a point that rounding has left outside the disc to the next one inside.
#[inline(always)]
fn inward<T: Float>(x: T::Real, y: T::Real) -> [T::Real; 2] {
    let near = T::Real::ONE - T::Real::EPSILON * T::Real::FOUR;
    if x * x + y * y > near { pull::<T>(x, y) } else { [x, y] }
}

/// The rare part of [`inward`]: near the rim, or far outside for a library with coarse functions.
#[inline(never)]
fn pull<T: Float>(x: T::Real, y: T::Real) -> [T::Real; 2] {
    let far = T::Real::ONE + T::Real::EPSILON * T::Real::FOUR;
    let (mut a, mut b) = sorted(x.magnitude(), y.magnitude());
    let length_squared = a * a + b * b;
    if length_squared > far {
        let scale = T::Real::ONE / T::sqrt(length_squared);
        (a, b) = (a * scale, b * scale);
    }
    while T::Real::outside(a, b) {
        a = a.below();
    }
    let [a, b] = if y.magnitude() > x.magnitude() { [b, a] } else { [a, b] };
    [a.with_sign(x), b.with_sign(y)]
}

/// The square [-1, 1]^2, for coordinates inside the disc.
#[inline(always)]
pub(super) fn centred<T: Float>(uv: [u32; 2]) -> [T::Real; 2] {
    let [x, y] = uv.map(|k| {
        let (m, sign) = fold(k);
        signed(T::Real::over_2_32(2 * m + 1), sign)
    });
    inward::<T>(x, y)
}

#[inline]
pub(super) fn invert_centred<R: Real>(point: [R; 2]) -> [u32; 2] {
    point.map(|x| unfold(x.magnitude().cell(31), x))
}

/// A point of the disc: r (x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatDisc<R> {
    /// (cos phi, sin phi); up to a common factor where an inverse begins.
    pub(in crate::arithmetic) direction: [R; 2],
    pub(super) r: R,
    pub(in crate::arithmetic) r2: R,
    /// 1 - r^2.
    pub(in crate::arithmetic) rim: R,
}

#[inline(always)]
pub(super) fn concentric<T: Float>([u, v]: [u32; 2]) -> FloatDisc<T::Real> {
    let ((m_u, sign_u), (m_v, sign_v)) = (fold(u), fold(v));
    let swap = m_v > m_u;
    let (major, minor) = if swap { (2 * m_v + 1, 2 * m_u + 1) } else { (2 * m_u + 1, 2 * m_v + 1) };
    let r = T::Real::over_2_32(major);
    let (sin, cos) = T::sin_cos(T::Real::FRAC_PI_4 * (T::Real::over_2_32(minor) / r));
    let (x, y) = if swap { (sin, cos) } else { (cos, sin) };
    let square = u64::from(major) * u64::from(major);
    FloatDisc {
        direction: [signed(x, sign_u), signed(y, sign_v)],
        r,
        r2: T::Real::over_2_64(square),
        // 2^64 - square; a major magnitude is odd, so the square is not 0.
        rim: T::Real::over_2_64(square.wrapping_neg()),
    }
}

#[inline(always)]
pub(super) fn polar<T: Float>([u, v]: [u32; 2]) -> FloatDisc<T::Real> {
    // u and !u are mirror images in the x axis: fold before rounding.
    let below = u.cast_signed() >> 31;
    let half = u ^ below.cast_unsigned();
    // 31 bits of a half turn: the quarter, the octant in it, 29 bits within.
    let left = half & 1 << 30 != 0;
    let quarter = if left { half ^ 0x7fff_ffff } else { half };
    let steep = quarter & 1 << 29 != 0;
    let octant = if steep { quarter ^ 0x3fff_ffff } else { quarter };
    let within = T::Real::over_2_32(2 * octant + 1) * T::Real::FOUR;
    let (sin, cos) = T::sin_cos(T::Real::FRAC_PI_4 * within);
    let (x, y) = if steep { (sin, cos) } else { (cos, sin) };
    let r2 = T::Real::centre(v);
    FloatDisc {
        direction: [if left { -x } else { x }, signed(y, below)],
        r: T::sqrt(r2),
        r2,
        rim: T::Real::centre(!v),
    }
}

/// A point from its direction and distance to the axis.
#[inline(always)]
pub(super) fn scaled<T: Float>([x, y]: [T::Real; 2], by: T::Real) -> [T::Real; 2] {
    inward::<T>(x * by, y * by)
}

/// x^2 + y^2 of a direction or a point of the disc.
#[inline(always)]
pub(super) fn length_squared<R: Real>(x: R, y: R) -> R {
    x * x + y * y
}

/// The nearest number in [0, 1]; 0 for NaN.
#[inline(always)]
pub(super) fn unit<R: Real>(x: R) -> R {
    if x > R::ZERO { if x < R::ONE { x } else { R::ONE } } else { R::ZERO }
}

/// A point of the disc where an inverse begins.
#[inline(always)]
pub(in crate::arithmetic) fn lowered<T: Float>(
    direction: [T::Real; 2],
    r2: T::Real,
    rim: T::Real,
) -> FloatDisc<T::Real> {
    let r2 = unit(r2);
    FloatDisc { direction, r: T::sqrt(r2), r2, rim: unit(rim) }
}

/// Whether |y| > |x|, and the angle from the nearer axis as a fraction of an octant.
#[inline(always)]
fn octant<T: Float>(x: T::Real, y: T::Real) -> (bool, T::Real) {
    let (x, y) = (x.magnitude(), y.magnitude());
    let (a, b) = sorted(x, y);
    // Not a number where the point is the centre, infinite or none.
    let ratio = b / a;
    let t = if ratio <= T::Real::ONE { T::atan(ratio) * T::Real::FRAC_4_PI } else { T::Real::ZERO };
    (y > x, t)
}

/// The coordinate of a magnitude and its sign: the inverse of [`fold`].
#[inline(always)]
fn unfold<R: Real>(magnitude: u32, sign: R) -> u32 {
    let m = magnitude.min(0x7fff_ffff);
    if sign < R::ZERO { 0x7fff_ffff - m } else { 0x8000_0000 + m }
}

#[inline]
pub(super) fn invert_concentric<T: Float>(disc: FloatDisc<T::Real>) -> [u32; 2] {
    let [x, y] = disc.direction;
    let (steep, t) = octant::<T>(x, y);
    let major = if disc.r2 < T::Real::HALF {
        disc.r.cell(31)
    } else {
        0x7fff_ffff_u32.saturating_sub((disc.rim / (T::Real::ONE + disc.r)).cell(31))
    };
    // On a diagonal rounding must not make the minor the larger one, which has the radius.
    let major = major.min(0x7fff_ffff);
    let minor = (T::Real::over_2_32(2 * major + 1) * t).cell(31).min(major);
    let (m_u, m_v) = if steep { (minor, major) } else { (major, minor) };
    [unfold(m_u, x), unfold(m_v, y)]
}

#[inline]
pub(super) fn invert_polar<T: Float>(disc: FloatDisc<T::Real>) -> [u32; 2] {
    let [x, y] = disc.direction;
    let (steep, t) = octant::<T>(x, y);
    let octant = t.cell(29).min(0x1fff_ffff);
    let quarter = if steep { octant ^ 0x3fff_ffff } else { octant };
    let half = if x < T::Real::ZERO { quarter ^ 0x7fff_ffff } else { quarter };
    let u = if y < T::Real::ZERO { !half } else { half };
    let v = if disc.r2 < T::Real::HALF { disc.r2.cell(32) } else { !disc.rim.cell(32) };
    [u, v]
}

#[inline]
pub(super) fn load<T: Float>([x, y]: [T::Real; 2]) -> FloatDisc<T::Real> {
    let (a, b) = sorted(x.magnitude(), y.magnitude());
    let rim = (T::Real::ONE - a) * (T::Real::ONE + a) - b * b;
    lowered::<T>([x, y], length_squared(x, y), rim)
}
