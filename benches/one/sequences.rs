//! Every sequence: the coordinates of one index.

use crate::calls::Calls;
use benches::failure::Failure;
use benches::random::SEED;
use hemidisc::catalogue::{self, SequenceVisitor};
use hemidisc::sequence::Sequence;

/// The points of a set; indices beyond it repeat them.
const COUNT: u32 = 1 << 12;

pub(crate) fn every(calls: &mut Calls<'_>) -> Result<(), Failure> {
    Ok(catalogue::sequences(COUNT, SEED, &mut Sequences { calls })?)
}

struct Sequences<'c, 'a> {
    calls: &'c mut Calls<'a>,
}

impl SequenceVisitor for Sequences<'_, '_> {
    fn visit<S: Sequence + 'static>(&mut self, name: &'static str, sequence: S) {
        self.calls.call(&format!("sequence/{name}"), move |given| sequence.at(given.index()));
    }
}
