//! Pictures of a source, rendered on all cores.

use crate::path::{PIXELS, Tile, View};
use crate::source::Request;
use hemidisc::Error;
use rayon::prelude::*;

/// Mean light of the pixels of each tile.
pub(crate) type Picture = Vec<[[f64; 3]; PIXELS]>;

/// Samples of a pixel that are summed in f32.
const PASS: u32 = 64;

/// How often [`render`] visits each pixel.
pub(crate) const fn passes(samples: u32) -> usize {
    samples.div_ceil(PASS) as usize
}

/// The means of some samples of each pixel; `step` is called after each pass.
///
/// # Errors
/// For a picture without pixels or samples.
pub(crate) fn render(
    view: &View,
    tile: Tile,
    seed: u32,
    samples: u32,
    step: &mut dyn FnMut(),
) -> Result<Picture, Error> {
    let request = Request::new(seed, view.size(), samples)?;
    let mut means = vec![[[0.0; 3]; PIXELS]; view.tiles().len()];
    for first in (0..samples).step_by(PASS as usize) {
        let count = PASS.min(samples - first);
        means.par_iter_mut().zip(view.tiles()).for_each(|(means, at)| {
            let sums = tile(view, &Request { tile: at, first, ..request }, count);
            for (mean, sum) in means.iter_mut().flatten().zip(sums.iter().flatten()) {
                *mean += f64::from(*sum) / f64::from(samples);
            }
        });
        step();
    }
    Ok(means)
}

/// Columns of white between two pictures.
const GAP: u32 = 4;

/// Pictures of a view side by side: the size, and the pixels by rows from the top.
pub(crate) fn side_by_side(view: &View, pictures: &[Picture]) -> ([u32; 2], Vec<[f64; 3]>) {
    let [width, height] = view.size();
    let whole = (width + GAP) * pictures.len() as u32 - GAP;
    let mut pixels = vec![[1.0; 3]; (whole * height) as usize];
    for (left, picture) in (0..).step_by((width + GAP) as usize).zip(pictures) {
        for (tile, means) in (0..).zip(picture) {
            for (place, mean) in (0..).zip(means) {
                if let Some([x, y]) = view.pixel(tile, place) {
                    pixels[(y * whole + left + x) as usize] = *mean;
                }
            }
        }
    }
    ([whole, height], pixels)
}
