//! The command line, which other programs rely on; and its errors, one line each.
//!
//! An error names the argument, what was wrong and what is accepted.

use crate::assembly::ARITHMETICS;
use crate::effects::Effects;
use crate::file;
use crate::sequence::Sequence;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{CommandFactory, Parser, ValueEnum};
use std::error::Error;
use std::num::{NonZeroU8, NonZeroU16};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Renders a scene with the effects that it calls for, or some of them
#[derive(Parser)]
#[command(name = "render", version)]
pub(crate) struct Arguments {
    /// A scene's name, or the path of a .ron file
    #[arg(long, value_name = "NAME", required_unless_present = "sheet")]
    scene: Option<String>,

    /// Some of lens, light, occlusion, glossy with commas between, or none [default: those of the scene]
    #[arg(long, value_name = "LIST", value_parser = Effects::from_str)]
    pub(crate) effects: Option<Effects>,

    /// Samples for each pixel
    #[arg(long, value_name = "N", default_value = "64", value_parser = NonZeroU16::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) spp: NonZeroU16,

    /// Pixels in a row
    #[arg(long, value_name = "W", default_value = "480", value_parser = side)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) width: u16,

    /// Rows
    #[arg(long, value_name = "H", default_value = "320", value_parser = side)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) height: u16,

    /// Where points come from
    #[arg(long, value_name = "NAME", default_value = "sobol-owen", value_parser = Sequence::from_str)]
    pub(crate) sequence: Sequence,

    /// Number type and its functions
    #[arg(long, value_name = "NAME", default_value = "libm-f32")]
    pub(crate) arithmetic: String,

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

    /// Write pictures of several scenes without and with effects, and print what they took
    #[arg(long, value_name = "DIR", exclusive = true)]
    pub(crate) sheet: Option<PathBuf>,

    /// Of the noise
    #[arg(long, value_name = "S", default_value = "0", value_parser = u32::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) seed: u32,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Report {
    Json,
}

/// The longest side: a frame of f64 sums of it by itself takes 1.6 GB.
const LONGEST: u16 = 8192;

fn side(text: &str) -> Result<u16, String> {
    match text.parse() {
        Ok(side @ 1..=LONGEST) => Ok(side),
        Ok(_) => Err("out of range".to_owned()),
        Err(error) => Err(error.to_string()),
    }
}

impl Arguments {
    /// The scene; empty where a sheet is asked for.
    pub(crate) fn scene(&self) -> &str {
        self.scene.as_deref().unwrap_or_default()
    }

    /// Where the picture goes.
    pub(crate) fn picture(&self) -> PathBuf {
        let name = Path::new(self.scene()).file_stem().unwrap_or_default();
        let usual = || Path::new("target").join("render").join(name).with_extension("png");
        self.out.clone().unwrap_or_else(usual)
    }

    /// 0 for as many as there are cores.
    pub(crate) fn threads(&self) -> usize {
        self.threads.map_or(0, |threads| threads.get().into())
    }

    /// Why no arithmetic has the name that was given.
    pub(crate) fn unknown_arithmetic(&self) -> String {
        let name = &self.arithmetic;
        let wrong = if hemidisc::catalogue::ARITHMETICS.contains(&name.as_str()) {
            "does not render, in this build"
        } else {
            "is not an arithmetic"
        };
        format!("--arithmetic: {name:?} {wrong}; accepted: {}", accepted("arithmetic"))
    }
}

/// An error of the parser, which would take several lines, on one.
pub(crate) fn one_line(error: &clap::Error) -> String {
    let argument = context(error, ContextKind::InvalidArg);
    let argument = argument.split(" <").next().unwrap_or_default();
    let value = context(error, ContextKind::InvalidValue);
    let accepted = accepted(argument.trim_start_matches('-'));
    match error.kind() {
        ErrorKind::MissingRequiredArgument => format!("{argument}: missing; accepted: {accepted}"),
        ErrorKind::InvalidValue if value.is_empty() => {
            format!("{argument}: no value; accepted: {accepted}")
        }
        ErrorKind::InvalidValue => {
            format!("{argument}: {value:?} is not known; accepted: {accepted}")
        }
        ErrorKind::ValueValidation => {
            let wrong = error.source().map(ToString::to_string).unwrap_or_default();
            format!("{argument}: {value:?}: {wrong}; accepted: {accepted}")
        }
        ErrorKind::ArgumentConflict if argument == "--sheet" => {
            format!("{argument}: given with others; accepted: {accepted}")
        }
        ErrorKind::ArgumentConflict => format!("{argument}: given more than once; accepted: once"),
        ErrorKind::UnknownArgument => {
            let command = Arguments::command();
            let known = command.get_arguments().filter_map(|known| known.get_long());
            let known: Vec<_> = known.map(|long| format!("--{long}")).collect();
            format!("{argument:?}: unknown argument; accepted: {}", known.join(", "))
        }
        _ => error.to_string().lines().next().unwrap_or_default().to_owned(),
    }
}

/// The first thing that the parser says about an error.
fn context(error: &clap::Error, kind: ContextKind) -> String {
    match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.first().cloned().unwrap_or_default(),
        _ => String::new(),
    }
}

/// What an argument accepts.
fn accepted(long: &str) -> String {
    match long {
        "scene" => format!("{}, or the path of a .ron file", file::names().join(", ")),
        "effects" => "some of lens,light,occlusion,glossy, with commas between; or none".to_owned(),
        "spp" => "an integer 1..=65535".to_owned(),
        "width" | "height" => format!("an integer 1..={LONGEST}"),
        "arithmetic" => ARITHMETICS.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", "),
        "sequence" => Sequence::ALL.map(|(name, _)| name).join(", "),
        "sheet" => "the path of a folder, and no other argument".to_owned(),
        "out" => "the path of a file".to_owned(),
        "report" => "json".to_owned(),
        "threads" => "an integer 1..=255".to_owned(),
        _ => "an integer 0..=4294967295".to_owned(),
    }
}
