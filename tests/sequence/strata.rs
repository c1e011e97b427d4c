//! The strata of the sets: the cells of a grid, and the columns and rows of rooks.

use hemidisc::{
    bits::hash::mix,
    invariant,
    sequence::{
        Correlated, Hammersley, Jittered, MultiJittered, NRooks, Random, Regular, Sequence,
        Shuffled, SobolOwen, grid,
    },
};
use std::collections::{HashMap, HashSet};
use testkit::chi_square::{assert_random, assert_uniform};
use testkit::strata::stratum;

const SEEDS: [u32; 6] = [0, 1, 7, 0x8000_0000, 0x2000_0000, u32::MAX];

/// Fails unless `hits` is each of 0 .. `count` once.
pub(crate) fn assert_each_once(count: u32, hits: impl Iterator<Item = u32>, what: &str) {
    let mut seen = vec![false; count as usize];
    let mut total = 0;
    for hit in hits {
        assert!(hit < count, "{what}: stratum {hit} of {count}");
        assert!(!seen[hit as usize], "{what}: stratum {hit} of {count} hit twice");
        seen[hit as usize] = true;
        total += 1;
    }
    assert_eq!(total, count, "{what}: strata hit");
}

fn all(set: impl Sequence) -> Vec<[u32; 2]> {
    (0..set.size().unwrap()).map(|i| set.at(i)).collect()
}

/// One point in each cell of a grid; cell i holds point i where the order is row by row.
fn assert_grid(set: impl Sequence, [m, n]: [u32; 2], row_by_row: bool, what: &str) {
    assert_eq!(set.size(), Some(m * n), "{what}");
    let cells: Vec<u32> =
        all(set).iter().map(|&[u, v]| stratum(v, n) * m + stratum(u, m)).collect();
    if row_by_row {
        assert!(cells.iter().zip(0..).all(|(&cell, i)| cell == i), "{what}: not row by row");
    }
    assert_each_once(m * n, cells.into_iter(), what);
}

/// One point in each of N columns and in each of N rows.
fn assert_rooks(set: impl Sequence, what: &str) {
    let points = all(set);
    let count = points.len() as u32;
    for (axis, name) in ["columns", "rows"].into_iter().enumerate() {
        let hits = points.iter().map(|point| stratum(point[axis], count));
        assert_each_once(count, hits, &format!("{what}: {name}"));
    }
}

fn assert_shape([m, n]: [u32; 2], seed: u32) {
    let what = |name: &str| format!("{name} {m} x {n}, seed {seed:#x}");
    assert_grid(Jittered::new(m, n, seed).unwrap(), [m, n], true, &what("jittered"));
    let multi = MultiJittered::new(m, n, seed).unwrap();
    assert_grid(multi, [m, n], true, &what("multi-jittered"));
    assert_rooks(multi, &what("multi-jittered"));
    let correlated = Correlated::new(m, n, seed).unwrap();
    assert_grid(correlated, [m, n], false, &what("correlated"));
    assert_rooks(correlated, &what("correlated"));
}

fn assert_count(count: u32, seed: u32) {
    let what = format!("n-rooks {count}, seed {seed:#x}");
    let rooks = NRooks::new(count, seed).unwrap();
    assert_eq!(rooks.size(), Some(count), "{what}");
    assert_rooks(rooks, &what);
}

fn assert_seedless(count: u32, [m, n]: [u32; 2]) {
    let regular = Regular::new(m, n).unwrap();
    assert_grid(regular, [m, n], true, &format!("regular {m} x {n}"));
    let centre = |c: u32, of: u32| (((2 * u128::from(c) + 1) << 31) / u128::from(of)) as u32;
    for (i, point) in (0..).zip(all(regular)) {
        assert_eq!(point, [centre(i % m, m), centre(i / m, n)], "regular {m} x {n}, point {i}");
    }
    let columns = all(Hammersley::new(count).unwrap());
    let hits = columns.iter().map(|[u, _]| stratum(*u, count));
    assert!(hits.eq(0..count), "hammersley {count}: not one point in each column, in order");
}

