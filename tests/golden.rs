//! Digests of every sequence, and of every sequence x map x arithmetic, against tests/golden/.
//!
//! A digest pins the bytes that other tests have shown to be right, on every target. After an
//! intended change of output, with a line in CHANGELOG.md:
//!
//!     HEMIDISC_BLESS=1 cargo test --all-features --test golden
//!
//! A file whose values depend on another crate begins with its version in the lock file.
#![cfg(feature = "libm")]

#[macro_use]
mod arithmetics;

use arithmetics::Tested;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{
    AVAILABLE_ARITHMETICS, MapVisitor, SequenceVisitor, maps, power_maps, sequences,
};
use hemidisc::disc::Rejection;
use hemidisc::invariant::{Digest, Digestible};
use hemidisc::sequence::{Sequence, Shuffled, SobolOwen, Stored};
use hemidisc::{Domain, Map, Points, UnitSquare};
use std::fmt::Write;
use std::path::Path;

/// Points of each digest: not a power of two, so that strata round and blocks have a tail.
const COUNT: u32 = 300;
const SEED: u32 = 7;
const EXPONENTS: [&str; 5] = ["0", "0.5", "1", "10", "10000"];

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

fn coordinates<S: Sequence>(sequence: S, count: u32) -> Vec<[u32; 2]> {
    sequence.iter(0).take(count as usize).collect()
}

/// A line for each set, of several sizes and seeds.
struct Squares<'a> {
    text: &'a mut String,
    label: String,
    count: u32,
}

impl SequenceVisitor for Squares<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let mut digest = Digest::new();
        for point in coordinates(sequence, self.count) {
            digest.value_of(point);
        }
        writeln!(self.text, "{name} {} {:016x}", self.label, digest.value()).unwrap();
    }
}

#[test]
fn sequences_are_as_recorded() {
    let mut text = String::new();
    for count in [1, 16, 256, 300, 4096] {
        for seed in [0, SEED] {
            let label = format!("count={count} seed={seed}");
            sequences(count, seed, &mut Squares { text: &mut text, label, count }).unwrap();
        }
    }
    compare("square.txt", &text);
}

/// A line for each sequence, shuffled.
struct Shuffles<'a>(&'a mut String);

impl SequenceVisitor for Shuffles<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let mut digest = Digest::new();
        for point in coordinates(Shuffled::new(sequence, Domain::new(SEED)), COUNT) {
            digest.value_of(point);
        }
        writeln!(self.0, "shuffled {name} {:016x}", digest.value()).unwrap();
    }
}

#[test]
fn domains_are_as_recorded() {
    let mut text = String::new();
    let root = Domain::new(SEED);
    for (name, domain) in [
        ("seed 0", Domain::new(0)),
        ("seed 7", root),
        ("child", root.child(1)),
        ("grandchild", root.child(1).child(2)),
        ("pixel", root.pixel(1, 2)),
        ("split", root.split(1, 4).domain()),
    ] {
        let (mut digest, stream) = (Digest::new(), domain.stream());
        digest.value_of(domain.seed());
        for index in (0..COUNT).chain([u32::MAX]) {
            digest.value_of(SobolOwen::in_domain(domain).at(index));
            digest.value_of([stream.at(index), stream.choose(index, 10)]);
        }
        writeln!(text, "domain {name} {:016x}", digest.value()).unwrap();
    }
    sequences(COUNT, SEED, &mut Shuffles(&mut text)).unwrap();
    compare("domain.txt", &text);
}

/// The coordinates of every sequence.
#[derive(Default)]
struct Collect(Vec<(&'static str, Vec<[u32; 2]>)>);

impl SequenceVisitor for Collect {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        self.0.push((name, coordinates(sequence, COUNT)));
    }
}

/// A line for each map of an arithmetic over one sequence.
struct Mapped<'a> {
    text: &'a mut String,
    sequence: &'static str,
    stored: Stored<'a>,
    exponent: &'static str,
}

impl Mapped<'_> {
    fn line<M: Map<Point: Digestible>>(&mut self, map: &str, disc: &str, mapping: M) {
        let mut digest = Digest::new();
        for point in &Points::new(self.stored, mapping) {
            digest.value_of(point);
        }
        let Self { sequence, exponent, .. } = self;
        writeln!(self.text, "{sequence} {map} {disc} {exponent} {:016x}", digest.value()).unwrap();
    }
}

impl<A: Arithmetic<Real: Digestible>> MapVisitor<A> for Mapped<'_> {
    fn disc<M: Map<Arithmetic = A, Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        self.line("disc", name, map);
    }

    fn hemisphere<M: Map<Arithmetic = A, Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.line(name, disc, map);
    }
}

/// The version of a dependency that the lock file pins.
fn locked(name: &str) -> &'static str {
    let entry = format!("name = \"{name}\"\nversion = \"");
    let (_, after) = include_str!("../Cargo.lock").split_once(&entry).unwrap();
    after.split('"').next().unwrap()
}

/// The file of one arithmetic.
fn digests<A: Tested>() -> String {
    let mut collect = Collect::default();
    sequences(COUNT, SEED, &mut collect).unwrap();
    let head = A::LIBRARY.map(|library| format!("# {library} {}\n", locked(library)));
    let mut text = head.unwrap_or_default();
    for (sequence, points) in &collect.0 {
        let mut kept = Digest::new();
        for point in Rejection::<A, _>::new(points.iter().copied()) {
            kept.value_of(point);
        }
        writeln!(text, "{sequence} disc rejection - {:016x}", kept.value()).unwrap();
        let stored = Stored::new(points).unwrap();
        let mut mapped = Mapped { text: &mut text, sequence, stored, exponent: "-" };
        mapped.line("square", "-", UnitSquare::<A>::new());
        maps::<A>(&mut mapped);
        for exponent in EXPONENTS {
            mapped.exponent = exponent;
            let parameter = exponent.parse().ok().unwrap();
            power_maps::<A>(parameter, &mut mapped).unwrap();
        }
    }
    text
}

fn is_as_recorded<A: Tested>() {
    compare(&format!("{}.txt", A::NAME), &digests::<A>());
}

each_arithmetic!(tests is_as_recorded);

#[test]
fn every_arithmetic_has_a_file() {
    for name in AVAILABLE_ARITHMETICS {
        let path = format!("{}/tests/golden/{name}.txt", env!("CARGO_MANIFEST_DIR"));
        assert!(Path::new(&path).exists(), "{path} is missing");
    }
}
