//! Frames: an orthonormal basis about a direction, and directions in world space.
//!
//! T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin, "Building an
//! Orthonormal Basis, Revisited", JCGT 6(1), 2017: no square root, and exact near n_z = -1, where
//! Frisvad's form divides by 0.

mod about;
mod axes;
mod unit;

pub use about::About;
pub use unit::Unit;

use crate::arithmetic::{Real, vector};
use crate::error::Error;

/// A right-handed orthonormal basis: x cross y is z, its third axis.
///
/// | from | by | if there is none |
/// | --- | --- | --- |
/// | a normal, in the inner loop | [`from_normal`](Self::from_normal) | the frame about the z axis |
/// | a normal, checked | [`new`](Self::new), [`normalized`](Self::normalized) | an error |
/// | a [`Unit`] | `from` | |
/// | a normal and a tangent | [`with_tangent`](Self::with_tangent) | an error |
/// | two axes | [`from_axes`](Self::from_axes) | an error |
/// | where a camera looks, and up | [`look_to`](Self::look_to) | an error |
///
/// About a normal alone, the first two axes are a continuous function of a normal above the plane n_z = 0, and of one
/// below it. Between neighbouring normals on either side of that plane they turn about the normal,
/// by up to half a turn: no frame is a continuous function of all normals. Nothing that is symmetric
/// about the normal depends on it. For sets of points that must not jump, as of textures or brushed
/// metal, [`with_tangent`](Self::with_tangent) takes the first axis from the surface.
///
/// ```
/// use hemidisc::{Cosine, Frame, LibmF32};
/// // The normal of a hit, which rounding has left a little off unit length.
/// let normal = [0.0, 1.000_001, 0.0];
/// let lobe = Cosine::<LibmF32>::new().about(Frame::from_normal(normal));
/// let [_, up, _] = lobe.sample([1 << 30, 3 << 30]);
/// assert!(up > 0.0);
/// assert!(Frame::new([0.0_f32, 2.0, 0.0]).is_err());
/// // In flash.
/// static DOWN: Frame<f32> = match Frame::<f32>::const_new([0.0, -1.0, 0.0]) {
///     Ok(frame) => frame,
///     Err(_) => panic!("not a unit vector"),
/// };
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<R> {
    x: [R; 3],
    y: [R; 3],
    z: Unit<R>,
}

impl<R: Copy> Frame<R> {
    /// The unit vector that the frame is about: its third axis.
    #[must_use]
    #[inline]
    pub const fn unit(&self) -> Unit<R> {
        self.z
    }

    /// The three axes; the third is the vector that the frame was built about.
    #[must_use]
    #[inline]
    pub const fn axes(&self) -> [[R; 3]; 3] {
        [self.x, self.y, self.z.get()]
    }
}

impl<R: Real> Frame<R> {
    /// The frame about a vector that is near unit length, as [`Unit::new`] takes it.
    ///
    /// # Errors
    /// [`Error::NotUnit`] for a vector whose length squared is not within 1/128 of 1.
    /// [`normalized`](Self::normalized) takes a vector of any length.
    #[inline]
    pub fn new(z: [R; 3]) -> Result<Self, Error> {
        Unit::new(z).map(Self::from)
    }

    /// The frame about the direction of a vector of any length, as [`Unit::normalized`] takes it.
    ///
    /// # Errors
    /// [`Error::NoDirection`] for a vector that is zero, infinite or not a number.
    #[inline]
    pub fn normalized(vector: [R; 3]) -> Result<Self, Error> {
        Unit::normalized(vector).map(Self::from)
    }

    /// The frame about a surface's normal, as a renderer's inner loop has it: of any length, and
    /// without an error.
    ///
    /// The third axis is [`Unit::normalized_or_z`] of the normal: within 2 ulp of 1 of its
    /// direction, or the normal itself where its length squared is within 16 ulp of 1. All lengths
    /// squared and cosines between the axes are within 4 ulp of 1 and 0, plus three times what the
    /// third axis's length squared is off. A zero, infinite or NaN normal has no direction: its
    /// frame is that of the z axis, so a sample about it is wrong, but a unit vector.
    ///
    /// It takes a dot product and Duff's basis, of one division and no square root. Where the length
    /// squared is more than 16 ulp from 1, two polynomials bring it to 1; more than 1/128 from it,
    /// three more divisions.
    ///
    /// ```
    /// use hemidisc::{Cosine, FastF32, Frame};
    /// // Of a hit on a sphere.
    /// let (centre, radius, hit) = ([0.0, 1.0, 0.0], 1.0_f32, [0.36, 1.48, 0.8]);
    /// let normal = [0, 1, 2].map(|i| (hit[i] - centre[i]) / radius);
    /// let frame = Frame::from_normal(normal);
    /// let bounce = frame.to_world(Cosine::<FastF32>::new().sample([1 << 31, 1 << 30]));
    /// assert!(bounce[0] * normal[0] + bounce[1] * normal[1] + bounce[2] * normal[2] > 0.0);
    /// assert_eq!(Frame::from_normal([0.0, 0.0, f32::NAN]), Frame::from_normal([0.0, 0.0, 1.0]));
    /// ```
    #[must_use]
    #[inline]
    pub fn from_normal(normal: [R; 3]) -> Self {
        Self::from(Unit::normalized_or_z(normal))
    }

    /// A vector from the frame's coordinates to the world's.
    #[must_use]
    #[inline]
    pub fn to_world(&self, [x, y, z]: [R; 3]) -> [R; 3] {
        let [a, b, c] = self.axes();
        core::array::from_fn(|i| x * a[i] + y * b[i] + z * c[i])
    }

    /// A vector from the world's coordinates to the frame's.
    #[must_use]
    #[inline]
    pub fn to_local(&self, world: [R; 3]) -> [R; 3] {
        self.axes().map(|axis| R::dot(axis, world))
    }
}

impl<R: Real> From<Unit<R>> for Frame<R> {
    /// The frame about a unit vector.
    #[inline]
    fn from(z: Unit<R>) -> Self {
        let [x, y] = R::basis(z.get());
        Self { x, y, z }
    }
}

macro_rules! const_frame {
    ($float:ident) => {
        impl Frame<$float> {
            /// [`new`](Self::new), as a `const fn`: for a frame in a `static`.
            ///
            /// # Errors
            /// Those of `new`.
            pub const fn const_new(z: [$float; 3]) -> Result<Self, Error> {
                match Unit::<$float>::const_new(z) {
                    Ok(z) => Ok(Self::const_from(z)),
                    Err(error) => Err(error),
                }
            }

            /// [`normalized`](Self::normalized), as a `const fn`.
            ///
            /// # Errors
            /// Those of `normalized`.
            pub const fn const_normalized(vector: [$float; 3]) -> Result<Self, Error> {
                match Unit::<$float>::const_normalized(vector) {
                    Ok(z) => Ok(Self::const_from(z)),
                    Err(error) => Err(error),
                }
            }

            const fn const_from(z: Unit<$float>) -> Self {
                let [x, y] = vector::$float::basis(z.get());
                Self { x, y, z }
            }
        }
    };
}
const_frame!(f32);
const_frame!(f64);
