//! Rounds: every contender once, in turn, repeatedly. The minimum of each counts.
//!
//! Other load, or a change of the clock rate, slows whichever contender runs at the time. Rounds
//! expose all of them alike, and the minimum of many is undisturbed.

use std::time::Instant;

/// One among those that are timed.
pub struct Contender<'a> {
    path: String,
    run: Box<dyn FnMut() + 'a>,
    points: usize,
    runs: usize,
    warm: bool,
    shortest: f64,
}

/// The shortest time of a contender, for each of its points.
pub struct Measurement {
    /// Its name.
    pub path: String,
    /// The points of a run.
    pub points: usize,
    /// For a point.
    pub nanoseconds: f64,
}

impl<'a> Contender<'a> {
    /// One that makes so many points in a run, and runs so often between two readings of the clock.
    pub fn new(path: String, points: usize, runs: usize, run: impl FnMut() + 'a) -> Self {
        Self { path, run: Box::new(run), points, runs, warm: true, shortest: f64::INFINITY }
    }

    /// Without as many runs before, which would bring nothing into a cache.
    #[must_use]
    pub fn cold(self) -> Self {
        Self { warm: false, ..self }
    }

    fn round(&mut self) {
        if self.warm {
            (0..self.runs).for_each(|_| (self.run)());
        }
        let start = Instant::now();
        (0..self.runs).for_each(|_| (self.run)());
        let points = (self.runs * self.points) as f64;
        let nanoseconds = start.elapsed().as_secs_f64() * 1e9 / points;
        self.shortest = self.shortest.min(nanoseconds);
    }
}

/// Times them.
pub fn shortest(mut contenders: Vec<Contender<'_>>, rounds: usize) -> Vec<Measurement> {
    for _ in 0..rounds {
        contenders.iter_mut().for_each(Contender::round);
    }
    let measurement = |Contender { path, points, shortest, .. }| Measurement {
        path,
        points,
        nanoseconds: shortest,
    };
    contenders.into_iter().map(measurement).collect()
}
