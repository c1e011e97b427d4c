//! How fast buffers fill: every sequence, every map of every arithmetic, both fused, and the peers.
//!
//! ```text
//! cargo bench --bench throughput                       criterion's timings, then the tables of ratios
//! cargo bench --bench throughput -- --ratios           the tables alone, in a minute
//! cargo bench --bench throughput -- --ratios --merge   the same, the shortest of this run and those before
//! cargo bench --bench throughput -- FILTER ...         criterion alone, with its own arguments
//! ```
//!
//! The tables are Markdown on standard output: ratios of minimum times, in rounds that interleave
//! all fills in one process. A build with `RUSTFLAGS="-C target-cpu=native"` has its figures beside
//! the baseline's. `--test` does everything once, to see that it works.
//!
//! `fills` says what is timed. `sequences`, `maps`, `fused` and `peers` are its families, and
//! `buffers` is what they share. The peers' formulas are in `testkit::textbook`. `timings` is
//! criterion's part. `rounds` times what is wanted; `targets` and `linear` are rounds of their own.
//! `report` keeps what was measured, and `table` prints it. What `one` has as well is the library of
//! this package.

mod buffers;
mod fills;
mod fused;
mod linear;
mod maps;
mod peers;
mod report;
mod rounds;
mod sequences;
mod shapes;
mod table;
mod targets;
mod timings;

use benches::arguments::Arguments;
use benches::failure::Failure;
use buffers::{Coordinates, LARGE, SMALL};
use report::{Build, Report};
use std::io::{self, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    benches::arguments::main(run)
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    let coordinates = Coordinates::new(LARGE);
    if arguments.timings {
        timings::run(&coordinates)?;
    }
    if arguments.ratios {
        let name = if arguments.test { "test.json" } else { "report.json" };
        let [small, large, sizes] = if arguments.test { [1; 3] } else { [30, 30, 12] };
        let mut report = Report::read(name)?;
        let mut measured = rounds::at_sizes(&coordinates, &[SMALL], small, |_| true)?;
        measured.extend(targets::run(&coordinates, large)?);
        measured.extend(linear::run(&coordinates, sizes)?);
        report.take(Build::new(small, measured), arguments.merge);
        report.write(name)?;
        io::stdout().write_all(table::whole(&report).as_bytes())?;
    }
    Ok(())
}
