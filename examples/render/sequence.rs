//! The sequences that a picture can be rendered with, to compare their noise.

use crate::tracer::sobol_owen;
use hemidisc::Domain;
use hemidisc::sequence::{MultiJittered, Random, Sequence as _, Shuffled};
use std::str::FromStr;

/// A sequence that has a name.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Sequence {
    SobolOwen,
    Random,
    /// Of one set of all samples of a pixel.
    MultiJittered,
}

impl Sequence {
    pub(crate) const ALL: [(&str, Self); 3] = [
        ("sobol-owen", Self::SobolOwen),
        ("random", Self::Random),
        ("multi-jittered", Self::MultiJittered),
    ];

    /// The points of a pixel of so many samples.
    pub(crate) fn points(self, samples: u32) -> impl Fn(Domain, u32) -> [u32; 2] {
        let [columns, rows] = hemidisc::catalogue::grid(samples);
        move |domain, index| match self {
            Self::SobolOwen => sobol_owen(domain, index),
            Self::Random => Random::new(domain.seed()).at(index),
            Self::MultiJittered => {
                let set = MultiJittered::new(columns, rows, domain.child(0).seed());
                // Two effects' cells in the same order would be one set of cells.
                Shuffled::new(set.expect("at most 2^16 samples"), domain).point(index)
            }
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
