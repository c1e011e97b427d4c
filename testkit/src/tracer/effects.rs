//! The four effects as the renderer asks for them, and what stands in for each where it is absent.
//!
//! `draw` gives the effect's point of the sample. A stand-in does not call it, and its rays count
//! as the renderer's own.

use super::vector::{along, difference, dot};
use super::{Counts, Vector};
use hemidisc::arithmetic::{Arithmetic, Real, Root};
use hemidisc::effect::{
    AmbientOcclusion, DirectionSample, DiscLight, Glossy, LensRay, LightSample, ThinLens,
};
use hemidisc::{Frame, Invert, Unit};

/// Draws the point of a sample.
pub trait Draw: FnOnce() -> [u32; 2] {}

impl<F: FnOnce() -> [u32; 2]> Draw for F {}

/// Where the rays of a pixel start.
pub trait Lens<A: Root> {
    /// A ray in camera space, for the ray (d_x, d_y, 1) through the centre.
    fn ray(&self, centre: [A::Real; 2], draw: impl Draw, counts: &mut Counts) -> LensRay<A::Real>;
}

/// Where direct light comes from.
pub trait Light<A: Root> {
    /// A point of the light as a receiver sees it.
    fn sample(
        &self,
        receiver: Vector<A>,
        draw: impl Draw,
        counts: &mut Counts,
    ) -> LightSample<A::Real>;
    /// One ray between the receiver and the light.
    fn send(counts: &mut Counts);
}

/// How much of the ambient light arrives.
pub trait Ambient<A: Root> {
    /// Its share at a surface; `meets` is whether, and where, something is met along a direction
    /// within a distance.
    fn openness(
        &self,
        normal: Unit<A::Real>,
        meets: impl Fn(Vector<A>, A::Real) -> Option<A::Real>,
        draw: impl Draw,
        counts: &mut Counts,
    ) -> A::Real;
}

/// Where a shiny surface looks.
pub trait Reflection<A: Root> {
    /// A direction above the surface. `None` means that the sample sees nothing there, and its
    /// energy is lost.
    fn sample(
        &self,
        arriving: Vector<A>,
        normal: Unit<A::Real>,
        draw: impl Draw,
        counts: &mut Counts,
    ) -> Option<DirectionSample<A::Real>>;
}

/// No lens: everything is sharp.
#[derive(Clone, Copy, Debug)]
pub struct Pinhole;

impl<A: Root> Lens<A> for Pinhole {
    #[inline]
    fn ray(&self, [x, y]: [A::Real; 2], _: impl Draw, counts: &mut Counts) -> LensRay<A::Real> {
        counts.base.send();
        let mut ray = LensRay::default();
        ray.direction = [x, y, A::Real::ONE];
        ray
    }
}

impl<A: Root, M> Lens<A> for ThinLens<M, A::Real>
where
    M: Invert<Point = [A::Real; 2]>,
{
    #[inline]
    fn ray(&self, centre: [A::Real; 2], draw: impl Draw, counts: &mut Counts) -> LensRay<A::Real> {
        counts.lens.draw();
        counts.lens.send();
        ThinLens::ray(self, centre, draw())
    }
}

/// No disc: a light at one point, with hard shadows, that shines about its normal as a disc does.
#[derive(Clone, Copy, Debug)]
pub struct PointLight<A: Arithmetic> {
    /// Where it is.
    pub position: [A::Real; 3],
    /// Where it shines to.
    pub normal: Unit<A::Real>,
    /// Whether it shines to the other side too.
    pub two_sided: bool,
}

