//! Boots the programs on every core in QEMU, checks what they print, links every fill alone, and
//! reports.
//!
//!     cargo run --manifest-path firmware/Cargo.toml --package runner
//!
//! Fails on a digest that is not the host's, on counts that differ between two runs, on a panic or
//! a software float in an image that promises none, and on a committed table that a run with the
//! same compiler does not give. Writes `target/firmware/report.json` and `report.md`.

mod cores;
mod digests;
mod effect_table;
mod effects;
mod folders;
mod images;
mod qemu;
mod report;
mod table;
mod tools;

use anyhow::{Context, Result, ensure};
use clap::Parser;
use cores::{CORES, Core};
use folders::root;
use report::{Lens, Record, Report};
use std::process::ExitCode;

/// Measures hemidisc on microcontroller cores in QEMU.
#[derive(Parser)]
struct Arguments {
    /// Build the library with several sets of features, and `panel`, for every core; measure
    /// nothing.
    #[arg(long)]
    library: bool,
    /// Write the tables into docs/firmware.md and README.md instead of comparing with them.
    #[arg(long)]
    bless: bool,
}

/// What is measured of one core.
fn measure(core: &Core) -> Result<(Vec<Record>, Lens)> {
    eprintln!("{}: building", core.name);
    tools::build(core, &["--package", "programs", "--package", "image"])?;
    let printed = qemu::run(core, "digests")? + &qemu::run(core, "effect_digests")?;
    let files = digests::compare(core, &printed)?;
    println!("{}: {} digests are the host's", core.name, files.lines);
    let mut counts = qemu::counts(core, "counts")?;
    counts.extend(qemu::counts(core, "effect_counts")?);
    println!("{}: {} fills counted twice, alike", core.name, counts.len());
    let nothing = images::link(core, "nothing")?;
    images::shown_to_fail(core)?;
    effects::shown_to_fail(core)?;
    let mut records = Vec::new();
    for count in counts {
        let image = images::link(core, &count.path)?;
        effects::check(&count.path, &image)?;
        records.push(Record::new(core, &count, &image, &nothing, &files)?);
    }
    for exponent in hemidisc::catalogue::ARITHMETICS {
        let path = format!("exponent/{exponent}");
        let image = images::link(core, &path)?;
        records.push(Record::prepared(core, exponent, &image, &nothing));
    }
    println!(
        "{}: {} images linked; no panic, and no software float in fixed point",
        core.name,
        records.len()
    );
    let lens = images::program(core, "lens")?;
    let picture = qemu::run(core, "lens")?;
    lens.check("lens", true)?;
    println!(
        "{}: lens: {} bytes of flash, {} of RAM; no panic, no float",
        core.name, lens.flash, lens.ram
    );
    Ok((records, Lens { core: core.name, flash_bytes: lens.flash, ram_bytes: lens.ram, picture }))
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        // The chain of reasons, and no trace of the stack.
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<()> {
    let arguments = Arguments::parse();
    if arguments.library {
        tools::build_library()?;
        return tools::build_x87();
    }
    tools::check()?;
    let mut report = Report::new(tools::compiler(&CORES[0])?);
    for core in &CORES {
        let (records, lens) = measure(core).with_context(|| format!("on {}", core.name))?;
        report.records.extend(records);
        report.lens.push(lens);
    }
    report.covers_the_catalogue()?;
    effects::cost_nothing_where_absent(&report.records)?;
    println!("absent effects: no symbol, and the cost of a renderer that never had one");
    let pictures = report.lens.windows(2).all(|pair| pair[0].picture == pair[1].picture);
    ensure!(pictures, "the example's picture is not the same on every core");
    println!("{}", report.lens[0].picture);
    table::write(&report, &root().join("target/firmware"))?;
    table::publish(&report, &root(), arguments.bless)
}
