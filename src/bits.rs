//! Integer tools under the sequences: all `const`, all exact on every target.

pub mod hash;
pub mod owen;
pub mod permute;
pub mod strata;
