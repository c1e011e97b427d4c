//! The examples, as programs to run.
//!
//! `cargo test` builds those examples that have no tests of their own, and none with `--test NAME`;
//! so a test has cargo build what it runs, which takes no time where it is there and fresh.

use hemidisc::catalogue::POWER_LOBES;
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;

/// Those that this process has had built.
static BUILT: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());

/// The program beside this test's: target/PROFILE/examples/NAME, this one being in deps.
pub fn program(name: &str) -> PathBuf {
    let test = std::env::current_exe().expect("the path of this program");
    let profile = test.parent().and_then(|deps| deps.parent()).expect("target/PROFILE/deps");
    let mut built = BUILT.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    if !built.contains(name) {
        let mut cargo = Command::new(env!("CARGO"));
        // From the root, so that all packages have the features that `cargo test` gives them.
        cargo.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        cargo.args(["build", "--quiet", "--all-features"]);
        let release = profile.ends_with("release");
        cargo.args(["--profile", if release { "release" } else { "test" }, "--example", name]);
        cargo.arg("--target-dir").arg(profile.parent().expect("target"));
        assert!(cargo.status().expect("cargo").success(), "{name} is not built");
        built.insert(name.to_owned());
    }
    profile.join("examples").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

/// A map as the programs' arguments name it, after `--map`: the kind is `disc` or a lobe, as
/// [`EachMap`](crate::errors::EachMap) has it. Power lobes alone take the exponent.
pub fn map_arguments(kind: &str, disc: &str, exponent: &str) -> String {
    if kind == "disc" {
        format!("disc-{disc}")
    } else if POWER_LOBES.contains(&kind) {
        format!("hemisphere-{kind} --disc {disc} --exponent {exponent}")
    } else {
        format!("hemisphere-{kind} --disc {disc}")
    }
}
