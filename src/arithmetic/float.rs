//! The kernels of every map on floats, for any library of elementary functions.
//!
//! **Coordinates.** 2u - 1 of a cell k is (2j + 1) / 2^32 with the signed j = k - 2^31. Its
//! magnitude is (2m + 1) / 2^32 with m = j ^ (j >> 31), one correctly rounded conversion, so mirror
//! images are equal bit for bit. r^2 = (2m + 1)^2 / 2^64 and 1 - r^2 are exact integers of 64 bits,
//! so each is correctly rounded too: nothing cancels at the rim.
//!
//! **Concentric** (P. Shirley and K. Chiu, "A Low Distortion Map between Disk and Square", 1997).
//! With the larger magnitude r and the smaller n, phi = pi/4 n/r is in [0, pi/4]; x = r cos phi,
//! y = r sin phi, swapped where |v| is the larger. No pi/2 - phi, so nothing cancels near the
//! diagonals.
//!
//! **Polar.** 2 pi u is folded to an octant on the integer: the angle within it is exact.
//!
//! **Lobes** take the direction (cos phi, sin phi) and form sin theta from r^2 and 1 - r^2: two
//! roundings fewer than scaling x and y.
//!
//! **Inward.** Rounding leaves about half of the rim outside the disc. Only those points move, by
//! one ulp of their larger component; shrinking all of them would cost accuracy everywhere.
//!
//! **Power.** With L = ln(1 - r^2), z = exp(L / (e + 1)). sqrt(1 - z^2) loses every digit of sin
//! theta by e = 1e8, so with q = -2 L / (e + 1), sin theta = sqrt(-expm1(-q)); where q nears the
//! end of the type's range (e near 3e38) it is sqrt(2 / (e + 1)) sqrt(-L), whose factors do not
//! underflow. L comes from r^2 where r^2 < 1/2, else from 1 - r^2.
//!
//! **Density of a sample.** z^e = z^(e + 1) / z = (1 - r^2) / z: one division where a given
//! direction takes a logarithm and an exponential, and an error of a few eps and that of z where the
//! rounding of a direction costs sqrt(e) eps.

mod disc;
mod disc_point;
pub(crate) mod exponent;
mod functions;
mod inverse;
pub(crate) mod length;
mod power;
mod real;
mod share;
pub(crate) mod vector;

pub use disc_point::DiscPoint;
pub use functions::Float;
pub use power::PowerExponent;
pub use real::{Real, RealKernel};

use super::{Arithmetic, Back, sealed::Sealed};
use crate::error::Error;
use crate::target::ROUNDS_FLOATS;
use disc::{FloatDisc, scaled};
use inverse::Lowered;

impl<T: Float> Sealed for T {}

/// What lobes of floats know beyond their densities.
#[doc(hidden)]
pub trait FloatBack: Back {
    /// The share of a power lobe above a plane, from the sine and the square of the cosine of its
    /// axis's elevation.
    fn power_share(exponent: Self::Exponent, sin: Self::Real, cos2: Self::Real) -> Self::Real;
}

impl<T: Float> FloatBack for T {
    fn power_share(exponent: PowerExponent<T::Real>, sin: T::Real, cos2: T::Real) -> T::Real {
        share::above::<T>(exponent.plus_1(), sin, cos2)
    }
}

/// An arithmetic of `f32` or `f64` with a square root, which distances need.
pub trait Root: Arithmetic<Real: Real, Back: FloatBack> {
    /// Square root of x in [0, MAX].
    ///
    /// For normal numbers and 0 it is within 2^-52 in `f64` and 2.5e-7 in `f32`, relative. For a
    /// subnormal number it may be 1 % off. For other x it is unspecified.
    fn sqrt(x: Self::Real) -> Self::Real;

    /// A point of the disc in the parts that a lobe lifts.
    #[doc(hidden)]
    fn disc_point(disc: Self::Disc) -> DiscPoint<Self::Real>;
}

impl<T: Float> Root for T {
    #[inline(always)]
    fn sqrt(x: T::Real) -> T::Real {
        <T as Float>::sqrt(x)
    }

    #[inline(always)]
    fn disc_point(disc: FloatDisc<T::Real>) -> DiscPoint<T::Real> {
        let FloatDisc { direction, r2, one_minus_r2, .. } = disc;
        DiscPoint { direction, r2, one_minus_r2 }
    }
}

impl<T: Float> Arithmetic for T {
    const NAME: &'static str = T::NAME;
    const ABSOLUTE_DENSITY: bool = true;
    const POINTWISE: bool = true;
    const ROUNDS: bool = ROUNDS_FLOATS;

    type Real = T::Real;
    type Disc = FloatDisc<T::Real>;
    type Parameter = T::Real;
    type Exponent = PowerExponent<T::Real>;
    type Back = T;

    #[inline(always)]
    fn square(uv: [u32; 2]) -> [T::Real; 2] {
        uv.map(T::Real::centre_down)
    }

