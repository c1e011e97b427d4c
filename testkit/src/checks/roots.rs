//! The arithmetics of floats with a square root, which frames and effects take.

use crate::arithmetics::{Number, Tested};
use hemidisc::arithmetic::{Real, Root};

/// Something to do with each of them.
pub trait EachRoot {
    fn each<A: Root<Real: Real> + Tested>(&mut self);
}

macro_rules! roots {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        pub fn every_root(visitor: &mut impl EachRoot) {
            $(roots!(@$kind visitor $arithmetic);)*
        }
    };
    (@float $visitor:ident $arithmetic:ident) => {
        $visitor.each::<hemidisc::$arithmetic>()
    };
    (@fixed $visitor:ident $arithmetic:ident) => {};
}
hemidisc::for_each_arithmetic!(roots);

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
