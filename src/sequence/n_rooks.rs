//! N-rooks (Latin hypercube) points: N rooks on an N x N board, none attacking another
//! (P. Shirley, "Discrepancy as a Quality Measure for Sample Distributions", 1991).

use super::walk::repeat;
use super::walk::{Walk, block_in_order, indices, is_inside, walks};
use super::{Sequence, not_empty};
use crate::bits::{
    hash::{Jitter, key},
    permute::{permute, permute_block},
    strata::Strata,
};
use crate::block::{BLOCK, Block};
use crate::error::Error;

/// N points, one in each of N columns and one in each of N rows: column i, a random row.
///
/// Promise: each of the N strata of u and each of the N strata of v holds exactly one point, at one
/// of 2^16 places of the stratum. The order is by column; a renderer that pairs two such sets
/// shuffles one ([`Shuffled`](super::Shuffled)). A point costs one permutation ([`permute`]).
///
/// ```
/// use hemidisc::sequence::NRooks;
/// let rooks = NRooks::new(4, 7)?;
/// let mut rows = [0, 1, 2, 3].map(|i| rooks.at(i)[1] >> 30);
/// rows.sort();
/// assert_eq!(rows, [0, 1, 2, 3]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct NRooks {
    strata: Strata,
    rows: u32,
    jitter: Jitter,
}

impl NRooks {
    /// A set of `count` points; every seed, 0 too, is hashed.
    ///
    /// # Errors
    /// [`Error::EmptySet`] if `count` is 0.
    pub const fn new(count: u32, seed: u32) -> Result<Self, Error> {
        match not_empty(count) {
            Ok(()) => Ok(Self {
                strata: Strata::new(count),
                rows: key(seed, *b"rows"),
                jitter: Jitter::new(seed, *b"rook"),
            }),
            Err(error) => Err(error),
        }
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn seed(&self) -> u32 {
        self.jitter.seed()
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn count(&self) -> u32 {
        self.strata.count()
    }

    /// How many points there are.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        Some(self.strata.count())
    }

    /// The point of any index; the set repeats after `count` points.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let count = self.strata.count();
        let column = repeat(index, count);
        self.in_column(column, self.strata.first(column))
    }

    /// The point of a column that begins at `left`.
    #[inline(always)]
    const fn in_column(self, column: u32, left: u32) -> [u32; 2] {
        let row = permute(column, self.strata.count(), self.rows);
        let [u, v] = self.jitter.at(column);
        [self.strata.jittered(left, u), self.strata.jittered(self.strata.first(row), v)]
    }
}

impl Sequence for NRooks {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    walks!();

    /// Each round of the permutation runs over the whole block.
    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        let Self { strata, rows, jitter } = *self;
        if !is_inside::<BLOCK>(start, strata.count()) {
            return block_in_order(self.iter(start), u, v);
        }
        *v = indices(start);
        permute_block(v, strata.count(), rows);
        for ((u, v), column) in u.iter_mut().zip(v).zip(start..) {
            let [right, up] = jitter.at(column);
            *u = strata.jittered(strata.first(column), right);
            *v = strata.jittered(strata.first(*v), up);
        }
    }
}

impl Walk for NRooks {
    /// A column, and where it begins.
    type State = (u32, u32);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let column = repeat(index, self.strata.count());
        ((column, self.strata.first(column)), self.strata.count() - column)
    }

    #[inline(always)]
    fn step(&self, (column, left): &mut Self::State) -> [u32; 2] {
        let point = self.in_column(*column, *left);
        (*column, *left) = (*column + 1, self.strata.after(*left));
        point
    }
}
