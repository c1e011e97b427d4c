//! What hemidisc's tests, benches, examples, firmware and fuzz targets share.
//!
//! | module | what it has | needs |
//! | --- | --- | --- |
//! | [`contract`] | accuracy bounds of every arithmetic and map | |
//! | [`digest`] | digests of points | |
//! | [`golden`] | the lines of the golden files, for the host and the boards | |
//! | [`textbook`] | textbook formulas of the maps | |
//! | [`tracer`] | a small renderer, over the library's effects | |
//! | `panel` | drawing on a panel of 16-bit colours | `panel` |
//! | `arithmetics` | the list of arithmetics, and what tests know of each | `std` |
//! | `errors`, `reference`, `vectors` | errors of points, exact points, mpmath's values | `std` |
//! | `rings` | the coordinates of one distance from the centre | `std` |
//! | `promises`, `model`, `orthonormal` | oracles of maps, of points and of frames | `std` |
//! | `chi_square`, `strata` | Pearson's test, the strata of a coordinate | `std` |
//! | `programs` | the examples, as programs to run | `std` |
//! | `checks` | what the fuzz targets check | `std` and every arithmetic |
//!
//! Without the feature `std` the crate needs `core` alone: the firmware builds it for its boards.
//! Its other features turn on those of the library that bear the same names.
#![cfg_attr(not(feature = "std"), no_std)]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
pub mod arithmetics;
#[cfg(all(
    feature = "std",
    feature = "libm",
    feature = "micromath",
    feature = "fixed-point",
    feature = "arbitrary"
))]
pub mod checks;
#[cfg(feature = "std")]
pub mod chi_square;
pub mod contract;
pub mod digest;
#[cfg(feature = "std")]
pub mod errors;
pub mod golden;
#[cfg(feature = "std")]
pub mod model;
#[cfg(feature = "std")]
pub mod orthonormal;
#[cfg(feature = "panel")]
pub mod panel;
#[cfg(feature = "std")]
pub mod programs;
#[cfg(feature = "std")]
pub mod promises;
#[cfg(feature = "std")]
pub mod reference;
#[cfg(feature = "std")]
pub mod rings;
#[cfg(feature = "std")]
pub mod strata;
pub mod textbook;
pub mod tracer;
#[cfg(feature = "std")]
pub mod vectors;
