//! A frame of a scene, from its file to its PNG: the examples `render` and `shard` share it.
//!
//! `request` holds the arguments that settle the picture. `description` is a scene as its file
//! has it, of checked `values`, and `file` reads it. `assembly` makes a renderer of the scene's
//! `objects` and of the `effects` called for. `frame` renders its rows on all cores into `sums`,
//! from the points of a `sequence`. `picture` makes a PNG of them for the `output`.

pub mod assembly;
pub mod description;
pub mod effects;
pub mod file;
pub mod frame;
pub mod objects;
pub mod output;
pub mod picture;
pub mod request;
pub mod sequence;
pub mod sums;
pub mod values;
