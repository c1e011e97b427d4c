//! Where the samples of a path come from.
//!
//! All sources give the same distributions, so the pictures have the same expected value. They
//! differ in time, and in how evenly the samples of a pixel lie.

mod blocks;
mod formulas;
mod rejection;
mod sampler;

pub(crate) use blocks::Blocks;
pub(crate) use formulas::Formulas;
pub(crate) use rejection::Rejection;
pub(crate) use sampler::OneByOne;

use crate::vector::Vector;
use hemidisc::{Domain, Screen};

pub(crate) const SURFACE: u32 = 2;
fn screen(r: &Request) -> Screen { Screen::new(Domain::new(r.seed), r.size, r.samples).unwrap() }

/// What is asked for: some samples of each pixel of a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request {
    pub(crate) seed: u32,
    /// Width and height of the picture.
    pub(crate) size: [u32; 2],
    /// Of each pixel, over all requests.
    pub(crate) samples: u32,
    /// The tile
    pub(crate) tile: u32,
    /// The first sample.
    pub(crate) first: u32,
}

/// A source of the samples of a row, from left to right. A path calls [`begin`](Self::begin), and
/// [`bounce`](Self::bounce) before it draws at a surface.
pub(crate) trait Source {
    fn new(request: &Request) -> Self;

    /// The pixel that the next paths are of.
    fn pixel(&mut self, x: u32, y: u32);

    /// Begins the path of a sample of the pixel: a uniform point of [0, 1)^2, for the film, and one
    /// of the unit disc, for the lens.
    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2];

    /// The path is at its next surface, where it draws at most once of what follows.
    fn bounce(&mut self);

    /// A direction about a normal, of density cos / pi.
    fn lambert(&mut self, normal: Vector) -> Vector;

    /// A uniform point of the unit ball.
    fn ball(&mut self) -> Vector;

    /// True with a probability.
    fn chance(&mut self, probability: f32) -> bool;
}
