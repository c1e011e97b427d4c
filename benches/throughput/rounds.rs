//! Rounds: every fill once, in turn, repeatedly. The minimum of each counts.
//!
//! Other load, or a change of the clock rate, slows whichever fill runs at the time. Rounds expose
//! all fills alike, and the minimum of many is undisturbed.

use crate::buffers::{Coordinates, SMALL, Visitor, WINDOWS};
use crate::failure::Failure;
use crate::fills;
use std::time::Instant;

/// Points between two readings of the clock: enough to hide the cost of reading it, and every
/// window once.
const TIMED: usize = SMALL * WINDOWS;
/// A larger buffer is in memory, and filling it first does not bring it into the cache.
const CACHED: usize = 1 << 16;

/// A fill among others.
struct Contender<'a> {
    path: String,
    fill: Box<dyn FnMut() + 'a>,
    shortest: f64,
}

/// The shortest time of a fill, for each of its points.
pub(crate) struct Measurement {
    pub(crate) path: String,
    pub(crate) points: usize,
    pub(crate) nanoseconds: f64,
}

/// Times the fills whose paths are wanted, at each of some sizes.
pub(crate) fn at_sizes(
    coordinates: &Coordinates,
    sizes: &[usize],
    rounds: usize,
    wanted: impl Fn(&str) -> bool,
) -> Result<Vec<Measurement>, Failure> {
    let mut sized = Vec::new();
    for points in sizes {
        let mut collector = Collector { wanted: &wanted, found: Vec::new() };
        fills::every(coordinates, *points, &mut collector)?;
        sized.extend(collector.found.into_iter().map(|contender| (*points, contender)));
    }
    for _ in 0..rounds {
        for (points, contender) in &mut sized {
            contender.run(*points);
        }
    }
    let measurement = |(points, Contender { path, shortest, .. })| Measurement {
        path,
        points,
        nanoseconds: shortest,
    };
    Ok(sized.into_iter().map(measurement).collect())
}

impl Contender<'_> {
    fn run(&mut self, points: usize) {
        let fills = TIMED.div_ceil(points);
        if points <= CACHED {
            (0..fills).for_each(|_| (self.fill)());
        }
        let start = Instant::now();
        (0..fills).for_each(|_| (self.fill)());
        let nanoseconds = start.elapsed().as_secs_f64() * 1e9 / (fills * points) as f64;
        self.shortest = self.shortest.min(nanoseconds);
    }
}

struct Collector<'a, 'w, W> {
    wanted: &'w W,
    found: Vec<Contender<'a>>,
}

impl<'a, W: Fn(&str) -> bool> Visitor<'a> for Collector<'a, '_, W> {
    fn fill<F: FnMut() + 'a>(&mut self, path: &str, make: impl FnOnce() -> F) {
        if (self.wanted)(path) {
            let fill = Box::new(make());
            self.found.push(Contender { path: path.to_owned(), fill, shortest: f64::INFINITY });
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
