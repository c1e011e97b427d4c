//! The examples, as programs to run.
//!
//! `cargo test` builds the examples first; `cargo test --test NAME` alone does not, and then a test says that the
//! program is missing or stale.

use std::path::PathBuf;

/// The program beside this test's: target/PROFILE/examples/NAME, this one being in deps.
pub fn program(name: &str) -> PathBuf {
    let test = std::env::current_exe().expect("the path of this program");
    let profile = test.parent().and_then(|deps| deps.parent()).expect("target/PROFILE/deps");
    let program = profile.join("examples").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    let built = program.metadata().and_then(|file| file.modified());
    let built =
        built.unwrap_or_else(|_| panic!("no program: cargo build --profile test --example {name}"));
    // Cargo lists the sources of a program beside it.
    let sources = std::fs::read_to_string(program.with_extension("d")).unwrap_or_default();
    for source in sources.split_whitespace() {
        let edited = std::fs::metadata(source).and_then(|file| file.modified());
        let fresh = edited.is_ok_and(|edited| edited > built);
        assert!(
            !fresh,
            "the program is older than {source}: cargo build --profile test --example {name}"
        );
    }
    program
}
