//! Frames: an orthonormal basis about a direction, and directions in world space.
//!
//! T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin, "Building an
//! Orthonormal Basis, Revisited", JCGT 6(1), 2017: no square root, and exact near n_z = -1, where
//! Frisvad's form divides by 0.

mod unit;

pub use unit::Unit;

use crate::arithmetic::{Real, vector};
use crate::block::{BLOCK, Block, Lanes};
use crate::error::Error;
use crate::map::{Density, Invert, Map};

/// A right-handed orthonormal basis whose third axis is a given unit vector.
///
/// The first two axes are a continuous function of a normal above the plane n_z = 0, and of one
/// below it. Between neighbouring normals on either side of that plane they turn about the normal,
/// by up to half a turn: no frame is a continuous function of all normals. Nothing that is symmetric
/// about the normal depends on it. For sets of points that must not jump, as of textures or brushed
/// metal, [`with_tangent`](Self::with_tangent) takes the first axis from the surface.
///
/// ```
/// use hemidisc::{Cosine, Frame, LibmF32, Map};
/// let normal = [0.0, 1.0, 0.0];
/// let lobe = Cosine::<LibmF32>::new().about(Frame::new(normal)?);
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

    /// The frame about a normal whose first axis is a tangent, of any length, made orthogonal to the
    /// normal. It is a continuous function of both. The second axis is normal x first axis.
    ///
    /// ```
    /// use hemidisc::{Error, Frame, Unit};
    /// let up = Unit::new([0.0, 0.0, 1.0])?;
    /// let frame = Frame::with_tangent(up, [0.0, 3.0, 4.0])?;
    /// assert_eq!(frame.axes(), [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    /// assert_eq!(Frame::with_tangent(up, [0.0, 0.0, 2.0]), Err(Error::Parallel { cosine: 1.0 }));
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoDirection`] for a tangent that is zero, infinite or not a number, and
    /// [`Error::Parallel`] for one within 16 ulp of 1 of the normal or its opposite.
    pub fn with_tangent(normal: Unit<R>, tangent: [R; 3]) -> Result<Self, Error> {
        // The first axis of a frame gives that frame again, bit for bit: that of the frame about the
        // normal alone may be as far from orthogonal as the normal is from unit length, and another
        // has lost no more than rounding.
        let plain = Self::from(normal);
        if tangent == plain.x {
            return Ok(plain);
        }
        let z = normal.get();
        let mut x = Unit::normalized(tangent)?.get();
        let cosine = R::dot(x, z);
        if cosine.magnitude() > R::EPSILON * R::FOUR {
            let across = rejected(x, z);
            let room = R::EPSILON * R::FOUR * R::FOUR;
            if R::dot(across, across) <= room * room {
                return Err(Error::Parallel { cosine: cosine.into() });
            }
            // Twice is enough: what rounding has left along the normal is small beside the first
            // rest, but may not be beside 1 (B. Parlett, "The Symmetric Eigenvalue Problem", 1980).
            x = Unit::normalized(across)?.get();
            x = Unit::normalized(rejected(x, z))?.get();
        }
        if x == plain.x { Ok(plain) } else { Ok(Self { x, y: cross(z, x), z: normal }) }
    }

    /// The first axis, unless it is that of the frame about the third axis alone.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) fn tangent(&self) -> Option<[R; 3]> {
        (*self != Self::from(self.z)).then_some(self.x)
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

/// What is left of a vector across another. A unit vector's length is within 8 ulp of 1, which a
/// short rest would show.
fn rejected<R: Real>(vector: [R; 3], axis: [R; 3]) -> [R; 3] {
    let along = R::dot(vector, axis) / R::dot(axis, axis);
    core::array::from_fn(|i| vector[i] - along * axis[i])
}

fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
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
