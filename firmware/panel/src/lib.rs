//! The drawing of the example `display`, with the renderer, as a firmware takes them: where there is `core` alone.
//!
//! It is built for every core and no more. A program has a driver's display to give to `panel::discs::draw` and
//! `panel::picture::draw`, as the example has its panel in memory.
#![no_std]

#[path = "../../../examples/display/panel/mod.rs"]
pub mod panel;
#[path = "../../../examples/render/tracer/mod.rs"]
#[expect(dead_code, unused_imports, reason = "`render` counts, and does without effects")]
mod tracer;
