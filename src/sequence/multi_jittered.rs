//! Multi-jittered points: jittered and n-rooks at once (K. Chiu, P. Shirley and C. Wang,
//! "Multi-Jittered Sampling", Graphics Gems IV, 1994).
//!
//! The cell in column c and row r puts its point into fine column c n + P_c(r) and fine row
//! r m + Q_r(c) of an mn x mn board, where P_c permutes the n rows of column c and Q_r the m
//! columns of row r, each with a key of its own.

use super::Sequence;
use super::walk::repeat;
use super::walk::{Walk, block_in_order, is_inside, walks};
use crate::bits::grid::{Grid, grid_getters};
use crate::bits::{
    hash::{Jitter, key, mix},
    permute::{permute, permute_each},
    strata::Strata,
};
use crate::block::{BLOCK, Block};
use crate::error::Error;

/// One random point in each cell of an m x n grid that also has one in each of mn columns and rows.
///
/// Promise: exactly one point in each of the m x n cells, in each of the mn strata of u and in each
/// of the mn strata of v, at one of 2^16 places of each. The order is row by row. A point costs two
/// permutations ([`permute`]).
///
/// ```
/// use hemidisc::sequence::MultiJittered;
/// let set = MultiJittered::new(2, 2, 7)?;
/// let mut columns = [0, 1, 2, 3].map(|i| set.at(i)[0] >> 30);
/// columns.sort();
/// assert_eq!(columns, [0, 1, 2, 3]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MultiJittered {
    grid: Grid,
    fine: Strata,
    in_columns: u32,
    in_rows: u32,
    jitter: Jitter,
}

impl MultiJittered {
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
            in_columns: key(seed, *b"mulc"),
            in_rows: key(seed, *b"mulr"),
            jitter: Jitter::new(seed, *b"mult"),
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
        self.in_cell(index, self.grid.cell(index))
    }

    /// The point of an index inside the set, whose cell is known.
    #[inline(always)]
    const fn in_cell(self, index: u32, [column, row]: [u32; 2]) -> [u32; 2] {
        let (columns, rows) = (self.grid.columns(), self.grid.rows());
        let fine_column =
            column * rows + permute(row, rows, mix(self.in_columns.wrapping_add(column)));
        let fine_row =
            row * columns + permute(column, columns, mix(self.in_rows.wrapping_add(row)));
        let [u, v] = self.jitter.at(index);
        [
            self.fine.jittered(self.fine.first(fine_column), u),
            self.fine.jittered(self.fine.first(fine_row), v),
        ]
    }
}

impl Sequence for MultiJittered {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    walks!();

    /// Each round of the permutations runs over the whole block.
    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        let Self { grid, fine, .. } = *self;
        if !is_inside::<BLOCK>(start, grid.size()) {
            return block_in_order(self.iter(start), u, v);
        }
        let (mut columns, mut rows) = ([0; BLOCK], [0; BLOCK]);
        for ((column, row), index) in columns.iter_mut().zip(&mut rows).zip(start..) {
            [*column, *row] = grid.cell(index);
        }
        (*u, *v) = (rows, columns);
        permute_each(
            u,
            grid.rows(),
            columns.map(|column| mix(self.in_columns.wrapping_add(column))),
        );
        permute_each(v, grid.columns(), rows.map(|row| mix(self.in_rows.wrapping_add(row))));
        let cells = columns.iter().zip(&rows).zip(start..);
        for ((u, v), ((column, row), index)) in u.iter_mut().zip(v).zip(cells) {
            let [right, up] = self.jitter.at(index);
            *u = fine.jittered(fine.first(column * grid.rows() + *u), right);
            *v = fine.jittered(fine.first(row * grid.columns() + *v), up);
        }
    }
}

/// A row at a time.
impl Walk for MultiJittered {
    /// The index and its cell.
    type State = (u32, [u32; 2]);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let index = repeat(index, self.grid.size());
        let [column, row] = self.grid.cell(index);
        ((index, [column, row]), self.grid.columns() - column)
    }

    #[inline(always)]
    fn step(&self, (index, cell): &mut Self::State) -> [u32; 2] {
        let point = self.in_cell(*index, *cell);
        (*index, cell[0]) = (index.wrapping_add(1), cell[0] + 1);
        point
    }
}
