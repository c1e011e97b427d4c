//! Computes a set of points or a frame in K shards, by threads or as processes, and merges them byte-identically.
//!
//! ```text
//! cargo run --release --example shard -- frame --scene still-life --shards 4 --by processes --out still-life.png
//! cargo run --release --example shard -- frame --scene still-life --shards 4 --shard 2 --out 2.part
//! cargo run --release --example shard -- merge 0.part 1.part 2.part 3.part --out still-life.png
//! ```
//!
//! `arguments` reads the command line. A `job` is what is computed: the `set` of points asked for, which `point_set`
//! makes and `number` writes, or a `rendering` of the scene asked for. `cover` says which range of it a shard has, and
//! whether ranges make up the whole. `part` is the file of a shard, `run` computes one or all of them and `merge` puts
//! them together. What makes a frame is that of the example `render`, whose picture has the same bytes.

mod arguments;
#[path = "../render/assembly.rs"]
mod assembly;
mod cover;
#[path = "../render/description.rs"]
mod description;
#[path = "../render/effects.rs"]
#[expect(dead_code, reason = "the report renders without each effect")]
mod effects;
#[path = "../render/file.rs"]
mod file;
#[path = "../render/frame.rs"]
#[expect(dead_code, reason = "the report has counts and seconds")]
mod frame;
mod job;
mod merge;
mod number;
#[path = "../render/objects.rs"]
mod objects;
#[path = "../render/output.rs"]
mod output;
mod part;
#[path = "../render/picture.rs"]
mod picture;
mod point_set;
#[path = "../gallery/progress.rs"]
mod progress;
#[path = "../points/refusal.rs"]
mod refusal;
mod rendering;
#[path = "../render/request.rs"]
mod request;
mod run;
#[path = "../render/sequence.rs"]
mod sequence;
mod set;
#[path = "../render/sums.rs"]
mod sums;
#[path = "../render/values.rs"]
mod values;

use arguments::{Arguments, Command};
use clap::Parser;
use output::{Output, say};
use point_set::PointSet;
use rendering::Rendering;
use std::io::{self, Write};
use std::process::ExitCode;

/// Why there is no result.
enum Failure {
    /// Names the argument, the field or the part, what was wrong and what is accepted.
    Usage(String),
    Output(String, io::Error),
    /// Names the shard.
    Shard(String),
}

impl Failure {
    /// The exit status and one line.
    fn told(self) -> (u8, String) {
        match self {
            Self::Usage(message) => (2, message),
            Self::Output(path, error) => (1, format!("cannot write {path}: {error}")),
            Self::Shard(message) => (1, message),
        }
    }
}

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
