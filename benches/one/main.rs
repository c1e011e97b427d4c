//! What one call takes, as a renderer makes it: one at a time, with other work between.
//!
//! ```text
//! cargo bench --bench one -- --ratios           the tables, in a minute or two
//! cargo bench --bench one -- --ratios --merge   the same, the shortest of this run and earlier ones
//! cargo bench --bench one -- --test             everything once, to see that it works
//! ```
//!
//! A call is a function that is not inlined, so nothing of it is shared with the next one. It reads
//! what it takes from memory. Each is timed in three ways:
//!
//! - throughput: calls do not depend on each other, so they overlap in the processor;
//! - latency: each waits for what the last one gave;
//! - repeated: as throughput, but with inputs that the branch predictor has learnt.
//!
//! The tables are Markdown on standard output: ratios of minimum times, in rounds that interleave
//! all calls in one process. A build with `RUSTFLAGS="-C target-cpu=native"` has its figures beside
//! the baseline's.
//!
//! `inputs` has what calls take, `words` what they give, and `calls` how they are timed. `maps`,
//! `sequences`, `draws`, `effects` and `fills` have the rows, a function each. `formulas` and
//! `generators` have the peers. `peers` says which row is compared with which, `bars` what a row
//! must reach. `report` keeps what was measured, and `table` prints it.

mod bars;
mod calls;
mod draws;
mod effects;
mod fills;
mod formulas;
mod generators;
mod inputs;
mod maps;
mod peers;
mod report;
mod sequences;
mod table;
mod words;

use benches::arguments::Arguments;
use benches::failure::Failure;
use calls::Calls;
use inputs::Inputs;
use report::Report;
use std::io::{self, Write};
use std::process::ExitCode;

/// They take a minute or two, with the fewer rounds of repeated inputs.
const ROUNDS: usize = 2500;

fn main() -> ExitCode {
    benches::arguments::main(run)
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    if !arguments.ratios {
        return Err("there are --ratios, --ratios --merge and --test".into());
    }
    let inputs = Inputs::new()?;
    let mut calls = Calls::new(&inputs);
    every(&mut calls)?;
    let (name, rounds) = if arguments.test { ("test.json", 1) } else { ("report.json", ROUNDS) };
    let measured = calls.measure(rounds);
    let mut report = Report::read(name)?;
    report.take(&measured, arguments.merge)?;
    report.write(name)?;
    io::stdout().write_all(table::whole(&report).as_bytes())?;
    Ok(())
}

/// Every row, and every peer.
fn every(calls: &mut Calls<'_>) -> Result<(), Failure> {
    maps::every(calls)?;
    sequences::every(calls)?;
    draws::every(calls);
    effects::every(calls)?;
    fills::every(calls);
    formulas::every(calls);
    generators::every(calls);
    Ok(())
}
