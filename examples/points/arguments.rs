//! The command line, which other programs rely on; and its errors, one line each.
//!
//! An error names the argument, what was wrong and what is accepted.

use crate::Failure;
use clap::builder::PossibleValuesParser;
use clap::{CommandFactory, Parser};
use examples::{maps, refusal};
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{ARITHMETICS, AVAILABLE_ARITHMETICS, DISC_MAPS, SEQUENCES};
use hemidisc::screen::Pixel;
use hemidisc::{Domain, Screen};
use std::num::NonZeroU32;
use std::str::FromStr;

/// Prints points of a sequence through a map: a header, then one line a point
#[derive(Parser)]
#[command(name = "points", version)]
pub(crate) struct Arguments {
    /// Where the coordinates come from
    #[arg(
        long,
        value_name = "NAME",
        value_parser = PossibleValuesParser::new(SEQUENCES),
        required_unless_present = "stdin"
    )]
    pub(crate) sequence: Option<String>,

    /// Size of a set (rows I..N are printed), or number of rows of an endless sequence
    #[arg(
        long,
        value_name = "N",
        value_parser = NonZeroU32::from_str,
        allow_negative_numbers = true,
        required_unless_present_any = ["stdin", "screen"]
    )]
    count: Option<NonZeroU32>,

    /// Index of the first row [default: 0]
    #[arg(long, value_name = "I", value_parser = u32::from_str, allow_negative_numbers = true)]
    start: Option<u32>,

    /// Seed; regular, hammersley and halton ignore it; 0 is the textbook's sobol and r2
    /// [default: 0]
    #[arg(long, value_name = "S", value_parser = u32::from_str, allow_negative_numbers = true)]
    seed: Option<u32>,

    /// Where the coordinates go; the square prints them as they are
    #[arg(long, value_name = "MAP", value_parser = PossibleValuesParser::new(maps::all()))]
    pub(crate) map: String,

    /// Disc map below a hemisphere map [default: concentric]
    #[arg(long, value_name = "DISC", value_parser = PossibleValuesParser::new(DISC_MAPS))]
    disc: Option<String>,

    /// Exponent of hemisphere-power: a finite number above -1; in fixed point 0 <= e < 4294967296
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    exponent: Option<String>,

    #[arg(
        long,
        value_name = "NAME",
        default_value = "libm-f32",
        help = format!("Number type and its functions; in this build: {}", AVAILABLE_ARITHMETICS.join(", "))
    )]
    pub(crate) arithmetic: String,

    /// Coordinates of a row; 4 are the first dimensions of sobol or sobol-owen, on the square
    #[arg(
        long,
        value_name = "D",
        default_value = "2",
        value_parser = PossibleValuesParser::new(["2", "4"])
    )]
    dimensions: String,

    /// Width and height of a screen, of which one pixel's points are printed; of sobol-owen
    #[arg(
        long,
        value_name = "W,H",
        value_parser = both,
        requires_all = ["spp", "pixel"],
        conflicts_with = "stdin"
    )]
    screen: Option<[u32; 2]>,

    /// Samples in each pixel of the screen, and so rows
    #[arg(long, value_name = "N", value_parser = NonZeroU32::from_str, requires = "screen")]
    spp: Option<NonZeroU32>,

    /// Column and row of the pixel, from 0
    #[arg(long, value_name = "X,Y", value_parser = both, requires = "screen")]
    pixel: Option<[u32; 2]>,

    /// Read the coordinates from standard input: lines `u,v` of 0x-prefixed hexadecimal u32
    #[arg(long, conflicts_with = "sequence")]
    pub(crate) stdin: bool,

    /// Add a column: the density at the point
    #[arg(long)]
    pub(crate) density: bool,

    /// Map each point back and print the coordinates found
    #[arg(long)]
    pub(crate) invert: bool,

    /// Print the bits of numbers in hexadecimal
    #[arg(long)]
    pub(crate) raw: bool,
}

const COUNT: &str = "an integer 1..=4294967295";
const INDEX: &str = "an integer 0..=4294967295";
const EXPONENT: &str = "a finite number above -1";
const BOTH: &str = "two integers 0..=4294967295, as in 640,480";

/// Two numbers with a comma between them.
fn both(text: &str) -> Result<[u32; 2], String> {
    let parts = text.split_once(',').ok_or("without a comma")?;
    let number = |part: &str| part.parse::<u32>().map_err(|error| error.to_string());
    Ok([number(parts.0)?, number(parts.1)?])
}

impl Arguments {
    /// At least 1; 1 with `--stdin`, where it has no meaning.
    pub(crate) fn count(&self) -> u32 {
        self.count.map_or(1, NonZeroU32::get)
    }

    pub(crate) fn start(&self) -> u32 {
        self.start.unwrap_or(0)
    }

    pub(crate) fn seed(&self) -> u32 {
        self.seed.unwrap_or(0)
    }

