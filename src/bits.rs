//! Integer tools under the sequences: all `const`, all exact on every target.

pub mod hash;
pub mod owen;
pub mod permute;
pub(crate) mod reversed;
pub mod strata;
pub(crate) mod wide;
