//! Small fills: the points of a pixel, with all that it takes to come to its domain. A long one is
//! their measure.

use crate::calls::Calls;
use crate::inputs::Given;
use hemidisc::map::Point;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Map, Points, Screen};
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
    let (map, mut buffer) = (Cosine::<FastF32>::new(), [[0.0; 3]; ROW]);
    calls.fill(&format!("row/{ROW}/cosine/concentric/fast-f32"), ROW, move |given| {
        row(given, black_box(&map), black_box(&mut buffer));
    });
}

/// Pixels of a row.
const ROW: usize = 64;

/// A child of each of a row's pixels, and its direction.
#[inline(never)]
fn row<M: Map>(given: Given, map: &M, buffer: &mut [M::Point; ROW]) {
    let Ok(screen) = Screen::new(Domain::new(7), [4096; 2], 16) else { return };
    let [x, y] = given.pixel().map(|place| place & 4032);
    let Ok(row) = screen.row(x, y, given.index() & 15) else { return };
    Points::new(row.child(given.key()), *map).fill(buffer);
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
