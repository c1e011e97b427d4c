//! The lines of the golden files: a digest of every sequence, and of every sequence x map of an
//! arithmetic.
//!
//! `core` alone, without a heap: the tests of the host and the firmware compile this one source,
//! and what a board prints is compared with the file line by line.

use crate::digest::{Digest, Digestible};
use core::fmt::Arguments;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{
    MapVisitor, Parameters, SequenceVisitor, maps, power_maps, sequences_of,
};
use hemidisc::disc::Rejection;
use hemidisc::sequence::{Sequence, Shuffled, SobolOwen, Stored};
use hemidisc::{Domain, Error, Invert, Map, Points, UnitSquare};

/// Points of each digest: not a power of two, so that strata round and blocks have a tail.
const COUNT: u32 = 300;
const SEED: u32 = 7;
const EXPONENTS: [&str; 5] = ["0", "0.5", "1", "10", "10000"];

/// For sets of `count` points. A grid of 17 x 18 has six more, so that a set does not end with its
/// digest either.
const fn parameters(count: u32, seed: u32) -> Parameters {
    let parameters = Parameters::new(count, seed);
    if count == COUNT { Parameters { columns: 17, rows: 18, ..parameters } } else { parameters }
}

/// Takes a line without its end.
pub type Lines<'a> = &'a mut dyn FnMut(Arguments);

fn digest_of(points: impl Iterator<Item = impl Digestible>) -> u64 {
    let mut digest = Digest::new();
    points.for_each(|point| digest.value_of(point));
    digest.value()
}

/// A line for each set of one size and seed.
struct Squares<'a, 'b> {
    lines: Lines<'a>,
    size_and_seed: Arguments<'b>,
    count: u32,
}

impl SequenceVisitor for Squares<'_, '_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let digest = digest_of(sequence.iter(0).take(self.count as usize));
        (self.lines)(format_args!("{name} {} {digest:016x}", self.size_and_seed));
    }
}

/// `square.txt`: every sequence, in several sizes and seeds.
pub fn squares(lines: Lines) -> Result<(), Error> {
    for count in [1, 16, 256, 300, 4096] {
        for seed in [0, SEED] {
            let size_and_seed = format_args!("count={count} seed={seed}");
            let mut squares = Squares { lines: &mut *lines, size_and_seed, count };
            sequences_of(parameters(count, seed), &mut squares)?;
        }
    }
    Ok(())
}

/// A line for each sequence, shuffled.
struct Shuffles<'a>(Lines<'a>);

impl SequenceVisitor for Shuffles<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let shuffled = Shuffled::new(sequence, Domain::new(SEED));
        let digest = digest_of(shuffled.iter(0).take(COUNT as usize));
        (self.0)(format_args!("shuffled {name} {digest:016x}"));
    }
}

/// `domain.txt`: domains, their streams, and sets shuffled by them.
pub fn domains(lines: Lines) -> Result<(), Error> {
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
        lines(format_args!("domain {name} {:016x}", digest.value()));
    }
    sequences_of(parameters(COUNT, SEED), &mut Shuffles(lines))
}

/// A line for each map of an arithmetic over one sequence.
struct Mapped<'a> {
    lines: Lines<'a>,
    sequence: &'static str,
    stored: Stored<'a>,
    exponent: &'static str,
}

impl Mapped<'_> {
    fn line<M: Map<Point: Digestible>>(&mut self, map: &str, disc: &str, mapping: M) {
        let digest = digest_of(Points::new(self.stored, mapping).iter());
        let Self { sequence, exponent, .. } = self;
        (self.lines)(format_args!("{sequence} {map} {disc} {exponent} {digest:016x}"));
    }
}

impl<A: Arithmetic<Real: Digestible>> MapVisitor<A> for Mapped<'_> {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        self.line("disc", name, map);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.line(name, disc, map);
    }
}

/// Every map of an arithmetic over each sequence.
struct OfArithmetic<'a> {
    lines: Lines<'a>,
    /// The maps over one set of points: one piece of code for all sequences.
    maps: fn(Lines, &'static str, &[[u32; 2]]),
}

impl SequenceVisitor for OfArithmetic<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let mut points = [[0; 2]; COUNT as usize];
        for (slot, point) in points.iter_mut().zip(sequence.iter(0)) {
            *slot = point;
        }
        (self.maps)(self.lines, name, &points);
    }
}

fn mapped<A: Arithmetic<Real: Digestible>>(
    lines: Lines,
    sequence: &'static str,
    points: &[[u32; 2]],
) {
    let kept = digest_of(Rejection::<A, _>::new(points.iter().copied()));
    lines(format_args!("{sequence} disc rejection - {kept:016x}"));
    let Ok(stored) = Stored::new(points) else { return };
    let mut mapped = Mapped { lines, sequence, stored, exponent: "-" };
    mapped.line("square", "-", UnitSquare::<A>::new());
    maps::<A>(&mut mapped);
    for exponent in EXPONENTS {
        mapped.exponent = exponent;
        let Ok(parameter) = exponent.parse() else { continue };
        // An error leaves lines out, which the comparison detects.
        let _ = power_maps::<A>(parameter, &mut mapped);
    }
}

/// The file of one arithmetic, but for its first line where that names a library.
pub fn arithmetic<A: Arithmetic<Real: Digestible>>(lines: Lines) -> Result<(), Error> {
    sequences_of(parameters(COUNT, SEED), &mut OfArithmetic { lines, maps: mapped::<A> })
}
