//! Prints what effects and scenes cost on this core.
//!
//! A program of its own, as is `effect_digests`: with all else they do not fit into the smallest
//! board's flash.
#![no_std]
#![no_main]

#[path = "../counting.rs"]
mod counting;

#[board::entry]
fn main() -> ! {
    counting::run(|counts| kernels::effects(counts))
}
