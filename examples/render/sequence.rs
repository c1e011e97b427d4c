//! The sequences and samplers that a picture can be rendered with, to compare their noise.

use hemidisc::sequence::{GridSize, InDomain, MultiJittered, Random, Shuffled, SobolOwen, grid};
use hemidisc::{Domain, Error, Sampler, Screen};
use serde::{Deserialize, Serialize};
use std::str::FromStr;
use testkit::tracer::Source;

/// A sequence that has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sequence {
    SobolOwen,
    Random,
    /// Of one set of all samples of a pixel.
    MultiJittered,
}

impl Sequence {
    pub const ALL: [(&str, Self); 3] = [
        ("sobol-owen", Self::SobolOwen),
        ("random", Self::Random),
        ("multi-jittered", Self::MultiJittered),
    ];
}

/// What the pixels have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pixels {
    /// Nothing: each has a domain of its own, and the noise is white.
    Pixel,
    /// A sequence, and the noise is blue.
    Screen,
}

impl Pixels {
    pub const ALL: [(&str, Self); 2] = [("pixel", Self::Pixel), ("screen", Self::Screen)];
}

/// The numbers of a picture's samples.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    screen: Screen,
    pixels: Pixels,
    member: Member,
}

impl Drawn {
    /// Those of a sequence, a seed, and a picture's size and samples in each pixel. The pixels of a
    /// screen are for the Sobol sequence alone.
    ///
    /// # Errors
    /// For a picture without a pixel or a sample.
    pub fn new(
        sequence: Sequence,
        pixels: Pixels,
        seed: u32,
        size: [u32; 2],
        samples: u16,
    ) -> Result<Self, Error> {
        let member = match sequence {
            Sequence::SobolOwen => Member::SobolOwen,
            Sequence::Random => Member::Random,
            Sequence::MultiJittered => {
                let [columns, rows] = grid(samples.into());
                Member::MultiJittered(GridSize::new(columns, rows)?)
            }
        };
        let screen = Screen::new(Domain::new(seed), size, samples.into())?;
        Ok(Self { screen, pixels, member })
    }
}

impl Source for Drawn {
    type Family = Named;

    #[inline]
    fn sampler(&self, pixel: [u32; 2], sample: u32) -> Sampler<Named> {
        let sampler = match self.pixels {
            Pixels::Pixel => self.screen.domain().sampler(pixel, sample),
            Pixels::Screen => self.screen.sampler(pixel, sample),
        };
        Sampler::of(sampler.domain(), self.member, sampler.index())
    }
}

/// The families that have a name.
#[derive(Clone, Copy, Debug)]
pub struct Named;

/// Which of them, and its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Member {
    SobolOwen,
    Random,
    MultiJittered(GridSize),
}

/// A sequence of one of them.
#[derive(Clone, Copy, Debug)]
pub enum AnySequence {
    SobolOwen(SobolOwen),
    Random(Random),
    MultiJittered(Shuffled<MultiJittered>),
}

impl InDomain for Named {
    type Size = Member;
    type Sequence = AnySequence;

    fn in_domain(domain: Domain, member: Member) -> AnySequence {
        match member {
            Member::SobolOwen => AnySequence::SobolOwen(SobolOwen::in_domain(domain)),
            Member::Random => AnySequence::Random(Random::in_domain(domain)),
            Member::MultiJittered(size) => {
                AnySequence::MultiJittered(<MultiJittered as InDomain>::in_domain(domain, size))
            }
        }
    }

    fn joint(domain: Domain, member: Member, index: u32) -> [[u32; 2]; 2] {
        match member {
            Member::SobolOwen => <SobolOwen as InDomain>::joint(domain, (), index),
            Member::Random => <Random as InDomain>::joint(domain, (), index),
            Member::MultiJittered(size) => <MultiJittered as InDomain>::joint(domain, size, index),
        }
    }
}

impl hemidisc::sequence::Sequence for AnySequence {
    fn size(&self) -> Option<u32> {
        match self {
            Self::MultiJittered(set) => set.size(),
            Self::SobolOwen(_) | Self::Random(_) => None,
        }
    }

    #[inline]
    fn at(&self, index: u32) -> [u32; 2] {
        match self {
            Self::SobolOwen(sequence) => sequence.at(index),
            Self::Random(sequence) => sequence.at(index),
            Self::MultiJittered(set) => set.at(index),
        }
    }
}

impl FromStr for Sequence {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known = Self::ALL.into_iter().find(|(name, _)| *name == text);
        known.map(|(_, sequence)| sequence).ok_or_else(|| "is not a sequence".to_owned())
    }
}

impl FromStr for Pixels {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let known = Self::ALL.into_iter().find(|(name, _)| *name == text);
        known.map(|(_, pixels)| pixels).ok_or_else(|| "is not a sampler".to_owned())
    }
}
