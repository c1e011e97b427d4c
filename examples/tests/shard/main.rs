//! Shards together are the whole, byte for byte: the example `shard`, run as its users run it.

mod dying;
mod frames;
mod page;
mod parts;
mod points;
mod ranges;

use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use testkit::programs;

fn folder() -> TempDir {
    tempfile::tempdir().expect("a folder")
}

/// Status and standard error of an example that runs in a folder, with arguments that hold no
/// spaces.
fn run(example: &str, folder: &Path, arguments: &str) -> (i32, String) {
    let mut command = Command::new(programs::program(example));
    let output = command.args(arguments.split_whitespace()).current_dir(folder).output();
    let output = output.expect("the program runs");
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    (output.status.code().expect("not ended by a signal"), said)
}

/// The bytes of the file that `shard` makes in a folder.
#[track_caller]
fn made(folder: &Path, arguments: &str) -> Vec<u8> {
    let made = run("shard", folder, &format!("{arguments} --out made"));
    assert_eq!(made, (0, String::new()), "{arguments}");
    let bytes = std::fs::read(folder.join("made")).expect("a file");
    std::fs::remove_file(folder.join("made")).expect("a file");
    bytes
}

/// Computes shards one by one, as machines of their own do: I-of-K.part is left in the folder.
#[track_caller]
fn parts(folder: &Path, arguments: &str, shards: impl IntoIterator<Item = u16>, of: u16) {
    for shard in shards {
        let out = format!("{shard}-of-{of}.part");
        let arguments = format!("{arguments} --shards {of} --shard {shard} --out {out}");
        assert_eq!(run("shard", folder, &arguments), (0, String::new()), "{arguments}");
    }
}

/// The one line that `shard` refuses its arguments with.
#[track_caller]
fn refusal(folder: &Path, arguments: &str) -> String {
    let (status, said) = run("shard", folder, arguments);
    assert_eq!((status, said.lines().count()), (2, 1), "{arguments}: {said}");
    let message = said.trim_end().strip_prefix("error: ");
    message.unwrap_or_else(|| panic!("{arguments}: {said}")).to_owned()
}

/// Whether the folder holds files of these names and nothing else.
#[track_caller]
fn holds(folder: &Path, names: &[&str]) {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let found = entries.map(|entry| entry.expect("an entry").file_name().into_string());
    let mut found: Vec<_> = found.map(|name| name.expect("UTF-8")).collect();
    found.sort();
    assert_eq!(found, names);
}
