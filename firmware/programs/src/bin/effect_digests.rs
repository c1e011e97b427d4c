//! Prints the golden lines of this core that are of effects: samples of each, and a scene rendered
//! with and without.
#![no_std]
#![no_main]

use board::{end, println};
use hemidisc::{Error, FastF32, LibmF32, LibmF64, MicromathF32};
use testkit::golden::{effects, render};

/// The lines of each arithmetic.
macro_rules! arithmetics {
    ($module:ident::$lines:ident, $line:expr, $($arithmetic:ident)*) => {
        $($module::$lines::<$arithmetic>($line)?;)*
    };
}

fn files() -> Result<(), Error> {
    println!("file effects");
    let mut line = |line: core::fmt::Arguments| println!("{line}");
    arithmetics!(effects::effects, &mut line, FastF32 MicromathF32 LibmF32 LibmF64);
    println!("file render");
    arithmetics!(render::digests, &mut line, FastF32 MicromathF32);
    Ok(())
}

#[board::entry]
fn main() -> ! {
    end(files())
}
