//! From a point or a direction back to coordinates.

use super::disc::sorted;
use super::functions::Float;
use super::real::{Real, RealKernel};

/// The input of the inverses: a point of the disc by its direction and r.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lowered<R> {
    /// (cos phi, sin phi), unnormalised.
    direction: [R; 2],
    r: R,
    r2: R,
    one_minus_r2: R,
}

/// x^2 + y^2 of a direction or a point of the disc.
#[inline(always)]
pub(super) fn length_squared<R: Real>(x: R, y: R) -> R {
    x * x + y * y
}

/// The nearest number in [0, 1]; 0 for NaN.
#[inline(always)]
pub(super) fn clamp_01<R: Real>(x: R) -> R {
    if x > R::ZERO { if x < R::ONE { x } else { R::ONE } } else { R::ZERO }
}

/// A point of the disc where an inverse begins.
#[inline(always)]
pub(super) fn lowered<T: Float>(
    direction: [T::Real; 2],
    r2: T::Real,
    one_minus_r2: T::Real,
) -> Lowered<T::Real> {
    let r2 = clamp_01(r2);
    Lowered { direction, r: T::sqrt(r2), r2, one_minus_r2: clamp_01(one_minus_r2) }
}

/// Whether |y| > |x|, and the angle from the nearer axis as a fraction of an octant.
#[inline(always)]
fn octant_fraction<T: Float>(x: T::Real, y: T::Real) -> (bool, T::Real) {
    let (x, y) = (x.magnitude(), y.magnitude());
    let (a, b) = sorted(x, y);
    // NaN where the point is the centre, infinite or NaN.
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
pub(super) fn concentric<T: Float>(lowered: Lowered<T::Real>) -> [u32; 2] {
    let [x, y] = lowered.direction;
    let (steep, t) = octant_fraction::<T>(x, y);
    let major = if lowered.r2 < T::Real::HALF {
        lowered.r.cell(31)
    } else {
        0x7fff_ffff_u32.saturating_sub((lowered.one_minus_r2 / (T::Real::ONE + lowered.r)).cell(31))
    };
    // On a diagonal, rounding must not exchange the minor and the larger one, which has the radius.
    let major = major.min(0x7fff_ffff);
    let minor = (T::Real::over_2_32(2 * major + 1) * t).cell(31).min(major);
    let (m_u, m_v) = if steep { (minor, major) } else { (major, minor) };
    [unfold(m_u, x), unfold(m_v, y)]
}

#[inline]
pub(super) fn polar<T: Float>(lowered: Lowered<T::Real>) -> [u32; 2] {
    let [x, y] = lowered.direction;
    let (steep, t) = octant_fraction::<T>(x, y);
    let octant = t.cell(29).min(0x1fff_ffff);
    let quarter = if steep { octant ^ 0x3fff_ffff } else { octant };
    let half = if x < T::Real::ZERO { quarter ^ 0x7fff_ffff } else { quarter };
    let u = if y < T::Real::ZERO { !half } else { half };
    let v = if lowered.r2 < T::Real::HALF {
        lowered.r2.cell(32)
    } else {
        !lowered.one_minus_r2.cell(32)
    };
    [u, v]
}

#[inline]
pub(super) fn lower_disc<T: Float>([x, y]: [T::Real; 2]) -> Lowered<T::Real> {
    let (a, b) = sorted(x.magnitude(), y.magnitude());
    let one_minus_r2 = (T::Real::ONE - a) * (T::Real::ONE + a) - b * b;
    lowered::<T>([x, y], length_squared(x, y), one_minus_r2)
}

#[inline]
pub(super) fn centred<R: Real>(point: [R; 2]) -> [u32; 2] {
    point.map(|x| unfold(x.magnitude().cell(31), x))
}
