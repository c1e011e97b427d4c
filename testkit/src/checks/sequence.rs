//! Every sequence, of any parameters and seed: its promise, and that random access, iteration and
//! blocks agree.

use super::convert::assert_clear;
use crate::strata::stratum;
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::sequence::{
    Correlated, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Random, Regular, Sequence,
    Shuffled, Sobol, SobolOwen, Stored,
};
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

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Kind {
    Regular,
    Random,
    Jittered,
    NRooks,
    MultiJittered,
    Correlated,
    Hammersley,
    Halton,
    Sobol,
    SobolOwen,
    R2,
    Stored,
    ShuffledSet,
    ShuffledSequence,
}

/// Cells that are marked at most: enough for each shape of a set to occur, quick enough to try them
/// all.
const CELLS: u32 = 1024;
type Marks = [u32; CELLS as usize / 32];

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let input: Input = Unstructured::new(data).arbitrary()?;
    let Input { shape: [m, n], seed, .. } = input;
    match input.kind {
        Kind::Regular => grid(&input, Regular::new(m, n), regular),
        Kind::Jittered => grid(&input, Jittered::new(m, n, seed), row_by_row),
        Kind::MultiJittered => grid(&input, MultiJittered::new(m, n, seed), |input, set| {
            row_by_row(input, set);
            rooks(input, set);
        }),
        Kind::Correlated => grid(&input, Correlated::new(m, n, seed), |input, set| {
            correlated(input, set);
            rooks(input, set);
        }),
        Kind::NRooks => set(&input, NRooks::new(m, seed), |input, set| {
            assert_eq!(stratum(set.at(input.indices[0])[0], m), input.indices[0] % m);
            rooks(input, set);
        }),
        Kind::Hammersley => set(&input, Hammersley::new(m), hammersley),
        Kind::Random => access(&input, Random::new(seed)),
        Kind::Halton => halton(&input),
        Kind::Sobol => {
            let sobol = Sobol::new(seed);
            net(&input, sobol);
            // Linear but for the shift, and the radical inverse on the first axis.
            let [i, j] = input.indices;
            let at = |index| sobol.at(index);
            let sum: [u32; 2] =
                core::array::from_fn(|axis| at(i)[axis] ^ at(j)[axis] ^ at(0)[axis]);
            assert_eq!(sum, at(i ^ j));
            assert_eq!(at(i)[0] ^ at(0)[0], i.reverse_bits());
        }
        Kind::SobolOwen => net(&input, SobolOwen::new(seed)),
        Kind::R2 => r2(&input, R2::new(seed)),
        Kind::Stored => match Stored::new(&input.stored) {
            Ok(stored) => {
                access(&input, stored);
                let index = input.indices[0];
                assert_eq!(stored.at(index), input.stored[index as usize % input.stored.len()]);
            }
            Err(error) => {
                assert_clear(&error);
                assert_eq!((error, input.stored.len()), (Error::EmptySet, 0));
            }
        },
        Kind::ShuffledSet => grid(&input, Correlated::new(m, n, seed), |input, set| {
            let shuffled = Shuffled::new(*set, Domain::new(seed ^ input.start));
            access(input, shuffled);
            rooks(input, &shuffled);
        }),
        Kind::ShuffledSequence => {
            net(&input, Shuffled::new(Sobol::new(seed), Domain::new(input.indices[0])));
        }
    }
    Ok(())
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
    if let Some(size) = sequence.size() {
        for index in input.indices {
            assert_eq!(sequence.at(index), sequence.at(index % size), "{input:x?}");
        }
    }
}

/// A set of a number of points, or the error of an empty one.
fn set<S: Sequence>(input: &Input, made: Result<S, Error>, promise: impl Fn(&Input, &S)) {
    let count = input.shape[0];
    match made {
        Ok(set) => {
            assert_eq!(set.size(), Some(count));
            access(input, set);
            promise(input, &set);
        }
        Err(error) => {
            assert_clear(&error);
            assert_eq!((error, count), (Error::EmptySet, 0));
        }
    }
}

/// A set of a grid, of which a small one is marked whole; or the error of an empty or too large
/// one.
fn grid<S: Sequence>(input: &Input, made: Result<S, Error>, promise: impl Fn(&Input, &S)) {
    let [columns, rows] = input.shape;
    let size = u64::from(columns) * u64::from(rows);
    made.as_ref().err().into_iter().for_each(assert_clear);
    match made {
        Ok(set) => {
            assert_eq!(set.size().map(u64::from), Some(size));
            access(input, set);
            if size <= CELLS.into() {
                keep(invariant::cells(&set, 0, [columns, rows], &mut Marks::default()), input);
            }
            promise(input, &set);
        }
        Err(Error::EmptyGrid { .. }) => assert_eq!(size, 0),
        Err(Error::SetTooLarge { .. }) => assert!(size > u32::MAX.into(), "{input:x?}"),
        Err(other) => panic!("{other}"),
    }
}

