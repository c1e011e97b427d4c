//! Every file of the fuzz corpora through the check of its target, on stable, as the fuzzer runs
//! it.
#![cfg(all(
    feature = "libm",
    feature = "micromath",
    feature = "fixed-point",
    feature = "arbitrary"
))]

use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use testkit::checks::CHECKS;

/// A folder of the fuzzing workspace, by name.
fn fuzz(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz").join(name)
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// No file is refused: a corpus holds valid inputs only.
fn replay(target: &str) {
    let (_, check) = CHECKS.iter().find(|(name, _)| *name == target).unwrap();
    let files = files(&fuzz("corpus").join(target));
    assert!(!files.is_empty(), "{target}: no corpus");
    for file in &files {
        // Said of the last one where it fails.
        println!("{}", file.display());
        assert_eq!(check(&std::fs::read(file).unwrap()), Ok(()));
    }
}

/// A test of each target.
macro_rules! replayed {
    ($($target:ident)*) => {
        const REPLAYED: &[&str] = &[$(stringify!($target)),*];
        $(
            #[test]
            fn $target() {
                replay(stringify!($target));
            }
        )*
    };
}
replayed!(map sequence points domain frame effects render convert);

/// A target is a file, a binary of the manifest, a check, a corpus and a test.
#[test]
fn every_target_is_listed() {
    assert!(CHECKS.iter().map(|(name, _)| name).eq(REPLAYED));
    let expected: BTreeSet<_> = REPLAYED.iter().map(|name| (*name).to_owned()).collect();
    let stem = |path: &PathBuf| path.file_stem().unwrap().to_string_lossy().into_owned();
    for folder in ["fuzz_targets", "corpus"] {
        let found: BTreeSet<_> = files(&fuzz(folder)).iter().map(stem).collect();
        assert_eq!(found, expected, "{folder}");
    }
    let manifest = std::fs::read_to_string(fuzz("Cargo.toml")).unwrap();
    for name in expected {
        assert!(manifest.contains(&format!("name = \"{name}\"\n")), "no binary {name}");
    }
}

/// The dictionary has the hard values: powers of two of coordinates with their neighbours,
/// exponents and numbers at the ends of their ranges. To write it anew:
///
///     HEMIDISC_BLESS=1 cargo test --test corpus
#[test]
fn the_dictionary_is_of_hard_values() {
    let mut text =
        String::from("# Hard coordinates, exponents and numbers: written by `tests/corpus.rs`.\n");
    let mut line = |kind: &str, value: &str, bytes: &[u8]| {
        let bytes: String = bytes.iter().map(|byte| format!("\\x{byte:02x}")).collect();
        writeln!(text, "# {kind} {value}\n\"{bytes}\"").unwrap();
    };
    for bit in [0, 1, 8, 15, 16, 23, 24, 30, 31_u32] {
        let step = 1_u32 << bit;
        for k in [step, step - 1, step + 1, step.wrapping_neg()] {
            line("coordinate", &format!("{k:#010x}"), &k.to_le_bytes());
        }
    }
    let exponents =
        [-1.0, -1.0 + f64::from(f32::EPSILON) / 2.0, -0.5, 0.5, 1.0, 10.0, 1e4, 1e8, 1e20];
    let numbers = [f64::NAN, f64::INFINITY, -0.0, 1.0 - f64::EPSILON / 2.0, 1.0 - 0.5_f64.powi(24)];
    let ends = [f32::MAX, f32::MIN_POSITIVE, f32::from_bits(1)].map(f64::from);
    for value in exponents.into_iter().chain(numbers).chain(ends) {
        line("f32", &format!("{value:e}"), &(value as f32).to_le_bytes());
        line("f64", &format!("{value:e}"), &value.to_le_bytes());
    }
    for value in [f64::MAX, f64::MIN_POSITIVE, f64::from_bits(1), 1e200, 1e-200] {
        line("f64", &format!("{value:e}"), &value.to_le_bytes());
    }
    for count in [1_u64, 10, 100_000_000] {
        line("fixed-point exponent", &format!("{count} / 2^32"), &count.to_le_bytes());
        line("fixed-point exponent", &format!("{count}"), &(count << 32).to_le_bytes());
    }
    let path = fuzz("hard.dict");
    if std::env::var_os("HEMIDISC_BLESS").is_some() {
        std::fs::write(&path, &text).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&path).unwrap(), text);
}
