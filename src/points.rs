//! Points: a sequence through a map, as a `Copy` value; and the one loop that fills buffers.
//!
//! A part of a set is byte-identical to the same indices of the whole, so a set can be split over
//! threads, machines or time. Filling takes single points up to a multiple of 16, blocks of 16 up to
//! a multiple of 64 and blocks of 64, one array a component, then the rest likewise. Where blocks do not pay (`target.rs`) it takes all
//! points one by one. The bits are the same.

use crate::block::{BLOCK, Block, Lanes, Point, SHORT_BLOCK};
use crate::error::Error;
use crate::map::Map;
use crate::sequence::Sequence;
use crate::target::BLOCKED;
use core::iter::FusedIterator;

mod chunks;
#[cfg(feature = "heapless")]
mod heapless;
mod range;

pub use chunks::Chunks;

/// A range of indices of a sequence, mapped.
///
/// ```
/// use hemidisc::{Concentric, LibmF32, Points, sequence::MultiJittered};
/// let lens = Points::new(MultiJittered::new(8, 8, 7)?, Concentric::<LibmF32>::new());
/// let mut buffer = [[0.0; 2]; 64];
/// assert_eq!(lens.fill(&mut buffer), 64);
/// assert!(buffer.iter().all(|[x, y]| x * x + y * y <= 1.0));
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Points<S, M> {
    sequence: S,
    map: M,
    start: u32,
    len: u32,
}

impl<S: Sequence, M: Map> Points<S, M> {
    /// All points of a set, or the first 2^32 - 1 of an endless sequence.
    #[must_use]
    pub fn new(sequence: S, map: M) -> Self {
        Self { sequence, map, start: 0, len: sequence.size().unwrap_or(u32::MAX) }
    }

