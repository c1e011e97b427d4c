//! Random numbers through closed formulas: polar coordinates on the functions of `std`.

use super::rejection::generator;
use super::{Request, Source};
use crate::vector::{Vector, scaled};
use core::f32::consts::TAU;
use rand::RngExt;
use rand::rngs::SmallRng;

#[derive(Debug)]
pub(crate) struct Formulas(SmallRng);

/// A point of the unit disc, and its distance from the centre squared.
fn disc([u, v]: [f32; 2]) -> ([f32; 2], f32) {
    let (sin, cos) = (TAU * v).sin_cos();
    let r = u.sqrt();
    ([r * cos, r * sin], u)
}

/// T. Duff and others, "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
fn basis([x, y, z]: Vector) -> [Vector; 2] {
    let sign = 1_f32.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
}

impl Source for Formulas {
    #[inline]
    fn new(request: &Request) -> Self {
        Self(generator(request))
    }

    #[inline]
    fn begin(&mut self, _: u32) -> [[f32; 2]; 2] {
        let film = self.0.random();
        let (lens, _) = disc(self.0.random());
        [film, lens]
    }

    /// A point of the disc, raised to the hemisphere.
    #[inline]
    fn lambert(&mut self, normal: Vector) -> Vector {
        let ([x, y], square) = disc(self.0.random());
        let z = (1.0 - square).sqrt();
        let [a, b] = basis(normal);
        core::array::from_fn(|i| x * a[i] + y * b[i] + z * normal[i])
    }

    /// A uniform direction, by a uniform z, times a cube root.
    #[inline]
    fn ball(&mut self) -> Vector {
        let z = 2.0 * self.0.random::<f32>() - 1.0;
        let across = (1.0 - z * z).sqrt();
        let (sin, cos) = (TAU * self.0.random::<f32>()).sin_cos();
        scaled(self.0.random::<f32>().cbrt(), [across * cos, across * sin, z])
    }

    #[inline]
    fn chance(&mut self, probability: f32) -> bool {
        self.0.random::<f32>() < probability
    }
}
