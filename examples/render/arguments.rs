//! The command line, which other programs rely on; and its errors, one line each.
//!
//! An error names the argument, what was wrong and what is accepted.

use clap::{CommandFactory, Parser, ValueEnum};
use examples::refusal;
use examples::render::request::{self, Request};
use std::num::NonZeroU8;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Renders a scene with the effects that it calls for, or some of them
#[derive(Parser)]
#[command(name = "render", version)]
#[command(after_help = "With --sheet DIR alone it writes the contact sheet of the README.")]
pub(crate) struct Arguments {
    #[command(flatten)]
    pub(crate) request: Request,

    /// The picture [default: target/render/SCENE.png]
    #[arg(long, value_name = "FILE.png")]
    out: Option<PathBuf>,

    /// Print what each effect took; renders once more without each of them
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) report: Option<Report>,

    /// Rows that are rendered at once; the picture is the same [default: one for each core]
    #[arg(long, value_name = "N", value_parser = NonZeroU8::from_str)]
    #[arg(allow_negative_numbers = true)]
    threads: Option<NonZeroU8>,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Report {
    Json,
}

impl Arguments {
    /// Where the picture goes.
    pub(crate) fn picture(&self) -> PathBuf {
        let name = Path::new(&self.request.scene).file_stem().unwrap_or_default();
        let usual = || Path::new("target").join("render").join(name).with_extension("png");
        self.out.clone().unwrap_or_else(usual)
    }

    /// 0 for as many as there are cores.
    pub(crate) fn threads(&self) -> usize {
        self.threads.map_or(0, |threads| threads.get().into())
    }
}

/// An error of the parser on one line.
pub(crate) fn one_line(error: &clap::Error) -> String {
    refusal::one_line(error, &Arguments::command(), &accepted)
}

/// What an argument accepts.
fn accepted(long: &str) -> String {
    let own = || match long {
        "out" => "the path of a file",
        "report" => "json",
        _ => "an integer 1..=255",
    };
    request::accepted(long).unwrap_or_else(|| own().to_owned())
}
