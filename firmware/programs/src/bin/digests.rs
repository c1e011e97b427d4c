//! Prints the golden lines of this core: every sequence x map x arithmetic, as tests/golden has them.
#![no_std]
#![no_main]

#[path = "../../../../tests/golden/effects.rs"]
mod effects;
#[path = "../../../../tests/golden/lines.rs"]
mod lines;
#[path = "../../../../tests/golden/render.rs"]
mod render;
#[path = "../../../../examples/render/tracer/mod.rs"]
#[expect(dead_code, unused_imports, reason = "the example counts and reflects in more ways")]
mod tracer;

use board::{exit, println};
use hemidisc::arithmetic::Arithmetic;
use hemidisc::invariant::Digestible;
use hemidisc::{Error, FastF32, LibmF32, LibmF64, MicromathF32, Q15, Q15Div, Q31};

fn file<A: Arithmetic<Real: Digestible>>() -> Result<(), Error> {
    println!("file {}", A::NAME);
    lines::arithmetic::<A>(&mut |line| println!("{line}"))
}

fn files() -> Result<(), Error> {
    println!("file square");
    lines::squares(&mut |line| println!("{line}"))?;
    println!("file domain");
    lines::domains(&mut |line| println!("{line}"))?;
    file::<Q15>()?;
    file::<Q15Div>()?;
    file::<Q31>()?;
    file::<FastF32>()?;
    file::<MicromathF32>()?;
    file::<LibmF32>()?;
    file::<LibmF64>()?;
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
    if let Err(error) = files() {
        println!("error: {error}");
        exit(1)
    }
    exit(0)
}
