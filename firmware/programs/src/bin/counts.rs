//! Prints what the fills of sequences, maps and peers cost on this core.
#![no_std]
#![no_main]

#[path = "../counting.rs"]
mod counting;

#[board::entry]
fn main() -> ! {
    counting::run(|counts| kernels::fills(counts))
}
