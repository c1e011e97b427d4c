//! The gallery: every sequence through every map, in numbers and in pictures.
//!
//! `cargo run --release --example gallery [-- --out DIR]` prints tables of each sequence's points
//! on the disc and on the hemisphere, and writes SVG plates under DIR:
//!
//! - one for each sequence: the square and its images under rejection, polar and concentric;
//! - `hemisphere.svg` and `lobes.svg`: cosine-power lobes of e = 0, 1, 10, 100;
//! - `exhibits.svg`: what goes wrong with two naive forms of the polar map;
//! - `overview.svg`: the crate in one picture.
//!
//! The plates hold no times and are the same on every run; the table's times are this machine's.

mod dome;
mod grid;
mod panels;
mod plates;
mod sets;
mod statistics;
mod table;

use clap::Parser;
use examples::messages::{answer, say, unwritable};
use examples::progress::Progress;
use hemidisc::catalogue::SEQUENCES;
use sets::COUNTS;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Draws every sequence through every map, and prints what is measured of them.
#[derive(Parser)]
struct Arguments {
    /// Directory that the plates are written under; made if it is not there.
    #[arg(long, value_name = "DIR", default_value = "target/gallery")]
    out: PathBuf,
}

fn main() -> ExitCode {
    answer("gallery", |arguments: Arguments| run(&arguments.out))
}

fn run(out: &Path) -> Result<(), Box<dyn Error>> {
    // Before anything that takes time.
    fs::create_dir_all(out).map_err(|error| unwritable(out, &error))?;
    let mut progress = Progress::new(COUNTS.len() * SEQUENCES.len() + plates::COUNT);
    let mut sets = Vec::new();
    for count in COUNTS {
        sets.push(sets::collect(count, &mut |name| progress.step(name))?);
    }
    let plates = plates::draw(&sets, &mut |name| progress.step(name))?;
    progress.finish();

    for of_count in &sets {
        say(&table::disc(of_count))?;
        say(&table::hemisphere(of_count))?;
    }
    say(table::LEGEND)?;
    for plate in &plates {
        let path = out.join(&plate.file);
        fs::write(&path, &plate.svg).map_err(|error| unwritable(&path, &error))?;
    }
    let names: Vec<_> = plates.iter().map(|plate| plate.file.as_str()).collect();
    say(&format!("\n{} plates in {}: {}", plates.len(), out.display(), names.join(", ")))?;
    Ok(())
}
