//! The functions of std, on which the textbooks' formulas are peers.

use testkit::textbook::Functions;

/// The functions of std, which are the platform's, as a renderer in C++ or Rust calls them; and the
/// same with `libm`'s power.
pub struct Std<const LIBM_POWER: bool = false>;

impl<const LIBM_POWER: bool> Functions for Std<LIBM_POWER> {
    #[inline(always)]
    fn sin(x: f32) -> f32 {
        x.sin()
    }
    #[inline(always)]
    fn cos(x: f32) -> f32 {
        x.cos()
    }
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }
    #[inline(always)]
    fn pow(x: f32, y: f32) -> f32 {
        if LIBM_POWER { libm::powf(x, y) } else { x.powf(y) }
    }
}
