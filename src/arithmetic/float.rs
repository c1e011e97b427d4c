//! The kernels of every map on floats, for any library of elementary functions.
//!
//! **Coordinates.** 2u - 1 of a cell k is (2j + 1) / 2^32 with the signed j = k - 2^31. Its magnitude is
//! (2m + 1) / 2^32 with m = j ^ (j >> 31), one correctly rounded conversion, so mirror images are equal
//! bit for bit. r^2 = (2m + 1)^2 / 2^64 and 1 - r^2 are exact integers of 64 bits, so each is correctly
//! rounded too: nothing cancels at the rim.
//!
//! **Concentric** (P. Shirley and K. Chiu, "A Low Distortion Map between Disk and Square", 1997).
//! With the larger magnitude r and the smaller n, phi = pi/4 n/r is in [0, pi/4]; x = r cos phi,
//! y = r sin phi, swapped where |v| is the larger. No pi/2 - phi, so nothing cancels near the diagonals.
//!
//! **Polar.** 2 pi u is folded to an octant on the integer: the angle within it is exact.
//!
//! **Lobes** take the direction (cos phi, sin phi) and form sin theta from r^2 and 1 - r^2: two roundings
//! fewer than scaling x and y.
//!
//! **Inward.** Rounding leaves about half of the rim outside the disc. Only those points move, by one
//! ulp of their larger component; shrinking all of them would cost accuracy everywhere.
//!
//! **Power.** With L = ln(1 - r^2), z = exp(L / (e + 1)). sqrt(1 - z^2) loses every digit of sin theta
//! by e = 1e8, so with q = -2 L / (e + 1), sin theta = sqrt(-expm1(-q)); where q nears the end of the
//! type's range (e near 3e38) it is sqrt(2 / (e + 1)) sqrt(-L), whose factors do not underflow. L comes
//! from r^2 where r^2 < 1/2, else from 1 - r^2.

mod disc;
mod power;
mod real;

pub use disc::FloatDisc;
pub use power::PowerExponent;
pub use real::Real;

use super::Arithmetic;
use crate::error::Error;
use core::fmt::Debug;
pub(super) use disc::lowered;
use disc::{length_squared, scaled};

/// A library of elementary functions on one float type: seven functions give every map.
///
/// The arguments always lie in the ranges given. Errors of a function add to those of the maps; the square
/// root must be good to 1 % for the points to stay on the disc.
pub trait Float: Copy + Default + Debug + PartialEq + Send + Sync + 'static {
    /// Its name on command lines and in tables.
    const NAME: &'static str;
    /// `f32` or `f64`.
    type Real: Real;

    /// Square root of x in [0, MAX].
    fn sqrt(x: Self::Real) -> Self::Real;
    /// Sine and cosine of x in [0, pi/4].
    fn sin_cos(x: Self::Real) -> (Self::Real, Self::Real);
    /// Arc tangent of x in [0, 1].
    fn atan(x: Self::Real) -> Self::Real;
    /// Logarithm of x in (0, 1].
    fn ln(x: Self::Real) -> Self::Real;
    /// ln(1 + x) for x in [-1/2, 0].
    fn ln_1p(x: Self::Real) -> Self::Real;
    /// Exponential of x, of either sign; infinite above the range, 0 below it.
    fn exp(x: Self::Real) -> Self::Real;
    /// exp(x) - 1 for x <= 0.
    fn exp_m1(x: Self::Real) -> Self::Real;
}

/// An arithmetic of `f32` or `f64` that takes square roots: what distances and unit vectors need.
pub trait Root: Arithmetic<Real: Real> {
    /// Square root of x in [0, MAX]: within 2^-52 in `f64` and 2.5e-7 in `f32`, relative, for normal numbers and 0. A
    /// subnormal one's may be 1 % off, and of other x it is no promised number.
    fn sqrt(x: Self::Real) -> Self::Real;
}

impl<T: Float> Root for T {
    #[inline(always)]
    fn sqrt(x: T::Real) -> T::Real {
        <T as Float>::sqrt(x)
    }
}

