//! What was measured, in `target/one/report.json` (of a test in `test.json`): comparisons, a list.
//!
//! ```json
//! [
//!   {
//!     "what": "map/disc/concentric/fast-f32/throughput",
//!     "against": "peer/disc/concentric/pbrt/throughput",
//!     "build": "baseline",
//!     "nanoseconds": 9.5,
//!     "against_nanoseconds": 19.0,
//!     "ratio": 2.0,
//!     "at_least": 1.5
//!   }
//! ]
//! ```
//!
//! `what` ends with how it was timed: `throughput`, `latency` or `repeated`, as `calls` has them.
//! `build` is `baseline` or `native`. `nanoseconds` is the time of a call, or of a point of a fill:
//! the minimum over all rounds. `ratio` is how many times as fast it is as the other: above 1 it is
//! faster. That of a small fill is against a long one, so it is at most 1, and 0.4 means that a
//! point takes 2.5 times as long. `at_least` is what the ratio must reach, where there is a bar. A
//! run replaces the rows of its own build, or is merged with them.

use crate::bars::BARS;
use crate::peers;
use benches::builds::{self, THIS};
use benches::failure::Failure;
use benches::record;
use benches::rounds::Measurement;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// The folder of the reports under `target`.
const BENCH: &str = "one";

/// All rows, those of a build after those of another.
#[derive(Default, Serialize, Deserialize)]
#[serde(transparent)]
pub(crate) struct Report {
    pub(crate) rows: Vec<Row>,
}

/// A call beside another.
#[derive(Serialize, Deserialize)]
pub(crate) struct Row {
    pub(crate) what: String,
    pub(crate) against: String,
    pub(crate) build: String,
    pub(crate) nanoseconds: f64,
    pub(crate) against_nanoseconds: f64,
    pub(crate) ratio: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) at_least: Option<f64>,
}

impl Row {
    /// Whether it reaches its bar, if it has one.
    pub(crate) fn met(&self) -> Option<bool> {
        self.at_least.map(|bar| self.ratio >= bar)
    }
}

impl Report {
    /// The one of earlier runs; empty if there is none.
    pub(crate) fn read(name: &str) -> Result<Self, Failure> {
        record::read(BENCH, name)
    }

    pub(crate) fn write(&self, name: &str) -> Result<(), Failure> {
        record::write(BENCH, name, self)
    }

    /// Takes in what this build measured, instead of what there is of it, or merged with that.
    ///
    /// # Errors
    /// Where a bar or a comparison names what was not measured.
    pub(crate) fn take(&mut self, measured: &[Measurement], merge: bool) -> Result<(), Failure> {
        let mut times: HashMap<_, _> =
            measured.iter().map(|one| (one.path.clone(), one.nanoseconds)).collect();
        for row in self.rows.iter().filter(|row| merge && row.build == THIS) {
            let both = [(&row.what, row.nanoseconds), (&row.against, row.against_nanoseconds)];
            for (path, nanoseconds) in both {
                times.entry(path.clone()).and_modify(|time| *time = nanoseconds.min(*time));
            }
        }
        self.rows.retain(|row| row.build != THIS);
        for Measurement { path, .. } in measured {
            let (call, kind) = path.rsplit_once('/').unwrap_or((path, ""));
            for peer in peers::of(call) {
                self.rows.push(row(&times, path.clone(), format!("{peer}/{kind}"))?);
            }
        }
        self.rows.sort_by_key(|row| builds::place(&row.build));
        self.bars_are_rows()
    }

    fn bars_are_rows(&self) -> Result<(), Failure> {
        for [path, peer] in BARS.iter().map(|bar| bar.names()) {
            if self.find(THIS, &path, &peer).is_none() {
                return Err(format!("no row has the bar of {path} against {peer}").into());
            }
        }
        Ok(())
    }

    /// The row of a build.
    pub(crate) fn find(&self, build: &str, what: &str, against: &str) -> Option<&Row> {
        let same = |row: &&Row| row.build == build && row.what == what && row.against == against;
        self.rows.iter().find(same)
    }
}

fn row(times: &HashMap<String, f64>, what: String, against: String) -> Result<Row, Failure> {
    let time = |path: &str| times.get(path).copied().ok_or(format!("{path} was not measured"));
    let (nanoseconds, against_nanoseconds) = (time(&what)?, time(&against)?);
    let bar = BARS.iter().find(|bar| bar.names() == [what.as_str(), against.as_str()]);
    Ok(Row {
        at_least: bar.and_then(|bar| builds::figure(bar.at_least, THIS)),
        build: THIS.to_owned(),
        ratio: against_nanoseconds / nanoseconds,
        what,
        against,
        nanoseconds,
        against_nanoseconds,
    })
}
