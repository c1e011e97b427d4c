//! A disc light: soft shadows (K. Suffern, "Ray Tracing from the Ground Up", 2007, chapter 18).
//!
//! A point of the disc, uniform over its area A, is seen from a receiver at a distance d and under
//! the angle t to the disc's normal, which the receiver sees under s to its own. The point's
//! density per steradian is d^2 / (A cos t), and irradiance is the mean of radiance A cos s cos
//! t / d^2 where nothing is in the way.
//!
//! A light is given by its radiance L or by its intensity along the axis, I = L A, which stays
//! finite for a light of radius 0, a point. So there are two weights: A cos t / d^2, to be multiplied
//! by L, and cos t / d^2, by I.

use super::{along, capped, positive, reciprocal};
use crate::arithmetic::{Arithmetic, FastF32, Real, RealKernel, Root, length};
use crate::error::Error;
use crate::frame::{Frame, Unit};
use crate::map::Concentric;

/// A disc-shaped light that shines to the side of its normal, or to both sides.
///
/// ```
/// use hemidisc::{Frame, LibmF32, effect::DiscLight};
/// let down = Frame::new([0.0, -1.0, 0.0])?;
/// let lamp = DiscLight::<LibmF32>::new([0.0, 3.0, 0.0], down, 0.5)?;
/// let receiver = [0.0, 1.0, 0.0];
/// let sample = lamp.sample(receiver, [1 << 31, 1 << 31]);
/// assert!((sample.distance - 2.0).abs() < 1e-6 && (sample.weight - 0.25).abs() < 1e-6);
/// // Of radiance 3, on a receiver that faces up.
/// let irradiance = 3.0 * sample.radiance_weight * sample.direction[1];
/// assert!((irradiance - 3.0 * lamp.area() / 4.0).abs() < 1e-6);
/// // A ray of another strategy, such as a lobe's, meets the light at this point.
/// let hit = lamp.hit(receiver, [0.1, 2.0, 0.0]).unwrap();
/// assert!((hit.point[0] - 0.1).abs() < 1e-6 && lamp.hit(receiver, [1.0, 2.0, 0.0]).is_none());
/// // Behind it there is no light.
/// assert_eq!(lamp.sample([0.0, 4.0, 0.0], [1 << 31, 1 << 31]).weight, 0.0);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscLight<A: Arithmetic> {
    map: Concentric<A>,
    centre: [A::Real; 3],
    frame: Frame<A::Real>,
    radius: A::Real,
    two_sided: bool,
    /// pi r^2.
    area: A::Real,
    /// The size of the centre, |x n_x| + |y n_y| + |z n_z|.
    offset: A::Real,
}

/// A point of a light as a receiver sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct LightSample<R> {
    /// On the light.
    pub point: [R; 3],
    /// From the receiver, of unit length. It is the light's normal where d^2 underflows or
    /// overflows: for a receiver at the point, and for one too far away.
    pub direction: [R; 3],
    /// From the receiver; 0 where d^2 underflows or overflows.
    pub distance: R,
    /// Per steradian about the receiver, a normal number; 0 where no light arrives.
    pub density: R,
    /// cos t / d^2, per square of the scene's unit: times the intensity along the axis and the
    /// receiver's cosine it is irradiance. 0 behind the light and in its plane. The plane is as
    /// thick as the rounding of a receiver's coordinates and of the centre's, half a step of each,
    /// and of the products by which its side is found.
    pub weight: R,
    /// The light's area times [`weight`](Self::weight), 1 / density within rounding: times the
    /// radiance and the receiver's cosine it is irradiance. 0 where `weight` is, and for a light
    /// of radius 0, which has an intensity and no radiance; at most MAX.
    pub radiance_weight: R,
}

/// Where a ray meets the disc.
struct Hit<R> {
    /// From the point to the centre.
    to_centre: [R; 3],
    /// Of the ray, of unit length.
    direction: [R; 3],
    distance: R,
    /// cos t, above 0.
    cosine: R,
}

impl<A: Arithmetic> DiscLight<A> {
    /// The centre of the disc.
    #[must_use]
    pub const fn centre(&self) -> [A::Real; 3] {
        self.centre
    }

