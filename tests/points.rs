//! Points against a slice model: `next`, `next_back`, `nth`, `split_at`, `fill` and the rest, in
//! any order, give what the same operations on a slice of all points give.
#![cfg(feature = "libm")]

use hemidisc::bits::hash::mix;
use hemidisc::catalogue::{SequenceVisitor, sequences};
use hemidisc::sequence::{
    Correlated, Hammersley, R2, Random, Sequence, Shuffled, Sobol, SobolOwen, Stored,
};
use hemidisc::{
    Concentric, Cosine, Domain, Error, FastF32, Frame, LibmF32, LibmF64, Map, Points, Polar, Power,
    Uniform, UnitSquare,
};
use proptest::prelude::*;
use testkit::model::{Op, check_range, slice};

fn op() -> impl Strategy<Value = Op> {
    prop_oneof![
        4 => Just(Op::Next),
        4 => Just(Op::NextBack),
        2 => (0..9_usize).prop_map(Op::Nth),
        2 => (0..9_usize).prop_map(Op::NthBack),
        1 => (0..700_u32, any::<bool>()).prop_map(|(at, front)| Op::SplitKeep { at, front }),
        2 => (0..300_u16).prop_map(Op::Fill),
        1 => (0..700_u32).prop_map(Op::Get),
        1 => (0..4_u32, 0..5_u32).prop_map(|(shard, of)| Op::Shard { shard, of }),
        1 => (0..64_u32, 0..600_u32).prop_map(|(start, count)| Op::Range { start, count }),
    ]
}

/// Every sequence through one map.
struct Ranges<'a> {
    start: u32,
    ops: &'a [Op],
}

impl SequenceVisitor for Ranges<'_> {
    fn visit<S: Sequence>(&mut self, _: &'static str, sequence: S) {
        let start = if sequence.size().is_some() { self.start % 400 } else { self.start };
        check_range(sequence, Concentric::<LibmF32>::new(), [start, 500], self.ops);
    }
}

proptest! {
    #[test]
    fn points_are_a_slice(ops in prop::collection::vec(op(), 0..60), start in 0..1000_u32, end in any::<bool>()) {
        // Near the last index as well as the first.
        let start = if end { u32::MAX - start } else { start };
        let (disc, cosine) = (Concentric::<LibmF32>::new(), Cosine::<LibmF64>::new());
        sequences(473, 1, &mut Ranges { start, ops: &ops }).unwrap();
        check_range(SobolOwen::new(1), UnitSquare::<LibmF32>::new(), [start, 500], &ops);
        check_range(Random::new(1), cosine, [start, 500], &ops);
        let turned = cosine.about(Frame::new([0.0, 0.6, 0.8]).unwrap());
        check_range(Sobol::new(2), turned, [start, 500], &ops);
        check_range(R2::new(1), Polar::<LibmF32>::new(), [start, 500], &ops);
        // Blocks in passes, for exponents on both sides of where the kernel scales them.
        for e in [-0.5, 0.0, 50.0, 1e20] {
            check_range(Sobol::new(3), Power::<FastF32>::new(e).unwrap(), [start, 500], &ops);
        }
        check_range(Sobol::new(4), Uniform::over(Polar::<FastF32>::new()), [start, 500], &ops);
        let start = start % 400;
        let stored: Vec<_> = (0..450).map(|i| Random::new(2).at(i)).collect();
        check_range(Stored::new(&stored).unwrap(), disc, [start, 500], &ops);
        let shuffled = Shuffled::new(Correlated::new(20, 25, 1).unwrap(), Domain::new(1));
        check_range(shuffled, disc, [start, 500], &ops);
    }
}

/// Buffers of the given lengths, filled, against the slice.
fn check_components<M: Map<Point = [f32; D]>, const D: usize>(
    map: M,
    start: u32,
    lengths: [usize; D],
) {
    let count = 400.min(u32::MAX - start);
    let points = Points::with_range(Sobol::new(1), map, start..start + count).unwrap();
    let mut buffers = lengths.map(|length| vec![7.0; length]);
    let filled = points.fill_components(buffers.each_mut().map(Vec::as_mut_slice));
    let shortest = *lengths.iter().min().unwrap();
    assert_eq!(filled, shortest.min(count as usize));
    let model = slice(Sobol::new(1), map, start, count);
    for (axis, buffer) in buffers.iter().enumerate() {
        for (index, value) in buffer.iter().enumerate() {
            let expected = if index < filled { model[index][axis] } else { 7.0 };
            assert_eq!(value.to_bits(), expected.to_bits(), "{axis} of {index} from {start}");
        }
    }
}