#[test]
fn every_count_to_300() {
    for count in 1..=300 {
        assert_seedless(count, grid(count));
        for seed in SEEDS {
            assert_shape(grid(count), seed);
            assert_count(count, seed);
        }
    }
}

#[test]
fn every_shape_to_24_x_24() {
    for (m, n) in (1..=24).flat_map(|m| (1..=24).map(move |n| (m, n))) {
        assert_seedless(m * n, [m, n]);
        assert_shape([m, n], mix(m * 32 + n));
    }
}

#[test]
fn long_thin_and_prime_shapes() {
    let shapes = [[1, 9973], [9973, 1], [1, 65_536], [65_537, 3], [3, 65_537], [127, 131]];
    for [m, n] in shapes.into_iter().chain([[256, 256], [1000, 10], [7, 1024]]) {
        assert_seedless(m * n, [m, n]);
        assert_count(m * n, m);
        for seed in [0, u32::MAX] {
            assert_shape([m, n], seed);
        }
    }
}

/// Sets near 2^32 points, on a sample of their indices: the first, the last, and hashed ones.
#[test]
fn sets_too_large_to_enumerate() {
    let shapes = [
        [65_537, 65_535],
        [1, u32::MAX],
        [u32::MAX, 1],
        [1, 1 << 31],
        [3, 1_431_655_765],
        [65_536, 7],
    ];
    for [m, n] in shapes {
        let size = m * n;
        let ends = (0..100).flat_map(|i| [i, size - 1 - i]);
        let indices: HashSet<u32> = ends.chain((0..20_000).map(|i| mix(i) % size)).collect();
        let (regular, jittered) = (Regular::new(m, n).unwrap(), Jittered::new(m, n, 7).unwrap());
        let multi = MultiJittered::new(m, n, 7).unwrap();
        let correlated = Correlated::new(m, n, 7).unwrap();
        let (rooks, hammersley) = (NRooks::new(size, 7).unwrap(), Hammersley::new(size).unwrap());
        let mut hits: [HashSet<u32>; 5] = Default::default();
        let [mut columns, mut rows] = [HashMap::new(), HashMap::new()];
        for &i in &indices {
            let what = format!("point {i} of {m} x {n}");
            // In strata of less than two cells the cell of a centre may begin in the one before.
            let regular = if m.max(n) <= 1 << 31 { regular.at(i) } else { jittered.at(i) };
            for [u, v] in [regular, jittered.at(i), multi.at(i)] {
                assert_eq!([stratum(u, m), stratum(v, n)], [i % m, i / m], "{what}");
            }
            for [u, _] in [rooks.at(i), hammersley.at(i)] {
                assert_eq!(stratum(u, size), i, "{what}");
            }
            let [u, v] = correlated.at(i);
            // Fine row r m + c tells the column c before its permutation; the column u lies in
            // must be the same for all rows, and fine columns likewise.
            let (fine_column, fine_row) = (stratum(u, size), stratum(v, size));
            assert_eq!([fine_column / n, fine_row / m], [stratum(u, m), stratum(v, n)], "{what}");
            let column = *columns.entry(fine_row % m).or_insert(fine_column / n);
            let row = *rows.entry(fine_row / m).or_insert(fine_column % n);
            assert_eq!([column, row], [fine_column / n, fine_column % n], "{what}: correlated");
            let [multi_u, multi_v] = multi.at(i);
            for (hits, cell) in hits.iter_mut().zip([u, v, multi_u, multi_v, rooks.at(i)[1]]) {
                hits.insert(stratum(cell, size));
            }
        }
        for hits in hits {
            assert_eq!(hits.len(), indices.len(), "{m} x {n}: a fine stratum is hit twice");
        }
    }
}

