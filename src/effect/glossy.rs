//! Glossy reflection: a cosine-power lobe about the mirror direction (B. T. Phong, "Illumination
//! for Computer Generated Pictures", 1975; K. Suffern, "Ray Tracing from the Ground Up", 2007,
//! chapter 25).
//!
//! At grazing angles a part of the lobe is below the surface; [`BelowHorizon`] chooses how to
//! handle it.

use super::{DirectionSample, along, capped};
use crate::arithmetic::{Arithmetic, FastF32, Real, RealKernel, Root};
use crate::error::Error;
use crate::frame::{Frame, Unit};
use crate::map::{Density, Power};

/// How to handle a direction below the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BelowHorizon {
    /// Rejected: there is no sample. The mean over the others is that of the lobe's upper part,
    /// normalised to 1. No energy is lost, and the caller counts the samples.
    Reject,
    /// Mirrored in the surface; its density is added to that of the direction it becomes. No energy
    /// is lost.
    Flip,
    /// Given weight 0: the energy of the part below is lost.
    Zero,
}

/// Directions of density (e + 1) cos^e / (2 pi) about the mirror direction.
///
/// ```
/// use hemidisc::{LibmF32, Unit, effect::{BelowHorizon, Glossy}};
/// let gloss = Glossy::<LibmF32>::new(50.0, BelowHorizon::Flip)?;
/// let (down, up) = (Unit::new([0.6, -0.8, 0.0])?, Unit::new([0.0, 1.0, 0.0])?);
/// let sample = gloss.sample(down, up, [1 << 31, 1 << 31]).unwrap();
/// // The middle of the square is the lobe's axis.
/// assert!((sample.direction[1] - 0.8).abs() < 1e-3);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glossy<A: Arithmetic> {
    lobe: Power<A>,
    below: BelowHorizon,
}

impl<A: Arithmetic> Glossy<A> {
    /// The exponent as it was given.
    #[must_use]
    pub fn exponent(&self) -> A::Parameter {
        self.lobe.exponent()
    }

    /// Whether all of its directions are one: never, for the exponent is finite. For
    /// [the heuristics](super::power_heuristic), as that of a light.
    #[must_use]
    #[inline]
    pub const fn is_delta(&self) -> bool {
        self.lobe.is_delta()
    }

    /// What becomes of a direction below the surface.
    #[must_use]
    pub const fn below_horizon(&self) -> BelowHorizon {
        self.below
    }
}

impl Glossy<FastF32> {
    /// [`new`](Self::new), as a `const fn`: for a reflection in a `static`.
    ///
    /// # Errors
    /// Those of `new`.
    pub const fn const_new(exponent: f32, below: BelowHorizon) -> Result<Self, Error> {
        match Power::<FastF32>::const_new(exponent) {
            Ok(lobe) => Ok(Self { lobe, below }),
            Err(error) => Err(error),
        }
    }
}

impl<A: Arithmetic<Real: Real>> Glossy<A> {
    /// Reflection with an exponent e > -1: the larger, the nearer to a mirror.
    ///
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub fn new(exponent: A::Parameter, below: BelowHorizon) -> Result<Self, Error> {
        Ok(Self { lobe: Power::new(exponent)?, below })
    }

    /// The direction in which light that arrives along a direction leaves a surface with a normal;
    /// `None` if it is rejected.
    ///
    /// Either side of a surface may be hit: the normal is taken to be on the side that the light
    /// comes from.
    #[must_use]
    #[inline]
    pub fn sample(
        &self,
        arriving: Unit<A::Real>,
        normal: Unit<A::Real>,
        uv: [u32; 2],
    ) -> Option<DirectionSample<A::Real>> {
        let mirror = Mirror::new(arriving, normal);
        let (local, mut density) = self.lobe.sample_with_density(uv);
        let mut direction = mirror.frame.to_world(local);
        let mut weight = A::Real::ONE;
        let across = A::Real::dot(direction, normal.get());
        let height = across * mirror.side;
        match self.below {
            BelowHorizon::Flip => {
                let image = in_surface(direction, across, normal.get());
                let others = self.density_of_image(&mirror, local[2], height, image);
                density = capped(density + others);
                // Half of the samples at a grazing angle: a product instead of a branch.
                let lower = if height < A::Real::ZERO { across } else { A::Real::ZERO };
                direction = in_surface(direction, lower, normal.get());
            }
            // Nothing is visible along the surface either.
            _ if height > A::Real::ZERO => {}
            BelowHorizon::Reject => return None,
            BelowHorizon::Zero => weight = A::Real::ZERO,
        }
        Some(DirectionSample { direction, density, weight })
    }

