//! Integer tools of the sequences: exact on every target, and `const` except for blocks.

pub(crate) mod grid;
pub mod hash;
pub mod owen;
pub mod permute;
pub(crate) mod sobol;
pub mod state;
pub(crate) mod strata;
pub(crate) mod wide;
