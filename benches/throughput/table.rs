//! The report as Markdown: ratios, since absolute times depend on the machine.

use crate::buffers::{LARGE, SMALL};
use crate::linear::SIZES;
use crate::peers;
use crate::report::{Build, Report, Row};
use crate::targets::{TARGETS, Target};
use benches::table::{joined, table, three_digits, yes_or_no};

/// All of it.
pub(crate) fn whole(report: &Report) -> String {
    let libm = "libm-f32";
    let tables = [
        targets(report),
        family(report, "sequence", &["sequence"], &["xoshiro128++", "sobol_burley"]),
        family(
            report,
            "map",
            &["map", "disc", "arithmetic"],
            &[libm, "pbrt", "suffern", "suffern-libm-powf", "rand_distr"],
        ),
        family(
            report,
            "fused",
            &["sequence", "map", "disc", "arithmetic"],
            &[libm, "rand_distr", "sobol_burley", "sobol_burley-4d", "slice-fill"],
        ),
        linear(report),
    ];
    let builds = report.builds.iter().map(|build| {
        let Build { name, vectors, runs, rounds, .. } = build;
        format!("{name} ({vectors}, the shortest of {runs} x {rounds} rounds)")
    });
    let builds: Vec<_> = builds.collect();
    format!(
        "How many times as fast a fill is as another, in buffers of {SMALL} points: {}.\n\n{}",
        builds.join(" / "),
        tables.join("\n")
    )
}

/// What the fast arithmetic must reach.
fn targets(report: &Report) -> String {
    let large = format!("in {LARGE}");
    let headers = ["fill", "against", "at least", "wanted", "is", "met", &large];
    let mut table = table(2, headers);
    for Target { path, peer, at_least, wanted } in TARGETS {
        let is = |build: &Build| build.ratio(path, peer, SMALL);
        let met = |build: &Build| Some(is(build)? >= build.figure(*at_least)?);
        table.add_row([
            (*path).to_owned(),
            (*peer).to_owned(),
            cell(report, |build| build.figure(*at_least)),
            cell(report, |build| build.figure(*wanted)),
            cell(report, is),
            each(report, |build| met(build).map(yes_or_no)),
            cell(report, |build| build.ratio(path, peer, LARGE)),
        ]);
    }
    format!("{table}\n")
}

/// Every fill of a family against each of its peers, which are the last parts of their paths.
fn family(report: &Report, family: &str, names: &[&str], peers: &[&str]) -> String {
    let mut table = table(names.len(), names.iter().chain(peers).copied());
    let all = report.builds.first().into_iter().flat_map(|build| &build.rows);
    for row in all.filter(|row| row.points == SMALL && row.family == family) {
        let path = row.path();
        let compared = peers::of(&path);
        let ratios = peers.iter().map(|peer| {
            let peer = compared.iter().find(|path| path.rsplit('/').next() == Some(peer));
            cell(report, |build| build.ratio(&path, peer?, SMALL))
        });
        table.add_row(row.name.split('/').map(str::to_owned).chain(ratios));
    }
    format!("{table}\n")
}

/// The time of a point, by that in a buffer of 4096.
fn linear(report: &Report) -> String {
    let sizes = SIZES.map(|points| format!("2^{}", points.ilog2()));
    let mut table =
        table(1, ["time of a point"].into_iter().chain(sizes.iter().map(String::as_str)));
    let all = report.builds.first().into_iter().flat_map(|build| &build.rows);
    let measured = all.filter(|row| row.points == SIZES[0]);
    for path in measured.map(Row::path) {
        let times = SIZES.map(|points| {
            cell(report, |build| {
                Some(build.nanoseconds(&path, points)? / build.nanoseconds(&path, SMALL)?)
            })
        });
        table.add_row([path].into_iter().chain(times));
    }
    format!("{table}\n")
}

/// A figure of every build.
fn cell(report: &Report, of: impl Fn(&Build) -> Option<f64>) -> String {
    each(report, |build| of(build).map(three_digits))
}

/// What is said of every build.
fn each(report: &Report, of: impl Fn(&Build) -> Option<String>) -> String {
    joined(report.builds.iter().filter_map(of))
}
