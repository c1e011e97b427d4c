#![doc = include_str!("../README.md")]
#![no_std]
#![forbid(unsafe_code)]
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::todo)]

#[cfg(test)]
extern crate std;

mod error;
mod square;

pub mod arithmetic;
pub mod bits;
pub mod catalogue;
pub mod domain;
pub mod frame;
pub mod invariant;
pub mod map;
pub mod points;
pub mod sequence;

#[cfg(feature = "libm")]
pub use arithmetic::{LibmF32, LibmF64};
pub use domain::Domain;
pub use error::{Axis, Error};
pub use frame::Frame;
pub use map::{Concentric, Cosine, Map, Polar, Power, Uniform, UnitSquare, disc, hemisphere};
pub use points::Points;
pub use square::Square;
