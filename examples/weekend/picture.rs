//! Pictures of a source, rendered on all cores.

use crate::path::{Row, View};
use crate::source::Request;
use crate::vector::Vector;
use rayon::prelude::*;

/// Samples of a pixel that are summed in f32.
pub(crate) const PASS: u32 = 64;

/// The means of some samples of each pixel, by rows from the top; `step` is called after each pass.
pub(crate) fn render(
    view: &View,
    row: Row,
    seed: u32,
    samples: u32,
    step: &mut dyn FnMut(),
) -> Vec<[f64; 3]> {
    let width = view.size[0] as usize;
    let mut means = vec![[0.0; 3]; width * view.rows().len()];
    for first in (0..samples).step_by(PASS as usize) {
        let count = PASS.min(samples - first);
        means.par_chunks_mut(width).zip(view.rows()).for_each(|(means, y)| {
            let mut sums: Vec<Vector> = vec![[0.0; 3]; width];
            row(view, &Request { seed, size: view.size, samples, y, first }, count, &mut sums);
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