    /// The index, in the sequence, of the first point.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn start(&self) -> u32 {
        self.start
    }

    /// How many points there are.
    #[must_use]
    pub const fn len(&self) -> u32 {
        self.len
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The sequence.
    #[must_use]
    pub const fn sequence(&self) -> &S {
        &self.sequence
    }

    /// The map.
    #[must_use]
    pub const fn map(&self) -> &M {
        &self.map
    }

    /// The `index`-th point, if there is one; O(1).
    #[must_use]
    #[inline]
    pub fn get(&self, index: u32) -> Option<M::Point> {
        Some(self.map.sample(self.coordinates(index)?))
    }

    /// The coordinates of the `index`-th point on the unit square, if there is one.
    #[must_use]
    #[inline]
    pub fn coordinates(&self, index: u32) -> Option<[u32; 2]> {
        (index < self.len).then(|| self.sequence.at(self.start.wrapping_add(index)))
    }

    /// The coordinates of all points in order: candidates for rejection, or for a map of one's own.
    /// Its `nth` is O(1) from both ends, as that of [`iter`](Self::iter).
    pub fn iter_coordinates(
        &self,
    ) -> impl ExactSizeIterator<Item = [u32; 2]> + DoubleEndedIterator + FusedIterator + Clone {
        let Self { sequence, start, len, .. } = *self;
        Iter { points: Points { sequence, map: Cells, start, len } }
    }

    /// The points in order.
    pub const fn iter(&self) -> Iter<S, M> {
        Iter { points: *self }
    }

    /// Writes points into the caller's buffer until either ends; returns how many.
    ///
    /// The rest of a longer buffer is left as it is.
    #[inline]
    pub fn fill(&self, buffer: &mut [M::Point]) -> usize {
        let count = buffer.len().min(self.len as usize);
        let Some(buffer) = buffer.get_mut(..count) else { return 0 };
        self.fill_slots(buffer, count)
    }

    /// Writes each component of the points into its own buffer, until the shortest or the set ends;
    /// returns how many points.
    ///
    /// The numbers are those of [`fill`](Self::fill). The rest of longer buffers is left as it is.
    ///
    /// ```
    /// use hemidisc::{Cosine, FastF32, Points, sequence::Sobol};
    /// let rays = Points::new(Sobol::new(0), Cosine::<FastF32>::new());
    /// let (mut x, mut y, mut z) = ([0.0; 256], [0.0; 256], [0.0; 256]);
    /// assert_eq!(rays.fill_components([&mut x, &mut y, &mut z]), 256);
    /// assert_eq!([x[9], y[9], z[9]], rays.get(9).unwrap_or_default());
    /// ```
    #[inline]
    pub fn fill_components<R: Copy + Default, const D: usize>(
        &self,
        buffers: [&mut [R]; D],
    ) -> usize
    where
        M: Map<Point = [R; D]>,
    {
        let shortest = buffers.iter().map(|buffer| buffer.len()).min().unwrap_or(0);
        let count = shortest.min(self.len as usize);
        self.fill_slots(Apart(buffers), count)
    }

    /// The loop that fills slots, of which there are `count` at least.
    #[inline(always)]
    fn fill_slots(&self, slots: impl Slots<M::Point>, count: usize) -> usize {
        let Self { sequence, map, start, .. } = *self;
        if !BLOCKED {
            slots.fill_singly(count, &sequence, start, &map);
            return count;
        }
        let (mut next, mut left, mut slots) = (start, count, slots);
        while left > 0 {
            let place = next as usize % BLOCK;
            let taken = if place == 0 && left >= BLOCK {
                left - left % BLOCK
            } else if place.is_multiple_of(SHORT_BLOCK) && left >= SHORT_BLOCK {
                let whole = left.min(BLOCK - place);
                whole - whole % SHORT_BLOCK
            } else {
                left.min(SHORT_BLOCK - place % SHORT_BLOCK)
            };
            let (now, rest) = slots.split(taken);
            if taken >= BLOCK {
                now.fill_blocks::<BLOCK, _, _>(taken, next, &map, |start, u, v| {
                    sequence.block(start, u, v)
                });
            } else if taken >= SHORT_BLOCK {
                now.fill_blocks::<SHORT_BLOCK, _, _>(taken, next, &map, |start, u, v| {
                    sequence.short_block(start, u, v);
                });
            } else {
                now.fill_singly(taken, &sequence, next, &map);
            }
            (next, left, slots) = (next.wrapping_add(taken as u32), left - taken, rest);
        }
        count
    }

    /// The first `N` points as an array.
    ///
    /// # Errors
    /// [`Error::TooShort`] if there are fewer.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, Points, sequence::Sobol};
    /// let lens = Points::new(Sobol::new(0), Concentric::<LibmF32>::new());
    /// let aperture: [[f32; 2]; 16] = lens.to_array()?;
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    pub fn to_array<const N: usize>(&self) -> Result<[M::Point; N], Error> {
        if N > self.len as usize {
            return Err(Error::TooShort { len: self.len, wanted: N });
        }
        let mut array = [M::Point::zero(); N];
        self.fill(&mut array);
        Ok(array)
    }

    /// Consecutive arrays of `N` points; the last `len` mod `N` points are left to
    /// [`Chunks::remainder`].
    ///
    /// ```
    /// use hemidisc::{Cosine, LibmF32, Points, sequence::Hammersley};
    /// let rays = Points::new(Hammersley::new(10)?, Cosine::<LibmF32>::new());
    /// let mut chunks = rays.chunks::<4>();
    /// assert_eq!(chunks.by_ref().count(), 2);
    /// assert_eq!(chunks.remainder().len(), 2);
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    pub const fn chunks<const N: usize>(&self) -> Chunks<S, M, N> {
        Chunks { points: *self }
    }
}

impl<S: Sequence, M: Map> IntoIterator for Points<S, M> {
    type Item = M::Point;
    type IntoIter = Iter<S, M>;

    fn into_iter(self) -> Iter<S, M> {
        self.iter()
    }
}

impl<S: Sequence, M: Map> IntoIterator for &Points<S, M> {
    type Item = M::Point;
    type IntoIter = Iter<S, M>;

    fn into_iter(self) -> Iter<S, M> {
        self.iter()
    }
}

/// The coordinates themselves.
#[derive(Clone, Copy, Debug)]
struct Cells;

impl Map for Cells {
    type Point = [u32; 2];

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> [u32; 2] {
        uv
    }
}

