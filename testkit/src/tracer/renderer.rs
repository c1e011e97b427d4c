//! What a pixel sees.

use super::sample::{BOUNCE, CAMERA, GLOSSY, LIGHT, OCCLUSION};
use super::vector::{along, dot, product, scaled, sum};
use super::{
    Ambient, Camera, Counts, Finish, Hit, Lens, Light, Mirror, Plane, Ray, Reflection, Source,
    Sphere, Vector,
};
use core::ops::Range;
use hemidisc::Sampler;
use hemidisc::arithmetic::{Arithmetic, Real, Root};

/// What is seen where nothing is.
#[derive(Clone, Copy, Debug)]
pub struct Sky<A: Arithmetic> {
    /// Radiance at the horizon, and below it.
    pub horizon: [A::Real; 3],
    /// Radiance straight up.
    pub zenith: [A::Real; 3],
}

/// A scene with the effects that it is rendered with.
#[derive(Clone, Copy, Debug)]
pub struct Renderer<'a, A: Arithmetic, L, S, O, G, P> {
    /// Where it is seen from.
    pub camera: Camera<A>,
    /// How rays leave the camera.
    pub lens: L,
    /// The lamp.
    pub light: S,
    /// The lamp's intensity along its axis.
    pub intensity: [A::Real; 3],
    /// Radiance of the ambient light.
    pub ambient: [A::Real; 3],
    /// How much of that arrives.
    pub occlusion: O,
    /// Behind all else.
    pub sky: Sky<A>,
    /// All spheres.
    pub spheres: &'a [Sphere<A, G>],
    /// All planes.
    pub planes: &'a [Plane<A, G>],
    /// Where the numbers of samples come from.
    pub source: P,
}

impl<A, L, S, O, G, P> Renderer<'_, A, L, S, O, G, P>
where
    A: Root,
    L: Lens<A>,
    S: Light<A>,
    O: Ambient<A>,
    G: Reflection<A>,
    P: Source,
{
    /// Adds a range of samples to each of the sums, which are those of the pixels from (x, y) to
    /// the right.
    pub fn row(&self, [mut x, y]: [u32; 2], samples: Range<u32>, sums: &mut [Vector<A>]) -> Counts {
        let mut counts = Counts::default();
        for pixel in sums {
            for index in samples.clone() {
                let sample = self.source.sampler([x, y], index);
                *pixel = sum(*pixel, self.radiance([x, y], sample, &mut counts));
            }
            x = x.wrapping_add(1);
        }
        counts
    }

    /// One sample of a pixel.
    fn radiance(&self, pixel: [u32; 2], of: Sampler<P::Family>, counts: &mut Counts) -> Vector<A> {
        counts.base.draw();
        let camera = of.child(CAMERA);
        let centre = self.camera.image_point(pixel, A::square(camera.pair()));
        let lens = self.lens.ray(centre, || camera.joint()[1], counts);
        let ray = self.camera.ray(lens.origin, lens.direction);
        let Some(hit) = self.nearest(&ray) else { return self.sky.along(ray.direction) };
        let own = self.lit(&hit, of, counts);
        let arriving = ray.direction;
        let draw = || of.child(GLOSSY).pair();
        let (reflectance, sample) = match &hit.material.finish {
            Finish::Matte => return own,
            Finish::Mirror(reflectance) => {
                (reflectance, Reflection::<A>::sample(&Mirror, arriving, hit.normal, draw, counts))
            }
            Finish::Glossy(reflectance, lobe) => {
                (reflectance, lobe.sample(arriving, hit.normal, draw, counts))
            }
        };
        let Some(sample) = sample else { return own };
        let ray = hit.leaving(sample.direction);
        let seen = match self.nearest(&ray) {
            Some(hit) => self.lit(&hit, of.child(BOUNCE), counts),
            None => self.sky.along(ray.direction),
        };
        sum(own, product(*reflectance, scaled(sample.weight, seen)))
    }

    /// Emission, direct light and ambient light: all but reflection.
    fn lit(&self, hit: &Hit<'_, A, G>, of: Sampler<P::Family>, counts: &mut Counts) -> Vector<A> {
        let light = self.light.sample(hit.point, || of.child(LIGHT).pair(), counts);
        let share = light.weight * dot(light.direction, hit.normal.get()) * A::Real::FRAC_1_PI;
        let mut arriving = [A::Real::ZERO; 3];
        if share > A::Real::ZERO {
            S::send(counts);
            if self.meets(&hit.leaving(light.direction), light.distance).is_none() {
                arriving = scaled(share, self.intensity);
            }
        }
        let meets = |direction, reach| self.meets(&hit.leaving(direction), reach);
        let openness =
            self.occlusion.openness(hit.normal, meets, || of.child(OCCLUSION).pair(), counts);
        let arriving = along(arriving, openness, self.ambient);
        sum(hit.material.emission, product(hit.albedo, arriving))
    }

    /// The first surface along a ray.
    pub fn nearest(&self, ray: &Ray<A>) -> Option<Hit<'_, A, G>> {
        let mut limit = A::Real::MAX;
        let (mut sphere, mut plane) = (None, None);
        for candidate in self.spheres {
            if let Some(distance) = candidate.meets(ray).filter(|distance| *distance < limit) {
                (limit, sphere) = (distance, Some(candidate));
            }
        }
        for candidate in self.planes {
            if let Some(distance) = candidate.meets(ray).filter(|distance| *distance < limit) {
                (limit, plane) = (distance, Some(candidate));
            }
        }
        match (plane, sphere) {
            (Some(plane), _) => Some(plane.hit(ray, limit)),
            (None, Some(sphere)) => sphere.hit(ray, limit),
            (None, None) => None,
        }
    }

    /// Any surface nearer than a limit.
    pub fn meets(&self, ray: &Ray<A>, limit: A::Real) -> Option<A::Real> {
        let spheres = self.spheres.iter().filter_map(|sphere| sphere.meets(ray));
        let planes = self.planes.iter().filter_map(|plane| plane.meets(ray));
        spheres.chain(planes).find(|distance| *distance < limit)
    }
}

impl<A: Root> Sky<A> {
    /// The radiance from a direction of unit length.
    pub fn along(&self, direction: Vector<A>) -> Vector<A> {
        let height = direction[1];
        if height > A::Real::ZERO {
            // A unit vector's component may round to more than 1.
            let below = A::Real::ONE - height;
            let below = if below > A::Real::ZERO { below } else { A::Real::ZERO };
            along(scaled(below, self.horizon), height, self.zenith)
        } else {
            self.horizon
        }
    }
}

impl<A: Root, G> Hit<'_, A, G> {
    /// A ray that leaves the surface.
    ///
    /// It starts sqrt(eps) above: far more than the error of a hit in scenes of up to some hundred
    /// units, and too little to be seen.
    #[inline]
    pub fn leaving(&self, direction: Vector<A>) -> Ray<A> {
        let above = A::sqrt(A::Real::EPSILON);
        Ray { origin: along(self.point, above, self.normal.get()), direction }
    }
}
