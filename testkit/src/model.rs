//! The slice model of points: what operations on an iterator give, in any order, the same
//! operations on a slice of all points give.

use arbitrary::Arbitrary;
use hemidisc::map::Point;
use hemidisc::sequence::Sequence;
use hemidisc::{Error, Map, Points};
use std::fmt::Debug;

/// A call on what is left of a set.
#[derive(Arbitrary, Clone, Copy, Debug)]
pub enum Op {
    Next,
    NextBack,
    Nth(usize),
    NthBack(usize),
    SplitKeep { at: u32, front: bool },
    Fill(u16),
    Get(u32),
    Shard { shard: u32, of: u32 },
    Range { start: u32, count: u32 },
}

/// The longest buffer that is filled.
const LONGEST: usize = 400;

/// Runs the operations on the iterator of a set and on that of a slice of its points.
fn check_against<S: Sequence, M: Map<Point: PartialEq + Debug>>(
    points: Points<S, M>,
    all: &[M::Point],
    ops: &[Op],
) {
    let (mut iter, mut model) = (points.iter(), all.iter());
    for &op in ops {
        let (left, slice) = (iter.as_points(), model.as_slice());
        match op {
            Op::Next => assert_eq!(iter.next(), model.next().copied()),
            Op::NextBack => assert_eq!(iter.next_back(), model.next_back().copied()),
            Op::Nth(n) => assert_eq!(iter.nth(n), model.nth(n).copied()),
            Op::NthBack(n) => assert_eq!(iter.nth_back(n), model.nth_back(n).copied()),
            Op::SplitKeep { at, front } => {
                let (got, expected) = (left.split_at(at), slice.split_at_checked(at as usize));
                assert_eq!(got.is_ok(), expected.is_some(), "split at {at} of {}", slice.len());
                if let (Ok((a, b)), Some((c, d))) = (got, expected) {
                    (iter, model) = if front { (a.iter(), c.iter()) } else { (b.iter(), d.iter()) };
                }
            }
            Op::Fill(size) => {
                let mut buffer = vec![M::Point::zero(); usize::from(size) % LONGEST];
                let filled = left.fill(&mut buffer);
                assert_eq!(filled, buffer.len().min(slice.len()));
                assert_eq!(buffer[..filled], slice[..filled]);
                assert!(buffer[filled..].iter().all(|point| *point == M::Point::zero()));
            }
            Op::Get(index) => {
                let expected = slice.get(index as usize).copied();
                assert_eq!(left.get(index), expected);
                assert_eq!(left.coordinates(index).map(|uv| left.map().sample(uv)), expected);
            }
            Op::Shard { shard, of } => match left.shard(shard, of) {
                Ok(part) => {
                    let edge =
                        |k: u32| (slice.len() as u128 * u128::from(k) / u128::from(of)) as usize;
                    let expected = &slice[edge(shard)..edge(shard + 1)];
                    assert!(part.iter().eq(expected.iter().copied()), "shard {shard} of {of}");
                    let (low, even) = (left.len() / of, left.len() % of == 0);
                    assert!(part.len() == low || !even && part.len() == low + 1);
                }
                Err(error) => assert_eq!((error, shard < of), (Error::Shard { shard, of }, false)),
            },
            Op::Range { start, count } => match left.range(start..start.saturating_add(count)) {
                Ok(part) => {
                    let expected = &slice[start as usize..][..count as usize];
                    assert!(part.into_iter().eq(expected.iter().copied()));
                }
                Err(_) => assert!(u64::from(start) + u64::from(count) > slice.len() as u64),
            },
        }
        assert_eq!(iter.size_hint(), model.size_hint());
        assert_eq!((iter.len(), iter.as_points().is_empty()), (model.len(), model.len() == 0));
    }
    assert_eq!(iter.clone().count(), model.len());
    assert_eq!(iter.clone().last(), model.as_slice().last().copied());
    assert!(iter.clone().rev().eq(model.as_slice().iter().rev().copied()));
    let folded = iter.clone().fold(Vec::new(), |mut list, point| {
        list.push(point);
        list
    });
    assert_eq!(folded, model.as_slice());
    let left = iter.as_points();
    assert!(left.iter_coordinates().map(|uv| left.map().sample(uv)).eq(folded.iter().copied()));
    for skip in [0, 1, 7, model.len()] {
        let mapped = |uv: Option<[u32; 2]>| uv.map(|uv| left.map().sample(uv));
        let (mut front, mut back) = (left.iter_coordinates(), left.iter_coordinates());
        assert_eq!(mapped(front.nth(skip)), model.clone().nth(skip).copied());
        assert_eq!(mapped(back.nth_back(skip)), model.clone().nth_back(skip).copied());
        assert_eq!((front.len(), back.len()), [model.len().saturating_sub(skip + 1); 2].into());
    }
    let array = left.to_array::<17>();
    assert_eq!(array.ok().as_ref().map(|array| &array[..]), model.as_slice().get(..17));
    in_vectors(left, model.as_slice());
    let mut chunks = left.chunks::<5>();
    let (exact, rest) = model.as_slice().as_chunks::<5>();
    assert_eq!((chunks.len(), chunks.clone().count()), (exact.len(), exact.len()));
    assert_eq!(chunks.clone().last(), exact.last().copied());
    for skip in [0, 1, 7, exact.len(), exact.len() + 1] {
        let mut from = chunks.clone();
        assert_eq!(from.nth(skip), exact.get(skip).copied());
        assert!(from.eq(exact.iter().skip(skip + 1).copied()));
    }
    assert!(chunks.by_ref().eq(exact.iter().copied()));
    assert!(chunks.remainder().iter().eq(rest.iter().copied()));
    // Fused at both ends.
    iter.nth(model.len());
    assert_eq!((iter.next(), iter.next_back(), iter.len()), (None, None, 0));
}

/// Into vectors without a heap, which may be too short.
#[cfg(feature = "heapless")]
fn in_vectors<S: Sequence, M: Map<Point: PartialEq + Debug>>(
    points: Points<S, M>,
    slice: &[M::Point],
) {
    let mut vec: heapless::Vec<M::Point, 100> = heapless::Vec::new();
    let first = &slice[..slice.len().min(100)];
    assert_eq!(points.extend_heapless(&mut vec), first.len());
    assert_eq!(vec[..], *first);
    match points.to_heapless::<100>() {
        Ok(vec) => assert_eq!(vec[..], *slice),
        Err(error) => {
            assert_eq!(error, Error::Capacity { len: points.len(), capacity: 100 });
            assert!(slice.len() > 100);
        }
    }
}

#[cfg(not(feature = "heapless"))]
fn in_vectors<S: Sequence, M: Map>(_: Points<S, M>, _: &[M::Point]) {}

/// The points of a sequence, from random access alone.
pub fn slice<S: Sequence, M: Map>(sequence: S, map: M, start: u32, count: u32) -> Vec<M::Point> {
    (0..count).map(|i| map.sample(sequence.at(start.wrapping_add(i)))).collect()
}

/// The operations on up to `longest` points from an index of a sequence.
pub fn check_range<S: Sequence, M: Map<Point: PartialEq + Debug>>(
    sequence: S,
    map: M,
    [start, longest]: [u32; 2],
    ops: &[Op],
) {
    let count = longest.min(sequence.size().map_or(u32::MAX - start, |size| size - start));
    let points = Points::with_range(sequence, map, start..).unwrap().take(count).unwrap();
    check_against(points, &slice(sequence, map, start, count), ops);
}
