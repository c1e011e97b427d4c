//! Times and errors of every source, measured side by side.
//!
//! A row of the picture is rendered from each source in turn, and a time is the shortest of some
//! repetitions: other load and a change of the clock rate then slow no source more than another.

use crate::path::{Sums, Tile, View, tile};
use crate::source::{Blocks, Formulas, OneByOne, Rejection, Request};
use crate::picture::Picture;
use std::time::Instant;

/// The sources, that of the tutorial first and this crate's last.
pub(crate) const SOURCES: [(&str, Tile); 4] = [
    ("rand, rejection", tile::<Rejection>),
    ("rand, formulas", tile::<Formulas>),
    ("hemidisc, Sampler", tile::<OneByOne>),
    ("hemidisc, blocks", tile::<Blocks>),
];

/// Samples of a pixel.
pub(crate) const COUNTS: [u32; 5] = [1, 4, 16, 64, 256];

/// Pictures of a source and a number of samples, whose errors are averaged.
pub(crate) const SEEDS: u32 = 4;

/// What is measured of a source at a number of samples.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Measured {
    /// Of a path.
    pub(crate) nanoseconds: f64,
    /// Root of the mean square of the difference to the reference, in linear light.
    pub(crate) error: f64,
}

/// How often each row is rendered.
pub(crate) fn repetitions(count: u32) -> u32 {
    (256 / count).clamp(3, 8)
}

/// Measures every source; `step` is called after each picture of all.
pub(crate) fn sources(
    view: &View,
    count: u32,
    reference: &Picture,
    step: &mut dyn FnMut(),
) -> [Measured; SOURCES.len()] {
    let mut measured = [Measured::default(); SOURCES.len()];
    let mut times = vec![[f64::INFINITY; SOURCES.len()]; SEEDS as usize * view.tiles().len()];
    for repetition in 0..repetitions(count) {
        for (seed, times) in (0..).zip(times.chunks_mut(view.tiles().len())) {
            for ((tile, times), reference) in view.tiles().zip(times).zip(reference) {
                for turn in 0..SOURCES.len() {
                    let at = (turn + repetition as usize) % SOURCES.len();
                    let request = Request { seed, size: view.size, samples: count, tile, first: 0 };
                    let start = Instant::now();
                    let sums = SOURCES[at].1(view, &request, count);
                    times[at] = times[at].min(start.elapsed().as_secs_f64());
                    if repetition == 0 {
                        measured[at].error += squares(&sums, count, reference);
                    }
                }
            }
            step();
        }
    }
    let pixels = f64::from(SEEDS) * f64::from(view.size[0] * view.size[1]);
    for (at, measured) in measured.iter_mut().enumerate() {
        let seconds: f64 = times.iter().map(|times| times[at]).sum();
        measured.nanoseconds = 1e9 * seconds / (pixels * f64::from(count));
        measured.error = (measured.error / (3.0 * pixels)).sqrt();
    }
    measured
}

/// The sum of the squares of the differences.
fn squares(sums: &Sums, count: u32, reference: &[[f64; 3]; 64]) -> f64 {
    let mean = |sum: f32| f64::from(sum) / f64::from(count);
    let difference = |(sum, exact): (&f32, &f64)| (mean(*sum) - exact).powi(2);
    sums.iter().flatten().zip(reference.iter().flatten()).map(difference).sum()
}
