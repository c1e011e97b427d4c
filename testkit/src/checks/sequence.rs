//! Every sequence, of any parameters and seed: its promise, and that random access, iteration and
//! blocks agree.

mod promises;

use super::convert::assert_clear;
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::catalogue::Parameters;
use hemidisc::sequence::{Correlated, Sequence, Shuffled, Sobol, Stored};
use hemidisc::{Domain, Error, invariant};

#[derive(Arbitrary, Debug)]
struct Input {
    kind: Kind,
    /// Columns and rows, or a number of points.
    shape: [u32; 2],
    seed: u32,
    /// Of a run of points; and two points anywhere.
    start: u32,
    indices: [u32; 2],
    /// Size of an elementary interval: 2^-a, 3^-b.
    fine: [u8; 2],
    stored: Vec<[u32; 2]>,
}

/// Cells that are marked at most: enough for each shape of a set to occur, quick enough to try them
/// all.
const CELLS: u32 = 1024;
type Marks = [u32; CELLS as usize / 32];

macro_rules! kinds {
    ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*) => {
        #[derive(Arbitrary, Clone, Copy, Debug)]
        enum Kind {
            $($sequence,)*
            Stored,
            ShuffledSet,
            ShuffledSequence,
        }

        fn of_kind(input: &Input) {
            let Input { shape: [columns, rows], seed, .. } = *input;
            let domain = Domain::new(seed);
            let parameters = Parameters { columns, rows, count: columns, seed, domain };
            match input.kind {
                $(Kind::$sequence => {
                    type Listed = hemidisc::sequence::$sequence;
                    let make = || -> Result<Listed, Error> {
                        let made = hemidisc::made_by!($kind Listed::$new($(parameters.$part),*));
                        Ok(made)
                    };
                    listed(input, &[$(stringify!($part)),*], make());
                })*
                Kind::Stored => stored(input),
                Kind::ShuffledSet => shuffled_set(input, parameters),
                Kind::ShuffledSequence => {
                    let domain = Domain::new(input.indices[0]);
                    let shuffled = Shuffled::new(Sobol::new(seed), domain);
                    access(input, shuffled);
                    promises::net(input, shuffled);
                }
            }
        }
    };
}
hemidisc::for_each_sequence!(kinds);

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    of_kind(&Unstructured::new(data).arbitrary()?);
    Ok(())
}

/// A sequence of the list: what its constructor takes says what it accepts and how many points it
/// has.
fn listed<S: Sequence + 'static>(input: &Input, takes: &[&str], made: Result<S, Error>) {
    let sequence = if takes.contains(&"columns") {
        grid(input, made)
    } else if takes.contains(&"count") {
        set(input, made)
    } else {
        let sequence = made.unwrap();
        assert_eq!(sequence.size(), None);
        Some(sequence)
    };
    if let Some(sequence) = sequence {
        access(input, sequence);
        promises::of(input, &sequence);
    }
}

fn stored(input: &Input) {
    match Stored::new(&input.stored) {
        Ok(stored) => {
            access(input, stored);
            let index = input.indices[0];
            assert_eq!(stored.at(index), input.stored[index as usize % input.stored.len()]);
        }
        Err(error) => {
            assert_clear(&error);
            assert_eq!((error, input.stored.len()), (Error::EmptySet, 0));
        }
    }
}

fn shuffled_set(input: &Input, Parameters { columns, rows, seed, .. }: Parameters) {
    if let Some(set) = grid(input, Correlated::new(columns, rows, seed)) {
        access(input, set);
        let shuffled = Shuffled::new(set, Domain::new(seed ^ input.start));
        access(input, shuffled);
        promises::rooks(input, &shuffled);
    }
}

#[track_caller]
fn keep(result: Result<(), invariant::Violation>, what: &impl core::fmt::Debug) {
    if let Err(violation) = result {
        panic!("{violation}: {what:x?}");
    }
}

/// Every way to a point gives the same point, past the last index and past the end of a set too.
fn access(input: &Input, sequence: impl Sequence) {
    keep(invariant::consistent(&sequence, input.start), input);
    for (offset, point) in (0..100).zip(sequence.iter(input.start)) {
        assert_eq!(point, sequence.at(input.start.wrapping_add(offset)), "{input:x?}");
    }
    // Sought from the first point, and from one that is entered already.
    for n in input.indices {
        let mut points = sequence.iter(input.start);
        let index = input.start.wrapping_add(n);
        let found = [points.nth(n as usize), points.nth(1)];
        let expected = [index, index.wrapping_add(2)].map(|index| Some(sequence.at(index)));
        assert_eq!(found, expected, "{n:#x} after {input:x?}");
    }
    if let Some(size) = sequence.size() {
        for index in input.indices {
            assert_eq!(sequence.at(index), sequence.at(index % size), "{input:x?}");
        }
    }
}

/// A set of a number of points, or the error of an empty one.
fn set<S: Sequence>(input: &Input, made: Result<S, Error>) -> Option<S> {
    let count = input.shape[0];
    match made {
        Ok(set) => {
            assert_eq!(set.size(), Some(count));
            Some(set)
        }
        Err(error) => {
            assert_clear(&error);
            assert_eq!((error, count), (Error::EmptySet, 0));
            None
        }
    }
}

/// A set of a grid, of which a small one is marked whole; or the error of an empty or too large
/// one.
fn grid<S: Sequence>(input: &Input, made: Result<S, Error>) -> Option<S> {
    let [columns, rows] = input.shape;
    let size = u64::from(columns) * u64::from(rows);
    made.as_ref().err().into_iter().for_each(assert_clear);
    match made {
        Ok(set) => {
            assert_eq!(set.size().map(u64::from), Some(size));
            if size <= CELLS.into() {
                keep(invariant::cells(&set, 0, [columns, rows], &mut Marks::default()), input);
            }
            return Some(set);
        }
        Err(Error::EmptyGrid { .. }) => assert_eq!(size, 0),
        Err(Error::SetTooLarge { .. }) => assert!(size > u32::MAX.into(), "{input:x?}"),
        Err(other) => panic!("{other}"),
    }
    None
}