/// Within their strata the jittered sets are uniformly random: 16 x 16 cells of a cell.
#[test]
fn jitter_is_uniform() {
    fn check(set: impl Sequence, [m, n]: [u32; 2], what: &str) {
        let within = |k: u32, count: u32| (k.wrapping_mul(count) >> 28) as usize;
        let mut counts = [0; 256];
        for [u, v] in all(set) {
            counts[within(u, m) * 16 + within(v, n)] += 1;
        }
        assert_random(&counts, what);
    }
    for seed in SEEDS {
        let (m, n) = (90, 110);
        let size = m * n;
        let what = |name: &str| format!("{name}, seed {seed:#x}");
        check(Jittered::new(m, n, seed).unwrap(), [m, n], &what("jittered"));
        check(NRooks::new(size, seed).unwrap(), [size; 2], &what("n-rooks"));
        check(MultiJittered::new(m, n, seed).unwrap(), [size; 2], &what("multi-jittered"));
        check(Correlated::new(m, n, seed).unwrap(), [size; 2], &what("correlated"));
    }
}

/// Over seeds, each arrangement that the promises allow comes equally often: 3 x 4 cells, 12 x 12
/// fine ones.
#[test]
fn arrangements_are_random() {
    let fine = |[u, v]: [u32; 2]| [stratum(u, 12), stratum(v, 12)];
    let (mut rooks, mut order) = (vec![0; 12], vec![0; 144]);
    let (mut within, mut columns, mut rows) = (vec![0; 12], vec![0; 16], vec![0; 9]);
    for seed in 0..30_000 {
        rooks[fine(NRooks::new(12, seed).unwrap().at(5))[1] as usize] += 1;
        let [column, row] = fine(Correlated::new(3, 4, seed).unwrap().at(5));
        order[(column * 12 + row) as usize] += 1;
        let multi = MultiJittered::new(3, 4, seed).unwrap();
        let [[a, b], [right, _], [_, below]] = [0, 1, 3].map(|i| fine(multi.at(i)));
        within[(a % 4 * 3 + b % 3) as usize] += 1;
        // Neighbouring columns and rows permute their cells independently.
        columns[(a % 4 * 4 + right % 4) as usize] += 1;
        rows[(b % 3 * 3 + below % 3) as usize] += 1;
    }
    assert_random(&order, "first fine cell of correlated");
    assert_uniform(&rooks, "row of a rook");
    assert_uniform(&within, "fine cell in a cell of multi-jittered");
    assert_uniform(&columns, "fine columns of two cells of multi-jittered");
    assert_uniform(&rows, "fine rows of two cells of multi-jittered");
}

/// The crate's own checkers, which its users and fuzz targets share, say the same.
#[test]
fn invariants_agree() {
    let marks = &mut [0; 64];
    for (seed, [m, n]) in (0..).zip([[1, 1], [5, 7], [1, 100], [32, 32], [33, 61]]) {
        let multi = MultiJittered::new(m, n, seed).unwrap();
        assert_eq!(invariant::cells(&multi, 0, [m, n], marks), Ok(()));
        assert_eq!(invariant::rooks(&multi, 0, m * n, marks), Ok(()));
        let random = Random::new(seed);
        assert_eq!(invariant::cells(&random, 0, [m, n], marks).is_ok(), m * n == 1);
    }
    assert_eq!(invariant::net(&SobolOwen::new(7), 1 << 20, 10, marks), Ok(()));
    assert!(invariant::net(&Random::new(7), 0, 10, marks).is_err());
}

/// A shuffled set is the same set: the promise passes through.
#[test]
fn shuffled_sets_keep_their_strata() {
    let domain = hemidisc::Domain::new(7);
    let set = Shuffled::new(MultiJittered::new(13, 17, 7).unwrap(), domain);
    assert_grid(set, [13, 17], false, "shuffled multi-jittered");
    assert_rooks(set, "shuffled multi-jittered");
}
