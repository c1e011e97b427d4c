//! The iterator over arrays of points.

use super::Points;
use crate::map::Map;
use crate::sequence::Sequence;
use core::iter::FusedIterator;

/// An iterator over arrays of `N` consecutive points.
#[derive(Clone, Debug)]
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct Chunks<S, M, const N: usize> {
    pub(super) points: Points<S, M>,
}

impl<S: Sequence, M: Map, const N: usize> Chunks<S, M, N> {
    const SIZE: u32 = {
        assert!(N > 0 && N as u64 <= u32::MAX as u64, "a chunk has at least one point");
        N as u32
    };

    /// The points not yet given; once the iterator has ended, fewer than `N`.
    #[must_use]
    pub const fn remainder(&self) -> Points<S, M> {
        self.points
    }
}

impl<S: Sequence, M: Map, const N: usize> Iterator for Chunks<S, M, N> {
    type Item = [M::Point; N];

    #[inline]
    fn next(&mut self) -> Option<[M::Point; N]> {
        let (chunk, rest) = self.points.split_at(Self::SIZE).ok()?;
        self.points = rest;
        chunk.to_array().ok()
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let len = (self.points.len / Self::SIZE) as usize;
        (len, Some(len))
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<[M::Point; N]> {
        let skipped = n.min(self.len()) as u32 * Self::SIZE;
        let (_, rest) = self.points.split_at(skipped).ok()?;
        self.points = rest;
        self.next()
    }

    #[inline]
    fn count(self) -> usize {
        self.len()
    }

    #[inline]
    fn last(mut self) -> Option<[M::Point; N]> {
        self.nth(self.len().checked_sub(1)?)
    }
}

impl<S: Sequence, M: Map, const N: usize> ExactSizeIterator for Chunks<S, M, N> {}
impl<S: Sequence, M: Map, const N: usize> FusedIterator for Chunks<S, M, N> {}
