//! Computes a set of points or a frame in K shards, by threads or as processes, and merges them
//! byte-identically.
//!
//! ```text
//! cargo run --release --example shard -- frame --scene still-life --shards 4 --by processes --out still-life.png
//! cargo run --release --example shard -- frame --scene still-life --shards 4 --shard 2 --out 2.part
//! cargo run --release --example shard -- merge 0.part 1.part 2.part 3.part --out still-life.png
//! ```
//!
//! `arguments` reads the command line. A `job` is what is computed: the `set` of points asked for,
//! which `point_set` makes and `number` writes, or a `rendering` of the scene asked for. `cover`
//! says which range of it a shard has, and whether ranges make up the whole. `part` is the file of
//! a shard, `run` computes one or all of them and `merge` puts them together. What makes a frame is
//! the library's `render`, so that the picture has the bytes of that example's.

mod arguments;
mod job;
mod merge;
mod number;
mod part;
mod point_set;
mod rendering;
mod run;
mod set;

use arguments::{Arguments, Command};
use clap::Parser;
use examples::Failure;
use examples::render::output::{Output, say};
use point_set::PointSet;
use rendering::Rendering;
use std::io::{self, Write};
use std::process::ExitCode;

fn main() -> ExitCode {
    let given = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned());
    let given: Vec<_> = given.collect();
    let result = match Arguments::try_parse_from(&given) {
        Ok(arguments) => run(arguments.command, &given),
        Err(error) if error.use_stderr() => {
            Err(Failure::Usage(arguments::one_line(&error, &given)))
        }
        Err(help) => say(&help.to_string()),
    };
    let Err(failure) = result else { return ExitCode::SUCCESS };
    let (status, message) = failure.told();
    // There is nowhere to say that this could not be written.
    let _ = writeln!(io::stderr(), "error: {message}");
    ExitCode::from(status)
}

fn run(command: Command, given: &[String]) -> Result<(), Failure> {
    let written = match command {
        Command::Points { set, shards } => run::run(&PointSet::new(set)?, &shards, given),
        Command::Frame { request, split, shards } => {
            run::run(&Rendering::new(request, split)?, &shards, given)
        }
        Command::Merge { parts, out } => merge::merge(&parts, Output::create(&out)?),
    };
    say(&format!("{}\n", written?))
}
