//! What a fill costs without a map.

use crate::Visitor;
use core::hint::black_box;

#[unsafe(export_name = "loop/empty")]
#[inline(never)]
fn empty(coordinates: &[[u32; 2]], points: &mut [[i16; 2]]) -> usize {
    for pair in coordinates.iter().zip(points.iter_mut()) {
        black_box(pair);
    }
    points.len()
}

#[unsafe(export_name = "loop/copy")]
#[inline(never)]
fn copy(coordinates: &[[u32; 2]], points: &mut [[i16; 2]]) -> usize {
    for ([u, v], point) in coordinates.iter().zip(points.iter_mut()) {
        *point = [(u >> 16) as i16, (v >> 16) as i16];
    }
    points.len()
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    visitor.points("loop/empty", empty);
    visitor.points("loop/copy", copy);
}
