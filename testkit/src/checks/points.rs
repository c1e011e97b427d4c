//! Points against a slice model: `next`, `next_back`, `nth`, `split_at`, `fill` and the rest, in
//! any order, give what the same operations on a slice of all points give; and `fill` gives what
//! `next` does in every map and arithmetic.

use super::convert::assert_clear;
use crate::arithmetics::{EachArithmetic, Exponent, Tested, every_arithmetic};
use crate::errors::{EachMap, each_map, each_power_map};
use crate::model::{Op, check_range};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::catalogue::AVAILABLE_ARITHMETICS;
use hemidisc::sequence::{self, Hammersley, Sequence, Shuffled, Sobol, Stored};
use hemidisc::{Concentric, Error, Invert, LibmF32, Points};

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

macro_rules! sources {
    ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident $parts:tt;)*) => {
        /// Any sequence of any parameters.
        #[derive(Arbitrary, Debug)]
        enum Source {
            $($sequence(sequence::$sequence),)*
            Stored(Box<[[u32; 2]; 90]>),
            ShuffledSet(Shuffled<Hammersley>),
            ShuffledSequence(Shuffled<Sobol>),
        }

        fn of_source(input: &Input) {
            match input.source {
                $(Source::$sequence(sequence) => operations(sequence, input),)*
                Source::Stored(ref points) => operations(Stored::new(&points[..]).unwrap(), input),
                Source::ShuffledSet(set) => operations(set, input),
                Source::ShuffledSequence(sequence) => operations(sequence, input),
            }
        }
    };
}
hemidisc::for_each_sequence!(sources);

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let input: Input = Unstructured::new(data).arbitrary()?;
    of_source(&input);
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
    let last = input.start.saturating_add(count);
    let fits = u64::from(last) < len;
    let made = Points::with_range(sequence, map, input.start..=last);
    let points = u64::from(last - input.start) + 1;
    let refused = Error::Range { start: input.start.into(), count: points, len };
    made.as_ref().err().into_iter().for_each(assert_clear);
    let made = made.map(|made| u64::from(made.len()));
    assert_eq!(made, if fits && points < 1 << 32 { Ok(points) } else { Err(refused) });
    let one = Points::with_range(sequence, map, start..=start).unwrap();
    let backward = Points::with_range(sequence, map, input.start..input.start / 2);
    assert_eq!(backward.is_err(), input.start > 0, "{input:x?}");
    let refused = [one.shard(count, count).err(), one.to_array::<2>().err(), one.range(1..2).err()];
    let refused = refused.into_iter().map(Option::unwrap);
    refused.chain(backward.err()).for_each(|error| assert_clear(&error));
    // To the end and no further.
    let left = Points::with_range(sequence, map, start..).unwrap().len();
    assert_eq!(u64::from(left), (len - u64::from(start)).min(u32::MAX.into()), "{input:x?}");
    if let Ok(end) = u32::try_from(len) {
        assert!(Points::with_range(sequence, map, start..=end).is_err(), "{input:x?}");
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
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let Input { start, lengths, .. } = *self.input;
        let what = [A::NAME, kind, disc];
        let [count, component] = lengths.map(|length| usize::from(length) % 200);
        let start = start.min(u32::MAX - 200);
        let points = Points::with_range(Sobol::new(start), map, start..start + 200).unwrap();
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
