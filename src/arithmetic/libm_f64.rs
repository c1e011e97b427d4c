//! libm f64: every elementary function within about 1 ulp of a double, in software on any core.

use super::Float;

/// `f64` with the functions of the crate `libm`.
///
/// The reference arithmetic: it holds coordinates exactly, and `invert` gives them back exactly.
/// The same bits on every target for one version of `libm`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LibmF64;

impl Float for LibmF64 {
    const NAME: &'static str = "libm-f64";
    type Real = f64;

    #[inline(always)]
    fn sqrt(x: f64) -> f64 {
        libm::sqrt(x)
    }
    #[inline(always)]
    fn sin_cos(x: f64) -> (f64, f64) {
        (libm::sin(x), libm::cos(x))
    }
    #[inline(always)]
    fn atan(x: f64) -> f64 {
        libm::atan(x)
    }
    #[inline(always)]
    fn ln(x: f64) -> f64 {
        libm::log(x)
    }
    #[inline(always)]
    fn ln_1p(x: f64) -> f64 {
        libm::log1p(x)
    }
    #[inline(always)]
    fn exp(x: f64) -> f64 {
        libm::exp(x)
    }
    #[inline(always)]
    fn exp_m1(x: f64) -> f64 {
        libm::expm1(x)
    }
}
