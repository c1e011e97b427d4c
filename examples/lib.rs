//! What the examples share: each program is a folder beside this file.

mod failure;
pub mod gallery;
pub mod maps;
pub mod messages;
pub mod progress;
pub mod refusal;
pub mod render;
pub mod shard;

pub use failure::Failure;
