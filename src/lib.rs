#![doc = include_str!("../README.md")]
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::todo)]

#[cfg(test)]
extern crate std;

// In the order of a point's journey.
pub mod domain;
pub mod sequence;
mod square;

pub mod map;

pub mod arithmetic;

pub mod frame;
pub mod points;

pub mod effect;
mod table;

// What the journey stands on, and what it promises.
#[cfg(feature = "arbitrary")]
mod arbitrary;
pub mod bits;
pub mod catalogue;
mod error;
pub mod invariant;

pub use arithmetic::FastF32;
#[cfg(feature = "micromath")]
pub use arithmetic::MicromathF32;
#[cfg(feature = "libm")]
pub use arithmetic::{LibmF32, LibmF64};
#[cfg(feature = "fixed-point")]
pub use arithmetic::{Q15, Q15Div, Q31};
pub use domain::Domain;
pub use error::{Axis, Error};
pub use frame::Frame;
pub use map::{Concentric, Cosine, Map, Polar, Power, Uniform, UnitSquare, disc, hemisphere};
pub use points::Points;
pub use square::Square;
