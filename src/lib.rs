#![doc = include_str!("../README.md")]
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]
#![forbid(unsafe_code)]
#![warn(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::todo)]

#[cfg(any(test, feature = "std"))]
extern crate std;

// The members of every family, of which the modules below are declared.
#[macro_use]
mod lists;

// In the order of a point's journey.
mod coordinates;
pub mod domain;
pub mod sampler;
pub mod screen;
pub mod sequence;

pub mod map;

pub mod arithmetic;

mod block;
pub mod frame;
pub mod points;

pub mod effect;
mod table;

// What the journey stands on, and what it promises.
#[cfg(feature = "arbitrary")]
mod arbitrary;
#[doc(hidden)]
pub mod bits;
#[doc(hidden)]
pub mod catalogue;
mod error;
#[cfg(any(feature = "serde", feature = "defmt"))]
mod form;
pub mod invariant;
mod target;

macro_rules! arithmetics {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {$(
        #[$cfg]
        pub use arithmetic::$arithmetic;
    )*};
}
for_each_arithmetic!(arithmetics);

// Their types and traits are part of the interface.
#[cfg(feature = "heapless")]
pub use heapless;
#[cfg(feature = "rand")]
pub use rand;
#[cfg(feature = "rand_core")]
pub use rand_core;

pub use coordinates::Coordinates;
pub use domain::Domain;
pub use error::{Axis, Error};
pub use frame::{Frame, Unit};
pub use map::{
    Concentric, Cosine, Density, Invert, Map, Polar, Power, Uniform, UnitSquare, disc, hemisphere,
};
pub use points::Points;
pub use sampler::Sampler;
pub use screen::Screen;
