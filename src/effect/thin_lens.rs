//! A thin lens: depth of field (R. Cook, T. Porter and L. Carpenter, "Distributed Ray Tracing",
//! 1984; K. Suffern, "Ray Tracing from the Ground Up", 2007, chapter 10).
//!
//! Rays of one pixel leave the lens anywhere and meet where the ray through its centre is in focus.
//! In camera space, z ahead, that ray has the direction d = (d_x, d_y, 1); from the lens point
//! (l_x, l_y) it is d - (l_x, l_y, 0) / f with the focal distance f. A lens of radius 0 gives d to
//! the last bit.
//!
//! Camera space has the handedness of the caller's axes: nothing here depends on it. With x to the
//! right and y up, z ahead makes it left-handed. With y down, as the rows of a picture count, it is
//! right-handed, and [`Frame::look_to`](crate::Frame::look_to) is the way to the world.

use super::{capped, reciprocal};
use crate::arithmetic::{Real, length};
use crate::error::Error;
use crate::map::{Density, Map};

/// A lens whose aperture is any map onto the unit disc: [`Concentric`](crate::Concentric) or
/// [`Polar`](crate::Polar) for a round one, [`Polygon`](super::Polygon) for one with blades.
///
/// ```
/// use hemidisc::{Concentric, LibmF32, effect::ThinLens};
/// // 5 mm, focused at 2 m.
/// let lens = ThinLens::new(Concentric::<LibmF32>::new(), 0.005, 2.0)?;
/// let ray = lens.ray([0.1, -0.2], [1 << 30, 3 << 30]);
/// // Two metres ahead all rays of the pixel meet.
/// assert!((ray.origin[0] + 2.0 * ray.direction[0] - 0.2).abs() < 1e-6);
/// assert!(ThinLens::new(Concentric::<LibmF32>::new(), -1.0, 2.0).is_err());
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThinLens<M, R> {
    aperture: M,
    radius: R,
    focal_distance: R,
    /// 1 / focal distance.
    nearness: R,
}

/// A ray from a lens, in camera space: x and y are the caller's axes of the image plane, z is
/// ahead. [`Frame::look_to`](crate::Frame::look_to) turns it to the world.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct LensRay<R> {
    /// On the lens, z = 0.
    pub origin: [R; 3],
    /// Ahead, with z = 1: not of unit length.
    pub direction: [R; 3],
    /// Of the origin, per unit of area: a normal number, for any radius.
    pub density: R,
    /// 1: a pixel is the mean over its lens.
    pub weight: R,
}

impl<M, R: Copy> ThinLens<M, R> {
    /// The map onto the aperture, a part of the unit disc.
    #[must_use]
    pub const fn aperture(&self) -> &M {
        &self.aperture
    }

    /// The radius of the lens.
    #[must_use]
    pub const fn radius(&self) -> R {
        self.radius
    }

    /// The distance at which the lens is in focus.
    #[must_use]
    pub const fn focal_distance(&self) -> R {
        self.focal_distance
    }
}

macro_rules! const_lens {
    ($float:ident) => {
        impl<M: Map<Point = [$float; 2]>> ThinLens<M, $float> {
            /// [`new`](Self::new), as a `const fn`: for a lens in a `static`.
            ///
            /// # Errors
            /// Those of `new`.
            pub const fn const_new(
                aperture: M,
                radius: $float,
                focal_distance: $float,
            ) -> Result<Self, Error> {
                match length::$float::nearness(radius, focal_distance) {
                    Ok(nearness) => Ok(Self { aperture, radius, focal_distance, nearness }),
                    Err(error) => Err(error),
                }
            }
        }
    };
}
const_lens!(f32);
const_lens!(f64);

impl<R: Real, M: Map<Point = [R; 2]>> ThinLens<M, R> {
    /// A lens with a radius (0 for a pinhole) and a focal distance, which may be infinite.
    ///
    /// # Errors
    /// [`Error::Radius`] for a radius that is negative, NaN or has no finite square,
    /// [`Error::Distance`] for a distance that is not above 0, or so small that radius / distance
    /// is not finite.
    pub fn new(aperture: M, radius: R, focal_distance: R) -> Result<Self, Error> {
        let nearness = R::nearness(radius, focal_distance)?;
        Ok(Self { aperture, radius, focal_distance, nearness })
    }

    /// Whether all rays pass one point: a pinhole, or a radius so small that its square is 0.
    #[must_use]
    #[inline]
    pub fn is_delta(&self) -> bool {
        self.radius * self.radius == R::ZERO
    }

    /// The point of the lens for a pair of coordinates.
    #[must_use]
    #[inline]
    pub fn sample(&self, uv: [u32; 2]) -> [R; 2] {
        self.aperture.sample(uv).map(|component| component * self.radius)
    }

    /// The ray from the lens point of a pair of coordinates. In focus it meets the ray (d_x,
    /// d_y, 1) through the lens's centre.
    #[must_use]
    #[inline]
    pub fn ray(&self, [d_x, d_y]: [R; 2], uv: [u32; 2]) -> LensRay<R>
    where
        M: Density,
    {
        let (unit, density) = self.aperture.sample_with_density(uv);
        let [x, y] = unit.map(|component| component * self.radius);
        LensRay {
            origin: [x, y, R::ZERO],
            direction: [d_x - x * self.nearness, d_y - y * self.nearness, R::ONE],
            density: reciprocal(self.radius * self.radius / density),
            weight: R::ONE,
        }
    }

    /// Radius of the circle of confusion at a distance ahead: r |1 - distance / f|, in the lens's
    /// unit, at most MAX. At infinity it is MAX, but 0 for a pinhole. A lens in focus at infinity
    /// has its own radius at every distance. Divided by the distance it is the radius of the blur in
    /// the image plane z = 1.
    #[must_use]
    #[inline]
    pub fn circle_of_confusion(&self, distance: R) -> R {
        if self.radius == R::ZERO || self.nearness == R::ZERO {
            return self.radius;
        }
        let ratio = distance * self.nearness;
        // Where the ratio overflows, a small radius may bring the product back. f is below 1 then,
        // so that the product grows to the end.
        let blur = if ratio.finite() {
            self.radius * (R::ONE - ratio)
        } else {
            distance * self.radius * self.nearness
        };
        capped(blur.magnitude())
    }
}