    /// Whether rows have four coordinates.
    ///
    /// # Errors
    /// What cannot be printed with four.
    pub(crate) fn is_joint(&self) -> Result<bool, Failure> {
        if self.dimensions == "2" {
            return Ok(false);
        }
        let named = self.sequence.as_deref().unwrap_or_default();
        let on_map = format!("--map {}", self.map);
        let wrong = [
            ("--stdin".to_owned(), self.stdin),
            (format!("--sequence {named}"), !["sobol", "sobol-owen"].contains(&named)),
            (on_map, self.map != maps::SQUARE),
            ("--density".to_owned(), self.density),
            ("--invert".to_owned(), self.invert),
        ];
        match wrong.into_iter().find(|(_, wrong)| *wrong) {
            None => Ok(true),
            Some((with, _)) => Err(Failure::Usage(format!(
                "--dimensions: 4 given with {with}; accepted: 4 with --sequence sobol or \
                 sobol-owen and --map square, without --density and --invert"
            ))),
        }
    }

    /// The pixel of a screen whose points are asked for, and how many they are.
    ///
    /// # Errors
    /// What is no screen, and a pixel outside.
    pub(crate) fn pixel(&self) -> Result<Option<(Pixel, u32)>, Failure> {
        let (Some(size), Some(samples), Some([x, y])) = (self.screen, self.spp, self.pixel) else {
            return Ok(None);
        };
        let named = self.sequence.as_deref().unwrap_or_default();
        if named != "sobol-owen" {
            return Err(Failure::Usage(format!(
                "--screen: given with --sequence {named}; accepted: --sequence sobol-owen"
            )));
        }
        let domain = Domain::new(self.seed());
        let screen = Screen::new(domain, size, samples.get())
            .map_err(|error| Failure::Usage(format!("--screen: {error}")))?;
        let pixel =
            screen.pixel(x, y).map_err(|error| Failure::Usage(format!("--pixel: {error}")))?;
        Ok(Some((pixel, samples.get())))
    }

    pub(crate) fn disc(&self) -> &str {
        self.disc.as_deref().unwrap_or("concentric")
    }

    /// The exponent, checked even where the map does not use it.
    pub(crate) fn exponent<A: Arithmetic>(&self) -> Result<Option<A::Parameter>, Failure> {
        let Some(text) = self.exponent.as_deref() else { return Ok(None) };
        let exponent = text.parse().map_err(|error| {
            // A number that the type refuses, or none.
            Failure::Usage(if text.parse::<f64>().is_ok() {
                format!("--exponent: {error}")
            } else {
                format!("--exponent: {text:?} is not a number; {}", accepted_exponent::<A>())
            })
        })?;
        A::exponent(exponent).map_err(|error| Failure::Usage(format!("--exponent: {error}")))?;
        Ok(Some(exponent))
    }

    /// A line for each argument that is accepted without an effect.
    pub(crate) fn notes(&self) -> Vec<String> {
        let on_map = format!("--map {}", self.map);
        let [disc, exponent] = [maps::is_hemisphere(&self.map), maps::takes_exponent(&self.map)];
        let unused = [
            ("--disc", self.disc.is_some() && !disc, on_map.as_str()),
            ("--exponent", self.exponent.is_some() && !exponent, on_map.as_str()),
            ("--count", self.count.is_some() && self.stdin, "--stdin"),
            ("--start", self.start.is_some() && self.stdin, "--stdin"),
            ("--seed", self.seed.is_some() && self.stdin, "--stdin"),
            ("--count", self.count.is_some() && self.screen.is_some(), "--screen"),
            ("--start", self.start.is_some() && self.screen.is_some(), "--screen"),
        ];
        let unused = unused.into_iter().filter(|(_, unused, _)| *unused);
        unused.map(|(name, _, with)| format!("note: {name} has no effect with {with}")).collect()
    }

    /// Why no arithmetic has the name that was given.
    pub(crate) fn unknown_arithmetic(&self) -> String {
        let name = &self.arithmetic;
        let wrong = if ARITHMETICS.contains(&name.as_str()) {
            "needs a feature that this build does not have"
        } else {
            "is not an arithmetic"
        };
        format!("--arithmetic: {name:?} {wrong}; accepted: {}", AVAILABLE_ARITHMETICS.join(", "))
    }
}

pub(crate) fn missing_exponent<A: Arithmetic>(map: &str) -> String {
    let accepted = accepted_exponent::<A>();
    format!("--exponent: missing, {map} needs it; {accepted}")
}

/// What the arithmetic accepts, in the words of the crate's errors.
fn accepted_exponent<A: Arithmetic>() -> String {
    let negative = "-0.5".parse::<A::Parameter>().is_ok();
    let fixed = || hemidisc::Error::FixedExponent { value: f64::NAN }.to_string();
    let fixed = || fixed().split("; ").last().unwrap_or_default().to_owned();
    if negative { format!("accepted: {EXPONENT}") } else { fixed() }
}

/// An error of the parser on one line.
pub(crate) fn one_line(error: &clap::Error) -> String {
    refusal::one_line(error, &Arguments::command(), &accepted)
}

/// What an argument accepts.
fn accepted(long: &str) -> String {
    let command = Arguments::command();
    let known = command.get_arguments().find(|known| known.get_long() == Some(long));
    let values = known.map(|known| known.get_possible_values()).unwrap_or_default();
    let values: Vec<_> = values.iter().map(|value| value.get_name()).collect();
    match long {
        "count" | "spp" => COUNT.to_owned(),
        "screen" | "pixel" => BOTH.to_owned(),
        "start" | "seed" => INDEX.to_owned(),
        "exponent" => EXPONENT.to_owned(),
        "arithmetic" => AVAILABLE_ARITHMETICS.join(", "),
        _ => values.join(", "),
    }
}
