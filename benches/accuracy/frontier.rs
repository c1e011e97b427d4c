//! The Pareto frontier of a machine's costs and errors.

use crate::measure::Row;

/// The boards of the firmware's report.
pub const CORES: [&str; 4] = ["Cortex-M0", "Cortex-M3", "Cortex-M4F", "RV32IMC"];
/// The machine that the bench runs on.
pub const HOST: &str = "host";

/// A map x arithmetic on a machine.
#[derive(Clone, Copy)]
pub struct Mark<'a> {
    /// Instructions a point; on the host the time as a ratio.
    pub cost: f64,
    /// Of a component.
    pub error: f64,
    pub row: &'a Row,
}

/// Those of the rows that the machine has counted.
pub fn marks<'a>(rows: &[&'a Row], machine: &str) -> Vec<Mark<'a>> {
    let cost = |row: &Row| {
        let board = row.boards.get(machine).map(|board| board.instructions_per_point);
        board.or((machine == HOST).then_some(row.host))
    };
    let mark =
        |row: &&'a Row| Some(Mark { cost: cost(row)?, error: row.position.max * row.unit, row });
    rows.iter().filter_map(mark).collect()
}

/// Those that no other beats in both, cheapest first.
pub fn frontier<'a>(marks: &[Mark<'a>]) -> Vec<Mark<'a>> {
    let mut marks = marks.to_vec();
    marks.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.error.total_cmp(&b.error)));
    let mut best = f64::INFINITY;
    marks.retain(|mark| {
        let better = mark.error < best;
        best = best.min(mark.error);
        better
    });
    marks
}
