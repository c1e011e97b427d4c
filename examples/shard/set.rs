//! What is asked for of a set of points: the arguments that settle its bytes, and what they accept.
//!
//! Names and defaults are those of the example `points`.

use clap::Args;
use clap::builder::PossibleValuesParser;
use examples::{Failure, maps};
use hemidisc::catalogue::{AVAILABLE_ARITHMETICS, DISC_MAPS, SEQUENCES};
use serde::{Deserialize, Serialize};
use std::num::NonZeroU32;
use std::str::FromStr;

// No doc comment: the parser would show it in place of the command's.
#[derive(Args, Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Set {
    /// Where the coordinates come from
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(SEQUENCES))]
    pub(crate) sequence: String,

    /// Size of the set, or number of points of an endless sequence
    #[arg(long, value_name = "N", value_parser = NonZeroU32::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) count: NonZeroU32,

    /// Seed; regular, hammersley and halton ignore it; 0 is the textbook's sobol and r2
    #[arg(long, value_name = "S", default_value = "0", value_parser = u32::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub(crate) seed: u32,

    /// Where the coordinates go; the square leaves them as they are, u32
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(maps::one_to_one()))]
    pub(crate) map: String,

    /// Disc map below a hemisphere map [default: concentric]
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(DISC_MAPS))]
    disc: Option<String>,

    /// Exponent of hemisphere-power: a finite number above -1; in fixed point 0 <= e < 4294967296
    #[arg(long, value_name = "E", allow_hyphen_values = true)]
    pub(crate) exponent: Option<String>,

    /// Number type and its functions
    #[arg(long, value_name = "NAME", default_value = "libm-f32")]
    #[arg(value_parser = PossibleValuesParser::new(AVAILABLE_ARITHMETICS))]
    pub(crate) arithmetic: String,
}

pub(crate) const EXPONENT: &str = "a finite number above -1";

/// What an argument accepts, if it is one of these.
pub(crate) fn accepted(long: &str) -> Option<String> {
    Some(match long {
        "sequence" => SEQUENCES.join(", "),
        "count" => "an integer 1..=4294967295".to_owned(),
        "seed" => "an integer 0..=4294967295".to_owned(),
        "map" => maps::one_to_one().collect::<Vec<_>>().join(", "),
        "disc" => DISC_MAPS.join(", "),
        "exponent" => EXPONENT.to_owned(),
        "arithmetic" => AVAILABLE_ARITHMETICS.join(", "),
        _ => return None,
    })
}

impl Set {
    pub(crate) fn disc(&self) -> &str {
        self.disc.as_deref().unwrap_or("concentric")
    }

    /// Refuses what has no effect: sets that differ in it alone would seem to be different ones.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        let Self { map, disc, exponent, .. } = self;
        let wrong = if disc.is_some() && !maps::is_hemisphere(map) {
            format!("--disc: has no effect with --map {map}; accepted: with a hemisphere")
        } else if exponent.is_some() && !maps::takes_exponent(map) {
            let accepted = maps::of_an_exponent();
            format!("--exponent: has no effect with --map {map}; accepted: with {accepted}")
        } else if exponent.is_none() && maps::takes_exponent(map) {
            format!("--exponent: missing, {map} needs it; accepted: {EXPONENT}")
        } else {
            return Ok(());
        };
        Err(Failure::Usage(wrong))
    }
}
