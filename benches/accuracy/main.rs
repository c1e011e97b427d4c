//! What accuracy costs. For every map x arithmetic: the errors, the evenness of a set, and the cost
//! of a point on this machine and on the boards.
//!
//! ```text
//! cargo bench --bench accuracy                  writes target/accuracy/{report.json, report.md, pareto.svg}
//! cargo bench --bench accuracy -- --check       and compares the accuracy columns with docs/accuracy.md
//! cargo bench --bench accuracy -- --bless       and writes docs/accuracy.md and docs/accuracy/pareto.svg
//! ```
//!
//! Instructions, flash and stack are those of `target/firmware/report.json`, which the firmware's
//! runner writes; without it the boards' columns are empty.

mod evenness;
mod firmware;
mod frontier;
mod measure;
mod plot;
mod report;
mod time;

use clap::Parser;
use std::error::Error;
use std::fs;
use std::path::Path;

#[derive(Parser)]
struct Arguments {
    /// Compare the accuracy columns of docs/accuracy.md with those measured
    #[arg(long, conflicts_with = "bless")]
    check: bool,
    /// Write docs/accuracy.md and docs/accuracy/pareto.svg
    #[arg(long)]
    bless: bool,
    /// What `cargo bench` adds
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let mut rows = measure::rows();
    time::measure(&mut rows);
    let boards = firmware::add(&mut rows, &root.join("target/firmware/report.json"))?;
    println!("{boards}");

    let folder = root.join("target/accuracy");
    fs::create_dir_all(&folder)?;
    let (table, choices) = (report::markdown(&rows), report::choices(&rows));
    let plot = plot::pareto(&rows)?;
    fs::write(folder.join("report.json"), serde_json::to_string_pretty(&rows)? + "\n")?;
    fs::write(folder.join("report.md"), format!("{table}\n{choices}"))?;
    fs::write(folder.join("pareto.svg"), &plot)?;
    println!("{table}\n{choices}");
    if arguments.check {
        report::check(root, &table)?;
    }
    if arguments.bless {
        report::publish(root, &table, &choices)?;
        fs::write(root.join("docs/accuracy/pareto.svg"), plot)?;
    }
    Ok(())
}
