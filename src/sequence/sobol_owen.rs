//! Owen-scrambled Sobol points in a nested-uniform shuffle of their order.
//!
//! B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020: Owen-scrambling the index
//! shuffles the order so that aligned blocks stay aligned blocks, and so nets; Owen-scrambling each
//! axis moves the points among elementary intervals of every size, and so keeps the nets too.

use super::Sequence;
use crate::bits::owen::{scramble, scramble_low, scramble_reversed, scramble_siblings};
use crate::bits::sobol::higher_dimensions;
use crate::bits::state::{finish, of_words, to_words};
use crate::block::{BLOCK, Block, Lanes, SHORT_BLOCK};
use crate::domain::Domain;
use crate::target::VECTORS_OF_HALVES;

/// The Sobol (0, 2)-sequence, Owen-scrambled on each axis, in a shuffled order.
///
/// Promise: each block of 2^k points that starts at a multiple of 2^k is a (0, k, 2)-net; the
/// points of different seeds or domains are independent. A point costs three hashes of four
/// multiplications each, and four bit reversals.
///
/// ```
/// use hemidisc::{Domain, sequence::SobolOwen};
/// let lens = SobolOwen::in_domain(Domain::new(7).child(1));
/// let light = SobolOwen::in_domain(Domain::new(7).child(2));
/// assert_ne!(lens.at(0), light.at(0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SobolOwen {
    order: u32,
    axes: [u32; 2],
}

impl SobolOwen {
    /// The sequence of `Domain::new(seed)`; every seed, 0 too, is scrambled.
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self::in_domain(Domain::new(seed))
    }

    /// The sequence of a domain: a shuffle and two scrambles with keys of their own.
    #[must_use]
    #[inline]
    pub const fn in_domain(domain: Domain) -> Self {
        let [order, u, v] = domain.keys();
        Self { order, axes: [u, v] }
    }

    /// The domain whose keys these are.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn domain(&self) -> Domain {
        Domain::of_keys([self.order, self.axes[0]])
    }

    /// How many points there are: `None`, for it is endless.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        None
    }

    /// The point of any index.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        scrambled(self.reversed(index), self.axes)
    }

    /// The first four dimensions at an index, as two pairs, the first that of [`at`](Self::at): for
    /// an effect of four dimensions, such as a point of the pixel and one of the lens.
    ///
    /// Promise: each aligned block of 2^k is a (1, k, 3)-net in the first three dimensions and a
    /// (3, k, 4)-net in all four, as those of Sobol are. It costs twice as much as a point, and a
    /// table of 1 KiB.
    #[must_use]
    #[inline]
    pub const fn joint(self, index: u32) -> [[u32; 2]; 2] {
        let [u, v] = self.reversed(index);
        // The reversed coordinate of dimension 0 is the shuffled index.
        let [w, x] = higher_dimensions(u);
        // The keys of a domain's first two are its state, mixed: so are these.
        let keys = to_words(finish(of_words([self.axes[0], self.order])));
        [scrambled([u, v], self.axes), scrambled([w, x], keys)]
    }

    /// The reversed coordinates of the Sobol point of a shuffled index: the index, and Pascal's
    /// matrix on it.
    #[inline(always)]
    const fn reversed(self, index: u32) -> [u32; 2] {
        let u = shuffle(index, self.order);
        [u, pascal_reversed(u)]
    }
}

/// Two reversed coordinates, scrambled by a key each.
///
/// Both are reversed in one word: x86-64 takes some 15 instructions for that, as for one of 32 bits.
#[inline(always)]
const fn scrambled([u, v]: [u32; 2], [key_u, key_v]: [u32; 2]) -> [u32; 2] {
    to_words(of_words([scramble_reversed(v, key_v), scramble_reversed(u, key_u)]).reverse_bits())
}

/// Of 64 or of 16: an aligned block of indices is shuffled within itself and moved as a whole, and
/// Pascal's matrix is linear over xor. So within a block only the low bits of both reversed
/// coordinates differ. The block runs in passes, because a point is a dependency chain of 60 operations.
impl SobolOwen {
    #[inline(always)]
    fn any_block<const N: usize>(self, start: u32, u: &mut Block<N>, v: &mut Block<N>) {
        if VECTORS_OF_HALVES {
            self.block_in_halves(start, u, v);
        } else {
            self.block_in_words(start, u, v);
        }
    }

    #[inline(always)]
    fn block_in_words<const N: usize>(self, start: u32, u: &mut Block<N>, v: &mut Block<N>) {
        let high = shuffle(start, self.order) & !LOW;
        let below = pascal_reversed(high);
        let places: Lanes<u16, N> = scramble_low(start, self.order);
        for ((u, v), place) in u.iter_mut().zip(v.iter_mut()).zip(places) {
            // The compiler sees that most of the matrix is not needed.
            let low = u32::from(place) & LOW;
            *u = high | low;
            *v = below ^ pascal_reversed(low);
        }
        self.scramble_each(u, v);
    }

