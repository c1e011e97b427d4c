//! The cells of an m x n grid, row by row.

use super::wide::high;
use crate::error::Error;
use core::num::{NonZeroU16, NonZeroU32};

/// An m x n grid that is neither empty nor larger than a `u32` counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Grid {
    columns: NonZeroU32,
    rows: NonZeroU32,
    /// floor((2^32 - 1) / columns).
    reciprocal: u32,
}

impl Grid {
    pub(crate) const fn new(columns: u32, rows: u32) -> Result<Self, Error> {
        let (Some(m), Some(n)) = (NonZeroU32::new(columns), NonZeroU32::new(rows)) else {
            return Err(Error::EmptyGrid { columns, rows });
        };
        if columns.checked_mul(rows).is_none() {
            return Err(Error::SetTooLarge { columns, rows });
        }
        Ok(Self::of(m, n))
    }

    /// A grid of at most `u32::MAX` points.
    const fn of(columns: NonZeroU32, rows: NonZeroU32) -> Self {
        Self { columns, rows, reciprocal: u32::MAX / columns.get() }
    }

    /// A grid of sides that a `u16` counts, at most (2^16 - 1)^2 points.
    pub(crate) const fn of_sides([columns, rows]: [NonZeroU16; 2]) -> Self {
        const fn wide(side: NonZeroU16) -> NonZeroU32 {
            // `From` is not `const`.
            match NonZeroU32::new(side.get() as u32) {
                Some(side) => side,
                None => NonZeroU32::MIN,
            }
        }
        Self::of(wide(columns), wide(rows))
    }

    pub(crate) const fn columns(self) -> u32 {
        self.columns.get()
    }

    pub(crate) const fn rows(self) -> u32 {
        self.rows.get()
    }

    pub(crate) const fn size(self) -> u32 {
        self.columns() * self.rows()
    }

    /// Column and row of a point inside the set: row by row.
    ///
    /// The reciprocal is smaller than 2^32 / m by at most 1, so its product with an index is
    /// smaller than index / m by less than 1, and the row at most one too small.
    #[inline(always)]
    pub(crate) const fn cell(self, index: u32) -> [u32; 2] {
        let row = high(index, self.reciprocal);
        let column = index - row * self.columns();
        if column < self.columns() { [column, row] } else { [column - self.columns(), row + 1] }
    }
}

/// The getters of a sequence whose field `grid` is its grid.
macro_rules! grid_getters {
    () => {
        /// Columns of the grid.
        #[must_use]
        pub const fn columns(&self) -> u32 {
            self.grid.columns()
        }

        /// Rows of the grid.
        #[must_use]
        pub const fn rows(&self) -> u32 {
            self.grid.rows()
        }
    };
}
pub(crate) use grid_getters;

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::bits::hash::mix;

    pub(crate) fn lengths() -> impl Iterator<Item = u32> {
        let about = |n: u32| [n - 1, n, n + 1];
        let powers = (1..32).flat_map(move |bit| about(1 << bit));
        powers.chain([3, 5, 7, 641, 1_431_655_765, u32::MAX - 1, u32::MAX]).filter(|&n| n > 0)
    }

    #[test]
    fn cells_are_quotients_and_remainders() {
        for columns in lengths() {
            let grid = Grid::new(columns, 1).unwrap();
            let multiples = (1..100).map(|i| (u32::MAX / columns).saturating_sub(i) * columns);
            let edges = multiples.flat_map(|k| [k.wrapping_sub(1), k, k.wrapping_add(1)]);
            let ends = (0..100).flat_map(|i| [i, u32::MAX - i, columns.wrapping_mul(i)]);
            for index in edges.chain(ends).chain((0..1000).map(mix)) {
                let cell = [index % columns, index / columns];
                assert_eq!(grid.cell(index), cell, "{index} of {columns}");
            }
        }
    }
}
