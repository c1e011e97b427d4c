//! What the fuzz targets check, one file a target: a function of bytes that panics where a promise is broken.
//!
//! The targets under `fuzz_targets` call these, and so does `tests/corpus.rs`, which replays the corpora on stable.
//! Tolerances are the library's contracts or those of its tests, by `#[path]`.

#[macro_use]
#[path = "../arithmetics/mod.rs"]
mod arithmetics;
#[path = "../accuracy/errors.rs"]
#[allow(dead_code, reason = "the accuracy tests look for stale bounds too")]
mod errors;
#[path = "../accuracy/reference.rs"]
mod reference;
#[path = "../../examples/render/tracer/mod.rs"]
#[allow(dead_code, unused_imports, reason = "the example reports more")]
mod tracer;

mod agreement;
pub mod convert;
pub mod domain;
mod draws;
pub mod effects;
pub mod frame;
pub mod map;
mod model;
mod orthonormal;
pub mod points;
mod promises;
pub mod render;
mod roots;
pub mod sequence;

/// A check: bytes that do not make an input are refused, and a broken promise panics.
pub type Check = fn(&[u8]) -> arbitrary::Result<()>;

/// Every target by its name, which is that of its corpus too.
pub const CHECKS: [(&str, Check); 8] = [
    ("map", map::check),
    ("sequence", sequence::check),
    ("points", points::check),
    ("domain", domain::check),
    ("frame", frame::check),
    ("effects", effects::check),
    ("render", render::check),
    ("convert", convert::check),
];
