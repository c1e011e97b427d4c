//! Frames: an orthonormal basis about a direction, and directions in world space.
//!
//! T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin, "Building an
//! Orthonormal Basis, Revisited", JCGT 6(1), 2017: no branch, no square root, and exact near
//! n_z = -1, where Frisvad's form divides by 0.

use crate::arithmetic::{Real, Root};
use crate::block::{BLOCK, Block, Lanes};
use crate::error::Error;
use crate::map::{Density, Invert, Map};

/// A right-handed orthonormal basis whose third axis is a given unit vector.
///
/// ```
/// use hemidisc::{Cosine, Frame, LibmF32, Map};
/// let normal = [0.0, 1.0, 0.0];
/// let lobe = Cosine::<LibmF32>::new().about(Frame::new(normal)?);
/// let [_, up, _] = lobe.sample([1 << 30, 3 << 30]);
/// assert!(up > 0.0);
/// assert!(Frame::new([0.0_f32, 2.0, 0.0]).is_err());
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<R> {
    x: [R; 3],
    y: [R; 3],
    z: [R; 3],
}

impl<R: Real> Frame<R> {
    /// The frame about a unit vector.
    ///
    /// # Errors
    /// [`Error::NotUnit`] for a vector whose length squared is not within 16 ulp of 1, for then the
    /// basis is not orthonormal. [`normalized`](Self::normalized) takes a vector of any length.
    #[inline]
    pub fn new(z: [R; 3]) -> Result<Self, Error> {
        let length_squared = dot(z, z);
        let tolerance = R::EPSILON * R::FOUR * R::FOUR;
        if (length_squared - R::ONE).magnitude() <= tolerance {
            Ok(Self::about(z))
        } else {
            Err(Error::NotUnit { length_squared: length_squared.into() })
        }
    }

    /// The frame about the direction of a vector of any length.
    ///
    /// # Errors
    /// [`Error::NoDirection`] for a vector that is zero, infinite or not a number.
    #[inline]
    pub fn normalized<A: Root<Real = R>>(vector: [R; 3]) -> Result<Self, Error> {
        // Scaled by the largest component first, or the squares may leave the range.
        let [x, y, z] = vector.map(R::magnitude);
        let larger = if x > y { x } else { y };
        let largest = if larger > z { larger } else { z };
        if !vector.into_iter().all(R::finite) || largest == R::ZERO {
            return Err(Error::NoDirection);
        }
        // Dividing twice keeps a subnormal length from an infinite reciprocal.
        let scaled = vector.map(|component| component / largest);
        let length = A::sqrt(dot(scaled, scaled));
        Ok(Self::about(scaled.map(|component| component / length)))
    }

    /// Of a vector that is known to be of unit length.
    #[inline]
    pub(crate) fn about(z: [R; 3]) -> Self {
        let [n_x, n_y, n_z] = z;
        let sign = R::ONE.with_sign(n_z);
        let a = -R::ONE / (sign + n_z);
        let b = n_x * n_y * a;
        Self {
            x: [R::ONE + sign * (n_x * n_x * a), sign * b, -(sign * n_x)],
            y: [b, sign + n_y * n_y * a, -n_y],
            z,
        }
    }

    /// The three axes; the third is the vector that the frame was built about.
    #[must_use]
    #[inline]
    pub const fn axes(&self) -> [[R; 3]; 3] {
        [self.x, self.y, self.z]
    }

    /// A vector from the frame's coordinates to the world's.
    #[must_use]
    #[inline]
    pub fn to_world(&self, [x, y, z]: [R; 3]) -> [R; 3] {
        core::array::from_fn(|i| x * self.x[i] + y * self.y[i] + z * self.z[i])
    }

    /// A vector from the world's coordinates to the frame's.
    #[must_use]
    #[inline]
    pub fn to_local(&self, world: [R; 3]) -> [R; 3] {
        [dot(self.x, world), dot(self.y, world), dot(self.z, world)]
    }
}

#[inline]
pub(crate) fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A map of directions, turned about the third axis of a frame: world-space sampling about a
/// normal. [`Hemisphere::about`](crate::hemisphere::Hemisphere::about) turns a lobe.
///
/// Rotation rounds: a direction at the horizon may end a few eps below the plane, where its density
/// is 0. The angle to the axis of a sharp lobe is off by an eps, so the density of a turned
/// direction is accurate to about sqrt(e) eps. [`sample_with_density`](Density::sample_with_density)
/// takes the density before the rotation: positive for every sample, and as accurate as the lobe's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct About<M, R> {
    map: M,
    frame: Frame<R>,
}

impl<M, R> About<M, R> {
    /// The directions of a map in world space: its z axis is the third axis of the frame.
    #[must_use]
    pub const fn new(map: M, frame: Frame<R>) -> Self {
        Self { map, frame }
    }

    /// The map, about its own z axis.
    #[must_use]
    pub const fn map(&self) -> &M {
        &self.map
    }

    /// The frame.
    #[must_use]
    pub const fn frame(&self) -> &Frame<R> {
        &self.frame
    }
}

impl<R: Real, M: Map<Point = [R; 3]>> Map for About<M, R> {
    type Point = [R; 3];

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> [R; 3] {
        self.frame.to_world(self.map.sample(uv))
    }

    /// The map's own block, turned.
    #[inline(always)]
    fn sample_block(&self, u: &Block, v: &Block, out: &mut [Lanes<R>; 3]) {
        self.map.sample_block(u, v, out);
        let [x, y, z] = out;
        for lane in 0..BLOCK {
            [x[lane], y[lane], z[lane]] = self.frame.to_world([x[lane], y[lane], z[lane]]);
        }
    }
}

impl<R: Real, M: Density<Point = [R; 3]>> Density for About<M, R> {
    #[inline]
    fn density(&self, world: [R; 3]) -> R {
        self.map.density(self.frame.to_local(world))
    }

    #[inline]
    fn sample_with_density(&self, uv: [u32; 2]) -> ([R; 3], R) {
        let (local, density) = self.map.sample_with_density(uv);
        (self.frame.to_world(local), density)
    }
}

impl<R: Real, M: Invert<Point = [R; 3]>> Invert for About<M, R> {
    #[inline]
    fn invert(&self, world: [R; 3]) -> [u32; 2] {
        self.map.invert(self.frame.to_local(world))
    }
}

#[cfg(feature = "rand")]
crate::map::distribution!([R: Real, M: Map<Point = [R; 3]>] About<M, R>, [R; 3]);
