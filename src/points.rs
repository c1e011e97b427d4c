//! Points: a sequence through a map, as a `Copy` value; and the one loop that fills buffers.
//!
//! A part of a set is byte-identical to the same indices of the whole, so a set can be split over
//! threads, machines or time. Filling takes single points up to a multiple of 64, then blocks of
//! 64, one array a component, then the rest. Where blocks do not pay (`target.rs`) it takes all
//! points one by one. The bits are the same.

use crate::block::{BLOCK, Point};
use crate::error::Error;
use crate::map::Map;
use crate::sequence::Sequence;
use crate::target::BLOCKED;
use core::iter::FusedIterator;
use core::ops::{Bound, RangeBounds};
use slots::{Apart, Slots};

mod chunks;
mod iter;
mod slots;

pub use chunks::Chunks;
pub use iter::Iter;

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

    /// The points of a range of indices of `sequence`. Only this constructor reaches index
    /// `u32::MAX`.
    ///
    /// An unbounded end is the end of the set.
    ///
    /// # Errors
    /// [`Error::Range`] if the range is not within the set, or has 2^32 points.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, Points, sequence::Sobol};
    /// let map = Concentric::<LibmF32>::new();
    /// let last = Points::with_range(Sobol::new(0), map, u32::MAX - 3..=u32::MAX)?;
    /// assert_eq!(last.len(), 4);
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    pub fn with_range(sequence: S, map: M, range: impl RangeBounds<u32>) -> Result<Self, Error> {
        let (start, len) = resolve(range, sequence.size().map_or(1 << 32, u64::from))?;
        Ok(Self { sequence, map, start, len })
    }

    /// The points of a range of this set, counted from its first.
    ///
    /// # Errors
    /// [`Error::Range`] if it is not within this set.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, Points, sequence::Sobol};
    /// let lens = Points::new(Sobol::new(0), Concentric::<LibmF32>::new());
    /// let second = lens.range(64..128)?;
    /// assert_eq!(second.get(0), lens.get(64));
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    pub fn range(self, range: impl RangeBounds<u32>) -> Result<Self, Error> {
        let (start, len) = resolve(range, self.len.into())?;
        Ok(Self { start: self.start.wrapping_add(start), len, ..self })
    }

    /// The first `count` points.
    ///
    /// # Errors
    /// [`Error::Range`] if there are fewer.
    pub fn take(self, count: u32) -> Result<Self, Error> {
        self.range(..count)
    }

    /// The points before and from `middle`.
    ///
    /// # Errors
    /// [`Error::Range`] if `middle` exceeds the length.
    pub fn split_at(self, middle: u32) -> Result<(Self, Self), Error> {
        let before = self.range(..middle)?;
        let after = self.range(middle..)?;
        Ok((before, after))
    }

    /// The `shard`-th, counted from 0, of `of` consecutive parts whose lengths differ by at most 1.
    ///
    /// # Errors
    /// [`Error::Shard`] unless `shard` < `of`.
    pub fn shard(self, shard: u32, of: u32) -> Result<Self, Error> {
        if shard >= of {
            return Err(Error::Shard { shard, of });
        }
        // Fits in a `u32`, because shard + 1 <= of.
        let edge = |k: u64| (u64::from(self.len) * k / u64::from(of)) as u32;
        self.range(edge(shard.into())..edge(u64::from(shard) + 1))
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
    pub fn iter_coordinates(
        &self,
    ) -> impl ExactSizeIterator<Item = [u32; 2]> + DoubleEndedIterator + FusedIterator + Clone {
        let Self { sequence, start, len, .. } = *self;
        (0..len).map(move |index| sequence.at(start.wrapping_add(index)))
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
        let ahead = count.min((start.wrapping_neg() % BLOCK as u32) as usize);
        let (full, odd) = ((count - ahead) / BLOCK, (count - ahead) % BLOCK);
        let (head, rest) = slots.split(ahead);
        let (mut blocks, tail) = rest.split(full * BLOCK);
        head.fill_singly(ahead, &sequence, start, &map);
        let mut start = start.wrapping_add(ahead as u32);
        let (mut u, mut v, mut components) = ([0; BLOCK], [0; BLOCK], M::Point::zeros());
        for index in 0..full {
            sequence.block(start, &mut u, &mut v);
            blocks.fill_block(index, &u, &v, &map, &mut components);
            start = start.wrapping_add(BLOCK as u32);
        }
        tail.fill_singly(odd, &sequence, start, &map);
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

/// Start and length of a range within a set of `len` points.
fn resolve(range: impl RangeBounds<u32>, len: u64) -> Result<(u32, u32), Error> {
    let start = match range.start_bound() {
        Bound::Included(start) => u64::from(*start),
        Bound::Excluded(before) => u64::from(*before) + 1,
        Bound::Unbounded => 0,
    };
    let end = match range.end_bound() {
        Bound::Included(last) => u64::from(*last) + 1,
        Bound::Excluded(end) => u64::from(*end),
        // As many as there are, or as `Points` counts.
        Bound::Unbounded => len.min(start + u64::from(u32::MAX)).max(start),
    };
    let Some(count) = end.checked_sub(start) else {
        return Err(Error::ReversedRange { start, end });
    };
    match (u32::try_from(start), u32::try_from(count)) {
        (Ok(start), Ok(count)) if end <= len => Ok((start, count)),
        _ => Err(Error::Range { start, count, len }),
    }
}

/// Filling `heapless` vectors, which cannot panic on a short capacity.
#[cfg(feature = "heapless")]
impl<S: Sequence, M: Map> Points<S, M> {
    /// Appends points until the set or the vector's capacity ends; returns how many.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, Points, sequence::R2};
    /// let lens = Points::new(R2::new(0), Concentric::<LibmF32>::new());
    /// let mut buffer: heapless::Vec<[f32; 2], 16> = heapless::Vec::new();
    /// assert_eq!(lens.extend_heapless(&mut buffer), 16);
    /// ```
    pub fn extend_heapless<const N: usize>(&self, vec: &mut heapless::Vec<M::Point, N>) -> usize {
        let before = vec.len();
        for point in self.iter().take(vec.capacity() - before) {
            // There is room, so nothing is refused.
            if vec.push(point).is_err() {
                break;
            }
        }
        vec.len() - before
    }

    /// The whole set in a vector of capacity `N`.
    ///
    /// # Errors
    /// [`Error::Capacity`] if the set is larger than `N`.
    pub fn to_heapless<const N: usize>(&self) -> Result<heapless::Vec<M::Point, N>, Error> {
        if self.len as usize > N {
            return Err(Error::Capacity { len: self.len, capacity: N });
        }
        let mut vec = heapless::Vec::new();
        self.extend_heapless(&mut vec);
        Ok(vec)
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
