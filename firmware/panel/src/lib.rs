//! The drawing of the example `display`, with the renderer, as a firmware takes them: where there
//! is `core` alone.
//!
//! It is built for every core and no more. A program has a driver's display to give to
//! `panel::discs::draw` and `panel::picture::draw`, as the example has its frame buffer.
#![no_std]

pub use testkit::panel;
