//! What sequences share: sets that repeat, sequences that are expensive to seek and cheap to
//! advance, and the blocks of those that are not vector code.

use super::Sequence;
use crate::block::Block;
use crate::target::{HALVES, REVERSES_BITS};

/// `index` modulo `size`, without a division for an index inside the set. A set is never empty.
#[inline(always)]
pub(crate) const fn repeat(index: u32, size: u32) -> u32 {
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

/// `index` modulo `size` by doubling and subtracting. A core without a divider would link 800 bytes
/// of a routine that is seldom called.
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

/// A sequence that is expensive to seek and cheap to advance.
pub(super) trait Walk: Sequence {
    /// What advances from point to point.
    type State: Default;

    /// The state at an index, and the number of points that it gives: at least one.
    fn enter(&self, index: u32) -> (Self::State, u32);

    /// Takes a point from a state.
    fn step(&self, state: &mut Self::State) -> [u32; 2];

    /// Like [`enter`](Self::enter), but the stretch ends at `u32::MAX`, after which the index wraps
    /// to 0.
    #[inline(always)]
    fn stretch(&self, start: u32) -> (Self::State, u32) {
        let (state, left) = self.enter(start);
        (state, if start == 0 { left } else { left.min(start.wrapping_neg()) })
    }

    /// [`Sequence::iter`].
    #[inline(always)]
    fn walk(self, start: u32) -> Walking<Self> {
        Walking { sequence: self, state: Self::State::default(), left: 0, next: start }
    }

    /// [`Sequence::fill_with`]: the loop over a stretch has one branch a point.
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

/// The points of a sequence that walks, without end.
pub(super) struct Walking<S: Walk> {
    sequence: S,
    /// Gives `left` more points, up to index `next`.
    state: S::State,
    left: u32,
    next: u32,
}

impl<S: Walk> Iterator for Walking<S> {
    type Item = [u32; 2];

    #[inline(always)]
    fn next(&mut self) -> Option<[u32; 2]> {
        if self.left == 0 {
            (self.state, self.left) = self.sequence.stretch(self.next);
            self.next = self.next.wrapping_add(self.left);
        }
        self.left -= 1;
        Some(self.sequence.step(&mut self.state))
    }

    /// Seeks: O(1). Indices wrap, so a count is taken modulo 2^32.
    #[inline]
    fn nth(&mut self, n: usize) -> Option<[u32; 2]> {
        if n > 0 {
            self.next = self.next.wrapping_sub(self.left).wrapping_add(n as u32);
            self.left = 0;
        }
        self.next()
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        (usize::MAX, None)
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
pub(super) use walks;

/// Whether a block of N indices from `start` on is inside a set, which does not repeat before its
/// end.
#[inline(always)]
pub(crate) const fn is_inside<const N: usize>(start: u32, size: u32) -> bool {
    start as u64 + N as u64 <= size as u64
}

/// The indices of a block.
#[inline(always)]
pub(super) fn indices(start: u32) -> Block {
    core::array::from_fn(|lane| start + lane as u32)
}

/// A block of points that are cheaper in order than each by its index.
#[inline(always)]
pub(super) fn block_in_order(points: impl Iterator<Item = [u32; 2]>, u: &mut Block, v: &mut Block) {
    for ((u, v), point) in u.iter_mut().zip(v).zip(points) {
        [*u, *v] = point;
    }
}

/// An index with its bits reversed, counted on: the radical inverse in base 2.
///
/// A core that cannot reverse bits in one instruction takes some 20. Counting on with a carry from
/// the highest bit down changes two bits on average.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Reversed {
    index: u32,
    bits: u32,
}

impl Reversed {
    pub(super) const fn new(index: u32) -> Self {
        Self { index, bits: index.reverse_bits() }
    }

    /// The bits of the index in reverse.
    pub(super) const fn bits(self) -> u32 {
        self.bits
    }

    /// The next index; 0 after the last.
    #[inline(always)]
    pub(super) const fn after(self) -> Self {
        let index = self.index.wrapping_add(1);
        Self { index, bits: if REVERSES_BITS { index.reverse_bits() } else { carried(self.bits) } }
    }
}

/// The sum with the highest bit, carried downwards.
#[inline(always)]
const fn carried(mut bits: u32) -> u32 {
    let mut bit = 1 << 31;
    while bits & bit != 0 {
        bits ^= bit;
        bit >>= 1;
    }
    bits | bit
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::grid::tests::lengths;
    use crate::bits::hash::mix;

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

    #[test]
    fn counts_as_the_index_does() {
        let powers = (0..32).map(|bit| (1_u32 << bit) - 1);
        for index in powers.chain(0..10_000).chain(u32::MAX - 10_000..=u32::MAX) {
            let next = index.wrapping_add(1);
            assert_eq!(carried(index.reverse_bits()), next.reverse_bits(), "{index}");
            assert_eq!(Reversed::new(index).after(), Reversed::new(next), "{index}");
        }
    }
}
