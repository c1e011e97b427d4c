//! What the fuzz targets check, one file a target: a function of bytes that panics on a broken
//! promise.
//!
//! The targets under `fuzz/fuzz_targets` call these functions. `tests/corpus.rs` replays the
//! corpora through them on stable. Tolerances are the contracts, or those of the tests.

mod agreement;
pub mod convert;
pub mod domain;
mod draws;
pub mod effects;
pub mod frame;
pub mod map;
pub mod points;
pub mod render;
mod roots;
pub mod sequence;

/// A check: bytes that do not make an input are refused, and a broken promise panics.
pub type Check = fn(&[u8]) -> arbitrary::Result<()>;

/// Every target by its name, which is that of its corpus too.
pub const CHECKS: &[(&str, Check)] = &[
    ("map", map::check),
    ("sequence", sequence::check),
    ("points", points::check),
    ("domain", domain::check),
    ("frame", frame::check),
    ("effects", effects::check),
    ("render", render::check),
    ("convert", convert::check),
];
