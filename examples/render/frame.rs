//! Renders a frame, a row at a time on all cores.
//!
//! A row's pixels are its alone and take their samples in order, so that the picture is the same for any number
//! of threads and any ranges of samples.

use crate::sequence::Sequence;
use crate::tracer::Counts;
use hemidisc::arithmetic::Real;
use rayon::prelude::*;
use std::ops::Range;
use std::time::Instant;

/// Samples of all pixels between two steps of the progress bar.
const PASS: u32 = 8;

/// What is to be rendered of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub(crate) size: [u32; 2],
    /// For each pixel.
    pub(crate) samples: u32,
    pub(crate) sequence: Sequence,
    pub(crate) seed: u32,
}

impl Settings {
    /// Steps of a progress bar.
    pub(crate) fn passes(&self) -> usize {
        self.samples.div_ceil(PASS) as usize
    }
}

/// A frame.
#[derive(Debug)]
pub(crate) struct Frame {
    /// Mean radiance, by rows from the top.
    pub(crate) pixels: Vec<[f64; 3]>,
    pub(crate) counts: Counts,
    pub(crate) seconds: f64,
}

/// Adds a range of samples to the sums of the pixels from (x, y) to the right: [`Renderer::row`] of any type.
///
/// Behind a pointer, so that what runs rows on all cores is compiled once and not for every renderer.
///
/// [`Renderer::row`]: crate::tracer::Renderer::row
pub(crate) type Row<'a, R> = dyn Fn([u32; 2], Range<u32>, &mut [[R; 3]]) -> Counts + Sync + 'a;

/// A frame of all samples; `step` is called after each pass.
pub(crate) fn render<R: Real>(
    row: &Row<'_, R>,
    settings: &Settings,
    step: &mut dyn FnMut(),
) -> Frame {
    let start = Instant::now();
    let [width, height] = settings.size.map(|side| side as usize);
    let mut sums = vec![[R::ZERO; 3]; width * height];
    let mut counts = Counts::default();
    for first in (0..settings.samples).step_by(PASS as usize) {
        let samples = first..settings.samples.min(first.saturating_add(PASS));
        counts += pass(row, width, samples, &mut sums);
        step();
    }
    let share = 1.0 / f64::from(settings.samples);
    let pixels = sums.into_iter().map(|sum| sum.map(|sum| share * sum.into())).collect();
    Frame { pixels, counts, seconds: start.elapsed().as_secs_f64() }
}

/// Adds a range of samples to the sums of all pixels.
pub(crate) fn pass<R: Real>(
    row: &Row<'_, R>,
    width: usize,
    samples: Range<u32>,
    sums: &mut [[R; 3]],
) -> Counts {
    let rows = sums.par_chunks_mut(width).enumerate();
    let counts = rows.map(|(y, pixels)| row([0, y as u32], samples.clone(), pixels));
    counts.reduce(Counts::default, |mut all, of_row| {
        all += of_row;
        all
    })
}
