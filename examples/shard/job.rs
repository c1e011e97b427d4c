//! What is computed: all that settles its bytes, as a part says it.

use crate::point_set::Layout;
use crate::set::Set;
use clap::ValueEnum;
use examples::render::frame::{Region, Settings};
use examples::render::request::Request;
use examples::render::sums::Sum;
use serde::{Deserialize, Serialize};
use std::io::{self, Write};
use std::ops::Range;

#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) enum Job {
    Points { set: Set, layout: Layout },
    Frame { request: Request, scene_digest: String, split: Split },
}

/// What a shard of a frame has some of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
pub(crate) enum Split {
    /// All samples of some rows
    Rows,
    /// Some samples of all rows, in passes of 8
    Samples,
}

impl Split {
    /// How many units there are to share out.
    fn units(self, settings: &Settings) -> u32 {
        match self {
            Self::Rows => settings.size[1],
            Self::Samples => settings.passes(),
        }
    }

    /// The part of a frame that a range of units is.
    pub(crate) fn region(self, settings: &Settings, units: Range<u32>) -> Region {
        match self {
            Self::Rows => Region { rows: units, ..settings.whole() },
            // Not all rows, of nothing.
            Self::Samples if units.is_empty() => Region { rows: 0..0, passes: units },
            Self::Samples => Region { passes: units, ..settings.whole() },
        }
    }
}

impl Job {
    /// How many units there are to share out.
    pub(crate) fn len(&self) -> u32 {
        match self {
            Self::Points { set, .. } => set.count.get(),
            Self::Frame { request, split, .. } => split.units(&request.settings()),
        }
    }

    /// What the units are.
    pub(crate) const fn unit(&self) -> &'static str {
        match self {
            Self::Points { .. } => "points",
            Self::Frame { split: Split::Rows, .. } => "rows",
            Self::Frame { split: Split::Samples, .. } => "passes",
        }
    }

    /// Bytes of a range of units.
    pub(crate) fn bytes(&self, units: Range<u32>) -> u64 {
        match self {
            Self::Points { layout, .. } => u64::from(layout.bytes) * units.len() as u64,
            Self::Frame { request, split, .. } => {
                let settings = request.settings();
                let rows = split.region(&settings, units).rows.len();
                size_of::<Sum>() as u64 * u64::from(request.width) * rows as u64
            }
        }
    }
}

/// A job that is known to be good.
pub(crate) trait Work: Sync {
    fn job(&self) -> &Job;

    /// Writes the bytes of a shard.
    fn write(&self, shard: u16, of: u16, out: &mut dyn Write) -> io::Result<()>;
}
