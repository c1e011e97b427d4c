//! Points that the caller has stored: recorded, random, or a table in flash.

use super::walk::block_in_order;
use super::walk::repeat;
use super::{Sequence, looked_up};
use crate::block::{BLOCK, Block};
use crate::error::Error;

/// The caller's own points, in a slice of at least one.
///
/// Promise: none beyond what the slice holds. A point costs a load.
///
/// ```
/// use hemidisc::sequence::Stored;
/// let points = [[0, 0], [1 << 31, 1 << 30]];
/// assert_eq!(Stored::new(&points)?.at(1), [1 << 31, 1 << 30]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Stored<'a> {
    points: &'a [[u32; 2]],
}

impl<'a> Stored<'a> {
    /// The points of a slice.
    ///
    /// # Errors
    /// [`Error::EmptySet`] for an empty slice, [`Error::StoredTooLong`] for more than a `u32`
    /// counts.
    pub const fn new(points: &'a [[u32; 2]]) -> Result<Self, Error> {
        if points.is_empty() {
            return Err(Error::EmptySet);
        }
        if points.len() as u64 > u32::MAX as u64 {
            return Err(Error::StoredTooLong { len: points.len() });
        }
        Ok(Self { points })
    }

    /// How many points there are.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        Some(self.points.len() as u32)
    }

    /// The point of any index; the set repeats after its last point.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let index = repeat(index, self.points.len() as u32) as usize;
        // Always true; the comparison removes a path to a panic.
        if index < self.points.len() { self.points[index] } else { [0; 2] }
    }

    /// The points from an index up to the end of the slice or of the indices; at least one.
    #[inline(always)]
    fn stretch(&self, start: u32) -> &'a [[u32; 2]] {
        let first = repeat(start, self.points.len() as u32) as usize;
        up_to_the_last_index(self.points.get(first..).unwrap_or_default(), start)
    }
}

/// Of points whose first has the index `start`.
#[inline(always)]
fn up_to_the_last_index(points: &[[u32; 2]], start: u32) -> &[[u32; 2]] {
    let indices = if start == 0 { usize::MAX } else { start.wrapping_neg() as usize };
    points.get(..indices).unwrap_or(points)
}

impl Sequence for Stored<'_> {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    #[inline(always)]
    fn iter(&self, start: u32) -> impl Iterator<Item = [u32; 2]> {
        let from = self.stretch(start);
        let after = looked_up(*self, start.wrapping_add(from.len() as u32));
        from.iter().copied().chain(after)
    }

    #[inline(always)]
    fn fill_with<P>(&self, start: u32, slots: &mut [P], map: impl Fn([u32; 2]) -> P) {
        let (mut start, mut left, mut from) = (start, slots, self.stretch(start));
        while !left.is_empty() {
            let (slots, rest) = left.split_at_mut(left.len().min(from.len()));
            walk(from, slots, &map);
            start = start.wrapping_add(slots.len() as u32);
            left = rest;
            // The slice's first point comes at index 0 and after the slice's end.
            from = up_to_the_last_index(self.points, start);
        }
    }

    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        // All but the last of the slice: vectors take the axes apart.
        if let Some(points) = self.stretch(start).first_chunk::<BLOCK>() {
            block_in_order(points.iter().copied(), u, v);
        } else {
            block_in_order(self.iter(start), u, v);
        }
    }
}

/// Slots and points along two slices. A chained iterator would test at each point which half it is
/// in. Inlined into the loop over stretches, it would leave the map too few registers.
#[inline(never)]
fn walk<P>(points: &[[u32; 2]], slots: &mut [P], map: impl Fn([u32; 2]) -> P) {
    for (slot, point) in slots.iter_mut().zip(points) {
        *slot = map(*point);
    }
}
