//! Prints the golden lines of this core that are of effects: samples of each, and a scene rendered
//! with and without.
#![no_std]
#![no_main]

use board::{end, println};
use hemidisc::Error;
use testkit::golden::{effects, render};

fn files() -> Result<(), Error> {
    println!("file effects");
    effects::file(&mut |line| println!("{line}"))?;
    println!("file render");
    render::file(&mut |line| println!("{line}"))
}

#[board::entry]
fn main() -> ! {
    end(files())
}
