//! Where the samples of a path come from.
//!
//! All sources give the same distributions, so their pictures have the same expected value. They
//! differ in time, and in how evenly the samples lie.

mod blocks;
mod formulas;
mod one_by_one;
mod rejection;

pub(crate) use blocks::Blocks;
pub(crate) use formulas::Formulas;
pub(crate) use one_by_one::OneByOne;
pub(crate) use rejection::Rejection;

use crate::vector::Vector;
use hemidisc::screen::Pixel;
use hemidisc::{Domain, Error, Screen};

/// What is asked of a source: samples of the pixels of a tile.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request {
    pub(crate) seed: u32,
    /// The picture, for as many samples of each pixel as it has.
    pub(crate) screen: Screen,
    /// Of the picture.
    pub(crate) corner: Pixel,
    pub(crate) tile: u32,
    /// The first sample.
    pub(crate) first: u32,
}

impl Request {
    /// The first samples of the first tile.
    ///
    /// # Errors
    /// For a picture without pixels or samples.
    pub(crate) fn new(seed: u32, size: [u32; 2], samples: u32) -> Result<Self, Error> {
        let screen = Screen::new(Domain::new(seed), size, samples)?;
        Ok(Self { seed, screen, corner: screen.pixel(0, 0)?, tile: 0, first: 0 })
    }
}

/// A source of samples. For each pixel that is asked for, [`pixel`](Self::pixel) is called, for each
/// of its samples [`begin`](Self::begin), and for each surface that a path meets
/// [`bounce`](Self::bounce) and at most one of the others. A stream of random numbers has no place, so
/// for it both do nothing.
pub(crate) trait Source {
    fn new(request: &Request) -> Self;

    /// The pixel that the next paths are of.
    #[inline]
    fn pixel(&mut self, _x: u32, _y: u32) {}

    /// A path begins: a uniform point of [0, 1)^2, for the film, and one of the unit disc, for the
    /// lens.
    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2];

    /// The path is at its next surface.
    #[inline]
    fn bounce(&mut self) {}

    /// A direction about a normal, of density cos / pi.
    fn lambert(&mut self, normal: Vector) -> Vector;

    /// A uniform point of the unit ball.
    fn ball(&mut self) -> Vector;

    /// True with a probability.
    fn chance(&mut self, probability: f32) -> bool;
}