proptest! {
    #[test]
    fn components_are_those_of_the_points(
        start in 0..1000_u32,
        end in any::<bool>(),
        lengths in [0..450_usize, 0..450, 0..450],
    ) {
        let start = if end { u32::MAX - start } else { start };
        let [x, y, z] = lengths;
        check_components(Concentric::<LibmF32>::new(), start, [x, y]);
        check_components(Concentric::<FastF32>::new(), start, [x, y]);
        check_components(Power::<FastF32>::new(50.0).unwrap(), start, [x, y, z]);
    }
}

#[test]
fn the_last_index_is_reached() {
    let (sequence, map) = (Sobol::new(0), Concentric::<LibmF32>::new());
    let last = Points::with_range(sequence, map, u32::MAX..=u32::MAX).unwrap();
    assert_eq!(last.iter().collect::<Vec<_>>(), [map.sample(sequence.at(u32::MAX))]);
    assert_eq!(Points::with_range(sequence, map, u32::MAX..).unwrap().len(), 1);
    assert_eq!(Points::with_range(sequence, map, ..).unwrap().len(), u32::MAX);
    assert_eq!(Points::with_range(sequence, map, 1..).unwrap().len(), u32::MAX);
    let error = Points::with_range(sequence, map, ..=u32::MAX).unwrap_err();
    assert_eq!(error, Error::Range { start: 0, count: 1 << 32, len: 1 << 32 });
    assert_eq!(
        error.to_string(),
        "a range of 4294967296 points; accepted: at most 4294967295 points"
    );
    let backward = core::ops::Range { start: 5, end: 3 };
    let error = Points::with_range(sequence, map, backward).unwrap_err();
    assert_eq!(error.to_string(), "a range from 5 to 3; accepted: an end not below the start");
    let set = Points::new(Hammersley::new(8).unwrap(), map);
    assert_eq!(set.len(), 8);
    assert!(set.range(8..8).is_ok() && set.range(8..9).is_err() && set.take(9).is_err());
    assert!(Points::with_range(Hammersley::new(8).unwrap(), map, 4..9).is_err());
}

/// Point by point this would take an hour.
#[test]
fn coordinates_are_sought() -> Result<(), Error> {
    let all = Points::with_range(SobolOwen::new(3), Concentric::<FastF32>::new(), 5..u32::MAX)?;
    for index in (0..1000).map(|i| mix(i) >> 1) {
        let (front, back) = (all.iter_coordinates(), all.iter_coordinates());
        assert_eq!(front.clone().nth(index as usize), all.coordinates(index));
        let from_the_end = all.len() - 1 - index;
        assert_eq!(back.clone().nth_back(index as usize), all.coordinates(from_the_end));
        let step = (index as usize).max(1 << 20);
        let steps = front.step_by(step).collect::<Vec<_>>();
        let expected = (0..all.len()).step_by(step).map(|i| all.coordinates(i).unwrap());
        assert!(expected.eq(steps), "every {step}");
    }
    Ok(())
}

#[test]
fn arrays_are_checked() {
    let set = Points::new(Hammersley::new(8).unwrap(), Concentric::<LibmF32>::new());
    let all: [_; 8] = set.to_array().unwrap();
    assert!(all.into_iter().eq(set.iter()));
    assert_eq!(set.to_array::<9>(), Err(Error::TooShort { len: 8, wanted: 9 }));
    assert_eq!(set.to_array::<0>(), Ok([]));
}

#[cfg(feature = "heapless")]
#[test]
fn heapless_vectors_do_not_panic() {
    let set = Points::new(Hammersley::new(8).unwrap(), Concentric::<LibmF32>::new());
    let mut vec: heapless::Vec<[f32; 2], 11> = heapless::Vec::new();
    assert_eq!(
        (set.extend_heapless(&mut vec), set.extend_heapless(&mut vec), vec.len()),
        (8, 3, 11)
    );
    assert_eq!(set.extend_heapless(&mut vec), 0);
    assert_eq!(set.to_heapless::<7>(), Err(Error::Capacity { len: 8, capacity: 7 }));
    let whole = set.to_heapless::<8>().unwrap();
    assert!(whole.iter().copied().eq(set.iter()));
    let collected: heapless::Vec<[f32; 2], 5> = set.iter().take(5).collect();
    assert_eq!(collected[..], whole[..5]);
}

#[cfg(feature = "rand")]
#[test]
fn maps_are_distributions() {
    use rand::distr::Distribution;
    use rand::{Rng, SeedableRng, rngs::SmallRng};
    let (disc, lobe) = (Concentric::<LibmF32>::new(), Cosine::<LibmF32>::new());
    let mut words = SmallRng::seed_from_u64(1);
    let mut uv = || [words.next_u32(), words.next_u32()];
    let mut rng = SmallRng::seed_from_u64(1);
    assert_eq!(Distribution::sample(&disc, &mut rng), Map::sample(&disc, uv()));
    assert_eq!(Distribution::sample(&lobe, &mut rng), Map::sample(&lobe, uv()));
}
