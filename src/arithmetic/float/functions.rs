//! The seven functions that a library of elementary functions must give.

use super::real::Real;
use core::fmt::Debug;

/// A library of elementary functions on one float type: seven functions give every map.
///
/// The arguments always lie in the ranges given. Errors of a function add to those of the maps. The
/// square root must be good to 1 % for the points to stay on the disc.
pub trait Float: Copy + Default + Debug + PartialEq + Send + Sync + 'static {
    /// Its name on command lines and in tables.
    const NAME: &'static str;
    /// `f32` or `f64`.
    type Real: Real;

    /// Square root of x in [0, MAX].
    fn sqrt(x: Self::Real) -> Self::Real;
    /// Sine and cosine of x in [0, pi/4].
    fn sin_cos(x: Self::Real) -> (Self::Real, Self::Real);
    /// Arc tangent of x in [0, 1].
    fn atan(x: Self::Real) -> Self::Real;
    /// Logarithm of x in (0, 1].
    fn ln(x: Self::Real) -> Self::Real;
    /// ln(1 + x) for x in [-1/2, 0].
    fn ln_1p(x: Self::Real) -> Self::Real;
    /// Exponential of x, of either sign; infinite above the range, 0 below it.
    fn exp(x: Self::Real) -> Self::Real;
    /// exp(x) - 1 for x <= 0.
    fn exp_m1(x: Self::Real) -> Self::Real;
}
