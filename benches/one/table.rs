//! The report as Markdown: what has a bar, then everything by families. Figures are those of all
//! builds that were measured, side by side.

use crate::bars::BARS;
use crate::calls::{LATENCY, THROUGHPUT};
use crate::report::{Report, Row};
use benches::builds::BUILDS;
use benches::table::{joined, table, three_digits, yes_or_no};

/// The first parts of paths, and what the first column is called.
const FAMILIES: [&str; 8] =
    ["map", "density", "sequence", "pair", "lens", "bounce", "effect", "fill"];

/// All of it.
pub(crate) fn whole(report: &Report) -> String {
    let builds = joined(builds(report).map(str::to_owned));
    let tables: Vec<_> = FAMILIES.iter().map(|family| of_family(report, family)).collect();
    format!(
        "One call at a time, or a point of a fill, in nanoseconds, and how many times as fast it is \
         as what it is compared with: {builds}.\n\n{}\n{}",
        bars(report),
        tables.join("\n")
    )
}

/// Throughput, and what it must reach.
fn bars(report: &Report) -> String {
    let mut table =
        table(2, ["call", "against", "ns", "against, ns", "times as fast", "at least", "met"]);
    for [path, peer] in BARS.iter().map(|bar| bar.names()) {
        let cell = |of: fn(&Row) -> Option<String>| {
            joined(builds(report).filter_map(|build| of(report.find(build, &path, &peer)?)))
        };
        table.add_row([
            without_end(&path).to_owned(),
            without_end(&peer).to_owned(),
            cell(|row| Some(three_digits(row.nanoseconds))),
            cell(|row| Some(three_digits(row.against_nanoseconds))),
            cell(|row| Some(three_digits(row.ratio))),
            cell(|row| row.at_least.map(three_digits)),
            cell(|row| row.met().map(yes_or_no)),
        ]);
    }
    format!("{table}\n")
}

/// Every comparison of a family, by throughput and by latency.
fn of_family(report: &Report, family: &str) -> String {
    let mut table = table(
        2,
        [
            family,
            "against",
            "ns",
            "against, ns",
            "times as fast",
            "latency, ns",
            "against, ns",
            "times as fast",
        ],
    );
    let first = builds(report).next();
    let mut rows = report.rows.iter().filter(|row| Some(row.build.as_str()) == first);
    let of =
        |row: &&Row| row.what.starts_with(&format!("{family}/")) && row.what.ends_with(THROUGHPUT);
    for row in rows.by_ref().filter(of) {
        let (call, peer) = (without_end(&row.what), without_end(&row.against));
        let figures = [THROUGHPUT, LATENCY].map(|kind| {
            let ends = [call, peer].map(|path| format!("{path}/{kind}"));
            let cell = |of: fn(&Row) -> f64| {
                let [what, against] = &ends;
                let found = builds(report).filter_map(|build| report.find(build, what, against));
                joined(found.map(|row| three_digits(of(row))))
            };
            [
                cell(|row| row.nanoseconds),
                cell(|row| row.against_nanoseconds),
                cell(|row| row.ratio),
            ]
        });
        let names = [call, peer].map(|path| path.trim_start_matches("peer/").to_owned());
        table.add_row(names.into_iter().chain(figures.into_iter().flatten()));
    }
    format!("{table}\n")
}

/// The builds that have rows, in their order.
fn builds(report: &Report) -> impl Iterator<Item = &'static str> {
    BUILDS.into_iter().filter(|build| report.rows.iter().any(|row| row.build == *build))
}

/// A path without the measurement's name.
fn without_end(path: &str) -> &str {
    path.rsplit_once('/').map_or(path, |(call, _)| call)
}
