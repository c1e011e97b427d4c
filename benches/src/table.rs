//! Figures of several builds as Markdown.

use comfy_table::presets::ASCII_MARKDOWN;
use comfy_table::{CellAlignment, Table};

/// An empty table: `names` columns of text, then figures.
pub fn table<'a>(names: usize, headers: impl IntoIterator<Item = &'a str>) -> Table {
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header(headers);
    for column in table.column_iter_mut().skip(names) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// What is said of every build, side by side.
pub fn joined(parts: impl Iterator<Item = String>) -> String {
    let parts: Vec<_> = parts.collect();
    if parts.is_empty() { "-".to_owned() } else { parts.join(" / ") }
}

/// A figure in three digits.
pub fn three_digits(figure: f64) -> String {
    let places = if figure < 10.0 { 2 } else { usize::from(figure < 100.0) };
    format!("{figure:.places$}")
}

/// Whether a bar is met.
pub fn yes_or_no(met: bool) -> String {
    if met { "yes" } else { "no" }.to_owned()
}
