//! Digests of every sequence, and of every sequence x map x arithmetic, against tests/golden/.
//!
//! A digest pins the bytes that other tests have shown to be right, on every target. After an
//! intended change of output, with a line in CHANGELOG.md:
//!
//!     HEMIDISC_BLESS=1 cargo test --all-features --test golden
//!
//! A file whose values depend on another crate begins with its version in the lock file.
#![cfg(feature = "libm")]

use hemidisc::catalogue::AVAILABLE_ARITHMETICS;
#[cfg(feature = "micromath")]
use hemidisc::{
    FastF32,
    arithmetic::{Arithmetic, Real, Root},
    catalogue::EFFECTS,
};
use std::fmt::Write;
use std::path::Path;
use testkit::arithmetics::Tested;
#[cfg(feature = "micromath")]
use testkit::arithmetics::{EachRoot, every_root};
use testkit::golden::lines;
#[cfg(feature = "micromath")]
use testkit::golden::{bare, effects, render};

/// Compares with the file, or writes it where that is asked for.
fn compare(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    if std::env::var_os("HEMIDISC_BLESS").is_some() {
        std::fs::write(&path, text).unwrap();
    }
    let golden = std::fs::read_to_string(&path).unwrap();
    let different: Vec<_> = golden.lines().zip(text.lines()).filter(|(a, b)| a != b).collect();
    assert!(different.is_empty(), "{name}: golden and computed differ: {different:#?}");
    assert_eq!(golden.lines().count(), text.lines().count(), "{name}: lines");
}

#[test]
fn sequences_are_as_recorded() {
    let mut text = String::new();
    lines::squares(&mut |line| writeln!(text, "{line}").unwrap()).unwrap();
    compare("square.txt", &text);
}

#[test]
fn domains_are_as_recorded() {
    let mut text = String::new();
    lines::domains(&mut |line| writeln!(text, "{line}").unwrap()).unwrap();
    compare("domain.txt", &text);
}

/// An effect has lines of its own: its name alone, or before a space or a comma.
#[cfg(feature = "micromath")]
fn has_lines(text: &str, arithmetic: &str, effect: &str) {
    let start = format!("{arithmetic} {effect}");
    let mut rest = text.lines().filter_map(|line| line.strip_prefix(&start));
    assert!(rest.any(|rest| rest.starts_with([' ', ','])), "{start} has no line");
}

#[cfg(feature = "micromath")]
#[test]
fn effects_are_as_recorded() {
    let mut text = format!("# libm {}, micromath {}\n", locked("libm"), locked("micromath"));
    effects::file(&mut |line| writeln!(text, "{line}").unwrap()).unwrap();
    compare("effects.txt", &text);
    struct Named<'a>(&'a str);
    impl EachRoot for Named<'_> {
        fn each<A: Root<Real: Real> + Tested>(&mut self) {
            for effect in EFFECTS {
                has_lines(self.0, A::NAME, effect);
            }
        }
    }
    every_root(&mut Named(&text));
}

#[cfg(feature = "micromath")]
#[test]
fn pictures_are_as_recorded() {
    let mut text = format!("# micromath {}\n", locked("micromath"));
    render::file(&mut |line| writeln!(text, "{line}").unwrap()).unwrap();
    compare("render.txt", &text);
    for effect in EFFECTS {
        has_lines(&text, FastF32::NAME, effect);
    }
}

/// Without effects the picture is that of the renderer without them, bit for bit.
#[cfg(feature = "micromath")]
fn absent_effects_leave_no_trace<A: Root>() {
    render::with_bare::<A>(|scene| {
        for y in 0..render::SIZE[1] {
            let [mut found, mut bare] = [[[A::Real::default(); 3]; render::SIZE[0] as usize]; 2];
            scene.row([0, y], 0..3, &mut found);
            bare::row(&scene, [0, y], 0..3, &mut bare);
            let bits = |row: [[A::Real; 3]; _]| row.map(|pixel| pixel.map(|x| x.into().to_bits()));
            assert_eq!(bits(found), bits(bare), "{} row {y}", A::NAME);
        }
    })
    .unwrap();
}

#[cfg(feature = "micromath")]
testkit::test_each_float!(absent_effects_leave_no_trace);

/// The version of a dependency that the lock file pins.
fn locked(name: &str) -> &'static str {
    let entry = format!("name = \"{name}\"\nversion = \"");
    let (_, after) = include_str!("../Cargo.lock").split_once(&entry).unwrap();
    after.split('"').next().unwrap()
}

fn is_as_recorded<A: Tested>() {
    let head = A::LIBRARY.map(|library| format!("# {library} {}\n", locked(library)));
    let mut text = head.unwrap_or_default();
    lines::arithmetic::<A>(&mut |line| writeln!(text, "{line}").unwrap()).unwrap();
    compare(&format!("{}.txt", A::NAME), &text);
}

testkit::test_each_arithmetic!(is_as_recorded);

#[test]
fn every_arithmetic_has_a_file() {
    for name in AVAILABLE_ARITHMETICS {
        let path = format!("{}/tests/golden/{name}.txt", env!("CARGO_MANIFEST_DIR"));
        assert!(Path::new(&path).exists(), "{path} is missing");
    }
}
