//! The command line of a bench, and how a run ends.

use crate::failure::Failure;
use std::io::{self, Write};
use std::process::ExitCode;

/// What to do.
pub struct Arguments {
    /// Criterion's timings, which take other arguments too.
    pub timings: bool,
    /// The tables of ratios.
    pub ratios: bool,
    /// The shortest of this run and of those before.
    pub merge: bool,
    /// Everything once.
    pub test: bool,
}

impl Arguments {
    fn new(given: &[String]) -> Result<Self, String> {
        let has = |name: &str| given.iter().any(|argument| argument == name);
        // `cargo bench` passes this; criterion, too, takes anything else for a test.
        let test = has("--test") || !has("--bench");
        let mut others =
            given.iter().filter(|given| !["--bench", "--test"].contains(&given.as_str()));
        if !has("--ratios") {
            let alone = others.next().is_none();
            return Ok(Self { timings: true, ratios: alone, merge: false, test });
        }
        match others.find(|given| !["--ratios", "--merge"].contains(&given.as_str())) {
            Some(other) => Err(format!("`{other}`: beside --ratios there are --merge and --test")),
            None => Ok(Self { timings: false, ratios: true, merge: has("--merge"), test }),
        }
    }
}

/// A bench's `main`: reads the command line, runs, and reports an error.
pub fn main(run: impl FnOnce(&Arguments) -> Result<(), Failure>) -> ExitCode {
    let given: Vec<_> = std::env::args().skip(1).collect();
    let (status, message) = match Arguments::new(&given) {
        Ok(arguments) => match run(&arguments) {
            Ok(()) => return ExitCode::SUCCESS,
            Err(error) => (1, error.to_string()),
        },
        Err(message) => (2, message),
    };
    // There is nowhere to report a failed write.
    let _ = writeln!(io::stderr(), "error: {message}");
    ExitCode::from(status)
}
