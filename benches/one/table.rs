//! The report as Markdown: what has a bar, then everything by families. Figures are those of all
//! builds that were measured, side by side.

use crate::bars::{BARS, Bar};
use crate::calls::{LATENCY, REPEATED, THROUGHPUT};
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
    let headers = ["ns", "against, ns", "times as fast", "at least", "met", REPEATED, LATENCY];
    let mut table = table(2, ["call", "against"].into_iter().chain(headers));
    for Bar { path, peer, .. } in BARS {
        let pair = Pair { report, path, peer };
        table.add_row([
            (*path).to_owned(),
            (*peer).to_owned(),
            pair.figure(THROUGHPUT, |row| row.nanoseconds),
            pair.figure(THROUGHPUT, |row| row.against_nanoseconds),
            pair.figure(THROUGHPUT, |row| row.ratio),
            pair.cell(THROUGHPUT, |row| row.at_least.map(three_digits)),
            pair.cell(THROUGHPUT, |row| row.met().map(yes_or_no)),
            pair.figure(REPEATED, |row| row.ratio),
            pair.figure(LATENCY, |row| row.ratio),
        ]);
    }
    format!("{table}\n")
}

/// Every comparison of a family, timed in every way.
fn of_family(report: &Report, family: &str) -> String {
    let kinds = [THROUGHPUT, REPEATED, LATENCY];
    let headers = kinds.map(|kind| [format!("{kind}, ns"), "against, ns".into(), "ratio".into()]);
    let headers: Vec<_> = headers.iter().flatten().map(String::as_str).collect();
    let mut table = table(2, [family, "against"].into_iter().chain(headers));
    let first = builds(report).next();
    for row in report.rows.iter().filter(|row| Some(row.build.as_str()) == first) {
        let ends = [&row.what, &row.against].map(|path| path.rsplit_once('/'));
        let [Some((path, THROUGHPUT)), Some((peer, _))] = ends else { continue };
        if path.split('/').next() == Some(family) {
            let pair = Pair { report, path, peer };
            let figures = kinds.map(|kind| {
                [
                    pair.figure(kind, |row| row.nanoseconds),
                    pair.figure(kind, |row| row.against_nanoseconds),
                    pair.figure(kind, |row| row.ratio),
                ]
            });
            let names = [path, peer].map(|name| name.trim_start_matches("peer/").to_owned());
            table.add_row(names.into_iter().chain(figures.into_iter().flatten()));
        }
    }
    format!("{table}\n")
}

/// A call and what it is compared with, in every build.
struct Pair<'a> {
    report: &'a Report,
    path: &'a str,
    peer: &'a str,
}

impl Pair<'_> {
    fn cell(&self, kind: &str, of: impl Fn(&Row) -> Option<String>) -> String {
        let [what, against] = [self.path, self.peer].map(|path| format!("{path}/{kind}"));
        let row = |build| self.report.find(build, &what, &against);
        joined(builds(self.report).filter_map(|build| of(row(build)?)))
    }

    fn figure(&self, kind: &str, of: impl Fn(&Row) -> f64) -> String {
        self.cell(kind, |row| Some(three_digits(of(row))))
    }
}

/// The builds that have rows, in their order.
fn builds(report: &Report) -> impl Iterator<Item = &'static str> {
    BUILDS.into_iter().filter(|build| report.rows.iter().any(|row| row.build == *build))
}