impl<A: Root> Light<A> for PointLight<A> {
    /// Rounds as [`DiscLight::sample`] does, so that a disc of radius 0 gives the same bits.
    #[inline]
    fn sample(&self, receiver: Vector<A>, _: impl Draw, _: &mut Counts) -> LightSample<A::Real> {
        let to_light = difference(self.position, receiver);
        let square = dot(to_light, to_light);
        if !(square >= A::Real::MIN_POSITIVE && square.finite()) {
            return LightSample::default();
        }
        let distance = A::sqrt(square);
        let direction = to_light.map(|component| component / distance);
        let (normal, above) = (self.normal.get(), difference(receiver, self.position));
        let height = dot(above, normal);
        let size_of = |v: Vector<A>| dot(v.map(Real::magnitude), normal.map(Real::magnitude));
        // A receiver whose side rounding decides is in the light's plane.
        let half_a_step = A::Real::EPSILON * A::Real::HALF;
        let given = size_of(self.position) * half_a_step + size_of(receiver) * half_a_step;
        let lost = size_of(above) * (A::Real::EPSILON * A::Real::TWO);
        let beside = height.magnitude() > given + lost;
        let cosine = if beside { height / distance } else { A::Real::ZERO };
        let shines = cosine > A::Real::ZERO || self.two_sided;
        let weight = if shines { cosine.magnitude() / square } else { A::Real::ZERO };
        let mut sample = LightSample::default();
        sample.point = self.position;
        (sample.direction, sample.distance, sample.weight) = (direction, distance, weight);
        sample
    }

    #[inline]
    fn send(counts: &mut Counts) {
        counts.base.send();
    }
}

impl<A: Root> Light<A> for DiscLight<A> {
    #[inline]
    fn sample(
        &self,
        receiver: Vector<A>,
        draw: impl Draw,
        counts: &mut Counts,
    ) -> LightSample<A::Real> {
        counts.light.draw();
        DiscLight::sample(self, receiver, draw())
    }

    #[inline]
    fn send(counts: &mut Counts) {
        counts.light.send();
    }
}

/// No occlusion: ambient light arrives everywhere.
#[derive(Clone, Copy, Debug)]
pub struct Unoccluded;

impl<A: Root> Ambient<A> for Unoccluded {
    #[inline]
    fn openness(
        &self,
        _: Unit<A::Real>,
        _: impl Fn(Vector<A>, A::Real) -> Option<A::Real>,
        _: impl Draw,
        _: &mut Counts,
    ) -> A::Real {
        A::Real::ONE
    }
}

impl<A: Root> Ambient<A> for AmbientOcclusion<A> {
    #[inline]
    fn openness(
        &self,
        normal: Unit<A::Real>,
        meets: impl Fn(Vector<A>, A::Real) -> Option<A::Real>,
        draw: impl Draw,
        counts: &mut Counts,
    ) -> A::Real {
        counts.occlusion.draw();
        counts.occlusion.send();
        let sample = self.sample(&Frame::from(normal), draw());
        sample.weight * Self::openness(self, meets(sample.direction, self.reach()))
    }
}

/// No lobe: one direction.
#[derive(Clone, Copy, Debug)]
pub struct Mirror;

impl<A: Root> Reflection<A> for Mirror {
    #[inline]
    fn sample(
        &self,
        arriving: Vector<A>,
        normal: Unit<A::Real>,
        _: impl Draw,
        counts: &mut Counts,
    ) -> Option<DirectionSample<A::Real>> {
        counts.base.send();
        let normal = normal.get();
        let cosine = dot(arriving, normal);
        let direction = along(arriving, -(cosine + cosine), normal);
        let mut sample = DirectionSample::default();
        sample.direction = direction;
        (sample.density, sample.weight) = (A::Real::ONE, A::Real::ONE);
        Some(sample)
    }
}

impl<A: Root> Reflection<A> for Glossy<A> {
    #[inline]
    fn sample(
        &self,
        arriving: Vector<A>,
        normal: Unit<A::Real>,
        draw: impl Draw,
        counts: &mut Counts,
    ) -> Option<DirectionSample<A::Real>> {
        let arriving = Unit::normalized(arriving).ok()?;
        counts.glossy.draw();
        let sample = Glossy::sample(self, arriving, normal, draw());
        counts.glossy.rays += u64::from(sample.is_some());
        sample
    }
}
