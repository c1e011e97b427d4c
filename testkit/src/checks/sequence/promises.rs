//! What each sequence promises besides: cells, strata, nets, formulas.

use super::{CELLS, Input, Marks, keep};
use crate::strata::stratum;
use hemidisc::invariant;
use hemidisc::sequence::{
    Correlated, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Regular, Sequence, Sobol,
    SobolOwen,
};
use std::any::Any;

/// The promise of a sequence; of a type that is not here, what holds for every sequence is all.
pub fn of(input: &Input, sequence: &dyn Any) {
    if let Some(set) = sequence.downcast_ref::<Regular>() {
        regular(input, set);
    }
    if let Some(set) = sequence.downcast_ref::<Jittered>() {
        row_by_row(input, set);
    }
    if let Some(set) = sequence.downcast_ref::<NRooks>() {
        let (index, count) = (input.indices[0], input.shape[0]);
        assert_eq!(stratum(set.at(index)[0], count), index % count);
        rooks(input, set);
    }
    if let Some(set) = sequence.downcast_ref::<MultiJittered>() {
        row_by_row(input, set);
        rooks(input, set);
    }
    if let Some(set) = sequence.downcast_ref::<Correlated>() {
        correlated(input, set);
        rooks(input, set);
    }
    if let Some(set) = sequence.downcast_ref::<Hammersley>() {
        hammersley(input, set);
    }
    if let Some(halton) = sequence.downcast_ref::<Halton>() {
        self::halton(input, *halton);
    }
    if let Some(sobol) = sequence.downcast_ref::<Sobol>() {
        self::sobol(input, *sobol);
    }
    if let Some(sequence) = sequence.downcast_ref::<SobolOwen>() {
        assert_eq!(*sequence, SobolOwen::new(input.seed));
        net(input, *sequence);
    }
    if let Some(r2) = sequence.downcast_ref::<R2>() {
        self::r2(input, *r2);
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
pub fn rooks(input: &Input, set: &impl Sequence) {
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
pub fn net(input: &Input, sequence: impl Sequence) {
    let m = u32::from(input.fine[0]) % (CELLS.ilog2() + 1);
    keep(invariant::net(&sequence, input.start >> m << m, m, &mut Marks::default()), input);
}

/// Linear but for the shift, and the radical inverse on the first axis.
fn sobol(input: &Input, sobol: Sobol) {
    net(input, sobol);
    let [i, j] = input.indices;
    let at = |index| sobol.at(index);
    let sum: [u32; 2] = core::array::from_fn(|axis| at(i)[axis] ^ at(j)[axis] ^ at(0)[axis]);
    assert_eq!(sum, at(i ^ j));
    assert_eq!(at(i)[0] ^ at(0)[0], i.reverse_bits());
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
fn halton(input: &Input, halton: Halton) {
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
