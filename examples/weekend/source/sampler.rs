//! Samples of this crate, drawn where they are needed: a child of the path's sampler for each use.

use super::{Request, SURFACE, Source, screen};
use crate::vector::Vector;
use hemidisc::screen::Pixel;
use hemidisc::{Concentric, Cosine, FastF32, Frame, Sampler, Screen, UnitSquare};

pub(super) const FILM: u32 = 0;
pub(super) const LENS: u32 = 1;

/// The path of a sample: its sampler is in the domain of the surface where it is.
#[derive(Debug)]
pub(crate) struct OneByOne {
    screen: Screen,
    pub(super) pixel: Pixel,
    pub(super) path: Sampler,
}

impl OneByOne {
    pub(super) const fn path(&self) -> Sampler {
        self.path
    }
}

impl Source for OneByOne {
    fn new(request: &Request) -> Self {
        let screen = screen(request);
        let pixel = screen.pixel(0, 0).unwrap();
        Self { screen, pixel, path: pixel.sampler(0) }
    }

    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self.pixel = self.screen.pixel(x, y).unwrap();
    }

    #[inline]
    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2] {
        self.path = self.pixel.sampler(sample);
        let film = self.path.child(FILM).sample(&UnitSquare::<FastF32>::new());
        [film, self.path.child(LENS).sample(&Concentric::<FastF32>::new())]
    }

    #[inline]
    fn bounce(&mut self) {
        self.path = self.path.child(SURFACE);
    }

    #[inline]
    fn lambert(&mut self, normal: Vector) -> Vector {
        turned(self.path.sample(&Cosine::<FastF32>::new()), normal)
    }

    #[inline]
    fn ball(&mut self) -> Vector {
        in_ball(self.path.sample(&Cosine::<FastF32>::new()), self.path.unit_f32())
    }

    #[inline]
    fn chance(&mut self, probability: f32) -> bool {
        self.path.chance(probability)
    }
}

/// A direction about the z axis, turned to be about a normal.
#[inline]
pub(super) fn turned(local: Vector, normal: Vector) -> Vector {
    // A sphere's normals have a length of 1.
    Frame::new(normal).map_or(normal, |frame: Frame<f32>| frame.to_world(local))
}

/// A uniform point of the ball from a cosine-weighted direction, whose angle to the axis is half
/// that of a uniform direction, and the cube of the distance.
#[inline]
pub(super) fn in_ball([x, y, z]: Vector, cube: f32) -> Vector {
    let radius = cube.cbrt();
    let across = 2.0 * radius * z;
    [across * x, across * y, across * z - radius]
}
