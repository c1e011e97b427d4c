//! Ambient occlusion: how much of the sky, weighted by the cosine, nothing near hides
//! (S. Zhukov, A. Iones and G. Kronin, "An Ambient Light Illumination Model", 1998).
//!
//! With directions of density cos theta / pi it is a plain mean: of 1 where nothing is hit within
//! the reach, else 0, or a function of the distance that fades to 1 at the reach.

use super::DirectionSample;
use crate::arithmetic::{Arithmetic, FastF32, Real, RealKernel, length};
use crate::error::Error;
use crate::frame::Frame;
use crate::map::{Cosine, Density};

/// Cosine-weighted directions about a normal, to be traced up to a reach.
///
/// ```
/// use hemidisc::{Frame, LibmF32, effect::AmbientOcclusion};
/// let occlusion = AmbientOcclusion::<LibmF32>::new(0.5)?;
/// let ground = Frame::new([0.0, 1.0, 0.0])?;
/// let sample = occlusion.sample(&ground, [1 << 31, 1 << 30]);
/// assert!(sample.direction[1] > 0.0 && sample.weight == 1.0);
/// assert_eq!(occlusion.openness(Some(0.4)), 0.0);
/// assert_eq!(occlusion.openness(None), 1.0);
/// assert_eq!(occlusion.faded_openness(Some(0.25)), 0.75);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AmbientOcclusion<A: Arithmetic> {
    lobe: Cosine<A>,
    reach: A::Real,
}

impl<A: Arithmetic> AmbientOcclusion<A> {
    /// How far to look.
    #[must_use]
    pub const fn reach(&self) -> A::Real {
        self.reach
    }
}

impl AmbientOcclusion<FastF32> {
    /// [`new`](Self::new), as a `const fn`: for occlusion in a `static`.
    ///
    /// # Errors
    /// Those of `new`.
    pub const fn const_new(reach: f32) -> Result<Self, Error> {
        match length::f32::distance(reach) {
            Ok(reach) => Ok(Self { lobe: Cosine::new(), reach }),
            Err(error) => Err(error),
        }
    }
}

impl<A: Arithmetic<Real: Real>> AmbientOcclusion<A> {
    /// Occlusion by what is nearer than `reach`, which may be infinite.
    ///
    /// # Errors
    /// [`Error::Distance`] for a reach that is not above 0.
    pub fn new(reach: A::Real) -> Result<Self, Error> {
        Ok(Self { lobe: Cosine::new(), reach: A::Real::checked_distance(reach)? })
    }

    /// A direction about the third axis of a frame.
    #[must_use]
    #[inline]
    pub fn sample(&self, normal: &Frame<A::Real>, uv: [u32; 2]) -> DirectionSample<A::Real> {
        let (local, density) = self.lobe.sample_with_density(uv);
        DirectionSample { direction: normal.to_world(local), density, weight: A::Real::ONE }
    }

    /// 1 where nothing is hit, or only at the reach or beyond; else 0.
    #[must_use]
    #[inline]
    pub fn openness(&self, met: Option<A::Real>) -> A::Real {
        match met {
            Some(distance) if distance < self.reach => A::Real::ZERO,
            _ => A::Real::ONE,
        }
    }

    /// 1 where nothing is hit, or only at the reach or beyond; else 1 - (1 - distance / reach)^2.
    ///
    /// It is 0 at a distance of 0 and 1 at the reach, where it has no edge: occlusion fades out
    /// with the distance, as obscurance does (Zhukov et al. 1998). Within an infinite reach it is 0
    /// for anything that is hit.
    #[must_use]
    #[inline]
    pub fn faded_openness(&self, met: Option<A::Real>) -> A::Real {
        match met {
            Some(distance) if distance < self.reach => {
                let near = distance / self.reach;
                // 1 - (1 - n)^2, without the differences.
                if near > A::Real::ZERO { near * (A::Real::TWO - near) } else { A::Real::ZERO }
            }
            _ => A::Real::ONE,
        }
    }
}
