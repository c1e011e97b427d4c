//! Every way to a point gives the same point: both `at`, `iter` and `block`. Sets repeat.

use hemidisc::{
    Domain, Error,
    bits::hash::mix,
    catalogue::{Parameters, SEQUENCES, SequenceVisitor, sequences},
    for_each_sequence, made_by,
    sequence::{self, BLOCK, Sequence, Shuffled, Sobol, Stored},
};

const COUNTS: [u32; 8] = [1, 2, 63, 64, 65, 100, 300, 65_536];

/// The last start of a block, and of a run that ends with the last index.
const LAST: u32 = u32::MAX - (BLOCK as u32 - 1);

fn assert_access(sequence: impl Sequence, what: &str) {
    let starts = [0, 64, 128, 64 << 10, 1 << 31, (1 << 31) - 64, LAST - 64, LAST];
    for start in starts.into_iter().chain((0..20).map(|i| mix(i) & !63)) {
        let expected: Vec<_> = (0..64).map(|i| sequence.at(start + i)).collect();
        let (mut u, mut v) = ([0; BLOCK], [0; BLOCK]);
        sequence.block(start, &mut u, &mut v);
        let block: Vec<_> = u.into_iter().zip(v).map(|(u, v)| [u, v]).collect();
        assert_eq!(block, expected, "{what}: block from {start}");
        for ahead in [0, 1, 17, 63] {
            let left: Vec<_> = sequence.iter(start + ahead as u32).take(64 - ahead).collect();
            assert_eq!(left, expected[ahead..], "{what}: iter from {start} + {ahead}");
        }
    }
    let far: Vec<_> = sequence.iter(5).take(700).collect();
    assert!(far.iter().zip(5..).all(|(&point, i)| point == sequence.at(i)), "{what}: iter");
    if let Some(size) = sequence.size() {
        for i in (0..200).flat_map(|i| [i, u32::MAX - i, mix(i), size.wrapping_add(i)]) {
            assert_eq!(sequence.at(i), sequence.at(i % size), "{what}: point {i} of {size}");
        }
    }
}

/// `nth` seeks: point by point these would be 10^12 steps.
fn assert_seeks(sequence: impl Sequence, what: &str) {
    for start in [0, 5, 64, u32::MAX - 2] {
        for n in [0, 1, 2, 63, 700, 20_000_000, 0x7fff_fffe, 0xffff_ffff_usize] {
            let mut points = sequence.iter(start);
            let mut index = start;
            for again in [0, 1, 2] {
                index = index.wrapping_add(n as u32);
                let expected = [index, index.wrapping_add(1)].map(|i| Some(sequence.at(i)));
                let got = [points.nth(n), points.next()];
                assert_eq!(got, expected, "{what}: nth({n}) from {start}, {again} before");
                index = index.wrapping_add(2);
            }
        }
        let steps: Vec<_> = sequence.iter(start).step_by(300_000_001).take(20).collect();
        let expected =
            (0..20).map(|i| sequence.at(start.wrapping_add(300_000_001_u32.wrapping_mul(i))));
        assert!(expected.eq(steps), "{what}: every 300,000,001st from {start}");
    }
}

/// After the last index comes the first.
fn assert_wraps(sequence: impl Sequence, what: &str) {
    let wrapped: Vec<_> = sequence.iter(u32::MAX - 1).take(4).collect();
    let expected = [u32::MAX - 1, u32::MAX, 0, 1].map(|i| sequence.at(i));
    assert_eq!(wrapped, expected, "{what}: iter over the last index");
}

struct Access {
    seed: u32,
    count: u32,
    seen: Vec<&'static str>,
}

impl SequenceVisitor for Access {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        let what = format!("{name} of {}, seed {:#x}", self.count, self.seed);
        assert_access(sequence, &what);
        assert_wraps(sequence, &what);
        assert_seeks(sequence, &what);
        let shuffled = Shuffled::new(sequence, Domain::new(self.seed));
        assert_access(shuffled, &format!("shuffled {what}"));
        assert_wraps(shuffled, &format!("shuffled {what}"));
        assert_seeks(shuffled, &format!("shuffled {what}"));
        self.seen.push(name);
    }
}

#[test]
fn the_whole_catalogue() {
    for count in COUNTS {
        for seed in [0, 7, u32::MAX] {
            let mut access = Access { seed, count, seen: Vec::new() };
            sequences(count, seed, &mut access).unwrap();
            assert_eq!(access.seen, SEQUENCES);
        }
    }
}

#[test]
fn stored() {
    let points: Vec<_> = (0..1000).map(|i| [mix(i), mix(!i)]).collect();
    for count in [1, 2, 63, 64, 65, 1000] {
        let what = format!("stored, {count}");
        let stored = Stored::new(&points[..count]).unwrap();
        assert_eq!(stored.size(), Some(count as u32));
        assert!((0..count).all(|i| stored.at(i as u32) == points[i]), "{what}");
        assert_access(stored, &what);
        assert_wraps(stored, &what);
        assert_seeks(stored, &what);
        assert_access(Shuffled::new(stored, Domain::new(1)), &format!("shuffled {what}"));
    }
}

/// The inherent `at`, which constants use, gives the point of the trait's, which generic code uses.
macro_rules! assert_at_is_the_traits {
    ($sequence:expr, $name:expr) => {
        let sequence = $sequence;
        for i in (0..1000).flat_map(|i| [i, u32::MAX - i, mix(i)]) {
            assert_eq!(sequence.at(i), Sequence::at(&sequence, i), "{}, point {i}", $name);
        }
    };
}

macro_rules! every_at_is_the_traits {
    ($parameters:ident
        $($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*
    ) => {$(
        let made = sequence::$sequence::$new($($parameters.$part),*);
        assert_at_is_the_traits!(made_by!($kind made), $name);
    )*};
}

#[test]
fn at_is_point() -> Result<(), Error> {
    const TABLE: [u32; 2] = Sobol::new(7).at(3); // also at compile time
    assert_eq!(Sobol::new(7).at(3), TABLE);
    for seed in [0, 1, u32::MAX] {
        // Grids of 7 x 9.
        let parameters = Parameters::new(63, seed);
        for_each_sequence!(every_at_is_the_traits parameters);
    }
    let points = [[1, 2], [3, 4], [5, 6]];
    assert_at_is_the_traits!(Stored::new(&points)?, "stored");
    Ok(())
}
