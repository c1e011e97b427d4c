//! The iterator over points, from both ends.

use super::Points;
use crate::map::Map;
use crate::sequence::Sequence;
use core::iter::FusedIterator;

/// An iterator over points: exact-size, double-ended, fused, with O(1) `nth` from both ends.
#[derive(Clone, Debug)]
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct Iter<S, M> {
    pub(super) points: Points<S, M>,
}

impl<S: Sequence, M: Map> Iter<S, M> {
    /// The points that are left.
    #[must_use]
    pub const fn as_points(&self) -> Points<S, M> {
        self.points
    }

    /// Drops `count` points from the front; empties the iterator if there are not as many.
    #[inline]
    fn drop_front(&mut self, count: usize) {
        let count = count.min(self.points.len as usize) as u32;
        self.points.start = self.points.start.wrapping_add(count);
        self.points.len -= count;
    }
}

impl<S: Sequence, M: Map> Iterator for Iter<S, M> {
    type Item = M::Point;

    #[inline]
    fn next(&mut self) -> Option<M::Point> {
        let point = self.points.get(0)?;
        self.drop_front(1);
        Some(point)
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<M::Point> {
        self.drop_front(n);
        self.next()
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let len = self.points.len as usize;
        (len, Some(len))
    }

    #[inline]
    fn count(self) -> usize {
        self.points.len as usize
    }

    #[inline]
    fn last(mut self) -> Option<M::Point> {
        self.next_back()
    }

    #[inline]
    fn fold<B, F: FnMut(B, M::Point) -> B>(self, init: B, mut f: F) -> B {
        let Points { sequence, map, start, len } = self.points;
        let coordinates = sequence.iter(start).take(len as usize);
        coordinates.fold(init, |sum, uv| f(sum, map.sample(uv)))
    }
}

impl<S: Sequence, M: Map> DoubleEndedIterator for Iter<S, M> {
    #[inline]
    fn next_back(&mut self) -> Option<M::Point> {
        let last = self.points.len.checked_sub(1)?;
        let point = self.points.get(last)?;
        self.points.len = last;
        Some(point)
    }

    #[inline]
    fn nth_back(&mut self, n: usize) -> Option<M::Point> {
        self.points.len -= n.min(self.points.len as usize) as u32;
        self.next_back()
    }
}

impl<S: Sequence, M: Map> ExactSizeIterator for Iter<S, M> {}
impl<S: Sequence, M: Map> FusedIterator for Iter<S, M> {}
