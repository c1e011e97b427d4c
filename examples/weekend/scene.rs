//! Spheres on a sphere, under a sky: and where a ray meets them.

use crate::material::Material::{self, Glass, Matte, Metal};
use crate::vector::{Vector, along, difference, dot, scaled, unit};

/// A half-line. The direction is of unit length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    pub(crate) origin: Vector,
    pub(crate) direction: Vector,
}

#[derive(Clone, Copy, Debug)]
struct Sphere {
    centre: Vector,
    radius: f32,
    material: Material,
}

/// Where a ray ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    pub(crate) point: Vector,
    /// On the side that the ray comes from.
    pub(crate) normal: Vector,
    /// Whether the ray comes from outside.
    pub(crate) outside: bool,
    pub(crate) material: Material,
}

#[derive(Clone, Debug)]
pub(crate) struct Scene {
    spheres: Vec<Sphere>,
}

/// Nearer than this is the surface that a ray has left.
const NEAREST: f32 = 1e-3;

const SPHERES: &[Sphere] = &[
    sphere([0.0, -500.0, 0.0], 500.0, Matte([0.48, 0.50, 0.42])),
    // Glass with a bubble of air in it.
    sphere([0.0, 1.0, 0.0], 1.0, Glass { ratio: 1.5 }),
    sphere([0.0, 1.0, 0.0], 0.85, Glass { ratio: 1.0 / 1.5 }),
    sphere([-2.4, 1.0, -0.6], 1.0, Matte([0.70, 0.22, 0.14])),
    sphere([2.4, 1.0, -0.3], 1.0, Metal { colour: [0.78, 0.68, 0.52], fuzz: 0.12 }),
    sphere([-1.1, 0.35, 1.7], 0.35, Metal { colour: [0.75, 0.80, 0.85], fuzz: 0.5 }),
    sphere([0.9, 0.4, 1.6], 0.4, Matte([0.10, 0.28, 0.55])),
    sphere([0.0, 0.25, 2.6], 0.25, Glass { ratio: 1.5 }),
    sphere([-3.2, 0.5, 1.2], 0.5, Matte([0.16, 0.45, 0.24])),
    sphere([1.0, 0.8, -3.4], 0.8, Matte([0.75, 0.60, 0.20])),
];

const fn sphere(centre: Vector, radius: f32, material: Material) -> Sphere {
    Sphere { centre, radius, material }
}

impl Scene {
    pub(crate) fn new() -> Self {
        Self { spheres: SPHERES.to_vec() }
    }

    /// What a ray meets first.
    pub(crate) fn hit(&self, ray: &Ray) -> Option<Hit> {
        let mut nearest = None;
        let mut distance = f32::INFINITY;
        for sphere in &self.spheres {
            if let Some(found) = sphere.meets(ray, distance) {
                (nearest, distance) = (Some(sphere), found);
            }
        }
        nearest.map(|sphere| sphere.hit(ray, distance))
    }
}

impl Sphere {
    /// The distance along a ray, if it is less than another.
    ///
    /// The discriminant from the part of the way to the centre that is square to the ray: f32 has
    /// the digits for a ground of radius 500 (E. Haines, J. Günther and T. Akenine-Möller in "Ray
    /// Tracing Gems", 2019, chapter 7).
    fn meets(&self, ray: &Ray, below: f32) -> Option<f32> {
        let to_centre = difference(self.centre, ray.origin);
        let middle = dot(to_centre, ray.direction);
        let across = along(to_centre, -middle, ray.direction);
        let square = self.radius * self.radius - dot(across, across);
        if square < 0.0 {
            return None;
        }
        let half = square.sqrt();
        let (near, far) = (middle - half, middle + half);
        let distance = if near > NEAREST { near } else { far };
        (distance > NEAREST && distance < below).then_some(distance)
    }

    fn hit(&self, ray: &Ray, distance: f32) -> Hit {
        let from_centre = difference(along(ray.origin, distance, ray.direction), self.centre);
        let outward = scaled(1.0 / self.radius, from_centre);
        let outside = dot(outward, ray.direction) < 0.0;
        Hit {
            // On the sphere, not only near it.
            point: along(self.centre, self.radius, outward),
            normal: if outside { outward } else { scaled(-1.0, outward) },
            outside,
            material: self.material,
        }
    }
}

/// White at the horizon, blue above.
pub(crate) fn sky(direction: Vector) -> Vector {
    let blue = 0.5 * (direction[1] + 1.0);
    along(scaled(1.0 - blue, [1.0; 3]), blue, [0.5, 0.7, 1.0])
}

/// The direction from one point to another.
pub(crate) fn towards(from: Vector, to: Vector) -> Vector {
    unit(difference(to, from))
}
