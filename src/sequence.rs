//! Sequences: pure functions from (index, parameters, seed) to two `u32` coordinates.
//!
//! Integers only, no state, O(1) for any index, the same bits on every target. Each file states
//! its promise, which strata of the square a set of points hits, and `invariant` proves it.
//!
//! | sequence | points | seed | promise |
//! | --- | --- | --- | --- |
//! | [`Regular`] | m x n | none | one point at the centre of each cell of an m x n grid |
//! | [`Random`] | endless | hashed | none: independent uniform points |
//! | [`Jittered`] | m x n | hashed | one point in each cell of an m x n grid |
//! | [`NRooks`] | N | hashed | one point in each of N columns and in each of N rows |
//! | [`MultiJittered`] | m x n | hashed | both: m x n cells, and mn columns and rows |
//! | [`Correlated`] | m x n | hashed | both, with evenly spread neighbours, in shuffled order |
//! | [`Hammersley`] | N | none | N columns; for N = 2^k every elementary interval |
//! | [`Halton`] | endless | none | elementary intervals of 2^a x 3^b |
//! | [`Sobol`] | endless | xor shift | each aligned block of 2^k is a (0, k, 2)-net |
//! | [`SobolOwen`] | endless | scramble | as Sobol, randomly scrambled, in shuffled order |
//! | [`R2`] | endless | additive shift | none proved: low discrepancy for every N |
//! | [`Stored`] | the slice's | none | the caller's own points |
//! | [`Shuffled`] | as inside | hashed | another set's points in another order |

mod correlated;
mod halton;
mod hammersley;
mod jittered;
mod multi_jittered;
mod n_rooks;
mod r2;
mod random;
mod regular;
#[cfg(feature = "rand_core")]
mod rng;
mod shuffled;
mod sobol;
mod sobol_owen;
mod stored;

pub use correlated::Correlated;
pub use halton::Halton;
pub use hammersley::Hammersley;
pub use jittered::Jittered;
pub use multi_jittered::MultiJittered;
pub use n_rooks::NRooks;
pub use r2::R2;
pub use random::Random;
pub use regular::Regular;
#[cfg(feature = "rand_core")]
pub use rng::FromRng;
pub use shuffled::Shuffled;
pub use sobol::Sobol;
pub use sobol_owen::SobolOwen;
pub use stored::Stored;

use crate::bits::wide::{HALVES, high};
use crate::error::Error;
use core::num::NonZeroU32;

/// Points in a block: what [`Sequence::block`] makes and a block of a map consumes at a time.
pub const BLOCK: usize = 64;

/// One coordinate of a block of points.
pub type Block = [u32; BLOCK];

/// A set or an endless sequence of points on the unit square.
///
/// Implement [`size`](Self::size) and [`point`](Self::point); the rest is provided, and may be
/// overridden as long as it gives the same bits.
pub trait Sequence: Copy {
    /// How many points there are; `None` for a sequence that has one for every `u32` index.
    fn size(&self) -> Option<u32>;

    /// The point of any index. A set repeats from its [`size`](Self::size) on.
    fn point(&self, index: u32) -> [u32; 2];

    /// The points from index `start` on, without end; the index wraps after `u32::MAX`.
    #[inline(always)]
    fn iter(&self, start: u32) -> impl Iterator<Item = [u32; 2]> {
        looked_up(*self, start)
    }

    /// Writes what `map` makes of the points from index `start` on, a slot each.
    #[inline(always)]
    fn fill_with<P>(&self, start: u32, slots: &mut [P], map: impl Fn([u32; 2]) -> P) {
        for (slot, point) in slots.iter_mut().zip(self.iter(start)) {
            *slot = map(point);
        }
    }

    /// The points of indices `start` .. `start` + 64, `start` a multiple of 64, an axis at a time.
    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        for (offset, (u, v)) in (0..).zip(u.iter_mut().zip(v)) {
            [*u, *v] = self.point(start.wrapping_add(offset));
        }
    }
}

/// The points from an index on, each by its index.
#[inline(always)]
fn looked_up<S: Sequence>(sequence: S, start: u32) -> impl Iterator<Item = [u32; 2]> {
    let mut index = start;
    core::iter::repeat_with(move || {
        let point = sequence.point(index);
        index = index.wrapping_add(1);
        point
    })
}

/// A sequence in stretches that are dear to begin and cheap to go on with.
trait Walk: Sequence {
    type State: Default;

    /// The state at an index, and for how many points it serves: at least one.
    fn enter(&self, index: u32) -> (Self::State, u32);

    /// Takes a point from a state.
    fn step(&self, state: &mut Self::State) -> [u32; 2];

