//! The command line, which other programs rely on; and its errors, one line each.

use crate::job::Split;
use crate::set::{self, Set};
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use examples::refusal;
use examples::render::request::{self, Request};
use std::num::{NonZeroU8, NonZeroU16};
use std::path::PathBuf;
use std::str::FromStr;

/// Computes a set of points or a frame in shards, here or on other machines, and merges them
/// byte-identically
#[derive(Parser)]
#[command(name = "shard", version)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Writes points of a sequence through a map: the bits of one component after another,
    /// little-endian
    Points {
        #[command(flatten)]
        set: Set,
        #[command(flatten)]
        shards: Shards,
    },
    /// Renders a scene; the picture is that of the example `render`
    Frame {
        #[command(flatten)]
        request: Request,

        /// What a shard has some of: the rows, or the samples of every pixel
        #[arg(long, value_enum, default_value = "rows")]
        split: Split,

        #[command(flatten)]
        shards: Shards,
    },
    /// Makes the points or the picture of the parts, in whatever order they are named
    Merge {
        /// The files of all shards
        #[arg(required = true, value_name = "PART")]
        parts: Vec<PathBuf>,

        /// What is made
        #[arg(long, value_name = "FILE")]
        out: PathBuf,
    },
}

// No doc comment: the parser would show it in place of the command's.
#[derive(Args)]
pub(crate) struct Shards {
    /// How many shards there are
    #[arg(long, value_name = "K", value_parser = NonZeroU16::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) shards: NonZeroU16,

    /// Compute this shard alone, 0..K, and write its part [default: compute all of them, and merge]
    #[arg(long, value_name = "I", value_parser = u16::from_str, allow_negative_numbers = true)]
    pub(crate) shard: Option<u16>,

    /// What computes the shards [default: threads]
    #[arg(long, value_enum, conflicts_with = "shard")]
    pub(crate) by: Option<By>,

    /// Threads, or processes of one thread, at once [default: one for each core]
    #[arg(long, value_name = "N", value_parser = NonZeroU8::from_str)]
    #[arg(allow_negative_numbers = true)]
    threads: Option<NonZeroU8>,

    /// The points, the picture or the part
    #[arg(long, value_name = "FILE")]
    pub(crate) out: PathBuf,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum By {
    Threads,
    /// This program, started once for each shard
    Processes,
}

impl Shards {
    /// 0 for as many as there are cores.
    pub(crate) fn threads(&self) -> usize {
        self.threads.map_or(0, |threads| threads.get().into())
    }
}

/// The arguments that every shard's process is started with: those given, but for what differs or
/// is not for it.
pub(crate) fn in_common(given: &[String]) -> Vec<String> {
    let mut kept = Vec::new();
    // Without the program's name.
    let mut given = given.iter().skip(1);
    while let Some(argument) = given.next() {
        let (name, value) = argument.split_once('=').unzip();
        if !["--by", "--threads", "--out"].contains(&name.unwrap_or(argument)) {
            kept.push(argument.clone());
        } else if value.is_none() {
            given.next();
        }
    }
    kept
}

/// An error of the parser on one line.
pub(crate) fn one_line(error: &clap::Error, given: &[String]) -> String {
    let all = Arguments::command();
    let chosen = given.get(1).and_then(|name| all.find_subcommand(name));
    refusal::one_line(error, chosen.unwrap_or(&all), &accepted)
}

/// What an argument accepts.
fn accepted(long: &str) -> String {
    let own = || match long {
        "split" => "rows, samples",
        "shards" => "an integer 1..=65535",
        "shard" => "an integer from 0 to below that of --shards",
        "by" => "threads, processes",
        "threads" => "an integer 1..=255",
        "out" => "the path of a file",
        _ => "paths of parts",
    };
    // The parser looks at the arithmetic of points alone: that of a frame is any text to it.
    let known = request::accepted(long).filter(|_| long != "arithmetic");
    known.or_else(|| set::accepted(long)).unwrap_or_else(|| own().to_owned())
}
