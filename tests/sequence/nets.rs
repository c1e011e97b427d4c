//! Elementary intervals: aligned blocks of 2^m points are (0, m, 2)-nets, that is, each interval of
//! a x b = 2^-j x 2^-(m-j) holds exactly one; Halton's intervals are 2^-a x 3^-b.

use super::strata::assert_each_once;
use hemidisc::{
    Domain,
    bits::hash::mix,
    sequence::{Halton, Hammersley, Sequence, Shuffled, Sobol, SobolOwen},
};
use testkit::strata::stratum;

const LARGEST: u32 = 12;

/// The leading bits of a coordinate.
fn leading(cell: u32, bits: u32) -> u32 {
    ((u64::from(cell) << bits) >> 32) as u32
}

/// Fails unless 2^m points have one in each elementary interval of area 2^-m.
fn assert_net(points: &[[u32; 2]], what: &str) {
    let m = points.len().trailing_zeros();
    for a in 0..=m {
        let b = m - a;
        let hits = points.iter().map(|&[u, v]| leading(u, a) << b | leading(v, b));
        assert_each_once(1 << m, hits, &format!("{what}, 2^-{a} x 2^-{b}"));
    }
}

/// Starts of aligned blocks of 2^m: the first ones, about the middle, the last before 2^32, others.
fn starts(m: u32) -> impl Iterator<Item = u32> {
    let last = (u32::MAX >> m) << m;
    let hashed = (0..3).map(move |i| (mix(i + 1 + m) >> m) << m);
    [0, 1 << m, 5 << m, 1 << 31, (1 << 31) - (1 << m), last].into_iter().chain(hashed)
}

fn assert_nets(sequence: impl Sequence, what: &str) {
    for m in 0..=LARGEST {
        for start in starts(m) {
            let points: Vec<_> = (0..1 << m).map(|i| sequence.at(start + i)).collect();
            assert_net(&points, &format!("{what}, {} from {start}", 1 << m));
        }
    }
}

#[test]
fn sobol() {
    for seed in [0, 1, 2, 7, 0x2000_0000, 0x8000_0000, 0xdead_beef, u32::MAX] {
        assert_nets(Sobol::new(seed), &format!("sobol, seed {seed:#x}"));
    }
    assert_nets(Shuffled::new(Sobol::new(7), Domain::new(1)), "shuffled sobol");
}

#[test]
fn sobol_owen() {
    for i in 0..12 {
        for seed in [i, 1 << (2 * i + 8), u32::MAX - i] {
            assert_nets(SobolOwen::new(seed), &format!("sobol-owen, seed {seed:#x}"));
        }
        let domain = Domain::new(i).pixel(i * 100, 7).child(u32::MAX - i).child(0);
        assert_nets(SobolOwen::in_domain(domain), &format!("sobol-owen in {domain:?}"));
    }
}

/// Blocks longer than 2^16, where the upper half of the index takes part.
#[test]
fn long_blocks() {
    for start in [0, 0xfff8_0000] {
        let points = |at: &dyn Fn(u32) -> [u32; 2]| (0..1 << 19).map(|i| at(start + i)).collect();
        let sobol: Vec<_> = points(&|i| Sobol::new(7).at(i));
        assert_net(&sobol, &format!("sobol, 2^19 from {start}"));
        let scrambled: Vec<_> = points(&|i| SobolOwen::new(7).at(i));
        assert_net(&scrambled, &format!("sobol-owen, 2^19 from {start}"));
    }
}

#[test]
fn hammersley() {
    for m in 0..=16 {
        let set = Hammersley::new(1 << m).unwrap();
        let points: Vec<_> = (0..1 << m).map(|i| set.at(i)).collect();
        assert_net(&points, &format!("hammersley 2^{m}"));
    }
}

/// Any consecutive 2^a 3^b points, wherever they start.
#[test]
fn halton_runs() {
    for (a, b) in (0..=8).flat_map(|a| (0..=6).map(move |b| (a, b))) {
        let (columns, rows) = (1_u32 << a, 3_u32.pow(b));
        let count = columns * rows;
        if count > 10_000 {
            continue;
        }
        let last = u32::MAX - count + 1;
        let edges = [3_u32.pow(20) - count / 2, 3_u32.pow(20), (1 << 31) - count / 3];
        for start in [0, 1, 7, 12_345, mix(count), last, last - 1].into_iter().chain(edges) {
            let start = start.min(last);
            let hits = (0..count).map(|i| {
                let [u, v] = Halton::new().at(start + i);
                leading(u, a) * rows + stratum(v, rows)
            });
            assert_each_once(count, hits, &format!("halton, 2^-{a} x 3^-{b}, from {start}"));
        }
    }
}

/// The interval of a point is the mirror of its index's last digits. With the Chinese remainder
/// theorem this is the whole promise, for any run of 2^a 3^b points, b <= 19; in 3^20 strata (1.2
/// cells each) rounding up to a cell may cross an edge for an index from 3^20 on.
#[test]
fn halton_digits() {
    fn mirrored(mut index: u32, digits: u32) -> u64 {
        (0..digits).fold(0, |mirror, _| {
            let digit = index % 3;
            index /= 3;
            mirror * 3 + u64::from(digit)
        })
    }
    let edges = (0..=20).flat_map(|b| [3_u32.pow(b) - 1, 3_u32.pow(b), u32::MAX - 3_u32.pow(b)]);
    let ends = (0..1000).flat_map(|i| [i, u32::MAX - i]);
    for index in edges.chain(ends).chain((0..100_000).map(mix)) {
        let [u, v] = Halton::new().at(index);
        assert_eq!(u, index.reverse_bits());
        // Rounded up to a cell from all 21 digits.
        let exact = (u128::from(mirrored(index, 21)) << 32).div_ceil(3_u128.pow(21));
        assert_eq!(u128::from(v), exact, "point {index}");
        let last = if index < 3_u32.pow(20) { 20 } else { 19 };
        for b in 0..=last {
            let interval = u64::from(stratum(v, 3_u32.pow(b)));
            assert_eq!(interval, mirrored(index, b), "point {index} in 3^{b} rows");
        }
    }
}

/// The values of a domain's stream: one in each of 2^m strata.
#[test]
fn streams() {
    for seed in 0..24 {
        let stream = Domain::new(seed).child(seed * 7).stream();
        for m in 0..=LARGEST {
            for start in starts(m) {
                let what = format!("stream of {seed}, {} from {start}", 1 << m);
                let hits = (0..1 << m).map(|i| leading(stream.at(start + i), m));
                assert_each_once(1 << m, hits, &what);
                // Equally likely choices are equally many.
                let hits = (0..1 << m).map(|i| stream.choose(start + i, 1 << m));
                assert_each_once(1 << m, hits, &what);
            }
        }
        assert_eq!(stream.choose(1, 0), 0);
        assert!((0..1000).all(|i| stream.choose(i, 7) < 7));
    }
}
