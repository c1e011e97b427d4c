//! Numbers for frames and effects, in the arithmetics of floats.

pub use crate::arithmetics::{EachRoot, every_root};
use crate::arithmetics::{Number, Tested};
use hemidisc::arithmetic::Real;

/// The numbers of the arithmetic nearest to those given; infinite where it has none as large.
pub fn nearest<A: Tested, const N: usize>(numbers: [f64; N]) -> [A::Real; N] {
    numbers.map(A::Real::nearest)
}

/// The same numbers as doubles.
pub fn wide<R: Into<f64>, const N: usize>(numbers: [R; N]) -> [f64; N] {
    numbers.map(Into::into)
}

/// The smallest number above 0.
pub fn smallest<R: Real>() -> f64 {
    R::MIN_POSITIVE.into() * R::EPSILON.into()
}

/// Half an ulp of 1.
pub fn eps<R: Real>() -> f64 {
    R::EPSILON.into() / 2.0
}
