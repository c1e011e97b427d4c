//! Prints the golden lines of this core: every sequence x map x arithmetic, as tests/golden has
//! them.
#![no_std]
#![no_main]

use board::{end, println};
use hemidisc::arithmetic::Arithmetic;
use hemidisc::{Error, FastF32, LibmF32, LibmF64, MicromathF32, Q15, Q15Div, Q31};
use testkit::digest::Digestible;
use testkit::golden::lines;

fn file<A: Arithmetic<Real: Digestible>>() -> Result<(), Error> {
    println!("file {}", A::NAME);
    lines::arithmetic::<A>(&mut |line| println!("{line}"))
}

/// The file of each arithmetic.
macro_rules! arithmetics {
    ($($arithmetic:ident)*) => { $(file::<$arithmetic>()?;)* };
}

fn files() -> Result<(), Error> {
    println!("file square");
    lines::squares(&mut |line| println!("{line}"))?;
    println!("file domain");
    lines::domains(&mut |line| println!("{line}"))?;
    arithmetics!(Q15 Q15Div Q31 FastF32 MicromathF32 LibmF32 LibmF64);
    Ok(())
}

#[board::entry]
fn main() -> ! {
    end(files())
}
