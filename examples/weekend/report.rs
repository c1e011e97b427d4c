//! What was measured, as a table and as `report.json`.
//!
//! ```json
//! {
//!   "bar": 1.1,
//!   "rows": [
//!     {
//!       "source": "hemidisc, in blocks",
//!       "samples": 64,
//!       "nanoseconds": 262.0,
//!       "time": 1.01,
//!       "error": 0.0081,
//!       "error_by_time": 0.033,
//!       "worth": 2.3,
//!       "met": true
//!     }
//!   ]
//! }
//! ```
//!
//! `nanoseconds` is the time of a path, `time` that time relative to the faster of the sources of
//! random numbers. `error_by_time` is the error times the root of a pixel's time in microseconds:
//! more samples do not change it, if they are random. `worth` is how many random samples have the
//! error of one. `met` is whether `time` is at most the bar; random numbers have none.

use crate::measure::{Measured, RANDOM, SOURCES};
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, Table};
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(crate) struct Report {
    bar: f64,
    pub(crate) rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Row {
    source: &'static str,
    samples: u32,
    nanoseconds: f64,
    pub(crate) time: f64,
    error: f64,
    error_by_time: f64,
    pub(crate) worth: f64,
    pub(crate) met: Option<bool>,
}

impl Report {
    pub(crate) const fn new() -> Self {
        Self { bar: 1.1, rows: Vec::new() }
    }

    /// Adds what was measured of the sources at a number of samples.
    pub(crate) fn add(&mut self, samples: u32, measured: &[Measured; SOURCES.len()]) {
        let random = &measured[..RANDOM];
        let fastest = random.iter().fold(f64::INFINITY, |least, of| least.min(of.nanoseconds));
        for (at, (Measured { nanoseconds, error }, (source, _))) in
            measured.iter().copied().zip(SOURCES).enumerate()
        {
            let time = nanoseconds / fastest;
            self.rows.push(Row {
                source,
                samples,
                nanoseconds,
                time,
                error,
                error_by_time: error * (f64::from(samples) * nanoseconds / 1e3).sqrt(),
                worth: (measured[0].error / error).powi(2),
                met: (at >= RANDOM).then_some(time <= self.bar),
            });
        }
    }

    pub(crate) fn table(&self) -> String {
        let mut table = Table::new();
        table.load_style(ASCII_MARKDOWN).set_header([
            "source",
            "samples",
            "ns a path",
            "time",
            "error",
            "error x sqrt time",
            "worth",
            "bar",
        ]);
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        for row in &self.rows {
            let met = row.met.map_or("", |met| if met { "met" } else { "not met" });
            table.add_row([
                row.source.to_owned(),
                row.samples.to_string(),
                format!("{:.0}", row.nanoseconds),
                format!("{:.2}", row.time),
                format!("{:.5}", row.error),
                format!("{:.4}", row.error_by_time),
                format!("{:.2}", row.worth),
                met.to_owned(),
            ]);
        }
        format!("{table}\n{}\n", legend(self.bar))
    }
}

fn legend(bar: f64) -> String {
    format!(
        "\
time              of a path, relative to the faster of the two of rand; the bar is {bar}
error             root mean square of linear light against the reference
error x sqrt time times the root of a pixel's time in microseconds
worth             samples of rand by rejection that have the error of one"
    )
}
