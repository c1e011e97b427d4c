//! Correlated multi-jittered points (A. Kensler, "Correlated Multi-Jittered Sampling", Pixar
//! Technical Memo 13-01, 2013).
//!
//! As multi-jittered, but every column permutes its rows alike and every row its columns, which
//! spreads neighbours evenly: column c and row r go to fine column p(c) n + q(r) and fine row
//! r m + c, after a shuffle of the order of all points.

use super::Sequence;
use super::walk::repeat;
use super::walk::{block_in_order, indices, is_inside};
use crate::bits::grid::{Grid, grid_getters};
use crate::bits::{
    hash::{Jitter, key},
    permute::{permute, permute_block},
    strata::Strata,
};
use crate::block::{BLOCK, Block};
use crate::error::Error;

/// One random point in each cell of an m x n grid, in each of mn columns and in each of mn rows,
/// evenly spread and in shuffled order.
///
/// Promise: exactly one point in each of the m x n cells, in each of the mn strata of u and in each
/// of the mn strata of v, at one of 2^16 places of each. A point costs three permutations
/// ([`permute`]).
///
/// ```
/// use hemidisc::sequence::Correlated;
/// let set = Correlated::new(2, 2, 7)?;
/// let mut rows = [0, 1, 2, 3].map(|i| set.at(i)[1] >> 30);
/// rows.sort();
/// assert_eq!(rows, [0, 1, 2, 3]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Correlated {
    grid: Grid,
    fine: Strata,
    order: u32,
    columns: u32,
    rows: u32,
    jitter: Jitter,
}

impl Correlated {
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
            fine: Strata::new(grid.size()),
            order: key(seed, *b"coro"),
            columns: key(seed, *b"corc"),
            rows: key(seed, *b"corw"),
            jitter: Jitter::new(seed, *b"corr"),
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
        let size = self.grid.size();
        let (columns, rows) = (self.grid.columns(), self.grid.rows());
        let index = permute(repeat(index, size), size, self.order);
        let [column, row] = self.grid.cell(index);
        let fine_column =
            permute(column, columns, self.columns) * rows + permute(row, rows, self.rows);
        let [u, v] = self.jitter.at(index);
        // r m + c is the shuffled index itself.
        [
            self.fine.jittered(self.fine.first(fine_column), u),
            self.fine.jittered(self.fine.first(index), v),
        ]
    }
}

impl Sequence for Correlated {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    /// Each round of the permutations runs over the whole block.
    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        let Self { grid, fine, .. } = *self;
        if !is_inside::<BLOCK>(start, grid.size()) {
            return block_in_order(self.iter(start), u, v);
        }
        let mut order = indices(start);
        permute_block(&mut order, grid.size(), self.order);
        for ((column, row), index) in u.iter_mut().zip(v.iter_mut()).zip(order) {
            [*column, *row] = grid.cell(index);
        }
        permute_block(u, grid.columns(), self.columns);
        permute_block(v, grid.rows(), self.rows);
        for ((u, v), index) in u.iter_mut().zip(v).zip(order) {
            let [right, up] = self.jitter.at(index);
            *u = fine.jittered(fine.first(*u * grid.rows() + *v), right);
            *v = fine.jittered(fine.first(index), up);
        }
    }
}
