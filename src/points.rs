//! Points: a sequence through a map, as a `Copy` value; and the one loop that fills a buffer.
//!
//! A part of a set is byte-identical to the same indices of the whole, so a set can be split over
//! threads, machines or time. Filling takes single points up to a multiple of 64, whole blocks of
//! 64 an axis at a time, then the rest; where blocks do not pay (`Arithmetic::BLOCKED`) it takes the
//! points one by one. The bits are the same.

use crate::arithmetic::Arithmetic;
use crate::error::Error;
use crate::map::Map;
use crate::sequence::{BLOCK, Sequence};
use core::iter::FusedIterator;

mod chunks;
mod iter;

pub use chunks::Chunks;
pub use iter::Iter;

#[cfg(target_pointer_width = "16")]
compile_error!("hemidisc counts points in u32 and needs a usize of at least 32 bits");

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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Points<S, M> {
    sequence: S,
    map: M,
    start: u32,
    len: u32,
}

impl<S: Sequence, M: Map> Points<S, M> {
    /// All points of a set, or the first 2^32 - 1 of an endless sequence.
    pub fn new(sequence: S, map: M) -> Self {
        Self { sequence, map, start: 0, len: sequence.size().unwrap_or(u32::MAX) }
    }

    /// `count` points of `sequence` from index `start`; the way to index `u32::MAX`.
    ///
    /// # Errors
    /// [`Error::Range`] if they are not within the set, or not below 2^32.
    pub fn of_range(sequence: S, map: M, start: u32, count: u32) -> Result<Self, Error> {
        let end = u64::from(start) + u64::from(count);
        let len = sequence.size().map_or(1 << 32, u64::from);
        if end > len {
            return Err(Error::Range { start, count, len });
        }
        Ok(Self { sequence, map, start, len: count })
    }

    /// `count` points of this set, from its `start`-th on.
    ///
    /// # Errors
    /// [`Error::Range`] if they are not within this set.
    pub fn range(self, start: u32, count: u32) -> Result<Self, Error> {
        let len = u64::from(self.len);
        if u64::from(start) + u64::from(count) > len {
            return Err(Error::Range { start, count, len });
        }
        Ok(Self { start: self.start.wrapping_add(start), len: count, ..self })
    }

    /// The first `count` points.
    ///
    /// # Errors
    /// [`Error::Range`] if there are fewer.
    pub fn first(self, count: u32) -> Result<Self, Error> {
        self.range(0, count)
    }

    /// The points before and from `middle`.
    ///
    /// # Errors
    /// [`Error::Range`] if `middle` exceeds the length.
    pub fn split_at(self, middle: u32) -> Result<(Self, Self), Error> {
        let before = self.range(0, middle)?;
        let after = self.range(middle, self.len - middle)?;
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
        // Below `len`, for shard + 1 <= of.
        let edge = |k: u64| (u64::from(self.len) * k / u64::from(of)) as u32;
        let start = edge(shard.into());
        self.range(start, edge(u64::from(shard) + 1) - start)
    }

    /// How many points there are.
    pub const fn len(&self) -> u32 {
        self.len
    }

    /// Whether there are none.
    pub const fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The sequence.
    pub const fn sequence(&self) -> &S {
        &self.sequence
    }

    /// The map.
    pub const fn map(&self) -> &M {
        &self.map
    }

    /// The `index`-th point, if there is one; O(1).
    #[inline]
    pub fn get(&self, index: u32) -> Option<M::Point> {
        Some(self.map.sample(self.coordinates(index)?))
    }

    /// The coordinates of the `index`-th point on the unit square, if there is one.
    #[inline]
    pub fn coordinates(&self, index: u32) -> Option<[u32; 2]> {
        (index < self.len).then(|| self.sequence.point(self.start.wrapping_add(index)))
    }

    /// The coordinates of all points in order: candidates for rejection, or for a map of one's own.
    pub fn iter_coordinates(
        &self,
    ) -> impl ExactSizeIterator<Item = [u32; 2]> + DoubleEndedIterator + FusedIterator + Clone {
        let Self { sequence, start, len, .. } = *self;
        (0..len).map(move |index| sequence.point(start.wrapping_add(index)))
    }

