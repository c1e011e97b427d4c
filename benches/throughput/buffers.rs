//! What every family of fills shares: the sizes of buffers, random coordinates, the visitor, and
//! the fill of a buffer with the points of a sequence.

use benches::random::generator;
use hemidisc::{Map, Points, map::Point, sequence::Sequence};
use rand_xoshiro::rand_core::Rng;
use std::hint::black_box;

/// A buffer of this many points stays in the caches of a core.
pub(crate) const SMALL: usize = 1 << 12;
/// A buffer of this many fits in no cache.
pub(crate) const LARGE: usize = 1 << 22;

/// Sees every fill in turn.
pub(crate) trait Visitor<'a> {
    /// Called once for each; `make` allocates the buffer, and what it gives fills it.
    fn fill<F: FnMut() + 'a>(&mut self, path: &str, make: impl FnOnce() -> F);
}

/// Consecutive fills take consecutive ranges of points. The branch predictor learns 4096 random
/// coordinates, and would then predict branches that it cannot predict in a renderer.
pub(crate) const WINDOWS: usize = 16;

/// Random coordinates.
pub(crate) struct Coordinates(Vec<[u32; 2]>);

impl Coordinates {
    /// Enough for every fill of at most `points` points.
    pub(crate) fn new(points: usize) -> Self {
        let mut rng = generator(points);
        let pairs = std::iter::repeat_with(|| [rng.next_u32(), rng.next_u32()]);
        Self(pairs.take(candidates(points)).collect())
    }

    /// Windows of `size` coordinates each.
    pub(crate) fn windows(&self, size: usize) -> &[[u32; 2]] {
        let windows = (self.0.len() / size).min(WINDOWS);
        self.0.get(..windows * size).unwrap_or(&self.0)
    }
}

/// Candidates from which rejection keeps that many points: of random ones it keeps 78.5 %.
pub(crate) const fn candidates(points: usize) -> usize {
    points + points / 2
}

/// Points of a sequence into a buffer: what a caller of the crate does.
pub(crate) fn filler<S: Sequence, M: Map>(sequence: S, map: M, points: usize) -> impl FnMut() {
    let mut buffer = vec![M::Point::zero(); points];
    let all = Points::new(sequence, map);
    // A set that is too short stops the bench at the division below.
    let windows = (all.len() as usize / points).min(WINDOWS);
    let mut window = 0;
    move || {
        window = (window + 1) % windows;
        if let Ok(points) = all.range((window * points) as u32..((window + 1) * points) as u32) {
            fill(black_box(&points), black_box(&mut buffer));
        }
    }
}

/// A function of its own for each set, so that none is inlined into another, and a profile
/// distinguishes them.
#[inline(never)]
fn fill<S: Sequence, M: Map>(points: &Points<S, M>, buffer: &mut [M::Point]) {
    points.fill(buffer);
}
