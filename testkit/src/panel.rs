//! What is drawn, on any `DrawTarget` of 16-bit colours: no heap, no operating system, no panic.
//!
//! A firmware takes this folder as it is, with the renderer beside it, and gives its driver's
//! display for the target; the firmware of this repository builds it for its cores. All that can
//! fail here is the target, whose error is passed on, and a scene of values that are not accepted.

pub mod discs;
pub mod picture;
pub mod scene;
pub mod srgb;