    /// The frame whose third axis is the disc's normal.
    #[must_use]
    pub const fn frame(&self) -> &Frame<A::Real> {
        &self.frame
    }

    /// The radius of the disc.
    #[must_use]
    pub const fn radius(&self) -> A::Real {
        self.radius
    }

    /// Whether the light shines to both sides.
    #[must_use]
    pub const fn is_two_sided(&self) -> bool {
        self.two_sided
    }
}

impl DiscLight<FastF32> {
    /// [`new`](Self::new), as a `const fn`: for a light in a `static`.
    ///
    /// # Errors
    /// Those of `new`.
    pub const fn const_new(
        centre: [f32; 3],
        frame: Frame<f32>,
        radius: f32,
    ) -> Result<Self, Error> {
        let centre = match length::f32::centre(centre, radius) {
            Ok(centre) => centre,
            Err(error) => return Err(error),
        };
        let offset = length::f32::size(centre, frame.unit().get());
        let area = radius * radius / core::f32::consts::FRAC_1_PI;
        Ok(Self { map: Concentric::new(), centre, frame, radius, two_sided: false, area, offset })
    }
}

impl<A: Root> DiscLight<A> {
    /// A light about a centre, whose normal is the frame's third axis; one-sided.
    ///
    /// # Errors
    /// [`Error::Radius`] for a radius that is negative, NaN or has no finite square,
    /// [`Error::Position`] if a coordinate of the centre or of the rim is not finite.
    pub fn new(
        centre: [A::Real; 3],
        frame: Frame<A::Real>,
        radius: A::Real,
    ) -> Result<Self, Error> {
        let centre = A::Real::checked_centre(centre, radius)?;
        let offset = A::Real::size(centre, frame.unit().get());
        let area = radius * radius / A::Real::FRAC_1_PI;
        Ok(Self { map: Concentric::new(), centre, frame, radius, two_sided: false, area, offset })
    }

    /// The same light, shining to both sides.
    #[must_use]
    pub const fn two_sided(self) -> Self {
        Self { two_sided: true, ..self }
    }

    /// pi r^2.
    #[must_use]
    #[inline]
    pub fn area(&self) -> A::Real {
        self.area
    }

    /// Whether all of its light comes from one point: its radius is 0, or so small that its area is.
    /// No direction of another strategy hits it, so that
    /// [the heuristics](super::power_heuristic) weigh its samples with 1.
    #[must_use]
    #[inline]
    pub fn is_delta(&self) -> bool {
        self.area() == A::Real::ZERO
    }

    /// The density of its points, per unit of area; at most MAX.
    #[must_use]
    #[inline]
    pub fn area_density(&self) -> A::Real {
        reciprocal(self.area())
    }

    /// The light's point for a pair of coordinates, as seen from a receiver. A receiver so near
    /// that d^2 underflows counts as on the light.
    #[must_use]
    #[inline]
    pub fn sample(&self, receiver: [A::Real; 3], uv: [u32; 2]) -> LightSample<A::Real> {
        let [x_axis, y_axis, normal] = self.frame.axes();
        let [x, y] = self.map.sample(uv);
        let point = along(along(self.centre, x * self.radius, x_axis), y * self.radius, y_axis);
        let to_light = along(point, -A::Real::ONE, receiver);
        let square = A::Real::dot(to_light, to_light);
        if !(square >= A::Real::MIN_POSITIVE && square.finite()) {
            return LightSample { point, direction: normal, ..LightSample::default() };
        }
        let distance = A::sqrt(square);
        let direction = to_light.map(|component| component / distance);
        // The cosine comes from the distance to the plane: all points agree on the side, and none
        // is a rounding error.
        let weight = self.shining(self.height(receiver) / distance) / square;
        self.seen(point, direction, distance, weight)
    }

    /// A point of the light as a receiver sees it.
    #[inline]
    fn seen(
        &self,
        point: [A::Real; 3],
        direction: [A::Real; 3],
        distance: A::Real,
        weight: A::Real,
    ) -> LightSample<A::Real> {
        let solid = self.area * weight;
        let density = if weight > A::Real::ZERO { reciprocal(solid) } else { A::Real::ZERO };
        let radiance_weight = capped(solid);
        LightSample { point, direction, distance, density, weight, radiance_weight }
    }