    /// A stretch, which ends with the indices, too: the first of all follows the last.
    #[inline(always)]
    fn stretch(&self, start: u32) -> (Self::State, u32) {
        let (state, left) = self.enter(start);
        (state, if start == 0 { left } else { left.min(start.wrapping_neg()) })
    }

    /// [`Sequence::iter`].
    #[inline(always)]
    fn walk(self, start: u32) -> impl Iterator<Item = [u32; 2]> {
        let (mut state, mut left, mut next) = (Self::State::default(), 0, start);
        core::iter::repeat_with(move || {
            if left == 0 {
                (state, left) = self.stretch(next);
                next = next.wrapping_add(left);
            }
            left -= 1;
            self.step(&mut state)
        })
    }

    /// [`Sequence::fill_with`]: a loop for a stretch asks one question a point.
    #[inline(always)]
    fn walk_into<P>(&self, start: u32, slots: &mut [P], map: impl Fn([u32; 2]) -> P) {
        let (mut next, mut slots) = (start, slots);
        while !slots.is_empty() {
            let (mut state, left) = self.stretch(next);
            let (now, rest) = slots.split_at_mut(slots.len().min(left as usize));
            for slot in now.iter_mut() {
                *slot = map(self.step(&mut state));
            }
            next = next.wrapping_add(now.len() as u32);
            slots = rest;
        }
    }
}

/// The methods of a [`Sequence`] that walks.
macro_rules! walks {
    () => {
        #[inline(always)]
        fn iter(&self, start: u32) -> impl Iterator<Item = [u32; 2]> {
            self.walk(start)
        }

        #[inline(always)]
        fn fill_with<P>(&self, start: u32, slots: &mut [P], map: impl Fn([u32; 2]) -> P) {
            self.walk_into(start, slots, map);
        }
    };
}
use walks;

/// Whether a block of indices from `start` on is inside a set, which does not repeat before its end.
#[inline(always)]
const fn is_inside(start: u32, size: u32) -> bool {
    start as u64 + BLOCK as u64 <= size as u64
}

/// The indices of a block.
#[inline(always)]
fn indices(start: u32) -> Block {
    core::array::from_fn(|lane| start + lane as u32)
}

/// A block of points that are cheaper one after another than each by its index.
#[inline(always)]
fn block_in_order(points: impl Iterator<Item = [u32; 2]>, u: &mut Block, v: &mut Block) {
    for ((u, v), point) in u.iter_mut().zip(v).zip(points) {
        [*u, *v] = point;
    }
}

/// An m x n grid that is neither empty nor larger than a `u32` counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        Ok(Self { columns: m, rows: n, reciprocal: u32::MAX / m.get() })
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
    /// The reciprocal is smaller than 2^32 / m by at most 1, so its product with an index is smaller than
    /// index / m by less than 1, and the row at most one too small.
    #[inline(always)]
    pub(crate) const fn cell(self, index: u32) -> [u32; 2] {
        let row = high(index, self.reciprocal);
        let column = index - row * self.columns();
        if column < self.columns() { [column, row] } else { [column - self.columns(), row + 1] }
    }
}

/// `index` modulo `size`, without a division for an index inside the set. A set is never empty.
#[inline(always)]
const fn repeat(index: u32, size: u32) -> u32 {
    if index < size {
        index
    } else if HALVES {
        remainder(index, size)
    } else {
        match index.checked_rem(size) {
            Some(index) => index,
            None => 0,
        }
    }
}

/// `index` modulo `size` by doubling and subtracting: a core that does not divide would link 800 bytes for what is seldom asked.
#[cold]
#[inline(never)]
const fn remainder(index: u32, size: u32) -> u32 {
    let mut rest = index;
    while size > 0 && rest >= size {
        let mut multiple = size;
        while multiple <= rest / 2 {
            multiple *= 2;
        }
        rest -= multiple;
    }
    rest
}

/// The check that a set without a grid is not empty.
const fn not_empty(count: u32) -> Result<(), Error> {
    if count == 0 { Err(Error::EmptySet) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;

    fn lengths() -> impl Iterator<Item = u32> {
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

    #[test]
    fn remainders_by_bits_are_remainders() {
        for size in lengths() {
            let ends = (0..100).flat_map(|i| [i, u32::MAX - i, size.wrapping_mul(i)]);
            for index in ends.chain((0..1000).map(mix)) {
                assert_eq!(remainder(index, size), index % size, "{index} mod {size}");
                assert_eq!(repeat(index, size), index % size, "{index} mod {size}");
            }
        }
    }
}
