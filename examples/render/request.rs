//! What is asked for of a scene: the arguments that settle a picture's bits, and what they accept.

use crate::Failure;
use crate::render::assembly::{Render, renderer_of, renderers};
use crate::render::effects::Effects;
use crate::render::file;
use crate::render::frame::Settings;
use crate::render::sequence::{Pixels, Sequence};
use clap::Args;
use hemidisc::catalogue::{ARITHMETICS, EFFECTS};
use serde::{Deserialize, Serialize};
use std::num::NonZeroU16;
use std::str::FromStr;

// No doc comment: the parser would show it in place of the program's.
#[derive(Args, Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// A scene's name, or the path of a .ron file
    #[arg(long, value_name = "NAME")]
    pub scene: String,

    #[arg(long, value_name = "LIST", value_parser = Effects::from_str)]
    #[arg(help = format!(
        "Some of {} with commas between, or none [default: those of the scene]",
        EFFECTS.join(", ")
    ))]
    pub effects: Option<Effects>,

    /// Samples for each pixel
    #[arg(long, value_name = "N", default_value = "64", value_parser = NonZeroU16::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub spp: NonZeroU16,

    /// Pixels in a row
    #[arg(long, value_name = "W", default_value = "480", value_parser = side)]
    #[arg(allow_negative_numbers = true)]
    pub width: u16,

    /// Rows
    #[arg(long, value_name = "H", default_value = "320", value_parser = side)]
    #[arg(allow_negative_numbers = true)]
    pub height: u16,

    /// Where points come from
    #[arg(long, value_name = "NAME", default_value = "sobol-owen", value_parser = Sequence::from_str)]
    pub sequence: Sequence,

    /// What the pixels share: nothing, or a sequence, so that their noise is blue
    /// [default: screen for sobol-owen, pixel for the others, which have no other]
    #[arg(long, value_name = "NAME", value_parser = Pixels::from_str)]
    pub sampler: Option<Pixels>,

    /// Number type and its functions
    #[arg(long, value_name = "NAME", default_value = "libm-f32")]
    pub arithmetic: String,

    /// Of the noise
    #[arg(long, value_name = "S", default_value = "0", value_parser = u32::from_str)]
    #[arg(allow_negative_numbers = true)]
    pub seed: u32,
}

/// The longest side: a frame of sums of it by itself takes 1.6 GB.
const LONGEST: u16 = 8192;

fn side(text: &str) -> Result<u16, String> {
    match text.parse() {
        Ok(side @ 1..=LONGEST) => Ok(side),
        Ok(_) => Err("out of range".to_owned()),
        Err(error) => Err(error.to_string()),
    }
}

impl Request {
    pub fn settings(&self) -> Settings {
        Settings {
            size: [self.width.into(), self.height.into()],
            samples: self.spp.get(),
            sequence: self.sequence,
            pixels: self.sampler.unwrap_or(match self.sequence {
                Sequence::SobolOwen => Pixels::Screen,
                Sequence::Random | Sequence::MultiJittered => Pixels::Pixel,
            }),
            seed: self.seed,
        }
    }

    /// The effects called for, which have to be among those of the scene.
    ///
    /// # Errors
    /// [`Failure::Usage`] for others, and for a sampler that the sequence does not have.
    pub fn called_for(&self, of_scene: Effects) -> Result<Effects, Failure> {
        if self.sampler == Some(Pixels::Screen) && self.sequence != Sequence::SobolOwen {
            return Err(Failure::Usage(
                "--sampler: \"screen\" given with another sequence; accepted: pixel, or \
                 --sequence sobol-owen"
                    .to_owned(),
            ));
        }
        let effects = self.effects.unwrap_or(of_scene);
        if let Some(missing) = effects.each().find(|effect| !of_scene.has(*effect)) {
            return Err(Failure::Usage(format!(
                "--effects: scene {:?} has no {}; accepted: {}",
                self.scene,
                missing.name(),
                of_scene.accepted()
            )));
        }
        Ok(effects)
    }

    /// What renders in the arithmetic.
    pub fn renderer(&self) -> Result<Render, Failure> {
        renderer_of(&self.arithmetic).ok_or_else(|| {
            let name = &self.arithmetic;
            let wrong = if ARITHMETICS.contains(&name.as_str()) {
                "does not render, in this build"
            } else {
                "is not an arithmetic"
            };
            let accepted = accepted("arithmetic").unwrap_or_default();
            Failure::Usage(format!("--arithmetic: {name:?} {wrong}; accepted: {accepted}"))
        })
    }
}

/// What an argument accepts, if it is one of these.
pub fn accepted(long: &str) -> Option<String> {
    Some(match long {
        "scene" => format!("{}, or the path of a .ron file", file::names().join(", ")),
        "effects" => format!("some of {}, with commas between; or none", EFFECTS.join(",")),
        "spp" => "an integer 1..=65535".to_owned(),
        "width" | "height" => format!("an integer 1..={LONGEST}"),
        "arithmetic" => renderers().map(|(name, _)| name).collect::<Vec<_>>().join(", "),
        "sequence" => Sequence::ALL.map(|(name, _)| name).join(", "),
        "sampler" => Pixels::ALL.map(|(name, _)| name).join(", "),
        "seed" => "an integer 0..=4294967295".to_owned(),
        _ => return None,
    })
}
