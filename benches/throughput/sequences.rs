//! Every sequence: its coordinates by blocks, as a fused fill takes them.

use crate::buffers::Visitor;
use benches::failure::Failure;
use benches::random::SEED;
use hemidisc::catalogue::{self, SequenceVisitor};
use hemidisc::sequence::{BLOCK, Block, Sequence};
use std::hint::black_box;

pub(crate) fn every<'a>(points: usize, visitor: &mut impl Visitor<'a>) -> Result<(), Failure> {
    catalogue::sequences(u32::try_from(points)?, SEED, &mut Sequences { points, visitor })?;
    Ok(())
}

struct Sequences<'v, V> {
    points: usize,
    visitor: &'v mut V,
}

impl<'a, V: Visitor<'a>> SequenceVisitor for Sequences<'_, V> {
    fn visit<S: Sequence + 'static>(&mut self, name: &'static str, sequence: S) {
        self.visitor.fill(&format!("sequence/{name}"), || {
            let mut blocks = vec![[[0; BLOCK]; 2]; self.points / BLOCK];
            move || fill(black_box(&sequence), black_box(&mut blocks))
        });
    }
}

#[inline(never)]
fn fill<S: Sequence>(sequence: &S, blocks: &mut [[Block; 2]]) {
    for ([u, v], start) in blocks.iter_mut().zip((0..).step_by(BLOCK)) {
        sequence.block(start, u, v);
    }
}
