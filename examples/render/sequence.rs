//! The sequences that a picture can be rendered with, to compare their noise.

use hemidisc::Domain;
use hemidisc::sequence::{MultiJittered, Random, Sequence as _, Shuffled};
use serde::{Deserialize, Serialize};
use std::str::FromStr;
use testkit::tracer::{Owen, Points};

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

    /// The points of a pixel of so many samples.
    pub const fn points(self, samples: u32) -> Drawn {
        Drawn { sequence: self, grid: hemidisc::sequence::grid(samples) }
    }
}

/// The points of a sequence.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    sequence: Sequence,
    grid: [u32; 2],
}

impl Points for Drawn {
    fn point(&self, domain: Domain, index: u32) -> [u32; 2] {
        match self.sequence {
            Sequence::SobolOwen => Owen.point(domain, index),
            Sequence::Random => Random::new(domain.seed()).at(index),
            Sequence::MultiJittered => {
                let [columns, rows] = self.grid;
                let set = MultiJittered::new(columns, rows, domain.child(0).seed());
                // Two effects' cells in the same order would be one set of cells.
                Shuffled::new(set.expect("at most 2^16 samples"), domain).at(index)
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
