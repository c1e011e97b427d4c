//! What is drawn, on any `DrawTarget` of 16-bit colours: no heap, no operating system, no panic.
//!
//! Copy this folder into your firmware, with the renderer beside it, and pass your driver's display
//! as the target. This repository's firmware builds it for its cores. Only two things can fail: the
//! target, whose error is passed on, and a scene with invalid values.

pub mod discs;
pub mod picture;
pub mod scene;
pub mod srgb;
