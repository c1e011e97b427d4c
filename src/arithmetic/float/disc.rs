//! The disc kernels: both maps, and the rounding that stays inside.

use super::functions::Float;
use super::real::{Real, RealKernel};
use crate::coordinates::{Angle, fold, fold_angle};

#[inline(always)]
fn signed<R: Real>(magnitude: R, sign: i32) -> R {
    if sign < 0 { -magnitude } else { magnitude }
}

#[inline(always)]
pub(super) fn sorted<R: Real>(a: R, b: R) -> (R, R) {
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

/// A point of the disc: r (x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatDisc<R> {
    /// (cos phi, sin phi).
    pub(super) direction: [R; 2],
    pub(super) r: R,
    pub(super) r2: R,
    pub(super) one_minus_r2: R,
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
        one_minus_r2: T::Real::over_2_64(square.wrapping_neg()),
    }
}

#[inline(always)]
pub(super) fn polar<T: Float>([u, v]: [u32; 2]) -> FloatDisc<T::Real> {
    let Angle { below, left, steep, within } = fold_angle(u);
    let within = T::Real::over_2_32(2 * within + 1) * T::Real::FOUR;
    let (sin, cos) = T::sin_cos(T::Real::FRAC_PI_4 * within);
    let (x, y) = if steep != 0 { (sin, cos) } else { (cos, sin) };
    let r2 = T::Real::centre(v);
    FloatDisc {
        direction: [signed(x, left.cast_signed()), signed(y, below.cast_signed())],
        r: T::sqrt(r2),
        r2,
        one_minus_r2: T::Real::centre(!v),
    }
}

/// A point from its direction and distance to the axis.
#[inline(always)]
pub(super) fn scaled<T: Float>([x, y]: [T::Real; 2], by: T::Real) -> [T::Real; 2] {
    inward::<T>(x * by, y * by)
}
