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

use crate::peers;
use benches::builds::{self, THIS, VECTORS};
use benches::failure::Failure;
use benches::record;
use benches::rounds::Measurement;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The folder of the reports under `target`.
const BENCH: &str = "throughput";

/// The builds, in the order of [`builds::BUILDS`].
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

impl Row {
    pub(crate) fn path(&self) -> String {
        format!("{}/{}", self.family, self.name)
    }
}

impl Build {
    /// This build, as measured.
    pub(crate) fn new(rounds: usize, measured: Vec<Measurement>) -> Self {
        let mut build = Self {
            name: THIS.to_owned(),
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

    /// Of a figure for each of [`builds::BUILDS`], this build's.
    pub(crate) fn figure(&self, figures: [f64; 2]) -> Option<f64> {
        builds::figure(figures, &self.name)
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
        record::read(BENCH, name)
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
        self.builds.sort_by_key(|build| builds::place(&build.name));
    }

    pub(crate) fn write(&self, name: &str) -> Result<(), Failure> {
        record::write(BENCH, name, self)
    }
}
