//! Prints the golden lines of this core that are of effects: samples of each, and a scene rendered
//! with and without.
#![no_std]
#![no_main]

use board::{end, println};
use hemidisc::{Error, FastF32, LibmF32, LibmF64, MicromathF32};
use testkit::golden::{effects, render};

fn files() -> Result<(), Error> {
    println!("file effects");
    let mut line = |line: core::fmt::Arguments| println!("{line}");
    effects::effects::<FastF32>(&mut line)?;
    effects::effects::<MicromathF32>(&mut line)?;
    effects::effects::<LibmF32>(&mut line)?;
    effects::effects::<LibmF64>(&mut line)?;
    println!("file render");
    render::digests::<FastF32>(&mut line)?;
    render::digests::<MicromathF32>(&mut line)
}

#[board::entry]
fn main() -> ! {
    end(files())
}