    /// The point of the light that a ray from a receiver hits, with the distance, the density and
    /// the weights that [`sample`](Self::sample) gives for that point, within rounding. A vector
    /// that is not of unit length stands for its direction.
    ///
    /// `None` where the ray misses the light, arrives on a side that does not shine, or starts in
    /// the light's plane, as thick as [`weight`](LightSample::weight) has it; where d^2 or
    /// cos t / d^2 is no normal number; for a vector that is zero, infinite or not a number; and for
    /// a light of radius 0, which no ray hits. Within rounding of the rim a sampled direction may
    /// miss.
    ///
    /// It takes three divisions and no square root.
    #[must_use]
    #[inline]
    pub fn hit(
        &self,
        receiver: [A::Real; 3],
        direction: [A::Real; 3],
    ) -> Option<LightSample<A::Real>> {
        let Hit { to_centre, direction, distance, cosine } = self.met(receiver, direction)?;
        let point = along(self.centre, -A::Real::ONE, to_centre);
        Some(self.seen(point, direction, distance, cosine / (distance * distance)))
    }

    /// The density of a direction from a receiver, per steradian: that of [`hit`](Self::hit),
    /// within rounding, and 0 where that is `None`. It takes two divisions.
    #[must_use]
    #[inline]
    pub fn density(&self, receiver: [A::Real; 3], direction: [A::Real; 3]) -> A::Real {
        match self.met(receiver, direction) {
            Some(Hit { distance, cosine, .. }) => {
                let [seen, square] = [self.area * cosine, distance * distance];
                if seen >= A::Real::MIN_POSITIVE {
                    positive(square / seen)
                } else {
                    // The product has lost digits, and cos t / d^2 has not.
                    reciprocal(self.area * (cosine / square))
                }
            }
            None => A::Real::ZERO,
        }
    }

    /// Where a ray from a receiver meets the disc.
    #[inline]
    fn met(&self, receiver: [A::Real; 3], direction: [A::Real; 3]) -> Option<Hit<A::Real>> {
        let direction = Unit::normalized(direction).ok()?.get();
        let toward = -A::Real::dot(direction, self.frame.unit().get());
        let cosine = self.shining(toward);
        let distance = self.height(receiver) / toward;
        if !(cosine > A::Real::ZERO && distance > A::Real::ZERO) {
            return None;
        }
        let to_centre = along(self.centre, -A::Real::ONE, receiver);
        let to_centre = along(to_centre, -distance, direction);
        let inside = A::Real::dot(to_centre, to_centre) < self.radius * self.radius;
        let square = distance * distance;
        // Both d^2 and cos t / d^2 are normal numbers.
        let in_range = square >= A::Real::MIN_POSITIVE && cosine > square * A::Real::MIN_POSITIVE;
        (inside && in_range).then_some(Hit { to_centre, direction, distance, cosine })
    }

    /// A receiver's height above the light's plane, on the side of the normal; 0 where rounding
    /// decides the side.
    ///
    /// A coordinate is within half a step of what it stands for, and half a step is at most
    /// EPSILON / 2 of it. The difference, three products and two sums lose no more than 2 EPSILON
    /// of the sizes of the products.
    #[inline]
    fn height(&self, receiver: [A::Real; 3]) -> A::Real {
        let normal = self.frame.unit().get();
        let above = along(receiver, -A::Real::ONE, self.centre);
        let height = A::Real::dot(above, normal);
        let half_a_step = A::Real::EPSILON * A::Real::HALF;
        let given = self.offset * half_a_step + A::Real::size(receiver, normal) * half_a_step;
        let lost = A::Real::size(above, normal) * (A::Real::EPSILON * A::Real::TWO);
        if height.magnitude() > given + lost { height } else { A::Real::ZERO }
    }

    /// cos t from the cosine to the normal: 0 on a side where the light does not shine.
    #[inline]
    fn shining(&self, cosine: A::Real) -> A::Real {
        if cosine > A::Real::ZERO {
            cosine
        } else if self.two_sided {
            -cosine
        } else {
            A::Real::ZERO
        }
    }
}