/// The centre of each cell, rounded down.
fn regular(input: &Input, set: &Regular) {
    let centre = |c: u32, of: u32| (((2 * u128::from(c) + 1) << 31) / u128::from(of)) as u32;
    let [m, n] = input.shape;
    for index in input.indices {
        let index = index % (m * n);
        assert_eq!(set.at(index), [centre(index % m, m), centre(index / m, n)], "{input:x?}");
    }
}

/// The point of an index is in the cell of the index.
fn row_by_row(input: &Input, set: &impl Sequence) {
    let [m, n] = input.shape;
    for index in input.indices {
        let index = index % (m * n);
        let [u, v] = set.at(index);
        assert_eq!([stratum(u, m), stratum(v, n)], [index % m, index / m], "{input:x?}");
    }
}

/// One point in each of N columns and of N rows: all of a small set, and two of a large one.
fn rooks(input: &Input, set: &impl Sequence) {
    let Some(size) = set.size() else { return };
    if size <= CELLS {
        keep(invariant::rooks(set, 0, size, &mut Marks::default()), input);
    }
    let [i, j] = input.indices.map(|index| index % size);
    for (a, b) in set.at(i).into_iter().zip(set.at(j)) {
        assert_eq!(stratum(a, size) == stratum(b, size), i == j, "{input:x?}");
    }
}

/// The fine strata are within the coarse ones, and rows permute their columns alike.
fn correlated(input: &Input, set: &Correlated) {
    let [m, n] = input.shape;
    let size = m * n;
    let [a, b] = input.indices.map(|index| {
        let [u, v] = set.at(index);
        let fine = [stratum(u, size), stratum(v, size)];
        assert_eq!([fine[0] / n, fine[1] / m], [stratum(u, m), stratum(v, n)], "{input:x?}");
        fine
    });
    assert_eq!(a[1] % m == b[1] % m, a[0] / n == b[0] / n, "{input:x?}");
    assert_eq!(a[1] / m == b[1] / m, a[0] % n == b[0] % n, "{input:x?}");
}

/// An aligned block of 2^m points.
fn net(input: &Input, sequence: impl Sequence) {
    access(input, sequence);
    let m = u32::from(input.fine[0]) % (CELLS.ilog2() + 1);
    keep(invariant::net(&sequence, input.start >> m << m, m, &mut Marks::default()), input);
}

fn hammersley(input: &Input, set: &Hammersley) {
    let count = input.shape[0];
    let index = input.indices[0] % count;
    let first = (u64::from(index) << 32).div_ceil(count.into()) as u32;
    assert_eq!(set.at(index), [first, index.reverse_bits()], "{input:x?}");
    if count.is_power_of_two() && count <= CELLS {
        keep(invariant::net(set, 0, count.ilog2(), &mut Marks::default()), input);
    }
}

/// The digits of the index, mirrored and rounded up to a cell; and any 2^a 3^b points in a row.
fn halton(input: &Input) {
    let halton = Halton::new();
    access(input, halton);
    for index in input.indices {
        let (mut left, mut mirror) = (index, 0_u64);
        for _ in 0..21 {
            mirror = mirror * 3 + u64::from(left % 3);
            left /= 3;
        }
        let exact = (u128::from(mirror) << 32).div_ceil(3_u128.pow(21)) as u32;
        assert_eq!(halton.at(index), [index.reverse_bits(), exact], "{input:x?}");
    }
    let [a, b] = input.fine;
    let shape = [1 << (a % 6), 3_u32.pow(u32::from(b % 4))];
    let start = input.start.min(u32::MAX - shape[0] * shape[1]);
    keep(invariant::cells(&halton, start, shape, &mut Marks::default()), input);
}

/// The same steps anywhere: 2^32 over the plastic number g and its square, odd where the promise
/// needs it.
fn r2(input: &Input, r2: R2) {
    access(input, r2);
    let step = |from: u32, by: u32| {
        let (a, b) = (r2.at(from), r2.at(from.wrapping_add(by)));
        [b[0].wrapping_sub(a[0]), b[1].wrapping_sub(a[1])]
    };
    let [i, by] = input.indices;
    let [u, v] = step(i, 1);
    assert_eq!(step(i, by), [u.wrapping_mul(by), v.wrapping_mul(by)], "{input:x?}");
    let g = 1.324_717_957_244_746_f64;
    assert!((f64::from(u) - 4_294_967_296.0 / g).abs() < 1.0, "{u}");
    assert!((f64::from(v) - 4_294_967_296.0 / (g * g)).abs() < 2.0 && v % 2 == 1, "{v}");
}
