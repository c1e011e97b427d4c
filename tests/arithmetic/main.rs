//! What is tested of one arithmetic alone: the rims of the disc, whole rings, every pair of 16-bit
//! coordinates. What holds for every arithmetic is in `tests/map`.
//!
//! A plain run takes a sample; all of it, in some minutes, by
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --all-features --test arithmetic -- --nocapture

mod fast_f32;
#[cfg(feature = "fixed-point")]
mod q15;
#[cfg(feature = "fixed-point")]
mod q31;
