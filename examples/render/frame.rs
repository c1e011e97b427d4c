//! Renders a frame or a region of it, a row at a time on all cores.
//!
//! A pass is a few samples of a pixel, taken in order; passes add up to the same bits in any order
//! (`sums`). So the picture is the same for any number of threads, and for any regions that make up
//! the frame.

use crate::render::sequence::{Drawn, Pixels, Sequence};
use crate::render::sums::{MOST_PASSES, Sum};
use hemidisc::arithmetic::Real;
use rayon::prelude::*;
use std::ops::Range;
use std::time::Instant;
use testkit::tracer::Counts;

/// Samples of a pixel that are summed as floats, and then rounded; the last pass of a frame may
/// have fewer.
const PASS: u32 = 8;

const _: () = assert!((u16::MAX as u32).div_ceil(PASS) <= MOST_PASSES);

/// What is to be rendered of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub size: [u32; 2],
    /// For each pixel.
    pub samples: u16,
    pub sequence: Sequence,
    pub pixels: Pixels,
    pub seed: u32,
}

/// Some rows of a frame, and some of the passes over them.
#[derive(Clone, Debug)]
pub struct Region {
    pub rows: Range<u32>,
    pub passes: Range<u32>,
}

impl Settings {
    /// How often each pixel is visited.
    pub fn passes(&self) -> u32 {
        u32::from(self.samples).div_ceil(PASS)
    }

    /// Where the numbers of samples come from.
    ///
    /// # Errors
    /// For a picture without a pixel or a sample.
    pub fn source(&self) -> Result<Drawn, String> {
        let &Self { size, samples, sequence, pixels, seed } = self;
        Drawn::new(sequence, pixels, seed, size, samples).map_err(|error| error.to_string())
    }

    /// All of the frame.
    pub fn whole(&self) -> Region {
        Region { rows: 0..self.size[1], passes: 0..self.passes() }
    }
}

/// A frame, or a region of it.
#[derive(Debug)]
pub struct Frame {
    /// Of radiance, by rows from the top.
    pub sums: Vec<Sum>,
    pub counts: Counts,
    pub seconds: f64,
}

/// Adds a range of samples to the sums of the pixels from (x, y) to the right: [`Renderer::row`] of
/// any type.
///
/// Behind a pointer, so that what runs rows on all cores is compiled once and not for every
/// renderer.
///
/// [`Renderer::row`]: testkit::tracer::Renderer::row
pub type Row<'a, R> = dyn Fn([u32; 2], Range<u32>, &mut [[R; 3]]) -> Counts + Sync + 'a;

/// The sums of a region; `step` is called after each pass.
pub fn render<R: Real>(
    row: &Row<'_, R>,
    settings: &Settings,
    region: &Region,
    step: &mut dyn FnMut(),
) -> Frame {
    let start = Instant::now();
    let width = settings.size[0] as usize;
    let mut sums = vec![Sum::default(); width * region.rows.len()];
    let mut counts = Counts::default();
    for pass in region.passes.clone() {
        let end = u32::from(settings.samples).min(PASS * (pass + 1));
        let rows = sums.par_chunks_mut(width).zip(region.rows.clone());
        let of_rows = rows.map_init(
            || vec![[R::ZERO; 3]; width],
            |floats, (sums, y)| {
                floats.fill([R::ZERO; 3]);
                let counts = row([0, y], PASS * pass..end, floats);
                sums.iter_mut().zip(&*floats).for_each(|(sum, pass)| *sum += Sum::of_pass(*pass));
                counts
            },
        );
        counts += of_rows.reduce(Counts::default, |mut all, of_row| {
            all += of_row;
            all
        });
        step();
    }
    Frame { sums, counts, seconds: start.elapsed().as_secs_f64() }
}
