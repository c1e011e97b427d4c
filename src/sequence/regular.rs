//! Regular grid: the centre of every cell of an m x n grid, row by row.
//!
//! Coordinate c of m is the cell floor((2c + 1) 2^31 / m) that holds (2c + 1) / 2m, which is never on
//! the edge of a stratum. Point i is in column i mod m, row i / m.

use super::{Grid, Sequence, repeat};
use crate::error::Error;
use core::num::NonZeroU32;

/// The centres of an m x n grid: column i mod m, row i / m.
///
/// Promise: exactly one point in each of the m x n cells, at its centre, for at most 2^31 columns and
/// rows. (Above that a centre and the edge below it may be in one cell of the coordinate.) Takes no seed. A point
/// costs two 64-bit divisions.
///
/// ```
/// use hemidisc::sequence::Regular;
/// let grid = Regular::new(2, 2)?;
/// assert_eq!(grid.at(1), [0xc000_0000, 0x4000_0000]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Regular {
    grid: Grid,
}

impl Regular {
    /// A grid of `columns` x `rows`.
    ///
    /// # Errors
    /// [`Error::EmptyGrid`] if either is 0; [`Error::SetTooLarge`] if their product exceeds a `u32`.
    pub const fn new(columns: u32, rows: u32) -> Result<Self, Error> {
        match Grid::new(columns, rows) {
            Ok(grid) => Ok(Self { grid }),
            Err(error) => Err(error),
        }
    }

    /// The point of any index; the set repeats after m n points.
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let [column, row] = self.grid.cell(repeat(index, self.grid.size()));
        [centre(column, self.grid.columns), centre(row, self.grid.rows)]
    }
}

/// floor((2c + 1) 2^31 / count): at most (2^33 - 1) 2^31, which 64 bits hold.
const fn centre(stratum: u32, count: NonZeroU32) -> u32 {
    (((2 * stratum as u64 + 1) << 31) / count.get() as u64) as u32
}

impl Sequence for Regular {
    fn size(&self) -> Option<u32> {
        Some(self.grid.size())
    }

    #[inline(always)]
    fn point(&self, index: u32) -> [u32; 2] {
        self.at(index)
    }
}
