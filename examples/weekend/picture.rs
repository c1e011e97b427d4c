//! Pictures of a source, rendered on all cores.

use crate::path::{SIDE, Tile, View};
use crate::source::Request;
use rayon::prelude::*;

/// Samples of a pixel that are summed in f32.
pub(crate) const PASS: u32 = 64;

pub(crate) type Picture = Vec<[[f64; 3]; SIDE * SIDE]>;

/// The means of some samples of each pixel, by tiles; `step` is called after each pass.
pub(crate) fn render(
    view: &View,
    tile: Tile,
    seed: u32,
    samples: u32,
    step: &mut dyn FnMut(),
) -> Picture {
    let mut means = vec![[[0.0; 3]; SIDE * SIDE]; view.tiles().len()];
    for first in (0..samples).step_by(PASS as usize) {
        let count = PASS.min(samples - first);
        means.par_iter_mut().zip(view.tiles()).for_each(|(means, at)| {
            let request = Request { seed, size: view.size, samples, tile: at, first };
            let sums = tile(view, &request, count);
            for (mean, sum) in means.iter_mut().flatten().zip(sums.iter().flatten()) {
                *mean += f64::from(*sum) / f64::from(samples);
            }
        });
        step();
    }
    means
}
/// Pixels between two pictures.
const GAP: usize = 4;

/// Pictures of one size side by side, and the size.
pub(crate) fn side_by_side(
    pictures: &[Vec<[f64; 3]>],
    [width, height]: [u32; 2],
) -> ([u32; 2], Vec<[f64; 3]>) {
    let gap = [[1.0; 3]; GAP];
    let mut pixels = Vec::new();
    for y in 0..height as usize {
        for (at, picture) in pictures.iter().enumerate() {
            if at > 0 {
                pixels.extend(gap);
            }
            pixels.extend(picture.chunks(width as usize).nth(y).unwrap_or_default());
        }
    }
    ([(pixels.len() / height as usize) as u32, height], pixels)
}
