//! Points and a render on a small panel, as a firmware draws them.
//!
//! `cargo run --release --example display [-- --out DIR]` writes under DIR (default
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
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, raw};
use embedded_graphics::prelude::*;
use examples::messages::{answer, say, unwritable};
use std::error::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use testkit::panel::picture::PASSES;
use testkit::panel::scene::Objects;
use testkit::panel::{discs, picture};

const WIDTH: usize = 160;
const HEIGHT: usize = 128;
/// Pixels of a file along the side of one of the panel.
const SCALE: u32 = 2;
/// Of a pixel of the render.
const SAMPLES: u16 = 4;

/// The panel in memory.
type Display = Framebuffer<
    Rgb565,
    raw::RawU16,
    raw::LittleEndian,
    WIDTH,
    HEIGHT,
    { buffer_size::<Rgb565>(WIDTH, HEIGHT) },
>;

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
    let mut display = Display::new();
    discs::draw(&mut display)?;
    save(&display, &out.join("points.png"))?;

    let objects = Objects::new()?;
    let scene = objects.still_life([WIDTH as u32, HEIGHT as u32], SAMPLES.into())?;
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

fn save(display: &Display, path: &Path) -> Result<(), Box<dyn Error>> {
    Ok(png(display, path).map_err(|error| format!("cannot write {}: {error}", path.display()))?)
}

/// Writes what the panel shows, enlarged.
fn png(display: &Display, path: &Path) -> io::Result<()> {
    let size = display.size() * SCALE;
    let mut bytes = Vec::new();
    for y in 0..size.height {
        for x in 0..size.width {
            let pixel = display.pixel(Point::new((x / SCALE) as i32, (y / SCALE) as i32));
            let colour = Rgb888::from(pixel.unwrap_or_default());
            bytes.extend([colour.r(), colour.g(), colour.b()]);
        }
    }
    let mut encoder =
        png::Encoder::new(BufWriter::new(File::create(path)?), size.width, size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish().map_err(io::Error::from)
}
