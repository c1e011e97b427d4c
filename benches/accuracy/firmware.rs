//! What the boards count, from the report of the firmware's runner.

use crate::measure::{Board, Row};
use serde_json::Value;
use std::error::Error;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// Adds the boards to each row; says which there are.
pub fn add(rows: &mut [Row], path: &Path) -> Result<String, Box<dyn Error>> {
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == ErrorKind::NotFound => {
            return Ok("No report of the firmware's runner: no boards.".to_owned());
        }
        Err(error) => return Err(format!("{}: {error}", path.display()).into()),
    };
    let report: Value = serde_json::from_str(&text)?;
    let records = report["records"].as_array().ok_or("the firmware's report has no records")?;
    for row in &mut *rows {
        let own = records.iter().filter(|record| {
            record["kind"] == "map"
                && record["map"] == row.map
                && record["disc"] == row.disc
                && record["arithmetic"] == row.arithmetic
        });
        for record in own {
            let field = |name: &str| record[name].as_f64().ok_or(format!("no {name}"));
            let board = Board {
                instructions_per_point: field("instructions_per_point")?,
                flash_bytes: field("flash_bytes")? as u64,
                stack_bytes: field("stack_bytes")? as u64,
            };
            let core = record["core"].as_str().ok_or("no core")?;
            row.boards.insert(core.to_owned(), board);
        }
        if row.boards.is_empty() {
            return Err(
                format!("no board counts {} {} {}", row.map, row.disc, row.arithmetic).into()
            );
        }
    }
    Ok(format!("Boards counted by {}.", report["compiler"].as_str().unwrap_or("?")))
}
