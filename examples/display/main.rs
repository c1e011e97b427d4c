//! Points and a render on a small panel, as a firmware draws them.
//!
//! `cargo run --release --all-features --example display [-- --out DIR]` writes under DIR (default
//! `target/display`) what a panel of 160 x 128 pixels of 16 bits shows, at twice its size:
//!
//! - `points.png`: 256 lens samples of six sequences each;
//! - `pass-1.png` to `pass-3.png`, then `render.png`: a scene with four effects while it is
//!   rendered.
//!
//! `testkit::panel` draws, with the renderer `testkit::tracer`, and asks for nothing but `core` and
//! a `DrawTarget`. That is a panel in memory here, and in a firmware the display of its driver;
//! nothing else changes.

#[cfg(test)]
mod tests;

use clap::Parser;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use examples::messages::{answer, say, unwritable};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use testkit::panel::picture::PASSES;
use testkit::panel::scene::Objects;
use testkit::panel::{discs, picture};

/// Width and height.
const SIZE: [u32; 2] = [160, 128];
/// Of a pixel of the render.
const SAMPLES: u16 = 4;

/// Draws points and a render as a small panel shows them.
#[derive(Parser)]
struct Arguments {
    /// Directory that the pictures are written under; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "target/display")]
    out: PathBuf,
}

fn main() -> ExitCode {
    answer("display", |arguments: Arguments| run(&arguments.out))
}

fn run(out: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(out).map_err(|error| unwritable(out, &error))?;
    let mut display = SimulatorDisplay::<Rgb565>::new(SIZE.into());
    discs::draw(&mut display)?;
    save(&display, &out.join("points.png"))?;

    let objects = Objects::new()?;
    let scene = objects.still_life(SIZE)?;
    let names = ["pass-1.png", "pass-2.png", "pass-3.png", "render.png"];
    for (pass, name) in PASSES.into_iter().zip(names) {
        picture::draw(&mut display, pass, SAMPLES, |from, samples, sums| {
            scene.row(from, samples, sums);
        })?;
        save(&display, &out.join(name))?;
    }
    say(&format!("5 pictures in {}: points.png, {}", out.display(), names.join(", ")))?;
    Ok(())
}

fn save(display: &SimulatorDisplay<Rgb565>, path: &Path) -> Result<(), Box<dyn Error>> {
    let settings = OutputSettingsBuilder::new().scale(2).build();
    let image = display.to_rgb_output_image(&settings);
    Ok(image.save_png(path).map_err(|error| format!("cannot write {}: {error}", path.display()))?)
}
