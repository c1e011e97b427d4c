//! Output and one-line errors of the examples that write pictures into a folder.

use clap::Parser;
use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

/// What is wrong with the arguments, and what is accepted.
fn one_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let first = text.lines().next().unwrap_or_default();
    format!("{}; accepted: --out DIR", first.trim_start_matches("error: "))
}

pub fn unwritable(path: &Path, error: &io::Error) -> String {
    format!("cannot write {}: {error}", path.display())
}

/// Prints a text; a reader that has seen enough of it (`| head`) is no error.
pub fn say(text: &str) -> io::Result<()> {
    match writeln!(io::stdout(), "{text}") {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// Reads the arguments and runs an example with them: the status, after one line on what is wrong.
pub fn answer<A: Parser>(
    name: &str,
    run: impl FnOnce(A) -> Result<(), Box<dyn Error>>,
) -> ExitCode {
    let result = match A::try_parse() {
        Ok(arguments) => run(arguments).map_err(|error| error.to_string()),
        // Help goes to standard output and is not an error.
        Err(help) if !help.use_stderr() => help.print().map_err(|error| error.to_string()),
        Err(error) => Err(one_line(&error)),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{name}: {message}");
            ExitCode::from(2)
        }
    }
}
