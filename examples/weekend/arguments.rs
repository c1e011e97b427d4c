//! The command line; and its errors, one line each.

use clap::{CommandFactory, Parser, value_parser};
use examples::refusal;
use std::path::PathBuf;

/// Compares a path tracer's sources of samples: rand's numbers and this crate's points
#[derive(Parser)]
#[command(name = "weekend", version)]
pub(crate) struct Arguments {
    /// Pixels in a row of each picture
    #[arg(long, value_name = "W", default_value = "360", value_parser = value_parser!(u32).range(1..=2048))]
    #[arg(allow_negative_numbers = true)]
    pub(crate) width: u32,

    /// Rows of each picture
    #[arg(long, value_name = "H", default_value = "240", value_parser = value_parser!(u32).range(1..=2048))]
    #[arg(allow_negative_numbers = true)]
    pub(crate) height: u32,

    /// Samples for each pixel of the pictures; the largest one has 2^32
    #[arg(long, value_name = "N", default_value = "16", value_parser = value_parser!(u32).range(1..=1024))]
    #[arg(allow_negative_numbers = true)]
    pub(crate) samples: u32,

    /// Directory of the pictures and the report; made if it is not there
    #[arg(long, value_name = "DIR", default_value = "target/weekend")]
    pub(crate) out: PathBuf,
}

/// An error of the parser on one line.
pub(crate) fn one_line(error: &clap::Error) -> String {
    let accepted = |long: &str| match long {
        "out" => "the path of a directory".to_owned(),
        "samples" => "an integer 1..=1024".to_owned(),
        _ => "an integer 1..=2048".to_owned(),
    };
    refusal::one_line(error, &Arguments::command(), &accepted)
}
