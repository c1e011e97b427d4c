//! Frames from two vectors: a normal with a tangent, two axes, a camera.
//!
//! All are right-handed, and all end in [`Frame::with_tangent`], so that a frame is a function of
//! its third and first axis.

use super::{Frame, Unit};
use crate::arithmetic::Real;
use crate::error::Error;

impl<R: Real> Frame<R> {
    /// The frame about a normal whose first axis is a tangent, of any length, made orthogonal to the
    /// normal. It is a continuous function of both. The second axis is normal x first axis: the
    /// frame is right-handed.
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
        let x = across(Unit::normalized(tangent)?.get(), z)?;
        if x == plain.x { Ok(plain) } else { Ok(Self { x, y: cross(z, x), z: normal }) }
    }

    /// The frame whose first axis is along x, and whose second is what y has across it: x and y of
    /// any length, at any angle. The third axis is x cross y: the frame is right-handed.
    ///
    /// For axes that are almost parallel the third axis is as uncertain as their plane.
    ///
    /// ```
    /// use hemidisc::{Error, Frame};
    /// // The edges of a rectangular light, which shines down.
    /// let lamp = Frame::from_axes([2.0, 0.0, 0.0], [0.0, 0.0, 3.0])?;
    /// assert_eq!(lamp.axes(), [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]);
    /// let parallel = Frame::from_axes([2.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    /// assert_eq!(parallel, Err(Error::Parallel { cosine: -1.0 }));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoDirection`] for an axis that is zero, infinite or not a number, and
    /// [`Error::Parallel`] for axes within 16 ulp of 1 of the same direction or of opposite ones.
    pub fn from_axes(x: [R; 3], y: [R; 3]) -> Result<Self, Error> {
        let x = Unit::normalized(x)?.get();
        let y = across(Unit::normalized(y)?.get(), x)?;
        Self::with_tangent(Unit::polished(cross(x, y)), x)
    }

    /// The frame of a camera: z ahead, x to the right and y down in the image, where `up` is up. It
    /// is right-handed, as the rows of a picture count down. Both vectors are of any length, at any
    /// angle.
    ///
    /// For y up the frame would be left-handed, or x to the left: negate the component of the image
    /// plane instead, as in the example.
    ///
    /// ```
    /// use hemidisc::{Concentric, FastF32, Frame, effect::ThinLens};
    /// let (eye, at, up) = ([13.0, 2.0, 3.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    /// let camera = Frame::look_to([0, 1, 2].map(|i| at[i] - eye[i]), up)?;
    /// let lens = ThinLens::new(Concentric::<FastF32>::new(), 0.05, 10.0)?;
    /// // A quarter of the image's height above its middle, where a half is 0.18 at z = 1.
    /// let ray = lens.ray([0.0, -0.09], [1 << 30, 3 << 30]);
    /// let direction = camera.to_world(ray.direction);
    /// let leaves = camera.to_world(ray.origin);
    /// let origin = [0, 1, 2].map(|i| eye[i] + leaves[i]);
    /// assert!(direction[0] < 0.0 && direction[1] / direction[0] < 2.0 / 13.0);
    /// # Ok::<(), hemidisc::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoDirection`] for a vector that is zero, infinite or not a number, and
    /// [`Error::Parallel`] for an `up` within 16 ulp of 1 of `ahead` or its opposite.
    pub fn look_to(ahead: [R; 3], up: [R; 3]) -> Result<Self, Error> {
        let z = Unit::normalized(ahead)?;
        let up = across(Unit::normalized(up)?.get(), z.get())?;
        Self::with_tangent(z, cross(z.get(), up))
    }

    /// The first axis, unless it is that of the frame about the third axis alone.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) fn tangent(&self) -> Option<[R; 3]> {
        (*self != Self::from(self.z)).then_some(self.x)
    }
}

/// The unit vector along what a unit vector has across an axis: itself, where that is all.
///
/// # Errors
/// [`Error::Parallel`] for one within 16 ulp of 1 of the axis or its opposite.
fn across<R: Real>(vector: [R; 3], axis: [R; 3]) -> Result<[R; 3], Error> {
    let cosine = R::dot(vector, axis);
    if cosine.magnitude() <= R::EPSILON * R::FOUR {
        return Ok(vector);
    }
    let rest = rejected(vector, axis);
    let room = R::EPSILON * R::FOUR * R::FOUR;
    if R::dot(rest, rest) <= room * room {
        return Err(Error::Parallel { cosine: cosine.into() });
    }
    // Twice is enough: what rounding has left along the axis is small beside the first rest, but
    // may not be beside 1 (B. Parlett, "The Symmetric Eigenvalue Problem", 1980).
    let once = Unit::normalized(rest)?.get();
    Ok(renewed(rejected(once, axis))?.get())
}

/// The direction of a vector within 2 ulp, where [`Unit::normalized`] keeps what is within 16. What
/// was all but along the axis may have lost any part of its length.
fn renewed<R: Real>(vector: [R; 3]) -> Result<Unit<R>, Error> {
    Unit::normalized(vector.map(|x| x + x))
}

/// What is left of a vector across another. A unit vector's length is within 8 ulp of 1, which a
/// short rest would show.
fn rejected<R: Real>(vector: [R; 3], axis: [R; 3]) -> [R; 3] {
    let along = R::dot(vector, axis) / R::dot(axis, axis);
    core::array::from_fn(|i| vector[i] - along * axis[i])
}

fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
