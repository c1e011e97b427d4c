//! Samples of this crate, each drawn where it is needed, from a child of the path's sampler.

use super::{Request, Source};
use crate::vector::Vector;
use hemidisc::screen::Pixel;
use hemidisc::{Concentric, Cosine, FastF32, Frame, Sampler, Screen, UnitSquare};

pub(super) const FILM: u32 = 0;
pub(super) const LENS: u32 = 1;
pub(super) const SURFACE: u32 = 2;

#[derive(Debug)]
pub(crate) struct OneByOne {
    screen: Screen,
    pixel: Pixel,
    /// Of the picture first, then of each surface in the domain of the one before.
    path: Sampler,
}

impl OneByOne {
    /// Begins the path of a sample.
    #[inline]
    pub(super) fn path(&mut self, sample: u32) -> Sampler {
        self.path = self.pixel.sampler(sample);
        self.path
    }

    /// The path at its surface.
    #[inline]
    pub(super) const fn at_surface(&self) -> Sampler {
        self.path
    }
}

impl Source for OneByOne {
    fn new(request: &Request) -> Self {
        let Request { screen, corner, .. } = *request;
        Self { screen, pixel: corner, path: Sampler::new(screen.domain(), 0) }
    }

    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        // There are no others.
        if let Ok(pixel) = self.screen.pixel(x, y) {
            self.pixel = pixel;
        }
    }

    #[inline]
    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2] {
        let path = self.path(sample);
        let film = path.child(FILM).sample(&UnitSquare::<FastF32>::new());
        [film, path.child(LENS).sample(&Concentric::<FastF32>::new())]
    }

    #[inline]
    fn bounce(&mut self) {
        self.path = self.path.child(SURFACE);
    }

    #[inline]
    fn lambert(&mut self, normal: Vector) -> Vector {
        about(normal, self.path.sample(&Cosine::<FastF32>::new()))
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
pub(super) fn about(normal: Vector, local: Vector) -> Vector {
    Frame::from_normal(normal).to_world(local)
}

/// A uniform point of the ball, from a cosine-weighted direction and a uniform number.
///
/// Twice the angle between that direction and the axis is that of a uniform one: cos^2 is uniform
/// in [0, 1], and so is 2 cos^2 - 1 in [-1, 1].
#[inline]
pub(super) fn in_ball([x, y, z]: Vector, unit: f32) -> Vector {
    let radius = unit.cbrt();
    let across = 2.0 * radius * z;
    [across * x, across * y, across * z - radius]
}
