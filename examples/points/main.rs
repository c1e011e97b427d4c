//! Prints the points of a sequence through a map, one line each, for other programs to read.
//!
//! ```text
//! cargo run --release --example points -- --sequence sobol --count 16 --map disc-concentric
//! ```
//!
//! `arguments` reads the command line and the library's `refusal` says what is wrong with it,
//! `coordinates` makes the pairs of `u32`, `rows` maps and prints them and `field` is a number as
//! text. Sequences meet maps behind one `dyn Iterator`, so the program holds
//! sequences + maps x arithmetics loops, not the product of all three.

mod arguments;
mod coordinates;
mod field;
mod rows;

use arguments::Arguments;
use clap::Parser;
use examples::maps as names;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{ArithmeticVisitor, MapVisitor, arithmetics, maps, power_maps};
use hemidisc::{Invert, UnitSquare};
use rows::{Mapped, Rejected, Table, print_joint};
use std::io::{self, ErrorKind, Write};
use std::process::ExitCode;

/// Why nothing, or not everything, was printed.
enum Failure {
    /// Names the argument, what was wrong and what is accepted.
    Usage(String),
    Input(io::Error),
    Output(io::Error),
}

fn main() -> ExitCode {
    // No accepted argument has other letters than ASCII, so a lossy one fails like any wrong one.
    let given = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned());
    let result = match Arguments::try_parse_from(given) {
        Ok(arguments) => print(&arguments),
        Err(error) if error.use_stderr() => Err(Failure::Usage(arguments::one_line(&error))),
        Err(help) => write!(io::stdout(), "{help}").map_err(Failure::Output),
    };
    let (status, message) = match result {
        Ok(()) => return ExitCode::SUCCESS,
        // Whoever reads has seen enough.
        Err(Failure::Output(error)) if error.kind() == ErrorKind::BrokenPipe => {
            return ExitCode::SUCCESS;
        }
        Err(Failure::Usage(message)) => (2, message),
        Err(Failure::Input(error)) => (1, format!("standard input: {error}")),
        Err(Failure::Output(error)) => (1, format!("standard output: {error}")),
    };
    tell(&format!("error: {message}"));
    ExitCode::from(status)
}

/// One line on standard error; there is nowhere to say that it could not be written.
fn tell(line: &str) {
    let _ = writeln!(io::stderr(), "{line}");
}

fn print(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.is_joint()? {
        return print_joint(arguments);
    }
    let mut chosen = Chosen { arguments, result: None };
    arithmetics(&mut chosen);
    chosen.result.unwrap_or_else(|| Err(Failure::Usage(arguments.unknown_arithmetic())))
}

/// Prints with the arithmetic that the arguments name.
struct Chosen<'a> {
    arguments: &'a Arguments,
    result: Option<Result<(), Failure>>,
}

impl ArithmeticVisitor for Chosen<'_> {
    fn visit<A: Arithmetic>(&mut self) {
        if A::NAME == self.arguments.arithmetic {
            self.result = Some(print_in::<A>(self.arguments));
        }
    }
}

fn print_in<A: Arithmetic>(arguments: &Arguments) -> Result<(), Failure> {
    let table = Table::<A::Real>::new(arguments)?;
    let exponent = arguments.exponent::<A>()?;
    let map = arguments.map.as_str();
    if map == names::SQUARE {
        return table.print(&Mapped(UnitSquare::<A>::new()));
    }
    if map == names::REJECTION {
        return table.print(&Rejected::<A>::new());
    }
    let mut named = Named { map, disc: arguments.disc(), table, result: None };
    if names::takes_exponent(map) {
        let exponent =
            exponent.ok_or_else(|| Failure::Usage(arguments::missing_exponent::<A>(map)))?;
        power_maps::<A>(exponent, &mut named)
            .map_err(|error| Failure::Usage(format!("--exponent: {error}")))?;
    } else {
        maps::<A>(&mut named);
    }
    named
        .result
        .unwrap_or_else(|| Err(Failure::Usage(format!("--map: {map} is not in this build"))))
}

/// Prints with the map of a name.
struct Named<'a, R> {
    map: &'a str,
    disc: &'a str,
    table: Table<'a, R>,
    result: Option<Result<(), Failure>>,
}

impl<A: Arithmetic> MapVisitor<A> for Named<'_, A::Real> {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        if self.map.strip_prefix("disc-") == Some(name) {
            self.result = Some(self.table.print(&Mapped(map)));
        }
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        if self.map.strip_prefix("hemisphere-") == Some(name) && self.disc == disc {
            self.result = Some(self.table.print(&Mapped(map)));
        }
    }
}
