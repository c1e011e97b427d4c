//! libm f32: every elementary function within about 1 ulp, in software on any core.

use super::Float;

/// `f32` with the functions of the crate `libm`.
///
/// Accurate everywhere and the same bits on every target for one version of `libm`; it evaluates
/// the sine, the cosine and the exponential in f64 within, which is slow without a double-precision
/// unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LibmF32;

impl Float for LibmF32 {
    const NAME: &'static str = "libm-f32";
    type Real = f32;

    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    #[inline(always)]
    fn sin_cos(x: f32) -> (f32, f32) {
        (libm::sinf(x), libm::cosf(x))
    }
    #[inline(always)]
    fn atan(x: f32) -> f32 {
        libm::atanf(x)
    }
    #[inline(always)]
    fn ln(x: f32) -> f32 {
        libm::logf(x)
    }
    #[inline(always)]
    fn ln_1p(x: f32) -> f32 {
        libm::log1pf(x)
    }
    #[inline(always)]
    fn exp(x: f32) -> f32 {
        libm::expf(x)
    }
    #[inline(always)]
    fn exp_m1(x: f32) -> f32 {
        libm::expm1f(x)
    }
}
