//! Unit vectors, checked once.

use crate::arithmetic::{Real, vector};
use crate::error::Error;
use core::ops::Neg;

/// A vector of unit length: its length squared is within 16 ulp of 1.
///
/// ```
/// use hemidisc::Unit;
/// // A normal as renderers have it, off by a rounding error or a thousandth.
/// let [x, y, z] = Unit::new([0.6_f32, -0.8004, 0.0])?.get();
/// assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6);
/// // A vector of any length.
/// assert_eq!(Unit::normalized([0.0, -5e-324, 0.0])?.get(), [0.0, -1.0, 0.0]);
/// assert!(Unit::new([0.0, 2.0, 0.0]).is_err());
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit<R>([R; 3]);

impl<R: Copy> Unit<R> {
    /// Its components.
    #[must_use]
    #[inline]
    pub const fn get(self) -> [R; 3] {
        self.0
    }
}

impl<R: Real> Unit<R> {
    /// A vector that is near unit length, brought to it. One whose length squared is within 16 ulp
    /// of 1 keeps its bits.
    ///
    /// # Errors
    /// [`Error::NotUnit`] for a vector whose length squared is not within 1/128 of 1.
    #[inline]
    pub fn new(vector: [R; 3]) -> Result<Self, Error> {
        R::unit(vector).map(Self)
    }

    /// The direction of a vector of any length, each component within 2 ulp of 1. What
    /// [`new`](Self::new) takes is as `new` gives it.
    ///
    /// # Errors
    /// [`Error::NoDirection`] for a vector that is zero, infinite or not a number.
    #[inline]
    pub fn normalized(vector: [R; 3]) -> Result<Self, Error> {
        R::normalized(vector).map(Self)
    }

    /// A vector that rounding alone has moved from unit length, brought to it without a branch: of a
    /// length squared of 1 + d, 1 / sqrt(1 + d) is 1 - d / 2 within d^2 / 2.
    #[inline]
    pub(crate) fn polished(vector: [R; 3]) -> Self {
        let half = (R::dot(vector, vector) - R::ONE) * R::HALF;
        Self(vector.map(|x| x - x * half))
    }

    /// [`normalized`](Self::normalized) for an inner loop: the z axis for a vector that is zero,
    /// infinite or not a number.
    ///
    /// ```
    /// use hemidisc::Unit;
    /// assert_eq!(Unit::normalized_or_z([0.0, -3.0, 0.0]).get(), [0.0, -1.0, 0.0]);
    /// assert_eq!(Unit::normalized_or_z([0.0_f32; 3]).get(), [0.0, 0.0, 1.0]);
    /// ```
    #[must_use]
    #[inline]
    pub fn normalized_or_z(vector: [R; 3]) -> Self {
        Self(R::normal(vector))
    }
}

macro_rules! const_unit {
    ($float:ident) => {
        impl Unit<$float> {
            /// [`new`](Self::new), as a `const fn`: for a vector in a `static`.
            ///
            /// # Errors
            /// Those of `new`.
            pub const fn const_new(vector: [$float; 3]) -> Result<Self, Error> {
                match vector::$float::unit(vector) {
                    Ok(unit) => Ok(Self(unit)),
                    Err(error) => Err(error),
                }
            }

            /// [`normalized`](Self::normalized), as a `const fn`.
            ///
            /// # Errors
            /// Those of `normalized`.
            pub const fn const_normalized(vector: [$float; 3]) -> Result<Self, Error> {
                match vector::$float::normalized(vector) {
                    Ok(unit) => Ok(Self(unit)),
                    Err(error) => Err(error),
                }
            }
        }
    };
}
const_unit!(f32);
const_unit!(f64);

impl<R: Neg<Output = R>> Neg for Unit<R> {
    type Output = Self;

    /// The opposite direction.
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.map(R::neg))
    }
}

impl<R> From<Unit<R>> for [R; 3] {
    #[inline]
    fn from(unit: Unit<R>) -> Self {
        unit.0
    }
}

impl<R: Real> TryFrom<[R; 3]> for Unit<R> {
    type Error = Error;

    /// # Errors
    /// Those of [`Unit::new`].
    #[inline]
    fn try_from(vector: [R; 3]) -> Result<Self, Error> {
        Self::new(vector)
    }
}
