//! Samples of this crate: a child of the path's sampler for each bounce.

use super::{Request, Source};
use crate::vector::Vector;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Frame, Map, Sampler, UnitSquare};

const CAMERA: u32 = 0;
const BOUNCE: u32 = 1;

#[derive(Debug)]
pub(crate) struct Sampled {
    picture: Domain,
    y: u32,
    first: u32,
    pixel: Domain,
    path: Sampler,
}

impl Source for Sampled {
    fn new(&Request { seed, y, first, .. }: &Request) -> Self {
        let picture = Domain::new(seed);
        Self { picture, y, first, pixel: picture, path: Sampler::new(picture, 0) }
    }

    fn pixel(&mut self, x: u32) {
        self.pixel = self.picture.pixel(x, self.y);
    }

    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2] {
        self.path = Sampler::new(self.pixel, self.first + sample);
        let [film, lens] = self.path.child(CAMERA).joint();
        [UnitSquare::<FastF32>::new().sample(film), Concentric::<FastF32>::new().sample(lens)]
    }

    fn bounce(&mut self) {
        self.path = self.path.child(BOUNCE);
    }

    fn lambert(&mut self, normal: Vector) -> Vector {
        match Frame::new(normal) {
            Ok(frame) => self.path.sample(&Cosine::<FastF32>::new().about(frame)),
            Err(_) => normal,
        }
    }

    /// The sphere's point above or below one of the disc, by Lambert's equal-area projection, times
    /// a cube root.
    fn ball(&mut self) -> Vector {
        let [x, y] = self.path.sample(&Concentric::<FastF32>::new());
        let square = x * x + y * y;
        let radius = self.path.unit_f32().cbrt();
        let across = 2.0 * radius * (1.0 - square).max(0.0).sqrt();
        [across * x, across * y, radius * (1.0 - 2.0 * square)]
    }

    fn chance(&mut self, probability: f32) -> bool {
        self.path.chance(probability)
    }
}