    /// The points in order.
    pub const fn iter(&self) -> Iter<S, M> {
        Iter { points: *self }
    }

    /// Writes points into the caller's buffer until either ends; says how many.
    ///
    /// The rest of a longer buffer is left as it is.
    #[inline]
    pub fn fill(&self, buffer: &mut [M::Point]) -> usize {
        let count = buffer.len().min(self.len as usize);
        let Some(buffer) = buffer.get_mut(..count) else { return 0 };
        if M::Arithmetic::BLOCKED {
            let ahead = (self.start.wrapping_neg() % BLOCK as u32) as usize;
            let (head, rest) = buffer.split_at_mut(ahead.min(count));
            self.fill_singly(self.start, head);
            let mut start = self.start.wrapping_add(ahead as u32);
            let (blocks, tail) = rest.as_chunks_mut::<BLOCK>();
            let (mut u, mut v) = ([0; BLOCK], [0; BLOCK]);
            for block in blocks {
                self.sequence.block(start, &mut u, &mut v);
                self.map.sample_block(&u, &v, block);
                start = start.wrapping_add(BLOCK as u32);
            }
            self.fill_singly(start, tail);
        } else {
            self.fill_singly(self.start, buffer);
        }
        count
    }

    #[inline(always)]
    fn fill_singly(&self, start: u32, buffer: &mut [M::Point]) {
        self.sequence.fill_with(start, buffer, |uv| self.map.sample(uv));
    }

    /// Writes the components of points into a buffer each, until the shortest ends or the set; says how
    /// many points.
    ///
    /// The numbers are those of [`fill`](Self::fill); the rest of longer buffers is left as it is.
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
        mut buffers: [&mut [R]; D],
    ) -> usize
    where
        M: Map<Point = [R; D]>,
    {
        let shortest = buffers.iter().map(|buffer| buffer.len()).min().unwrap_or(0);
        let count = shortest.min(self.len as usize);
        // LLVM vectorises the stores into arrays of its own, not those into the caller's slices.
        let mut block = [[R::default(); BLOCK]; D];
        let mut done = 0;
        while done < count {
            let start = self.start.wrapping_add(done as u32);
            // Up to the next multiple of 64, so that all but the first and the last are whole blocks.
            let size = (BLOCK - start as usize % BLOCK).min(count - done);
            if size == BLOCK && M::Arithmetic::BLOCKED {
                let (mut u, mut v) = ([0; BLOCK], [0; BLOCK]);
                self.sequence.block(start, &mut u, &mut v);
                for (lane, (u, v)) in u.into_iter().zip(v).enumerate() {
                    let point = self.map.sample([u, v]);
                    for (component, value) in block.iter_mut().zip(point) {
                        component[lane] = value;
                    }
                }
            } else {
                for (lane, uv) in self.sequence.iter(start).take(size).enumerate() {
                    for (component, value) in block.iter_mut().zip(self.map.sample(uv)) {
                        component[lane] = value;
                    }
                }
            }
            for (buffer, component) in buffers.iter_mut().zip(&block) {
                let slots = buffer.iter_mut().skip(done);
                slots.zip(component.iter().take(size)).for_each(|(slot, value)| *slot = *value);
            }
            done += size;
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
        let mut array = [M::Point::default(); N];
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

/// Filling `heapless` vectors, which cannot panic on a short capacity.
#[cfg(feature = "heapless")]
impl<S: Sequence, M: Map> Points<S, M> {
    /// Appends points until the set or the vector's capacity ends; says how many.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, Points, sequence::R2};
    /// let lens = Points::new(R2::new(0), Concentric::<LibmF32>::new());
    /// let mut buffer: heapless::Vec<[f32; 2], 16> = heapless::Vec::new();
    /// assert_eq!(lens.extend_vec(&mut buffer), 16);
    /// ```
    pub fn extend_vec<const N: usize>(&self, vec: &mut heapless::Vec<M::Point, N>) -> usize {
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
    pub fn to_vec<const N: usize>(&self) -> Result<heapless::Vec<M::Point, N>, Error> {
        if self.len as usize > N {
            return Err(Error::Capacity { len: self.len, capacity: N });
        }
        let mut vec = heapless::Vec::new();
        self.extend_vec(&mut vec);
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
