//! A path tracer of one's own over several sources of samples: what they cost, and what they gain.
//!
//! `cargo run --release --example weekend` renders spheres of clay, metal and glass from `rand` as
//! P. Shirley's "Ray Tracing in One Weekend" does, from `rand` by closed formulas, and from this
//! crate. It prints the time of a path and the error at 1 to 256 samples a pixel, and writes under
//! DIR (default `target/weekend`):
//!
//! - `pictures.png`: by rejection, by formulas and by this crate, of 16 samples a pixel;
//! - `report.json`: the rows of the table.
//!
//! `path` traces, generic over a `source`; the sources are files beside each other. `scene`,
//! `material` and `camera` know nothing of them but the trait.

mod arguments;
mod camera;
mod material;
mod measure;
mod path;
mod picture;
mod report;
mod scene;
mod source;
#[cfg(test)]
mod tests;
mod vector;

use arguments::Arguments;
use clap::Parser;
use examples::Failure;
use examples::progress::Progress;
use examples::render::output::{Output, say};
use examples::render::picture::png;
use measure::SOURCES;
use path::View;
use report::Report;
use std::io::{self, Write};
use std::process::ExitCode;

/// Of the picture on which sources are measured.
const MEASURED: [u32; 2] = [96, 64];

/// Samples of a pixel at which they are.
const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];

/// Samples of the reference, and a seed that nothing else has.
const REFERENCE: u32 = 4096;
const REFERENCE_SEED: u32 = 0x7265_6600;

fn main() -> ExitCode {
    let result = match Arguments::try_parse() {
        Ok(arguments) => run(&arguments),
        Err(error) if error.use_stderr() => Err(Failure::Usage(arguments::one_line(&error))),
        Err(help) => say(&help.to_string()),
    };
    let Err(failure) = result else { return ExitCode::SUCCESS };
    let (status, message) = failure.told();
    // There is nowhere to say that this could not be written.
    let _ = writeln!(io::stderr(), "weekend: {message}");
    ExitCode::from(status)
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    // Before anything that takes time.
    let pictures_file = Output::create(&arguments.out.join("pictures.png"))?;
    let report_file = Output::create(&arguments.out.join("report.json"))?;
    let refused = |error: hemidisc::Error| Failure::Usage(error.to_string());

    let [by_rejection, by_formulas, _, by_blocks] = SOURCES;
    let shown = [by_rejection, by_formulas, by_blocks];
    let steps = picture::passes(REFERENCE)
        + shown.len() * picture::passes(arguments.samples)
        + COUNTS.map(measure::steps).iter().sum::<usize>();
    let mut progress = Progress::new(steps);

    let view = View::new([arguments.width, arguments.height]);
    let mut pictures = Vec::new();
    for (name, tile) in shown {
        let step = &mut || progress.step(name);
        pictures.push(picture::render(&view, tile, 0, arguments.samples, step).map_err(refused)?);
    }
    let (size, pixels) = picture::side_by_side(&view, &pictures);

    let view = View::new(MEASURED);
    let (_, tile) = by_blocks;
    let step = &mut || progress.step("reference");
    let reference =
        picture::render(&view, tile, REFERENCE_SEED, REFERENCE, step).map_err(refused)?;
    let mut report = Report::new();
    for count in COUNTS {
        let step = &mut || progress.step(&format!("{count} samples a pixel"));
        let measured = measure::sources(&view, count, &reference, step).map_err(refused)?;
        report.add(count, &measured);
    }
    progress.finish();

    let pictures = pictures_file.write(|out| png(out, size, &pixels))?;
    let json = report_file.write(|out| {
        serde_json::to_writer_pretty(&mut *out, &report).map_err(io::Error::from)?;
        writeln!(out)
    })?;
    say(&format!("{}\n{pictures}\n{json}\n", report.table()))
}
