//! Prints the golden lines of this core: every sequence x map x arithmetic, as tests/golden has
//! them.
#![no_std]
#![no_main]

use board::{end, println};
use hemidisc::Error;
use hemidisc::arithmetic::Arithmetic;
use testkit::digest::Digestible;
use testkit::golden::lines;

fn file<A: Arithmetic<Real: Digestible>>() -> Result<(), Error> {
    println!("file {}", A::NAME);
    lines::arithmetic::<A>(&mut |line| println!("{line}"))
}

/// The file of each arithmetic.
macro_rules! arithmetics {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        $(file::<hemidisc::$arithmetic>()?;)*
    };
}

fn files() -> Result<(), Error> {
    println!("file square");
    lines::squares(&mut |line| println!("{line}"))?;
    println!("file domain");
    lines::domains(&mut |line| println!("{line}"))?;
    hemidisc::for_each_arithmetic!(arithmetics);
    Ok(())
}

#[board::entry]
fn main() -> ! {
    end(files())
}
