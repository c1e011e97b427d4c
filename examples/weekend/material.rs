//! Matte, metal and glass, as in the tutorial: how light leaves a surface.

use crate::scene::{Hit, Ray};
use crate::source::Source;
use crate::vector::{Vector, along, dot, unit};

#[derive(Clone, Copy, Debug)]
pub(crate) enum Material {
    /// Lambert's: directions by their cosine to the normal.
    Matte(Vector),
    /// The mirror direction and `fuzz` times a uniform point of the unit ball.
    Metal { colour: Vector, fuzz: f32 },
    /// A ratio of refractive indices, inside to outside.
    Glass { ratio: f32 },
}

impl Material {
    /// A direction in which light that arrives along a ray goes on, and what is left of it. `None`
    /// if it is absorbed.
    #[inline]
    pub(crate) fn scatter<S: Source>(
        self,
        ray: &Ray,
        hit: &Hit,
        source: &mut S,
    ) -> Option<(Vector, Vector)> {
        let (arriving, normal) = (ray.direction, hit.normal);
        let cosine = -dot(arriving, normal);
        let mirror = || along(arriving, 2.0 * cosine, normal);
        match self {
            Self::Matte(colour) => Some((source.lambert(normal), colour)),
            Self::Metal { colour, fuzz } => {
                let direction = unit(along(mirror(), fuzz, source.ball()));
                // What leaves below the surface is lost.
                (dot(direction, normal) > 0.0).then_some((direction, colour))
            }
            Self::Glass { ratio } => {
                let ratio = if hit.outside { 1.0 / ratio } else { ratio };
                let square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
                let reflects = square < 0.0 || source.chance(reflectance(cosine, ratio));
                let direction = if reflects {
                    mirror()
                } else {
                    let across = along(arriving, cosine, normal);
                    along(across.map(|component| ratio * component), -square.sqrt(), normal)
                };
                Some((direction, [1.0; 3]))
            }
        }
    }
}

/// Schlick's approximation of Fresnel's.
fn reflectance(cosine: f32, ratio: f32) -> f32 {
    let straight = ((1.0 - ratio) / (1.0 + ratio)).powi(2);
    straight + (1.0 - straight) * (1.0 - cosine).powi(5)
}