    /// The density of leaving along a direction, per steradian: that of a sample with this
    /// direction, within rounding. A vector that is not of unit length stands for its direction.
    ///
    /// Below the surface it is 0 for [`Reject`](BelowHorizon::Reject) and
    /// [`Flip`](BelowHorizon::Flip), which give no such sample. For [`Zero`](BelowHorizon::Zero),
    /// which gives samples of weight 0 there, it is the lobe's. For `Reject` it is the density
    /// before rejection.
    #[must_use]
    #[inline]
    pub fn density(
        &self,
        arriving: Unit<A::Real>,
        normal: Unit<A::Real>,
        direction: [A::Real; 3],
    ) -> A::Real {
        let Ok(direction) = Unit::normalized(direction).map(Unit::get) else {
            return A::Real::ZERO;
        };
        let mirror = Mirror::new(arriving, normal);
        let across = A::Real::dot(direction, normal.get());
        let height = across * mirror.side;
        let local = mirror.frame.to_local(direction);
        match self.below {
            // A flipped direction may have rounded to the other side again.
            BelowHorizon::Flip if height >= -(A::Real::EPSILON * A::Real::FOUR) => {
                let image = in_surface(direction, across, normal.get());
                let others = self.density_of_image(&mirror, local[2], height, image);
                capped(self.lobe.density(local) + others)
            }
            BelowHorizon::Zero => self.lobe.density(local),
            BelowHorizon::Reject if height > A::Real::ZERO => self.lobe.density(local),
            BelowHorizon::Reject | BelowHorizon::Flip => A::Real::ZERO,
        }
    }

    /// The lobe's density of a direction's image in the surface, to be added to that of the
    /// direction, whose height about the lobe's axis is z. Most images are behind the lobe's horizon,
    /// or too dim for the sum to show: they are not turned to the lobe, and no power is taken of
    /// them.
    ///
    /// With the heights h of the direction and c of the axis above the surface, z of the image is
    /// less by 2 h c. So its x^2 + y^2 is more by 4 h c (z - h c), in which a narrow lobe loses few
    /// digits: h and c are small where its images count.
    #[inline]
    fn density_of_image(
        &self,
        mirror: &Mirror<A::Real>,
        z: A::Real,
        height: A::Real,
        image: [A::Real; 3],
    ) -> A::Real {
        let lower = height * mirror.height;
        let growth = A::Real::FOUR * lower * (z - lower);
        self.lobe.density_beside([growth, z - (lower + lower)], || mirror.frame.to_local(image))
    }
}

impl<A: Root> Glossy<A> {
    /// The share of the lobe that is above the surface, in [1/2, 1]: 1 at normal incidence, 1/2 for
    /// light along the surface.
    ///
    /// The density divided by it is the density of the samples that
    /// [`Reject`](BelowHorizon::Reject) gives: it integrates to 1, as multiple importance sampling
    /// needs. With [`Zero`](BelowHorizon::Zero) the share is the mean weight.
    ///
    /// It is that of the angle between the two vectors as they are, within 1e-5, for any exponent
    /// in (-1, 1e30]; with `MicromathF32` within 3e-5. A sharp lobe makes much of an angle: where
    /// the vectors are off by an eps, the share is off by up to 0.4 sqrt(e) eps. It takes two
    /// exponentials, a logarithm, three square roots and at most 17 divisions.
    ///
    /// ```
    /// use hemidisc::{LibmF64, Unit, effect::{BelowHorizon, Glossy}};
    /// let gloss = Glossy::<LibmF64>::new(10.0, BelowHorizon::Reject)?;
    /// let (sin, cos) = 10_f64.to_radians().sin_cos();
    /// let (arriving, up) = (Unit::new([cos, -sin, 0.0])?, Unit::new([0.0, 1.0, 0.0])?);
    /// let share = gloss.kept_share(arriving, up);
    /// assert!((share - 0.714_762).abs() < 1e-5);
    /// let sample = gloss.sample(arriving, up, [1 << 31, 1 << 31]).unwrap();
    /// let density_of_kept = sample.density / share;
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    #[must_use]
    pub fn kept_share(&self, arriving: Unit<A::Real>, normal: Unit<A::Real>) -> A::Real {
        let (arriving, normal) = (arriving.get(), normal.get());
        let sine = A::Real::dot(arriving, normal);
        // From the part along the surface: 1 - sin^2 has lost the digits near the normal.
        let across = along(arriving, -sine, normal);
        self.lobe.share_above(sine.magnitude(), A::Real::dot(across, across))
    }
}

/// The mirror direction a - 2 (a n) n.
struct Mirror<R> {
    frame: Frame<R>,
    /// Its height above the surface, on the side of arrival.
    height: R,
    /// The sign of heights on the side of arrival: 1 or -1.
    side: R,
}

impl<R: Real> Mirror<R> {
    /// Without a branch: light may come from either side.
    #[inline]
    fn new(arriving: Unit<R>, normal: Unit<R>) -> Self {
        let across = R::dot(arriving.get(), normal.get());
        // The lengths of both count in that of the mirror direction.
        let mirror = Unit::polished(in_surface(arriving.get(), across, normal.get()));
        // A difference has no negative zero: along the surface the side is the normal's.
        let side = R::ONE.with_sign(R::ZERO - across);
        Self { frame: Frame::from(mirror), height: across.magnitude(), side }
    }
}

/// A vector's image in the surface, of its height above it.
#[inline]
fn in_surface<R: Real>(vector: [R; 3], height: R, normal: [R; 3]) -> [R; 3] {
    along(vector, -(height + height), normal)
}
