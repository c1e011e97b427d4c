//! The lines of the golden files in `tests/golden`, and the scenes that some of them are digests
//! of.
//!
//! `core` alone, without a heap: tests on the host and the firmware on its boards run this code,
//! and every line that they print is compared with the file.

pub mod bare;
pub mod effects;
pub mod lines;
pub mod render;
