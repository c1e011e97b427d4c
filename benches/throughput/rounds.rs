//! The fills as contenders: those whose paths are wanted, at several sizes.

use crate::buffers::{Coordinates, SMALL, Visitor, WINDOWS};
use crate::fills;
use benches::failure::Failure;
use benches::rounds::{Contender, Measurement, shortest};

/// Points between two readings of the clock: enough to hide the cost of reading it, and every
/// window once.
const TIMED: usize = SMALL * WINDOWS;
/// A larger buffer is in memory, and filling it first does not bring it into the cache.
const CACHED: usize = 1 << 16;

/// Times the fills whose paths are wanted, at each of some sizes.
pub(crate) fn at_sizes(
    coordinates: &Coordinates,
    sizes: &[usize],
    rounds: usize,
    wanted: impl Fn(&str) -> bool,
) -> Result<Vec<Measurement>, Failure> {
    let mut found = Vec::new();
    for points in sizes {
        let mut collector = Collector { wanted: &wanted, points: *points, found: &mut found };
        fills::every(coordinates, *points, &mut collector)?;
    }
    Ok(shortest(found, rounds))
}

struct Collector<'a, 'w, W> {
    wanted: &'w W,
    points: usize,
    found: &'w mut Vec<Contender<'a>>,
}

impl<'a, W: Fn(&str) -> bool> Visitor<'a> for Collector<'a, '_, W> {
    fn fill<F: FnMut() + 'a>(&mut self, path: &str, make: impl FnOnce() -> F) {
        if (self.wanted)(path) {
            let runs = TIMED.div_ceil(self.points);
            let contender = Contender::new(path.to_owned(), self.points, runs, make());
            let cached = self.points <= CACHED;
            self.found.push(if cached { contender } else { contender.cold() });
        }
    }
}

/// The paths of all fills.
pub(crate) fn paths(coordinates: &Coordinates) -> Result<Vec<String>, Failure> {
    struct Paths(Vec<String>);
    impl<'a> Visitor<'a> for Paths {
        fn fill<F: FnMut() + 'a>(&mut self, path: &str, _: impl FnOnce() -> F) {
            self.0.push(path.to_owned());
        }
    }
    let mut paths = Paths(Vec::new());
    fills::every(coordinates, SMALL, &mut paths)?;
    Ok(paths.0)
}