impl<T: Float> Arithmetic for T {
    const NAME: &'static str = T::NAME;
    const ABSOLUTE_DENSITY: bool = true;
    /// Blocks were faster on x86-64 for every sequence and map tried; on a microcontroller the arrays
    /// cost more than they save.
    const BLOCKED: bool = cfg!(not(any(target_arch = "arm", target_arch = "riscv32")));

    type Real = T::Real;
    type Disc = FloatDisc<T::Real>;
    type Parameter = T::Real;
    type Exponent = PowerExponent<T::Real>;

    #[inline(always)]
    fn square(uv: [u32; 2]) -> [T::Real; 2] {
        uv.map(T::Real::centre_down)
    }

    #[inline(always)]
    fn centred(uv: [u32; 2]) -> [T::Real; 2] {
        disc::centred::<T>(uv)
    }

    #[inline(always)]
    fn concentric<const RIM: bool>(uv: [u32; 2]) -> FloatDisc<T::Real> {
        disc::concentric::<T>(uv)
    }

    #[inline(always)]
    fn polar<const RIM: bool>(uv: [u32; 2]) -> FloatDisc<T::Real> {
        disc::polar::<T>(uv)
    }

    #[inline(always)]
    fn store(disc: FloatDisc<T::Real>) -> [T::Real; 2] {
        scaled::<T>(disc.direction, disc.r)
    }

    /// sin theta = sqrt(1 - (1 - r^2)^2) = sqrt(r^2 (1 + (1 - r^2))).
    #[inline(always)]
    fn uniform(disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let [x, y] = scaled::<T>(disc.direction, T::sqrt(disc.r2 * (T::Real::ONE + disc.rim)));
        [x, y, disc.rim]
    }

    #[inline(always)]
    fn cosine(disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let [x, y] = scaled::<T>(disc.direction, disc.r);
        [x, y, T::sqrt(disc.rim)]
    }

    fn exponent(e: T::Real) -> Result<PowerExponent<T::Real>, Error> {
        PowerExponent::new::<T>(e)
    }

    #[inline]
    fn power(exponent: PowerExponent<T::Real>, disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        power::lift::<T>(exponent, disc)
    }

    #[inline]
    fn load(point: [T::Real; 2]) -> FloatDisc<T::Real> {
        disc::load::<T>(point)
    }

    #[inline]
    fn lower_uniform([x, y, z]: [T::Real; 3]) -> FloatDisc<T::Real> {
        lowered::<T>([x, y], length_squared(x, y) / (T::Real::ONE + z), z)
    }

    #[inline]
    fn lower_cosine([x, y, z]: [T::Real; 3]) -> FloatDisc<T::Real> {
        lowered::<T>([x, y], length_squared(x, y), z * z)
    }

    #[inline]
    fn lower_power(
        exponent: PowerExponent<T::Real>,
        direction: [T::Real; 3],
    ) -> FloatDisc<T::Real> {
        power::lower::<T>(exponent, direction)
    }

    #[inline]
    fn invert_square(point: [T::Real; 2]) -> [u32; 2] {
        point.map(|x| x.cell(32))
    }

    #[inline]
    fn invert_centred(point: [T::Real; 2]) -> [u32; 2] {
        disc::invert_centred(point)
    }

    #[inline]
    fn invert_concentric(disc: FloatDisc<T::Real>) -> [u32; 2] {
        disc::invert_concentric::<T>(disc)
    }

    #[inline]
    fn invert_polar(disc: FloatDisc<T::Real>) -> [u32; 2] {
        disc::invert_polar::<T>(disc)
    }

    #[inline]
    fn square_density([u, v]: [T::Real; 2]) -> T::Real {
        let inside = |x: T::Real| x >= T::Real::ZERO && x < T::Real::ONE;
        if inside(u) && inside(v) { T::Real::ONE } else { T::Real::ZERO }
    }

    #[inline]
    fn disc_density([x, y]: [T::Real; 2]) -> T::Real {
        if length_squared(x, y) <= T::Real::ONE { T::Real::FRAC_1_PI } else { T::Real::ZERO }
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
}