/// An iterator over points: exact-size, double-ended, fused, with O(1) `nth` from both ends.
#[derive(Clone, Debug)]
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct Iter<S, M> {
    points: Points<S, M>,
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

/// The caller's memory for points.
trait Slots<P: Point>: Sized {
    /// The first `count` slots, and those after them.
    fn split(self, count: usize) -> (Self, Self);

    /// Stores the points of a sequence from an index on, one by one.
    fn fill_singly<S: Sequence, M: Map<Point = P>>(
        self,
        count: usize,
        sequence: &S,
        start: u32,
        map: &M,
    );

    /// Stores the points of a block of coordinates: the `index`-th block of these slots.
    /// `components` is memory for them.
    fn fill_block<const N: usize, M: Map<Point = P>>(
        &mut self,
        index: usize,
        u: &Block<N>,
        v: &Block<N>,
        map: &M,
        components: &mut P::Components<N>,
    );

    /// Stores `count` points, a multiple of N, by blocks of N.
    #[inline(always)]
    fn fill_blocks<const N: usize, M: Map<Point = P>, B: Fn(u32, &mut Block<N>, &mut Block<N>)>(
        mut self,
        count: usize,
        start: u32,
        map: &M,
        block: B,
    ) {
        let (mut u, mut v, mut components) = ([0; N], [0; N], P::zeros::<N>());
        let mut start = start;
        for index in 0..count / N {
            block(start, &mut u, &mut v);
            self.fill_block(index, &u, &v, map, &mut components);
            start = start.wrapping_add(N as u32);
        }
    }
}

impl<P: Point> Slots<P> for &mut [P] {
    #[inline(always)]
    fn split(self, count: usize) -> (Self, Self) {
        self.split_at_mut(count.min(self.len()))
    }

    #[inline(always)]
    fn fill_singly<S: Sequence, M: Map<Point = P>>(
        self,
        _: usize,
        sequence: &S,
        start: u32,
        map: &M,
    ) {
        sequence.fill_with(start, self, |uv| map.sample(uv));
    }

    #[inline(always)]
    fn fill_block<const N: usize, M: Map<Point = P>>(
        &mut self,
        index: usize,
        u: &Block<N>,
        v: &Block<N>,
        map: &M,
        components: &mut P::Components<N>,
    ) {
        let Some(block) = self.as_chunks_mut::<N>().0.get_mut(index) else { return };
        if M::POINTWISE {
            for (slot, (u, v)) in block.iter_mut().zip(u.iter().zip(v)) {
                map.sample([*u, *v]).store(slot);
            }
        } else {
            map.sample_block(u, v, components);
            P::interleave::<N>(components, block);
        }
    }
}

/// A buffer for each component, each as long as there are slots, or longer.
struct Apart<'a, R, const D: usize>([&'a mut [R]; D]);

impl<R: Copy + Default, const D: usize> Slots<[R; D]> for Apart<'_, R, D> {
    #[inline(always)]
    fn split(self, count: usize) -> (Self, Self) {
        let mut after = [const { None }; D];
        let mut before = self.0.map(Some);
        for (before, after) in before.iter_mut().zip(&mut after) {
            if let Some(buffer) = before.take() {
                let (first, rest) = buffer.split_at_mut(count.min(buffer.len()));
                (*before, *after) = (Some(first), Some(rest));
            }
        }
        (Self(before.map(Option::unwrap_or_default)), Self(after.map(Option::unwrap_or_default)))
    }

    #[inline(always)]
    fn fill_singly<S: Sequence, M: Map<Point = [R; D]>>(
        mut self,
        count: usize,
        sequence: &S,
        start: u32,
        map: &M,
    ) {
        for (index, uv) in sequence.iter(start).take(count).enumerate() {
            for (buffer, value) in self.0.iter_mut().zip(map.sample(uv)) {
                if let Some(slot) = buffer.get_mut(index) {
                    *slot = value;
                }
            }
        }
    }

    #[inline(always)]
    fn fill_block<const N: usize, M: Map<Point = [R; D]>>(
        &mut self,
        index: usize,
        u: &Block<N>,
        v: &Block<N>,
        map: &M,
        components: &mut [Lanes<R, N>; D],
    ) {
        map.sample_block(u, v, components);
        for (buffer, lanes) in self.0.iter_mut().zip(&*components) {
            if let Some(block) = buffer.as_chunks_mut::<N>().0.get_mut(index) {
                *block = *lanes;
            }
        }
    }
}
