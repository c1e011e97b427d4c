//! Random numbers as the tutorial draws them: points of a square or a cube, until one is inside.

use super::{Request, Source};
use crate::vector::{Vector, along, dot, unit};
use hemidisc::Domain;
use rand::rngs::SmallRng;
use rand::{RngExt, SeedableRng};

#[derive(Debug)]
pub(crate) struct Rejection(SmallRng);

/// A generator for samples of a tile.
pub(super) fn generator(request: &Request) -> SmallRng {
    let Request { seed, tile, first, .. } = *request;
    let [low, high] = Domain::new(seed).pixel(tile, first).to_words().map(u64::from);
    SmallRng::seed_from_u64(high << 32 | low)
}

impl Rejection {
    fn inside<const D: usize>(&mut self) -> [f32; D] {
        loop {
            let point = core::array::from_fn(|_| 2.0 * self.0.random::<f32>() - 1.0);
            if point.iter().map(|x: &f32| x * x).sum::<f32>() < 1.0 {
                return point;
            }
        }
    }

    /// A uniform direction. A point too near the centre would have none.
    fn direction(&mut self) -> Vector {
        loop {
            let point = self.inside();
            if dot(point, point) > 1e-12 {
                return unit(point);
            }
        }
    }
}

impl Source for Rejection {
    #[inline]
    fn new(request: &Request) -> Self {
        Self(generator(request))
    }

    #[inline]
    fn begin(&mut self, _: u32) -> [[f32; 2]; 2] {
        [self.0.random(), self.inside()]
    }

    /// The normal and a uniform direction.
    #[inline]
    fn lambert(&mut self, normal: Vector) -> Vector {
        let sum = along(normal, 1.0, self.direction());
        // The opposite of the normal, almost.
        if dot(sum, sum) < 1e-12 { normal } else { unit(sum) }
    }

    #[inline]
    fn ball(&mut self) -> Vector {
        self.inside()
    }

    #[inline]
    fn chance(&mut self, probability: f32) -> bool {
        self.0.random::<f32>() < probability
    }
}
