//! Spheres and planes, what they are made of, and where a ray meets them.

use super::vector::{along, difference, dot, unit};
use super::{Ray, Vector};
use hemidisc::arithmetic::{Arithmetic, Real, Root};
use hemidisc::{Frame, Unit};

/// How a surface shines.
#[derive(Clone, Copy, Debug)]
pub enum Finish<A: Arithmetic, G> {
    /// Not at all.
    Matte,
    /// As a mirror of a reflectance.
    Mirror([A::Real; 3]),
    /// Through a lobe, of a reflectance.
    Glossy([A::Real; 3], G),
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug)]
pub struct Material<A: Arithmetic, G> {
    /// Reflectance of its diffuse part.
    pub albedo: [A::Real; 3],
    /// Radiance of its own.
    pub emission: [A::Real; 3],
    /// Its shine.
    pub finish: Finish<A, G>,
}

/// A sphere.
#[derive(Clone, Copy, Debug)]
pub struct Sphere<A: Arithmetic, G> {
    /// Its centre.
    pub centre: [A::Real; 3],
    /// Above 0.
    pub radius: A::Real,
    /// Its surface.
    pub material: Material<A, G>,
}

/// Squares of another colour.
#[derive(Clone, Copy, Debug)]
pub struct Checker<A: Arithmetic> {
    /// Albedo of every other square.
    pub albedo: [A::Real; 3],
    /// Side of a square.
    pub size: A::Real,
}

/// A plane, seen from either side.
#[derive(Clone, Copy, Debug)]
pub struct Plane<A: Arithmetic, G> {
    /// A point of it, a corner of the checker's squares.
    pub point: [A::Real; 3],
    /// About its normal.
    pub frame: Frame<A::Real>,
    /// Its surface.
    pub material: Material<A, G>,
    /// A second colour, if it has one.
    pub checker: Option<Checker<A>>,
}

/// Where a ray ends.
#[derive(Debug)]
pub struct Hit<'a, A: Arithmetic, G> {
    /// On the surface.
    pub point: [A::Real; 3],
    /// On the side that the ray comes from.
    pub normal: Unit<A::Real>,
    /// Reflectance of the diffuse part here.
    pub albedo: [A::Real; 3],
    /// What the surface is made of.
    pub material: &'a Material<A, G>,
}

impl<A: Root, G> Sphere<A, G> {
    /// The distance along a ray, if there is one.
    ///
    /// The discriminant from the part of the way to the centre that is square to the ray: nothing
    /// cancels for a small sphere far away (E. Haines, J. Günther and T. Akenine-Möller in "Ray
    /// Tracing Gems", 2019, chapter 7).
    #[inline]
    pub fn meets(&self, ray: &Ray<A>) -> Option<A::Real> {
        let to_centre = difference(self.centre, ray.origin);
        let middle = dot(to_centre, ray.direction);
        let across = along(to_centre, -middle, ray.direction);
        let square = self.radius * self.radius - dot(across, across);
        if square >= A::Real::ZERO {
            let half = A::sqrt(square);
            let (near, far) = (middle - half, middle + half);
            let distance = if near > A::Real::ZERO { near } else { far };
            (distance > A::Real::ZERO).then_some(distance)
        } else {
            None
        }
    }

    /// What a ray meets at a distance along it. Nothing, where rounding puts it at the centre of a
    /// sphere too small for that.
    #[inline]
    pub fn hit(&self, ray: &Ray<A>, distance: A::Real) -> Option<Hit<'_, A, G>> {
        // A radius so small that squares lose it takes the longer way.
        let outward = unit::<A>(difference(ray.at(distance), self.centre));
        let outward = Unit::normalized(outward).ok()?;
        Some(Hit {
            // On the sphere, not only near it.
            point: along(self.centre, self.radius, outward.get()),
            normal: facing(outward, ray.direction),
            albedo: self.material.albedo,
            material: &self.material,
        })
    }
}

impl<A: Root, G> Plane<A, G> {
    /// The distance along a ray, if there is one.
    #[inline]
    pub fn meets(&self, ray: &Ray<A>) -> Option<A::Real> {
        let normal = self.frame.unit().get();
        let distance = dot(difference(self.point, ray.origin), normal) / dot(ray.direction, normal);
        (distance > A::Real::ZERO && distance.finite()).then_some(distance)
    }

    /// What a ray meets at a distance along it.
    #[inline]
    pub fn hit(&self, ray: &Ray<A>, distance: A::Real) -> Hit<'_, A, G> {
        let point = ray.at(distance);
        let albedo = match &self.checker {
            Some(checker) if self.odd(point, checker.size) => checker.albedo,
            _ => self.material.albedo,
        };
        let normal = facing(self.frame.unit(), ray.direction);
        Hit { point, normal, albedo, material: &self.material }
    }

    /// Whether a point is in a square of the second colour.
    #[inline]
    fn odd(&self, point: Vector<A>, size: A::Real) -> bool {
        let [x, y, _] = self.frame.to_local(difference(point, self.point));
        // Whole squares from 0; the first one on the negative side is another one.
        let square = |x: A::Real| (x / size).magnitude().floor_u32() ^ u32::from(x < A::Real::ZERO);
        (square(x) ^ square(y)) & 1 == 1
    }
}

#[inline]
fn facing<R: Real>(normal: Unit<R>, arriving: [R; 3]) -> Unit<R> {
    if dot(normal.get(), arriving) > R::ZERO { -normal } else { normal }
}