    /// The points of the indices that `u` holds, in passes.
    #[inline(always)]
    pub(crate) fn points<const N: usize>(self, u: &mut Block<N>, v: &mut Block<N>) {
        for index in u.iter_mut() {
            *index = scramble_reversed(index.reverse_bits(), self.order);
        }
        for (u, v) in u.iter_mut().zip(v.iter_mut()) {
            *u = u.reverse_bits();
            *v = pascal_reversed(*u);
        }
        self.scramble_each(u, v);
    }

    /// Reversed coordinates to coordinates.
    #[inline(always)]
    fn scramble_each<const N: usize>(self, u: &mut Block<N>, v: &mut Block<N>) {
        for (axis, key) in [u, v].into_iter().zip(self.axes) {
            for k in axis.iter_mut() {
                *k = scramble_reversed(*k, key);
            }
            for k in axis {
                *k = k.reverse_bits();
            }
        }
    }

    #[inline(always)]
    fn block_in_halves<const N: usize>(self, start: u32, u: &mut Block<N>, v: &mut Block<N>) {
        let high = shuffle(start, self.order) & !LOW;
        let mut low: Lanes<u16, N> = scramble_low(start, self.order);
        scramble_siblings(high, &low, self.axes[0], u);
        for low in &mut low {
            *low = pascal_reversed(u32::from(*low) & LOW) as u16;
        }
        scramble_siblings(pascal_reversed(high), &low, self.axes[1], v);
    }
}

/// The bits of an index that distinguish the points of a block.
const LOW: u32 = BLOCK as u32 - 1;

/// Nested-uniform shuffle of the index: aligned blocks of 2^k stay aligned blocks of 2^k.
#[inline(always)]
pub(crate) const fn shuffle(index: u32, key: u32) -> u32 {
    scramble(index, key)
}

/// Pascal's triangle modulo 2, the matrix of Sobol's second dimension, on reversed bits: as in
/// `sobol.rs`, but each step takes the upper half of a group of bits into the lower.
const fn pascal_reversed(mut x: u32) -> u32 {
    x ^= x >> 1 & 0x5555_5555;
    x ^= x >> 2 & 0x3333_3333;
    x ^= x >> 4 & 0x0f0f_0f0f;
    x ^= x >> 8 & 0x00ff_00ff;
    x ^ (x >> 16)
}

impl Sequence for SobolOwen {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        self.any_block(start, u, v);
    }

    #[inline(always)]
    fn short_block(&self, start: u32, u: &mut Block<SHORT_BLOCK>, v: &mut Block<SHORT_BLOCK>) {
        self.any_block(start, u, v);
    }

    /// Pairs stay pairs, so an odd index is shuffled to what the even one before it is, with the
    /// last bit changed; and so are the coordinates, for Pascal's matrix takes the last bit to
    /// itself alone.
    #[inline(always)]
    fn iter(&self, start: u32) -> impl Iterator<Item = [u32; 2]> {
        InPairs { sequence: *self, index: start, even: self.reversed(start & !1) }
    }
}

/// The points from an index on.
struct InPairs {
    sequence: SobolOwen,
    index: u32,
    /// The reversed coordinates of the index or, if that is odd, of the one before.
    even: [u32; 2],
}

impl Iterator for InPairs {
    type Item = [u32; 2];

    #[inline(always)]
    fn next(&mut self) -> Option<[u32; 2]> {
        if self.index & 1 == 0 {
            self.even = self.sequence.reversed(self.index);
        }
        let point = scrambled(self.even.map(|axis| axis ^ self.index & 1), self.sequence.axes);
        self.index = self.index.wrapping_add(1);
        Some(point)
    }

    /// Indices wrap, so a count is taken modulo 2^32.
    #[inline]
    fn nth(&mut self, n: usize) -> Option<[u32; 2]> {
        self.index = self.index.wrapping_add(n as u32);
        self.even = self.sequence.reversed(self.index & !1);
        self.next()
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        (usize::MAX, None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;

    #[test]
    fn order_and_axes_have_keys_of_their_own() {
        for seed in 0..1000 {
            let SobolOwen { order, axes: [u, v] } = SobolOwen::new(seed);
            assert!(order != u && u != v && v != order, "{seed}");
        }
    }

    #[test]
    fn blocks_in_words_and_in_halves_are_those_of_their_points() {
        blocks_of::<BLOCK>();
        blocks_of::<SHORT_BLOCK>();
    }

    fn blocks_of<const N: usize>() {
        for trial in 0..500_u32 {
            let (sequence, start) = (SobolOwen::new(mix(trial)), mix(!trial) & !(N as u32 - 1));
            let (mut words, mut halves) = ([[0; N]; 2], [[0; N]; 2]);
            let [u, v] = &mut words;
            sequence.block_in_words(start, u, v);
            let [u, v] = &mut halves;
            sequence.block_in_halves(start, u, v);
            assert_eq!(words, halves, "{sequence:?} {start:#x}");
            for lane in 0..N {
                let [u, v] = &words;
                assert_eq!([u[lane], v[lane]], sequence.at(start | lane as u32), "{sequence:?}");
            }
        }
    }
}
