//! What is printed by the examples that write pictures into a folder, and what is wrong, on one line.

use std::io::{self, Write};
use std::path::Path;

/// What is wrong with the arguments, and what is accepted.
pub(crate) fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let first = text.lines().next().unwrap_or_default();
    format!("{}; accepted: --out DIR", first.trim_start_matches("error: "))
}

pub(crate) fn unwritable(path: &Path, error: &io::Error) -> String {
    format!("cannot write {}: {error}", path.display())
}

/// Prints a text; a reader that has seen enough of it (`| head`) is no error.
pub(crate) fn say(text: &str) -> io::Result<()> {
    match writeln!(io::stdout(), "{text}") {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}
