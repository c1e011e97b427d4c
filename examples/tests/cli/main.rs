//! The command line of the example `points`, which other programs rely on: run as they run it.

mod arguments;
mod coordinates;
mod maps;

use hemidisc::sequence::Random;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, Command, Stdio};
use testkit::programs::program;

/// What a run has left.
#[derive(Debug)]
struct Run {
    status: i32,
    stdout: String,
    stderr: String,
}

impl Run {
    /// The header and the rows of a run that said nothing on standard error.
    #[track_caller]
    fn quiet(self) -> (String, Vec<String>) {
        assert_eq!((self.status, self.stderr.as_str()), (0, ""));
        self.table()
    }

    #[track_caller]
    fn table(&self) -> (String, Vec<String>) {
        assert!(self.stdout.ends_with('\n'), "the last line is not ended: {self:?}");
        let mut lines = self.stdout.lines().map(str::to_owned);
        (lines.next().expect("a header"), lines.collect())
    }
}

/// Runs with arguments that hold no spaces.
fn points(arguments: &str) -> Run {
    run(&arguments.split_whitespace().collect::<Vec<_>>(), b"")
}

/// Runs on coordinates from standard input.
fn points_of(pairs: &[[u32; 2]], arguments: &str) -> Run {
    let lines: Vec<_> = pairs.iter().map(hex).collect();
    let arguments: Vec<_> = arguments.split_whitespace().chain(["--stdin"]).collect();
    run(&arguments, lines.join("\n").as_bytes())
}

fn run(arguments: &[&str], input: &[u8]) -> Run {
    /// Far more than any test asks for, lest a wrong range of 2^32 rows fill the memory.
    const MOST: u64 = 1 << 24;
    let mut command = Command::new(program("points"));
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    std::thread::scope(|scope| {
        // A run that refuses its arguments does not read, so the pipe may break.
        scope.spawn(move || drop(stdin.write_all(input)));
        let mut stdout = String::new();
        let mut pipe = child.stdout.take().expect("a pipe").take(MOST);
        pipe.read_to_string(&mut stdout).expect("UTF-8");
        drop(pipe);
        let (status, stderr) = end(child);
        Run { status, stdout, stderr }
    })
}

/// Status and standard error of a program whose output has been read.
fn end(child: Child) -> (i32, String) {
    let output = child.wait_with_output().expect("the program ends");
    let stderr = String::from_utf8(output.stderr).expect("UTF-8");
    (output.status.code().expect("not ended by a signal"), stderr)
}

/// Reads at most `most` lines and leaves; status, lines and standard error.
fn leave_after(most: usize, arguments: &str) -> (i32, Vec<String>, String) {
    let mut command = Command::new(program("points"));
    command.args(arguments.split_whitespace()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    let stdout = BufReader::new(child.stdout.take().expect("a pipe"));
    let lines = stdout.lines().take(most).map(|line| line.expect("UTF-8")).collect();
    let (status, stderr) = end(child);
    (status, lines, stderr)
}

/// A pair as the program prints it.
fn hex([u, v]: &[u32; 2]) -> String {
    format!("0x{u:08x},0x{v:08x}")
}

fn hexes(pairs: impl IntoIterator<Item = [u32; 2]>) -> Vec<String> {
    pairs.into_iter().map(|pair| hex(&pair)).collect()
}

/// Compares rows, and says where they differ first.
#[track_caller]
fn same(actual: &[String], expected: impl IntoIterator<Item = String>, what: &str) {
    let expected: Vec<_> = expected.into_iter().collect();
    let differs = actual.iter().zip(&expected).position(|(actual, expected)| actual != expected);
    if let Some(row) = differs {
        panic!("{what}: row {row} is {}, not {}", actual[row], expected[row]);
    }
    assert_eq!(actual.len(), expected.len(), "{what}: number of rows");
}

/// The coordinates that a row of hexadecimal fields starts with.
fn pair(row: &str) -> [u32; 2] {
    let cell = |text: &str| u32::from_str_radix(text.strip_prefix("0x")?, 16).ok();
    let mut cells = row.split(',').map(|text| cell(text).unwrap_or_else(|| panic!("{row}")));
    [(); 2].map(|()| cells.next().expect("two fields"))
}

/// The rows of `--map square`.
#[track_caller]
fn square(arguments: &str) -> Vec<String> {
    let (header, rows) = points(&format!("{arguments} --map square")).quiet();
    assert_eq!(header, "u,v");
    rows
}

/// Coordinates on and beside every fold of the maps, in all pairs, and random ones.
fn hard_pairs() -> Vec<[u32; 2]> {
    let folds = (0..=8_u32).map(|eighth| eighth.wrapping_mul(1 << 29));
    let near = folds.flat_map(|fold| [fold.wrapping_sub(1), fold, fold.wrapping_add(1)]);
    let near: Vec<_> = near.collect();
    let all = near.iter().flat_map(|u| near.iter().map(|v| [*u, *v]));
    all.chain((0..2000).map(|index| Random::new(7).at(index))).collect()
}
