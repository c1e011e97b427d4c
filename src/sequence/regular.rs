//! Regular grid: the centre of every cell of an m x n grid, row by row.
//!
//! Coordinate c of m is the cell floor((2c + 1) 2^31 / m) that holds (2c + 1) / 2m, which is never
//! on the edge of a stratum. Point i is in column i mod m, row i / m.

use super::Sequence;
use super::walk::repeat;
use super::walk::{Walk, block_in_order, walks};
use crate::bits::grid::{Grid, grid_getters};
use crate::bits::strata::Strata;
use crate::block::Block;
use crate::error::Error;

/// The centres of an m x n grid: column i mod m, row i / m.
///
/// Promise: exactly one point in each of the m x n cells, at its centre, for at most 2^31 columns
/// and rows. (Above that a centre and the edge below it may be in one cell of the coordinate.)
/// Takes no seed.
///
/// ```
/// use hemidisc::sequence::Regular;
/// let grid = Regular::new(2, 2)?;
/// assert_eq!(grid.at(1), [0xc000_0000, 0x4000_0000]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Regular {
    grid: Grid,
    columns: Centres,
    rows: Centres,
}

impl Regular {
    /// A grid of `columns` x `rows`.
    ///
    /// # Errors
    /// [`Error::EmptyGrid`] if either is 0; [`Error::SetTooLarge`] if their product exceeds a
    /// `u32`.
    pub const fn new(columns: u32, rows: u32) -> Result<Self, Error> {
        match Grid::new(columns, rows) {
            Ok(grid) => Ok(Self { grid, columns: Centres::new(columns), rows: Centres::new(rows) }),
            Err(error) => Err(error),
        }
    }

    grid_getters!();

    /// How many points there are.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        Some(self.grid.size())
    }

    /// The point of any index; the set repeats after m n points.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let [column, row] = self.grid.cell(repeat(index, self.grid.size()));
        let (left, top) = (self.columns.strata.first(column), self.rows.strata.first(row));
        [self.columns.centre(left), self.rows.centre(top)]
    }
}

/// The centres of the strata of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct Centres {
    strata: Strata,
    /// floor(2^31 / count) and 2^31 mod count: half a stratum.
    half: u32,
    rest: u32,
}

impl Centres {
    const fn new(count: u32) -> Self {
        let strata = Strata::new(count);
        Self { strata, half: (1 << 31) / strata.count(), rest: (1 << 31) % strata.count() }
    }

    /// floor((2c + 1) 2^31 / count) for the stratum that begins at `first`: that is c
    /// 2^32 / count + s / count with a slack s < count, and the centre half a stratum further on
    /// and s / count back.
    #[inline(always)]
    const fn centre(self, first: u32) -> u32 {
        let slack = first.wrapping_mul(self.strata.count());
        first.wrapping_add(self.half).wrapping_sub((slack > self.rest) as u32)
    }
}

impl Sequence for Regular {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    walks!();

    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        block_in_order(self.iter(start), u, v);
    }
}

/// A row at a time.
impl Walk for Regular {
    /// Where the column begins, and v.
    type State = (u32, u32);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let [column, row] = self.grid.cell(repeat(index, self.grid.size()));
        let v = self.rows.centre(self.rows.strata.first(row));
        ((self.columns.strata.first(column), v), self.grid.columns() - column)
    }

    #[inline(always)]
    fn step(&self, (left, v): &mut Self::State) -> [u32; 2] {
        let point = [self.columns.centre(*left), *v];
        *left = self.columns.strata.after(*left);
        point
    }
}
