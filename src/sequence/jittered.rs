//! Jittered points: one uniformly random point in every cell of an m x n grid
//! (R. Cook, "Stochastic Sampling in Computer Graphics", 1986).

use super::Sequence;
use super::walk::repeat;
use super::walk::{Walk, block_in_order, walks};
use crate::bits::grid::{Grid, grid_getters};
use crate::bits::{hash::Jitter, strata::Strata};
use crate::block::Block;
use crate::error::Error;

/// One random point in each cell of an m x n grid: column i mod m, row i / m.
///
/// Promise: exactly one point in each of the m x n cells, at one of 2^16 x 2^16 places. The order
/// is row by row; a renderer that pairs two such sets shuffles one ([`Shuffled`](super::Shuffled)).
/// A point costs one hash.
///
/// ```
/// use hemidisc::sequence::Jittered;
/// let [u, v] = Jittered::new(4, 4, 7)?.at(5);
/// assert_eq!([u >> 30, v >> 30], [1, 1]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Jittered {
    grid: Grid,
    columns: Strata,
    rows: Strata,
    jitter: Jitter,
}

impl Jittered {
    /// A grid of `columns` x `rows`; every seed, 0 too, is hashed.
    ///
    /// # Errors
    /// [`Error::EmptyGrid`] if either is 0; [`Error::SetTooLarge`] if their product exceeds a
    /// `u32`.
    pub const fn new(columns: u32, rows: u32, seed: u32) -> Result<Self, Error> {
        match Grid::new(columns, rows) {
            Ok(grid) => Ok(Self::on(grid, seed)),
            Err(error) => Err(error),
        }
    }

    /// The set on a grid.
    pub(crate) const fn on(grid: Grid, seed: u32) -> Self {
        Self {
            grid,
            columns: Strata::new(grid.columns()),
            rows: Strata::new(grid.rows()),
            jitter: Jitter::new(seed, *b"jitt"),
        }
    }

    grid_getters!();

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn seed(&self) -> u32 {
        self.jitter.seed()
    }

    /// How many points there are.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        Some(self.grid.size())
    }

    /// The point of any index; the set repeats after m n points.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let index = repeat(index, self.grid.size());
        let [column, row] = self.grid.cell(index);
        let [u, v] = self.jitter.at(index);
        [
            self.columns.jittered(self.columns.first(column), u),
            self.rows.jittered(self.rows.first(row), v),
        ]
    }
}

impl Sequence for Jittered {
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
impl Walk for Jittered {
    /// The index, and where its column and its row begin.
    type State = (u32, u32, u32);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let index = repeat(index, self.grid.size());
        let [column, row] = self.grid.cell(index);
        let state = (index, self.columns.first(column), self.rows.first(row));
        (state, self.grid.columns() - column)
    }

    #[inline(always)]
    fn step(&self, (index, left, top): &mut Self::State) -> [u32; 2] {
        let [u, v] = self.jitter.at(*index);
        let point = [self.columns.jittered(*left, u), self.rows.jittered(*top, v)];
        (*index, *left) = (index.wrapping_add(1), self.columns.after(*left));
        point
    }
}
