//! Points against a slice model: `next`, `next_back`, `nth`, `split_at`, `fill` and the rest, in
//! any order, give what the same operations on a slice of all points give; and `fill` gives what
//! `next` does in every map and arithmetic.

use super::convert::assert_clear;
use crate::arithmetics::{EachArithmetic, Exponent, Tested, every_arithmetic};
use crate::errors::{EachMap, each_map, each_power_map};
use crate::model::{Op, check_range};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::catalogue::AVAILABLE_ARITHMETICS;
use hemidisc::sequence::{
    Correlated, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Random, Regular, Sequence,
    Shuffled, Sobol, SobolOwen, Stored,
};
use hemidisc::{Concentric, Error, LibmF32, Map, Points};

#[derive(Arbitrary, Debug)]
struct Input {
    source: Source,
    start: u32,
    exponent: f32,
    /// Of which the maps are filled.
    arithmetic: u8,
    lengths: [u16; 2],
    ops: Vec<Op>,
}

/// Any sequence of any parameters.
#[derive(Arbitrary, Debug)]
enum Source {
    Regular(Regular),
    Random(Random),
    Jittered(Jittered),
    NRooks(NRooks),
    MultiJittered(MultiJittered),
    Correlated(Correlated),
    Hammersley(Hammersley),
    Halton(Halton),
    Sobol(Sobol),
    SobolOwen(SobolOwen),
    R2(R2),
    Stored(Box<[[u32; 2]; 90]>),
    ShuffledSet(Shuffled<Hammersley>),
    ShuffledSequence(Shuffled<Sobol>),
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let input: Input = Unstructured::new(data).arbitrary()?;
    match input.source {
        Source::Regular(set) => operations(set, &input),
        Source::Random(set) => operations(set, &input),
        Source::Jittered(set) => operations(set, &input),
        Source::NRooks(set) => operations(set, &input),
        Source::MultiJittered(set) => operations(set, &input),
        Source::Correlated(set) => operations(set, &input),
        Source::Hammersley(set) => operations(set, &input),
        Source::Halton(set) => operations(set, &input),
        Source::Sobol(set) => operations(set, &input),
        Source::SobolOwen(set) => operations(set, &input),
        Source::R2(set) => operations(set, &input),
        Source::Stored(ref points) => operations(Stored::new(&points[..]).unwrap(), &input),
        Source::ShuffledSet(set) => operations(set, &input),
        Source::ShuffledSequence(set) => operations(set, &input),
    }
    let turn = usize::from(input.arithmetic) % AVAILABLE_ARITHMETICS.len();
    every_arithmetic(&mut Filled { input: &input, name: AVAILABLE_ARITHMETICS[turn] });
    Ok(())
}

/// Points of a set: some before a block, a block or two, and some after.
const LONGEST: u32 = 150;

fn operations<S: Sequence>(sequence: S, input: &Input) {
    let start = input.start % sequence.size().unwrap_or(u32::MAX);
    let map = Concentric::<LibmF32>::new();
    check_range(sequence, map, [start, LONGEST], &input.ops);
    // Ranges that do not fit are refused.
    let [count, _] = input.lengths.map(u32::from);
    let len = sequence.size().map_or(1 << 32, u64::from);
    let fits = u64::from(input.start) + u64::from(count) <= len;
    let made = Points::of_range(sequence, map, input.start, count);
    let refused = Error::Range { start: input.start, count, len };
    made.as_ref().err().into_iter().for_each(assert_clear);
    assert_eq!(made.map(|points| points.len()), if fits { Ok(count) } else { Err(refused) });
    let one = Points::of_range(sequence, map, start, 1).unwrap();
    let refused = [one.shard(count, count).err(), one.to_array::<2>().err(), one.range(1, 1).err()];
    refused.into_iter().for_each(|error| assert_clear(&error.unwrap()));
    let left = len - u64::from(start);
    for (count, fits) in [(left, true), (left + 1, false)] {
        if let Ok(count) = u32::try_from(count) {
            assert_eq!(Points::of_range(sequence, map, start, count).is_ok(), fits, "{input:x?}");
        }
    }
}

/// Every map of an arithmetic: buffers that are filled by blocks, and by components.
struct Filled<'a> {
    input: &'a Input,
    name: &'static str,
}

impl EachArithmetic for Filled<'_> {
    fn each<A: Tested>(&mut self) {
        if A::NAME != self.name {
            return;
        }
        each_map::<A>(self);
        if let Some(parameter) = A::Parameter::exactly(self.input.exponent.into())
            && A::exponent(parameter).is_ok()
        {
            each_power_map::<A>(parameter, self);
        }
    }
}

impl<A: Tested> EachMap<A> for Filled<'_> {
    fn each<const D: usize, M: Map<Arithmetic = A, Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let Input { start, lengths, .. } = *self.input;
        let what = [A::NAME, kind, disc];
        let [count, component] = lengths.map(|length| usize::from(length) % 200);
        let start = start.min(u32::MAX - 200);
        let points = Points::of_range(Sobol::new(start), map, start, 200).unwrap();
        let mut buffer = [[A::Real::default(); D]; 200];
        assert_eq!(points.fill(&mut buffer[..count]), count);
        assert!(
            points.iter().take(count).eq(buffer[..count].iter().copied()),
            "{what:?}: {:x?}",
            self.input
        );
        let mut parts = [[A::Real::default(); 200]; D];
        let mut rest = parts.each_mut().map(|part| &mut part[..count]);
        rest[D - 1] = &mut core::mem::take(&mut rest[D - 1])[..component.min(count)];
        let filled = points.fill_components(rest);
        assert_eq!(filled, component.min(count));
        for (i, point) in buffer[..filled].iter().enumerate() {
            assert_eq!(*point, parts.map(|part| part[i]), "{what:?}: {:x?}", self.input);
        }
    }
}
