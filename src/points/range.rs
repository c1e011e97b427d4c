//! Parts of a set: ranges of indices, counted from the first point.

use super::Points;
use crate::error::Error;
use crate::map::Map;
use crate::sequence::Sequence;
use core::ops::{Bound, RangeBounds};

impl<S: Sequence, M: Map> Points<S, M> {
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
