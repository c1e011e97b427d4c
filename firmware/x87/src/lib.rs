//! Integers for an x86 without SSE2. With the feature `floats` it does not build there: such a
//! processor computes floats in registers of 80 bits, and the library says so.
#![no_std]

use hemidisc::sequence::{Sobol, SobolOwen};
use hemidisc::{Concentric, Cosine, Density, Points, Q15, Q31, table};

/// A table in flash.
pub static LENS: [[Q31; 2]; 16] = table!(Concentric<Q31>, Sobol::new(0), 16);

/// A fill.
pub fn fill(rays: &mut [[Q15; 3]]) -> usize {
    Points::new(SobolOwen::new(1), Cosine::<Q15>::new()).fill(rays)
}

/// The way back.
pub fn density(point: [Q31; 2]) -> Q31 {
    Concentric::<Q31>::new().density(point)
}

/// A fill of floats.
#[cfg(feature = "floats")]
pub fn fill_floats(rays: &mut [[f32; 3]]) -> usize {
    Points::new(SobolOwen::new(1), Cosine::<hemidisc::FastF32>::new()).fill(rays)
}
