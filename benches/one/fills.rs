//! Small fills: the points of a pixel, with all that it takes to come to its domain. A long one is
//! their measure.

use crate::calls::Calls;
use hemidisc::map::Point;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Map, Points};
use std::hint::black_box;

/// Points of a fill.
const SIZES: [usize; 4] = [4, 16, 64, LONG];
/// So many that the domain costs nothing.
pub(crate) const LONG: usize = 4096;

pub(crate) fn every(calls: &mut Calls<'_>) {
    for points in SIZES {
        of(calls, points, "disc/concentric", Concentric::<FastF32>::new());
        of(calls, points, "cosine/concentric", Cosine::<FastF32>::new());
    }
    // Later: a row of 64 pixels, child, pair and direction, against `bounce` one at a time.
}

fn of<M: Map + 'static>(calls: &mut Calls<'_>, points: usize, name: &str, map: M) {
    let mut buffer = vec![M::Point::zero(); points];
    calls.fill(&format!("fill/{points}/{name}/fast-f32"), points, move |given| {
        fill(given.domain(), given.key(), black_box(&map), black_box(&mut buffer));
    });
}

/// A child of a domain, and its first points.
#[inline(never)]
fn fill<M: Map>(domain: Domain, key: u32, map: &M, buffer: &mut [M::Point]) {
    Points::new(SobolOwen::in_domain(domain.child(key)), *map).fill(buffer);
}