    #[inline(always)]
    fn centred(uv: [u32; 2]) -> [T::Real; 2] {
        disc::centred::<T>(uv)
    }

    #[inline(always)]
    fn concentric(uv: [u32; 2]) -> FloatDisc<T::Real> {
        disc::concentric::<T>(uv)
    }

    #[inline(always)]
    fn polar(uv: [u32; 2]) -> FloatDisc<T::Real> {
        disc::polar::<T>(uv)
    }

    #[inline(always)]
    fn store(disc: FloatDisc<T::Real>) -> [T::Real; 2] {
        scaled::<T>(disc.direction, disc.r)
    }

    /// sin theta = sqrt(1 - (1 - r^2)^2) = sqrt(r^2 (1 + (1 - r^2))).
    #[inline(always)]
    fn uniform(disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let [x, y] =
            scaled::<T>(disc.direction, T::sqrt(disc.r2 * (T::Real::ONE + disc.one_minus_r2)));
        [x, y, disc.one_minus_r2]
    }

    #[inline(always)]
    fn cosine(disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let [x, y] = scaled::<T>(disc.direction, disc.r);
        [x, y, T::sqrt(disc.one_minus_r2)]
    }

    fn exponent(e: T::Real) -> Result<PowerExponent<T::Real>, Error> {
        PowerExponent::new::<T>(e)
    }

    fn given(exponent: PowerExponent<T::Real>) -> T::Real {
        exponent.value()
    }

    #[inline]
    fn power(exponent: PowerExponent<T::Real>, disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        power::lift::<T>(exponent, disc)
    }

    #[inline]
    fn power_with_density(
        exponent: PowerExponent<T::Real>,
        disc: FloatDisc<T::Real>,
    ) -> ([T::Real; 3], T::Real) {
        let direction = power::lift::<T>(exponent, disc);
        (direction, exponent.density_of_sample::<T>(disc.one_minus_r2, direction))
    }
}

impl<T: Float> Back for T {
    type Real = T::Real;
    type Lowered = Lowered<T::Real>;
    type Exponent = PowerExponent<T::Real>;

    #[inline]
    fn lower_disc(point: [T::Real; 2]) -> Lowered<T::Real> {
        inverse::lower_disc::<T>(point)
    }

    #[inline]
    fn lower_uniform([x, y, z]: [T::Real; 3]) -> Lowered<T::Real> {
        inverse::lowered::<T>([x, y], inverse::length_squared(x, y) / (T::Real::ONE + z), z)
    }

    #[inline]
    fn lower_cosine([x, y, z]: [T::Real; 3]) -> Lowered<T::Real> {
        inverse::lowered::<T>([x, y], inverse::length_squared(x, y), z * z)
    }

    #[inline]
    fn lower_power(exponent: PowerExponent<T::Real>, direction: [T::Real; 3]) -> Lowered<T::Real> {
        power::lower::<T>(exponent, direction)
    }

    #[inline]
    fn invert_square(point: [T::Real; 2]) -> [u32; 2] {
        point.map(|x| x.cell(32))
    }

    #[inline]
    fn invert_centred(point: [T::Real; 2]) -> [u32; 2] {
        inverse::centred(point)
    }

    #[inline]
    fn invert_concentric(lowered: Lowered<T::Real>) -> [u32; 2] {
        inverse::concentric::<T>(lowered)
    }

    #[inline]
    fn invert_polar(lowered: Lowered<T::Real>) -> [u32; 2] {
        inverse::polar::<T>(lowered)
    }

    #[inline]
    fn square_density([u, v]: [T::Real; 2]) -> T::Real {
        let inside = |x: T::Real| x >= T::Real::ZERO && x < T::Real::ONE;
        if inside(u) && inside(v) { T::Real::ONE } else { T::Real::ZERO }
    }

    #[inline]
    fn disc_density([x, y]: [T::Real; 2]) -> T::Real {
        if inverse::length_squared(x, y) <= T::Real::ONE {
            T::Real::FRAC_1_PI
        } else {
            T::Real::ZERO
        }
    }

    #[inline]
    fn uniform_density([_, _, z]: [T::Real; 3]) -> T::Real {
        if z > T::Real::ZERO { T::Real::FRAC_1_PI * T::Real::HALF } else { T::Real::ZERO }
    }

    #[inline]
    fn cosine_density([_, _, z]: [T::Real; 3]) -> T::Real {
        if z > T::Real::ZERO { T::Real::FRAC_1_PI * z } else { T::Real::ZERO }
    }

    #[inline]
    fn power_density(exponent: PowerExponent<T::Real>, direction: [T::Real; 3]) -> T::Real {
        power::density::<T>(exponent, direction)
    }

    #[inline]
    fn power_density_beside(
        exponent: PowerExponent<T::Real>,
        growth_and_z: [T::Real; 2],
        direction: impl FnOnce() -> [T::Real; 3],
    ) -> T::Real {
        power::density_beside::<T>(exponent, growth_and_z, direction)
    }
}
