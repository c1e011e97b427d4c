//! Domains: two of different paths have no point in common, a split is the whole, a stream keeps
//! its strata.

use arbitrary::{Arbitrary, Unstructured};
use hemidisc::sequence::{Sequence, SobolOwen};
use hemidisc::{Domain, Error, LibmF32, Points, UnitSquare, invariant};
use std::collections::HashSet;

#[derive(Arbitrary, Debug)]
struct Input {
    seed: u32,
    /// From the root to two domains.
    paths: [Path; 2],
    key: u32,
    ways: u32,
    sample: u32,
    start: u32,
    /// Of a set that is cut.
    cuts: [u32; 2],
}

/// A few steps down.
type Path = [Option<Step>; 3];

#[derive(Arbitrary, Clone, Copy, Debug, PartialEq, Eq)]
enum Step {
    Child(u32),
    Pixel(u32, u32),
}

fn along(path: Path, root: Domain) -> Domain {
    path.into_iter().flatten().fold(root, |domain, step| match step {
        Step::Child(key) => domain.child(key),
        Step::Pixel(x, y) => domain.pixel(x, y),
    })
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let input: Input = Unstructured::new(data).arbitrary()?;
    let root = Domain::new(input.seed);
    let [a, b] = input.paths.map(|path| along(path, root));
    let [first, second] = input.paths.map(|path| path.into_iter().flatten().collect::<Vec<_>>());
    if first == second {
        assert_eq!(a, b);
        assert_eq!(SobolOwen::in_domain(a), SobolOwen::in_domain(b));
    } else {
        independent(&input, a, b);
    }
    split(&input, a);
    cut(&input, a);
    stream(&input, a);
    Ok(())
}

/// Points that are compared. That two of 64 bits are equal by chance takes 10^14 inputs.
const COUNT: u32 = 256;

/// Pairs of points that are counted. Orders that are hashed alike for 64 points are 1 of 50,000
/// pairs of domains, and 1 of 10^6 for 256; the count ends at once where they are not.
const PAIRS: u32 = 4096;

/// Whether pairs fill more than half of a 4 x 4 grid. Of those that share an order, 12 of 16 cells
/// stay empty.
fn fill(pair: impl Fn(u32) -> [u32; 2]) -> bool {
    let mut cells = 0_u16;
    (0..PAIRS).any(|i| {
        let [x, y] = pair(i);
        cells |= 1 << (x >> 30 << 2 | y >> 30);
        cells.count_ones() > 8
    })
}

/// No equal points, and no order in common.
fn independent(input: &Input, a: Domain, b: Domain) {
    assert_ne!(a, b, "{input:x?}");
    let [a_points, b_points] = [a, b].map(SobolOwen::in_domain);
    let points = |sequence: SobolOwen| (0..COUNT).map(move |i| sequence.at(i));
    let seen: HashSet<_> = points(a_points).collect();
    assert_eq!(seen.len(), COUNT as usize, "{input:x?}");
    for (i, point) in points(b_points).enumerate() {
        assert!(!seen.contains(&point), "point {i} is in both: {input:x?}");
    }
    let [a_stream, b_stream] = [a, b].map(Domain::stream);
    for (axis, other) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let pair = |i| [a_points.at(i)[axis], b_points.at(i)[other]];
        assert!(fill(pair), "axes {axis} and {other} share an order: {input:x?}");
    }
    assert!(fill(|i| [a_stream.at(i), b_stream.at(i)]), "streams share an order: {input:x?}");
    let pair = |i| [a_points.at(i)[0], a_stream.at(i)];
    assert!(fill(pair), "points and stream share an order: {input:x?}");
}

/// The branches of consecutive samples are consecutive indices of the child.
fn split(input: &Input, domain: Domain) {
    let Input { key, ways, sample, .. } = *input;
    let split = domain.split(key, ways);
    assert_eq!(split.domain(), domain.child(key));
    let end = (u64::from(sample) + 1) * u64::from(ways);
    match split.branches(sample) {
        Ok(range) => {
            assert_eq!((u64::from(range.end), range.len()), (end, ways as usize), "{input:x?}");
            if let Some(next) = sample.checked_add(1)
                && let Ok(after) = split.branches(next)
            {
                assert_eq!(range.end, after.start, "{input:x?}");
            }
        }
        Err(error) => {
            assert!(matches!(error, Error::Range { .. }) && end > u32::MAX.into(), "{input:x?}");
        }
    }
}

/// Two cuts of a set: the three parts in order are the whole.
fn cut(input: &Input, domain: Domain) {
    let square = UnitSquare::<LibmF32>::new();
    let count = input.cuts[0] % 300;
    let start = input.start.min(u32::MAX - count);
    let whole =
        Points::with_range(SobolOwen::in_domain(domain), square, start..start + count).unwrap();
    let (left, rest) = whole.split_at(input.cuts[1] % (count + 1)).unwrap();
    let (middle, right) = rest.split_at(rest.len() / 2).unwrap();
    let parts: Vec<_> = left.iter().chain(middle).chain(right).collect();
    assert!(whole.iter().eq(parts.iter().copied()), "{input:x?}");
    assert!(parts.iter().zip(0..).all(|(part, i)| whole.get(i) == Some(*part)), "{input:x?}");
    let of = input.cuts[1] % 7 + 1;
    let shards = (0..of).flat_map(|shard| whole.shard(shard, of).unwrap());
    assert!(shards.eq(parts), "{input:x?}");
}

/// A stream as a sequence, its index as the other axis.
#[derive(Clone, Copy)]
struct Streamed(hemidisc::domain::Stream, u32);

impl Sequence for Streamed {
    fn size(&self) -> Option<u32> {
        None
    }

    fn at(&self, index: u32) -> [u32; 2] {
        [self.0.at(index), self.1]
    }
}

/// One value of an aligned block in each stratum, and choices that are even.
fn stream(input: &Input, domain: Domain) {
    let stream = domain.stream();
    let m = input.ways % 10;
    let start = input.start >> m << m;
    let found = invariant::cells(&Streamed(stream, 0), start, [1 << m, 1], &mut [0; 16]);
    assert_eq!(found, Ok(()), "{input:x?}");
    let choice = stream.choose(input.sample, input.ways);
    assert!(choice < input.ways || input.ways == 0 && choice == 0, "{input:x?}");
    let seeds = [domain, domain.child(0), domain.child(1)].map(Domain::seed);
    assert!(seeds != [seeds[0]; 3], "{input:x?}");
}
