//! Mutation: each fault of `list.rs`, one line of `src`, is put in alone and must be caught by the
//! tests that the list names.
//!
//! A plain run only checks that the list still fits the source. To put the faults in, in a copy of
//! the tree, all of them or those whose text contains a word; the seconds of the table that it
//! prints include the build:
//!
//!     bash .ci/run faults
//!     HEMIDISC_FAULTS=rounding cargo test --test faults -- --nocapture

mod list;

use list::{FAULTS, Fault};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn every_fault_is_a_line_of_the_source() {
    assert!(FAULTS.len() >= 15);
    for fault in FAULTS {
        let text = fs::read_to_string(root().join("src").join(fault.file)).unwrap();
        let found = text.matches(fault.right).count();
        assert_eq!(found, 1, "{}: {} has the line {found} times", fault.what, fault.file);
        assert!(!fault.right.contains('\n') && fault.right != fault.wrong, "{}", fault.what);
        assert!(!fault.caught_by.is_empty(), "{}", fault.what);
    }
}

#[test]
fn every_fault_is_caught() {
    let Some(word) = std::env::var_os("HEMIDISC_FAULTS") else { return };
    let word = word.to_string_lossy();
    let chosen = |fault: &&Fault| word == "all" || fault.what.contains(&*word);
    let tree = copy_of_the_tree();
    let mut escaped = Vec::new();
    println!("| fault | in | caught by | s |\n| --- | --- | --- | ---: |");
    for fault in FAULTS.iter().filter(chosen) {
        let path = tree.join("src").join(fault.file);
        let right = fs::read_to_string(&path).unwrap();
        fs::write(&path, right.replacen(fault.right, fault.wrong, 1)).unwrap();
        let started = Instant::now();
        let failed = failures(&tree, fault);
        let seconds = started.elapsed().as_secs_f64();
        fs::write(&path, right).unwrap();
        let tests = failed.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
        println!("| {} | {} | {tests} | {seconds:.1} |", fault.what, fault.file);
        let caught = |test: &&&str| failed.iter().any(|name| name.starts_with(**test));
        let missed: Vec<_> = fault.caught_by.iter().filter(|test| !caught(test)).collect();
        if !missed.is_empty() {
            escaped.push(format!("{}: not by {missed:?}", fault.what));
        }
    }
    assert!(escaped.is_empty(), "{escaped:#?}");
}

/// What the tests need, where a fault harms nothing.
fn copy_of_the_tree() -> PathBuf {
    let tree = root().join("target/faults/tree");
    let needed = ["Cargo.toml", "Cargo.lock", "README.md", "CHANGELOG.md", "docs"];
    let sources = ["src", "testkit", "tests", "examples", "benches"];
    fs::create_dir_all(tree.join("fuzz")).unwrap();
    let fuzz = ["fuzz/corpus", "fuzz/fuzz_targets", "fuzz/Cargo.toml", "fuzz/hard.dict"];
    for name in needed.into_iter().chain(sources).chain(fuzz) {
        let into = tree.join(name);
        let _ = fs::remove_dir_all(&into);
        let copied =
            Command::new("cp").arg("-r").arg(root().join(name)).arg(&into).status().unwrap();
        assert!(copied.success(), "{name}");
    }
    tree
}

/// The tests that fail, of those named and of the corpora, as the list writes them.
fn failures(tree: &Path, fault: &Fault) -> BTreeSet<String> {
    let named = fault.caught_by.iter().map(|test| test.split("::").next().unwrap_or(test));
    let files: BTreeSet<&str> = named.chain(["corpus"]).collect();
    let mut failed = BTreeSet::new();
    for file in files {
        let mut cargo = Command::new("cargo");
        cargo.current_dir(tree).args(["test", "--package", "hemidisc"]);
        cargo.args(["--all-features", "--no-fail-fast"]);
        if file == "lib" {
            cargo.arg("--lib")
        } else {
            cargo.args(["--test", file])
        };
        cargo.args(["--target-dir", "../build"]).env_remove("HEMIDISC_FAULTS");
        // Built a few dozen times and run once each.
        cargo.envs([("CARGO_PROFILE_TEST_OPT_LEVEL", "0"), ("CARGO_PROFILE_TEST_DEBUG", "0")]);
        let output = cargo.output().unwrap();
        let text = String::from_utf8_lossy(&output.stdout);
        // Any test would catch a fault that does not compile.
        assert!(text.contains("test result:"), "{}", String::from_utf8_lossy(&output.stderr));
        let lines = text.lines().filter_map(|line| line.strip_suffix(" ... FAILED"));
        failed.extend(
            lines
                .filter_map(|line| line.strip_prefix("test "))
                .map(|name| format!("{file}::{name}")),
        );
    }
    failed
}
