//! Glossy reflection: a cosine-power lobe about the mirror direction (B. T. Phong, "Illumination
//! for Computer Generated Pictures", 1975; K. Suffern, "Ray Tracing from the Ground Up", 2007,
//! chapter 25).
//!
//! At grazing angles a part of the lobe is below the surface; [`BelowHorizon`] chooses how to
//! handle it.

use super::{DirectionSample, along, capped};
use crate::arithmetic::{Arithmetic, Real};
use crate::error::Error;
use crate::frame::{Frame, dot};
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
/// use hemidisc::{LibmF32, effect::{BelowHorizon, Glossy}};
/// let gloss = Glossy::<LibmF32>::new(50.0, BelowHorizon::Flip)?;
/// let (down, up) = ([0.6, -0.8, 0.0], [0.0, 1.0, 0.0]);
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

    /// What becomes of a direction below the surface.
    #[must_use]
    pub const fn below_horizon(&self) -> BelowHorizon {
        self.below
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

    /// The direction in which light that arrives along a unit vector leaves a surface with a unit
    /// normal; `None` if it is rejected.
    ///
    /// Either side of a surface may be hit: the normal is taken to be on the side that the light
    /// comes from.
    #[must_use]
    #[inline]
    pub fn sample(
        &self,
        arriving: [A::Real; 3],
        normal: [A::Real; 3],
        uv: [u32; 2],
    ) -> Option<DirectionSample<A::Real>> {
        let (normal, mirror) = mirrored(arriving, normal);
        let (local, mut density) = self.lobe.sample_with_density(uv);
        let mut direction = mirror.to_world(local);
        let mut weight = A::Real::ONE;
        let height = dot(direction, normal);
        match self.below {
            BelowHorizon::Flip => {
                let flipped = in_surface(direction, height, normal);
                density = capped(density + self.lobe.density(mirror.to_local(flipped)));
                if height < A::Real::ZERO {
                    direction = flipped;
                }
            }
            // Nothing is visible along the surface either.
            _ if height > A::Real::ZERO => {}
            BelowHorizon::Reject => return None,
            BelowHorizon::Zero => weight = A::Real::ZERO,
        }
        Some(DirectionSample { direction, density, weight })
    }

    /// The density of leaving along a direction, per steradian. For
    /// [`Reject`](BelowHorizon::Reject) it is the density before rejection.
    #[must_use]
    #[inline]
    pub fn density(
        &self,
        arriving: [A::Real; 3],
        normal: [A::Real; 3],
        direction: [A::Real; 3],
    ) -> A::Real {
        let (normal, mirror) = mirrored(arriving, normal);
        let height = dot(direction, normal);
        let of = |direction| self.lobe.density(mirror.to_local(direction));
        if height > A::Real::ZERO {
            match self.below {
                BelowHorizon::Flip => {
                    capped(of(direction) + of(in_surface(direction, height, normal)))
                }
                BelowHorizon::Reject | BelowHorizon::Zero => of(direction),
            }
        } else {
            A::Real::ZERO
        }
    }
}

/// The normal on the side of arrival, and a frame about the mirror direction a - 2 (a n) n.
#[inline]
fn mirrored<R: Real>(arriving: [R; 3], normal: [R; 3]) -> ([R; 3], Frame<R>) {
    let cosine = dot(arriving, normal);
    let mirror = in_surface(arriving, cosine, normal);
    let normal = if cosine > R::ZERO { normal.map(|component| -component) } else { normal };
    (normal, Frame::about(mirror))
}

/// A vector's image in the surface, of its height above it.
#[inline]
fn in_surface<R: Real>(vector: [R; 3], height: R, normal: [R; 3]) -> [R; 3] {
    along(vector, -(height + height), normal)
}
