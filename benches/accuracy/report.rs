//! The rows as a table, and its copy in docs/accuracy.md.

use crate::frontier::{CORES, HOST, Mark, frontier, marks};
use crate::measure::{Board, Error, Row};
use hemidisc::catalogue::LOBES;
use std::error;
use std::fs;
use std::path::Path;

/// The disc and the lobes over it, in the order of the rows.
fn maps() -> impl Iterator<Item = &'static str> {
    ["disc"].into_iter().chain(LOBES.iter().copied())
}

/// Cells of a line that do not depend on a machine: name and accuracy.
const ACCURACY: usize = 7;

/// The marks that a table stands between.
const TABLE: &str = "<!-- accuracy: written by `cargo bench --bench accuracy -- --bless` -->\n";
const CHOICES: &str = "<!-- choices: written by `cargo bench --bench accuracy -- --bless` -->\n";
const END: &str = "<!-- end -->";

/// The table.
pub fn markdown(rows: &[Row]) -> String {
    let mut text =
        String::from("| map | arithmetic, unit | position | norm | theta | evenness | time |");
    for core in CORES {
        text += &format!(" {core} |");
    }
    text += " flash, M0 | stack, M0 |\n| --- | --- | ---: | ---: | ---: | ---: | ---: |";
    text += &" ---: |".repeat(CORES.len() + 2);
    text += "\n";
    for row in sorted(rows) {
        let Row { map, disc, arithmetic, unit, evenness, host, .. } = row;
        text += &format!(
            "| {map} {disc} | {arithmetic}, 2^{} | {} | {} | {} | {} | {} |",
            unit.log2(),
            errors(row.position),
            errors(row.norm),
            row.theta.map_or("-".to_owned(), errors),
            digits(*evenness),
            digits(*host)
        );
        for core in CORES {
            let board = row.boards.get(core);
            let count = board.map(|board| digits(board.instructions_per_point));
            text += &format!(" {} |", count.unwrap_or("-".to_owned()));
        }
        let board = row.boards.get(CORES[0]);
        let cell =
            |of: fn(&Board) -> u64| board.map_or("-".to_owned(), |board| of(board).to_string());
        text += &format!(" {} | {} |\n", cell(|b| b.flash_bytes), cell(|b| b.stack_bytes));
    }
    text
}

/// For each machine and map the arithmetics worth choosing from, over the concentric disc map.
pub fn choices(rows: &[Row]) -> String {
    let mut text = String::from(
        "| machine | map | from the cheapest to the most accurate: largest error of a component, cost |\n\
         | --- | --- | --- |\n",
    );
    for machine in [HOST].into_iter().chain(CORES) {
        for map in maps() {
            let own: Vec<_> =
                rows.iter().filter(|row| row.map == map && row.disc == "concentric").collect();
            let choices: Vec<_> = frontier(&marks(&own, machine))
                .into_iter()
                .map(|Mark { cost, error, row }| {
                    format!("`{}` {error:.0e}, {}", row.arithmetic, digits(cost))
                })
                .collect();
            text += &format!("| {machine} | {map} | {} |\n", choices.join("; "));
        }
    }
    text
}

/// By map, the most accurate first.
fn sorted(rows: &[Row]) -> Vec<&Row> {
    let mut sorted: Vec<_> = rows.iter().collect();
    let error = |row: &Row| row.position.max * row.unit;
    sorted.sort_by(|a, b| {
        let place = |row: &Row| (maps().position(|map| map == row.map), row.disc);
        place(a).cmp(&place(b)).then(error(a).total_cmp(&error(b)))
    });
    sorted
}

fn errors(of: Error) -> String {
    format!("{}, {}", digits(of.max), digits(of.rms))
}

/// Two digits of what is below 10, three of what is above.
fn digits(x: f64) -> String {
    match x {
        _ if x == 0.0 => "0".to_owned(),
        _ if x < 0.01 => format!("{x:.1e}"),
        _ if x < 1.0 => format!("{x:.2}"),
        _ if x < 100.0 => format!("{x:.1}"),
        _ => format!("{x:.0}"),
    }
}

/// The text before a table, the table, and the text after.
fn parts<'a>(text: &'a str, start: &str) -> Result<[&'a str; 3], Box<dyn error::Error>> {
    let missing = || format!("docs/accuracy.md has no {start}");
    let (before, rest) = text.split_once(start).ok_or_else(missing)?;
    let (table, after) = rest.split_once(END).ok_or_else(missing)?;
    Ok([before, table, after])
}

/// Fails where the accuracy columns of the committed table are not those of this one.
pub fn check(root: &Path, table: &str) -> Result<(), Box<dyn error::Error>> {
    let text = fs::read_to_string(root.join("docs/accuracy.md"))?;
    let [_, committed, _] = parts(&text, TABLE)?;
    let accuracy = |line: &str| line.split('|').take(ACCURACY).collect::<Vec<_>>().join("|");
    let committed: Vec<_> = committed.lines().map(accuracy).collect();
    let now: Vec<_> = table.lines().map(accuracy).collect();
    if let Some((committed, now)) = committed.iter().zip(&now).find(|(a, b)| a != b) {
        let hint = "To write it anew: --bless";
        return Err(
            format!("docs/accuracy.md says\n{committed}\nbut now it is\n{now}\n{hint}").into()
        );
    }
    if committed.len() != now.len() {
        return Err(
            format!("docs/accuracy.md has {} lines of {}", committed.len(), now.len()).into()
        );
    }
    println!("docs/accuracy.md: the accuracy of {} rows is as measured", now.len() - 2);
    Ok(())
}

/// Writes both tables.
pub fn publish(root: &Path, table: &str, choices: &str) -> Result<(), Box<dyn error::Error>> {
    let path = root.join("docs/accuracy.md");
    let mut text = fs::read_to_string(&path)?;
    for (start, table) in [(TABLE, table), (CHOICES, choices)] {
        let [before, _, after] = parts(&text, start)?;
        text = format!("{before}{start}{table}{END}{after}");
    }
    Ok(fs::write(&path, text)?)
}
