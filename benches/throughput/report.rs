//! What the rounds measured, in `target/throughput/report.json` (of a test in `test.json`).
//!
//! ```json
//! {
//!   "builds": [
//!     {
//!       "name": "baseline",
//!       "vectors": "sse2",
//!       "runs": 3,
//!       "rounds": 60,
//!       "rows": [
//!         {
//!           "family": "map",
//!           "name": "disc/concentric/q15",
//!           "points": 4096,
//!           "nanoseconds": 5.0,
//!           "ratios": { "map/disc/concentric/libm-f32": 1.9, "peer/disc/concentric/pbrt": 2.7 }
//!         }
//!       ]
//!     }
//!   ]
//! }
//! ```
//!
//! `name` is `baseline` for the architecture's guaranteed vectors, `native` for more. A run
//! replaces its own build in the file, or is merged into it. `family` and `name` of a row make the
//! path of `fills`. `nanoseconds` is the time of a point, the minimum over all `rounds` of all
//! `runs`. `ratios` has the speed relative to other fills, by their paths, at as many points: above
//! 1 it is faster.

use crate::failure::{Failure, failed};
use crate::peers;
use crate::rounds::Measurement;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::PathBuf;

/// The builds, in the order of [`BUILDS`].
#[derive(Default, Serialize, Deserialize)]
pub(crate) struct Report {
    pub(crate) builds: Vec<Build>,
}

#[derive(Serialize, Deserialize)]
pub(crate) struct Build {
    pub(crate) name: String,
    pub(crate) vectors: String,
    pub(crate) runs: u32,
    pub(crate) rounds: usize,
    pub(crate) rows: Vec<Row>,
}

#[derive(Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) family: String,
    pub(crate) name: String,
    pub(crate) points: usize,
    pub(crate) nanoseconds: f64,
    pub(crate) ratios: BTreeMap<String, f64>,
}

const BUILDS: [&str; 2] = ["baseline", "native"];

/// The widest vectors that this build may use.
const VECTORS: &str = if cfg!(target_feature = "avx512f") {
    "avx512f"
} else if cfg!(target_feature = "avx2") {
    "avx2"
} else if cfg!(target_feature = "sse2") {
    "sse2"
} else if cfg!(target_feature = "sve") {
    "sve"
} else if cfg!(target_feature = "neon") {
    "neon"
} else {
    "none"
};

const NATIVE: bool = cfg!(any(target_feature = "avx2", target_feature = "sve"));

impl Row {
    pub(crate) fn path(&self) -> String {
        format!("{}/{}", self.family, self.name)
    }
}

impl Build {
    /// This build, as measured.
    pub(crate) fn new(rounds: usize, measured: Vec<Measurement>) -> Self {
        let mut build = Self {
            name: BUILDS[usize::from(NATIVE)].to_owned(),
            vectors: VECTORS.to_owned(),
            runs: 1,
            rounds,
            rows: Vec::new(),
        };
        for Measurement { path, points, nanoseconds } in measured {
            let (family, name) = path.split_once('/').unwrap_or(("", &path));
            let (family, name) = (family.to_owned(), name.to_owned());
            build.keep(Row { family, name, points, nanoseconds, ratios: BTreeMap::new() });
        }
        build
    }

    /// The shorter of a row and what there is of it.
    fn keep(&mut self, row: Row) {
        let same = |old: &&mut Row| old.path() == row.path() && old.points == row.points;
        match self.rows.iter_mut().find(same) {
            Some(old) => old.nanoseconds = old.nanoseconds.min(row.nanoseconds),
            None => self.rows.push(row),
        }
    }

    /// The shorter of all that two runs of this build measured.
    fn merge(&mut self, earlier: Self) {
        self.runs += earlier.runs;
        earlier.rows.into_iter().for_each(|row| self.keep(row));
    }

    pub(crate) fn nanoseconds(&self, path: &str, points: usize) -> Option<f64> {
        let row = self.rows.iter().find(|row| row.points == points && row.path() == path);
        row.map(|row| row.nanoseconds)
    }

    /// How many times as fast a fill is as another.
    pub(crate) fn ratio(&self, path: &str, other: &str, points: usize) -> Option<f64> {
        Some(self.nanoseconds(other, points)? / self.nanoseconds(path, points)?)
    }

    /// Of a figure for each of [`BUILDS`], this build's.
    pub(crate) fn figure(&self, figures: [f64; 2]) -> Option<f64> {
        let build = BUILDS.iter().zip(figures).find(|(name, _)| **name == self.name);
        build.map(|(_, figure)| figure)
    }

    fn compare(&mut self) {
        let compared = |row: &Row| {
            let path = row.path();
            let ratio = |peer: String| Some((self.ratio(&path, &peer, row.points)?, peer));
            peers::of(&path)
                .into_iter()
                .filter_map(ratio)
                .map(|(ratio, peer)| (peer, ratio))
                .collect()
        };
        let ratios: Vec<_> = self.rows.iter().map(compared).collect();
        for (row, ratios) in self.rows.iter_mut().zip(ratios) {
            row.ratios = ratios;
        }
    }
}

impl Report {
    /// The one of earlier runs; empty if there is none.
    pub(crate) fn read(name: &str) -> Result<Self, Failure> {
        let path = path(name);
        match fs::read(&path) {
            Ok(bytes) => serde_json::from_slice(&bytes).map_err(|error| failed(&path, &error)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(Self::default()),
            Err(error) => Err(failed(&path, &error)),
        }
    }

    /// Takes a build in, instead of what there is of it, or merged with that.
    pub(crate) fn take(&mut self, mut build: Build, merge: bool) {
        if let Some(place) = self.builds.iter().position(|earlier| earlier.name == build.name) {
            let earlier = self.builds.remove(place);
            if merge {
                build.merge(earlier);
            }
        }
        build.compare();
        self.builds.push(build);
        self.builds.sort_by_key(|build| BUILDS.iter().position(|name| *name == build.name));
    }

    pub(crate) fn write(&self, name: &str) -> Result<(), Failure> {
        let path = path(name);
        let text = serde_json::to_string_pretty(self)? + "\n";
        let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
        folder.and_then(|()| fs::write(&path, text)).map_err(|error| failed(&path, &error))
    }
}

/// The same for every build, which may have target folders of their own.
fn path(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "..", "target", "throughput", name].iter().collect()
}
