//! Where points are stored: interleaved in one buffer, or each component in a buffer of its own.

use crate::block::{BLOCK, Block, Lanes, Point};
use crate::map::Map;
use crate::sequence::Sequence;

/// The caller's memory for points.
pub(super) trait Slots<P: Point>: Sized {
    /// The first `count` slots, and those after them.
    fn split(self, count: usize) -> (Self, Self);

    /// Stores the points of a sequence from an index on, one by one.
    fn fill_singly<S: Sequence, M: Map<Point = P>>(
        self,
        count: usize,
        sequence: &S,
        start: u32,
        map: &M,
    );

    /// Stores the points of a block of coordinates: the `index`-th block of these slots.
    /// `components` is memory for them.
    fn fill_block<M: Map<Point = P>>(
        &mut self,
        index: usize,
        u: &Block,
        v: &Block,
        map: &M,
        components: &mut P::Components,
    );
}

impl<P: Point> Slots<P> for &mut [P] {
    #[inline(always)]
    fn split(self, count: usize) -> (Self, Self) {
        self.split_at_mut(count.min(self.len()))
    }

    #[inline(always)]
    fn fill_singly<S: Sequence, M: Map<Point = P>>(
        self,
        _: usize,
        sequence: &S,
        start: u32,
        map: &M,
    ) {
        sequence.fill_with(start, self, |uv| map.sample(uv));
    }

    #[inline(always)]
    fn fill_block<M: Map<Point = P>>(
        &mut self,
        index: usize,
        u: &Block,
        v: &Block,
        map: &M,
        components: &mut P::Components,
    ) {
        let Some(block) = self.as_chunks_mut::<BLOCK>().0.get_mut(index) else { return };
        if M::POINTWISE {
            for (slot, (u, v)) in block.iter_mut().zip(u.iter().zip(v)) {
                map.sample([*u, *v]).store(slot);
            }
        } else {
            map.sample_block(u, v, components);
            P::interleave(components, block);
        }
    }
}

/// A buffer for each component, each as long as there are slots, or longer.
pub(super) struct Apart<'a, R, const D: usize>(pub(super) [&'a mut [R]; D]);

impl<R: Copy + Default, const D: usize> Slots<[R; D]> for Apart<'_, R, D> {
    #[inline(always)]
    fn split(self, count: usize) -> (Self, Self) {
        let mut after = [const { None }; D];
        let mut before = self.0.map(Some);
        for (before, after) in before.iter_mut().zip(&mut after) {
            if let Some(buffer) = before.take() {
                let (first, rest) = buffer.split_at_mut(count.min(buffer.len()));
                (*before, *after) = (Some(first), Some(rest));
            }
        }
        (Self(before.map(Option::unwrap_or_default)), Self(after.map(Option::unwrap_or_default)))
    }

    #[inline(always)]
    fn fill_singly<S: Sequence, M: Map<Point = [R; D]>>(
        mut self,
        count: usize,
        sequence: &S,
        start: u32,
        map: &M,
    ) {
        for (index, uv) in sequence.iter(start).take(count).enumerate() {
            for (buffer, value) in self.0.iter_mut().zip(map.sample(uv)) {
                if let Some(slot) = buffer.get_mut(index) {
                    *slot = value;
                }
            }
        }
    }

    #[inline(always)]
    fn fill_block<M: Map<Point = [R; D]>>(
        &mut self,
        index: usize,
        u: &Block,
        v: &Block,
        map: &M,
        components: &mut [Lanes<R>; D],
    ) {
        map.sample_block(u, v, components);
        for (buffer, lanes) in self.0.iter_mut().zip(&*components) {
            if let Some(block) = buffer.as_chunks_mut::<BLOCK>().0.get_mut(index) {
                *block = *lanes;
            }
        }
    }
}
