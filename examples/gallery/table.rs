//! The tables on standard output.

use crate::sets::{EXPONENTS, OnHemisphere, Set};
use crate::statistics::{cells, minimum_angle};
use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, Table};

/// How to read the columns of [`disc`].
pub(crate) const LEGEND: &str = "\
kept        points on the disc, of the candidates drawn
min dist    smallest distance between two points on the disc of radius 1
of hexagon  that distance over the largest possible for as many points (hexagonal packing)
half-plane  max over half-planes of |fraction of points inside - fraction of area inside|: exact,
            by trying the edges through every pair of points and at right angles to every radius
chi2/dof, p chi-square over cells of equal area (rings x sectors) by its degrees of freedom, and its
            tail: p near 0 is not uniform, near 1 more even than independent points are
ns          a point of Points::fill (rejection: of each point kept), libm-f32, the shortest of 16
            runs: this machine's";

/// Every sequence through every disc map, at one size.
pub(crate) fn disc(sets: &[Set]) -> String {
    let mut table = table(
        2,
        ["sequence", "map", "kept", "min dist", "of hexagon", "half-plane", "chi2/dof", "p", "ns"],
    );
    for set in sets {
        for disc in &set.discs {
            let m = &disc.measured;
            table.add_row([
                set.sequence.to_string(),
                disc.map.to_string(),
                m.kept.to_string(),
                format!("{:.4}", m.distance),
                format!("{:.0} %", 100.0 * m.spread),
                format!("{:.4}", m.discrepancy),
                format!("{:.2}", m.chi_square),
                format!("{:.3}", m.p),
                format!("{:.1}", disc.nanoseconds),
            ]);
        }
    }
    let [rings, sectors] = sets.first().map_or([0, 0], |set| cells(set.count));
    let count = sets.first().map_or(0, |set| set.count);
    format!("{count} candidates on the disc; chi-square over {rings} x {sectors} cells\n{table}\n")
}

/// Every sequence through every lobe, at one size.
pub(crate) fn hemisphere(sets: &[Set]) -> String {
    let per_exponent = |column: &str| EXPONENTS.map(|e| format!("{column}, e={e}"));
    let headers = ["sequence", "disc map"].map(String::from);
    let mut table = table(2, headers.iter().chain(&per_exponent("deg")).chain(&per_exponent("ns")));
    for set in sets {
        for disc in &set.discs {
            let lobes = EXPONENTS.map(|e| set.on_hemisphere(disc.map, e));
            // Rejection has no lobes.
            if lobes.iter().all(Option::is_none) {
                continue;
            }
            let each =
                |show: fn(&OnHemisphere) -> String| lobes.map(|l| l.map_or_else(String::new, show));
            let names = [set.sequence, disc.map].map(String::from);
            let angles = each(|lobe| format!("{:.2}", minimum_angle(&lobe.directions)));
            let times = each(|lobe| format!("{:.1}", lobe.nanoseconds));
            table.add_row(names.iter().chain(&angles).chain(&times));
        }
    }
    let count = sets.first().map_or(0, |set| set.count);
    format!(
        "{count} directions on the hemisphere, lobes cos^e: smallest angle between two (deg), \
         ns a point\n{table}\n"
    )
}

/// An empty table: `names` columns of text, then numbers.
fn table<T: ToString>(names: usize, headers: impl IntoIterator<Item = T>) -> Table {
    let mut table = Table::new();
    table
        .load_style(ASCII_MARKDOWN)
        .set_header(headers.into_iter().map(|h| h.to_string()).collect::<Vec<_>>());
    for column in table.column_iter_mut().skip(names) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}
