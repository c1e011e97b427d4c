//! Points: the bytes of shards are those of the library's own loop.

use super::{folder, holds, made, parts};
use hemidisc::catalogue::{DISC_MAPS, LOBES, SequenceVisitor, sequences};
use hemidisc::sequence::{Sequence, SobolOwen};
use hemidisc::{Concentric, FastF32, Invert, Map, Points};
use testkit::arithmetics::{Exponent, Number, Tested};
use testkit::errors::{EachMap, each_map, each_power_map};
use testkit::programs::map_arguments;

/// A component's bits from their text, little-endian.
fn bytes_of<N: Number>(number: N) -> Vec<u8> {
    let raw = number.raw();
    let bits = match raw.strip_prefix("0x") {
        Some(digits) => u64::from_str_radix(digits, 16).unwrap(),
        None => raw.parse::<i64>().unwrap() as u64,
    };
    bits.to_le_bytes()[..size_of::<N>()].to_vec()
}

/// The points one by one.
fn plain<N: Number, const D: usize>(
    sequence: impl Sequence,
    map: impl Map<Point = [N; D]>,
    count: u32,
) -> Vec<u8> {
    let points = Points::with_range(sequence, map, ..count).unwrap();
    points.iter().flatten().flat_map(bytes_of).collect()
}

struct EachSequence;

impl SequenceVisitor for EachSequence {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let folder = folder();
        let expected = plain(sequence, Concentric::<FastF32>::new(), 200);
        assert_eq!(expected.len(), 1600);
        for shards in [1, 2, 3, 7, 201] {
            let arguments = format!(
                "points --sequence {name} --seed 9 --count 200 --map disc-concentric \
                 --arithmetic fast-f32 --shards {shards}"
            );
            assert!(made(folder.path(), &arguments) == expected, "{arguments}");
        }
        holds(folder.path(), &[]);
    }
}

#[test]
fn shards_of_every_sequence_are_the_whole() {
    sequences(200, 9, &mut EachSequence).unwrap();
}

#[test]
fn processes_are_the_whole() {
    // More than a block of coordinates, and fewer than shards.
    for (count, shards) in [(10_000, 1), (10_000, 2), (10_000, 3), (10_000, 7), (5, 7)] {
        let folder = folder();
        let expected = plain(SobolOwen::new(0), Concentric::<FastF32>::new(), count);
        let arguments = format!(
            "points --sequence=sobol-owen --count={count} --map=disc-concentric \
             --arithmetic=fast-f32 --threads=2"
        );
        for by in ["threads", "processes"] {
            let arguments = format!("{arguments} --shards={shards} --by={by}");
            assert!(made(folder.path(), &arguments) == expected, "{arguments}");
        }
        parts(folder.path(), &arguments, 0..shards, shards);
        let names = (0..shards).rev().map(|shard| format!("{shard}-of-{shards}.part"));
        let names = names.collect::<Vec<_>>().join(" ");
        assert!(made(folder.path(), &format!("merge {names}")) == expected, "{names}");
    }
}

/// Of the power lobe, as an argument.
const EXPONENT: &str = "2.5";

/// Compares every map of an arithmetic with its shards, and counts them.
struct Shards(usize);

impl<A: Tested> EachMap<A> for Shards {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let folder = folder();
        let expected = plain(SobolOwen::new(3), map, 70);
        let arguments = format!(
            "points --sequence sobol-owen --seed 3 --count 70 --map {} --arithmetic {} --shards 3",
            map_arguments(kind, disc, EXPONENT),
            A::NAME
        );
        assert!(made(folder.path(), &arguments) == expected, "{arguments}");
        self.0 += 1;
    }
}

fn shards_of_every_map_are_the_whole<A: Tested>() {
    let mut shards = Shards(0);
    each_map::<A>(&mut shards);
    each_power_map::<A>(A::Parameter::exactly(EXPONENT.parse().unwrap()).unwrap(), &mut shards);
    assert_eq!(shards.0, DISC_MAPS.len() * (1 + LOBES.len()));
}

testkit::test_each_arithmetic!(shards_of_every_map_are_the_whole);

#[test]
fn the_square_is_its_coordinates() {
    let folder = folder();
    let bytes =
        made(folder.path(), "points --sequence sobol-owen --count 70 --map square --shards 3");
    let expected = (0..70).flat_map(|index| SobolOwen::new(0).at(index)).flat_map(u32::to_le_bytes);
    assert!(bytes == expected.collect::<Vec<_>>());
}
