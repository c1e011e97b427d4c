//! Sequences that are expensive to seek and cheap to advance, and the blocks of those that are not
//! vector code.

use super::Sequence;
use crate::block::{BLOCK, Block};

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

/// Whether a block of indices from `start` on is inside a set, which does not repeat before its
/// end.
#[inline(always)]
pub(super) const fn is_inside(start: u32, size: u32) -> bool {
    start as u64 + BLOCK as u64 <= size as u64
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
