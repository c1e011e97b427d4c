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
//! | [`Shifted`] | as inside | hashed | another set's points, shifted on the torus |
//!
//! A renderer draws them through a [`Sampler`](crate::Sampler), from the families of [`InDomain`].

mod in_domain;
#[cfg(feature = "rand_core")]
mod rng;
mod shifted;
mod shuffled;
mod stored;
pub(crate) mod walk;

macro_rules! modules {
    ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident $parts:tt;)*) => {$(
        mod $file;
        pub use $file::$sequence;
    )*};
}
for_each_sequence!(modules);

pub use in_domain::{GridSize, InDomain};
#[cfg(feature = "rand_core")]
pub use rng::FromRng;
pub use shifted::Shifted;
pub use shuffled::Shuffled;
pub use stored::Stored;

pub use crate::block::{BLOCK, Block, SHORT_BLOCK};

use crate::error::Error;

/// A set or an endless sequence of points on the unit square.
///
/// Implement [`size`](Self::size) and [`at`](Self::at); the rest is provided, and may be
/// overridden as long as it gives the same bits.
pub trait Sequence: Copy {
    /// How many points there are; `None` for a sequence that has one for every `u32` index.
    #[must_use]
    fn size(&self) -> Option<u32>;

    /// The point of any index. A set repeats from its [`size`](Self::size) on.
    #[must_use]
    fn at(&self, index: u32) -> [u32; 2];

    /// The points from index `start` on, without end; the index wraps after `u32::MAX`.
    ///
    /// `nth`, and so `skip` and `step_by`, are O(1) for every sequence of this crate.
    #[inline(always)]
    fn iter(&self, start: u32) -> impl Iterator<Item = [u32; 2]> {
        looked_up(*self, start)
    }

    /// Writes `map` of each point from index `start` on, a slot each.
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
            [*u, *v] = self.at(start.wrapping_add(offset));
        }
    }

    /// The points of indices `start` .. `start` + 16, `start` a multiple of 16, an axis at a time.
    #[inline(always)]
    fn short_block(&self, start: u32, u: &mut Block<SHORT_BLOCK>, v: &mut Block<SHORT_BLOCK>) {
        for ((u, v), point) in u.iter_mut().zip(v).zip(self.iter(start)) {
            [*u, *v] = point;
        }
    }
}

/// Columns and rows of the grid of exactly `count` points that is nearest to a square: the fewer
/// columns, 4 x 8 for 32.
///
/// A set of a grid keeps its promise only as a whole, so a grid must have as many points as are
/// drawn. A prime count has a single column. For a `count` of 0 both are 0, which sets refuse.
///
/// ```
/// use hemidisc::sequence::{MultiJittered, grid};
/// let [columns, rows] = grid(32);
/// assert_eq!([columns, rows], [4, 8]);
/// let pixel = MultiJittered::new(columns, rows, 7)?;
/// assert_eq!(grid(7), [1, 7]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[must_use]
pub const fn grid(count: u32) -> [u32; 2] {
    let mut columns = count.isqrt();
    while columns > 1 && !count.is_multiple_of(columns) {
        columns -= 1;
    }
    match count.checked_div(columns) {
        Some(rows) => [columns, rows],
        None => [0, 0],
    }
}

/// The points from an index on, each by its index.
#[inline(always)]
pub(crate) fn looked_up<S: Sequence>(sequence: S, start: u32) -> impl Iterator<Item = [u32; 2]> {
    LookedUp { sequence, index: start }
}

/// The points of a sequence, each by its index.
struct LookedUp<S> {
    sequence: S,
    index: u32,
}

impl<S: Sequence> Iterator for LookedUp<S> {
    type Item = [u32; 2];

    #[inline(always)]
    fn next(&mut self) -> Option<[u32; 2]> {
        let point = self.sequence.at(self.index);
        self.index = self.index.wrapping_add(1);
        Some(point)
    }

    /// Indices wrap, so a count is taken modulo 2^32.
    #[inline]
    fn nth(&mut self, n: usize) -> Option<[u32; 2]> {
        self.index = self.index.wrapping_add(n as u32);
        self.next()
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        (usize::MAX, None)
    }
}

/// The check that a set without a grid is not empty.
const fn not_empty(count: u32) -> Result<(), Error> {
    if count == 0 { Err(Error::EmptySet) } else { Ok(()) }
}
