//! Times and errors of every source, measured side by side.
//!
//! A tile is rendered from each source in turn, and its time is the shortest of some repetitions.
//! So other load and a change of the clock rate slow no source more than another.

use crate::path::{PIXELS, Tile, View, tile};
use crate::picture::Picture;
use crate::source::{Blocks, Formulas, OneByOne, Rejection, Request};
use crate::vector::Vector;
use hemidisc::Error;
use std::time::Instant;

/// The sources, that of the tutorial first.
pub(crate) const SOURCES: [(&str, Tile); 4] = [
    ("rand, rejection", tile::<Rejection>),
    ("rand, formulas", tile::<Formulas>),
    ("hemidisc, one by one", tile::<OneByOne>),
    ("hemidisc, in blocks", tile::<Blocks>),
];

/// Of these, how many are random numbers.
pub(crate) const RANDOM: usize = 2;

/// What is measured of a source at a number of samples.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Measured {
    /// Of a path.
    pub(crate) nanoseconds: f64,
    /// Root of the mean square of the difference to the reference, in linear light.
    pub(crate) error: f64,
}

/// Pictures whose errors and times are averaged, and how often each tile of them is rendered.
const fn pictures_and_repetitions(count: u32) -> [u32; 2] {
    match count {
        0..=16 => [4, 8],
        17..=64 => [4, 4],
        _ => [1, 4],
    }
}

/// How often [`sources`] calls `step`.
pub(crate) const fn steps(count: u32) -> usize {
    let [pictures, repetitions] = pictures_and_repetitions(count);
    (pictures * repetitions) as usize
}

/// Measures every source; `step` is called after each picture of all of them.
///
/// # Errors
/// For a picture without pixels or samples.
pub(crate) fn sources(
    view: &View,
    count: u32,
    reference: &Picture,
    step: &mut dyn FnMut(),
) -> Result<[Measured; SOURCES.len()], Error> {
    let [pictures, repetitions] = pictures_and_repetitions(count);
    let mut measured = [Measured::default(); SOURCES.len()];
    for seed in 0..pictures {
        let request = Request::new(seed, view.size(), count)?;
        let mut shortest = vec![[f64::INFINITY; SOURCES.len()]; view.tiles().len()];
        for repetition in 0..repetitions as usize {
            for ((tile, shortest), exact) in view.tiles().zip(&mut shortest).zip(reference) {
                for turn in 0..SOURCES.len() {
                    let at = (turn + repetition) % SOURCES.len();
                    let (_, render) = SOURCES[at];
                    let start = Instant::now();
                    let sums = render(view, &Request { tile, ..request }, count);
                    shortest[at] = shortest[at].min(start.elapsed().as_secs_f64());
                    if repetition == 0 {
                        measured[at].error += squares(&sums, count, exact);
                    }
                }
            }
            step();
        }
        for (at, measured) in measured.iter_mut().enumerate() {
            measured.nanoseconds += 1e9 * shortest.iter().map(|times| times[at]).sum::<f64>();
        }
    }
    let [width, height] = view.size().map(f64::from);
    let pixels = width * height * f64::from(pictures);
    Ok(measured.map(|sums| Measured {
        nanoseconds: sums.nanoseconds / (pixels * f64::from(count)),
        error: (sums.error / (3.0 * pixels)).sqrt(),
    }))
}

/// The sum of the squares of the differences.
fn squares(sums: &[Vector; PIXELS], count: u32, exact: &[[f64; 3]; PIXELS]) -> f64 {
    let difference = |(sum, exact): (&f32, &f64)| f64::from(*sum) / f64::from(count) - exact;
    sums.iter().flatten().zip(exact.iter().flatten()).map(difference).map(|d| d * d).sum()
}
