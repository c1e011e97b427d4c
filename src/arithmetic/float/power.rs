//! The power lobe: the exponent, the lift, its inverse and its density.

use super::disc::{FloatDisc, scaled};
use super::functions::Float;
use super::inverse::{Lowered, clamp_01, length_squared, lowered};
use super::real::{Real, RealKernel};
use crate::error::Error;

/// An exponent e > -1 with the power lobe's precomputed values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerExponent<R> {
    e: R,
    e_plus_1: R,
    /// The relative rounding error of e + 1.
    lost: R,
    /// sqrt(2 / (e + 1)): the scale of sin theta at the pole.
    spread: R,
}

impl<R: Real> PowerExponent<R> {
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub(in crate::arithmetic) fn new<T: Float<Real = R>>(e: R) -> Result<Self, Error> {
        let [e_plus_1, lost] = R::plus_1(e)?;
        Ok(Self::of_parts(e, [e_plus_1, lost], spread::<T>(e_plus_1)))
    }

    /// An exponent with what [`plus_1`](super::exponent) gives for it, and sqrt(2 / (e + 1)).
    pub(in crate::arithmetic) const fn of_parts(e: R, [e_plus_1, lost]: [R; 2], spread: R) -> Self {
        Self { e, e_plus_1, lost, spread }
    }

    /// e + 1, rounded.
    pub(super) fn plus_1(self) -> R {
        self.e_plus_1
    }

    /// (e + 1) / (2 pi): the density at the pole.
    #[inline]
    fn peak(self) -> R {
        self.e_plus_1 * (R::FRAC_1_PI * R::HALF)
    }

    /// The density of a sample of the lobe, from the 1 - r^2 that it was lifted from.
    ///
    /// It is a normal number: 1 - r^2 is at least 2^-33. Below e = 0 it is at most 1 / (2 pi z),
    /// else at most the peak.
    #[inline]
    pub(in crate::arithmetic) fn density_of_sample<T: Float<Real = R>>(
        self,
        one_minus_r2: R,
        direction: [R; 3],
    ) -> R {
        let [_, _, z] = direction;
        if z > R::MIN_POSITIVE {
            self.peak() * (one_minus_r2 / z)
        } else {
            // The exact z, which 1 - r^2 is a power of, is below the smallest that is given.
            density::<T>(self, direction)
        }
    }

    /// The exponent as the user gave it.
    pub fn value(self) -> R {
        self.e
    }
}

/// sqrt(2 / (e + 1)).
fn spread<T: Float>(e_plus_1: T::Real) -> T::Real {
    let [square, scale] = T::Real::spread(e_plus_1);
    T::sqrt(square) * scale
}

/// ln z of a direction times e + 1, that is ln(1 - r^2) of its disc point: from z near the horizon,
/// from x and y near the pole, where z has rounded to 1.
#[inline]
fn log_one_minus_r2<T: Float>(
    exponent: PowerExponent<T::Real>,
    [x, y, z]: [T::Real; 3],
) -> T::Real {
    let s2 = length_squared(x, y);
    if s2 <= T::Real::HALF {
        // ln z = ln(1 - s^2) / 2 = -g s^2 / 2; scaled first, because s^2 may underflow where s does
        // not.
        let scaled = length_squared(x / exponent.spread, y / exponent.spread);
        let g = if s2 < T::Real::EPSILON { T::Real::ONE } else { T::ln_1p(-s2) / -s2 };
        -(scaled * g)
    } else {
        let z = if z > T::Real::MIN_POSITIVE { clamp_01(z) } else { T::Real::MIN_POSITIVE };
        exponent.e_plus_1 * T::ln(z)
    }
}

#[inline]
pub(super) fn lift<T: Float>(
    exponent: PowerExponent<T::Real>,
    disc: FloatDisc<T::Real>,
) -> [T::Real; 3] {
    let log = if disc.r2 < T::Real::HALF { T::ln_1p(-disc.r2) } else { T::ln(disc.one_minus_r2) };
    let log_z = log / exponent.e_plus_1;
    let z = T::exp(log_z);
    // What e + 1 has lost would cost |ln z| eps: exp(l / (1 + d)) is exp(l) (1 - l d).
    let z = z - z * (log_z * exponent.lost);
    // Below e = 0 the exact z underflows in the last cells.
    let z = if z < T::Real::MIN_POSITIVE { T::Real::MIN_POSITIVE } else { z };
    let q = -T::Real::TWO * log_z;
    let sin =
        if q > T::Real::TINY { T::sqrt(-T::exp_m1(-q)) } else { exponent.spread * T::sqrt(-log) };
    let [x, y] = scaled::<T>(disc.direction, sin);
    [x, y, z]
}

#[inline]
pub(super) fn lower<T: Float>(
    exponent: PowerExponent<T::Real>,
    [x, y, z]: [T::Real; 3],
) -> Lowered<T::Real> {
    let log = log_one_minus_r2::<T>(exponent, [x, y, z]);
    lowered::<T>([x, y], -T::exp_m1(log), T::exp(log))
}

#[inline]
pub(super) fn density<T: Float>(
    exponent: PowerExponent<T::Real>,
    direction: [T::Real; 3],
) -> T::Real {
    let [x, y, z] = direction;
    let above = z > T::Real::ZERO && length_squared(x, y).finite();
    if !above {
        return T::Real::ZERO;
    }
    // e ln z = e / (e + 1) ln(1 - r^2), which stays moderate for any e: at most -ln MIN_POSITIVE
    // for e < 0, so the density does not overflow.
    let log = exponent.e / exponent.e_plus_1 * log_one_minus_r2::<T>(exponent, direction);
    exponent.peak() * T::exp(log)
}

/// The density of a direction at a height z, to be added to that of another one, whose s^2 =
/// x^2 + y^2 is less by `growth`: 0 below the horizon, and where the sum would round to the other's.
/// No power is taken of those.
///
/// The ratio of the two is (1 - growth / z_other^2)^(e / 2), at most exp(-e growth / 2) for e > 0.
#[inline]
pub(super) fn density_beside<T: Float>(
    exponent: PowerExponent<T::Real>,
    [growth, z]: [T::Real; 2],
    direction: impl FnOnce() -> [T::Real; 3],
) -> T::Real {
    let e = if exponent.e > T::Real::ZERO { exponent.e } else { T::Real::ZERO };
    let seen = T::Real::UNSEEN - e * growth * T::Real::HALF;
    // The smaller of the two, for one branch: most directions are below the horizon or dim, and it
    // is not known ahead which.
    let seen = if z < seen { z } else { seen };
    if seen > T::Real::ZERO { density::<T>(exponent, direction()) } else { T::Real::ZERO }
}

#[cfg(all(test, feature = "libm"))]
mod tests {
    use super::*;
    use crate::arithmetic::LibmF32;

    /// A quarter of e + 1 doubles the spread to the last bit where nothing is subnormal.
    #[test]
    fn spreads_of_the_largest_exponents_lose_nothing() {
        for step in 0..1 << 16 {
            let e_plus_1 = f32::from_bits(f32::MAX.to_bits() - step * 509);
            let quarter = spread::<LibmF32>(e_plus_1 / 4.0);
            assert!(quarter > 1e-20);
            assert_eq!(spread::<LibmF32>(e_plus_1) * 2.0, quarter, "{e_plus_1:e}");
        }
    }
}
