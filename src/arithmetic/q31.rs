//! Q31: the kernels of every map in integers, from the coordinate to the result.
//!
//! **Lengths** on the way are magnitudes in units of 2^-32, half an LSB, and signs beside them; r^2
//! and 1 - r^2 are exact in units of 2^-64. A magnitude is cut to LSBs once, toward zero, and its
//! sign put back, so mirror images are equal bit for bit.
//!
//! **Inward.** The rotation shortens by more than its roundings can add, so every point is on the
//! disc without a test; that costs about an LSB of radius.
//!
//! **Lobes** scale x and y by s/r: sqrt(1 + (1 - r^2)) for the uniform lobe, 1 for the cosine. For
//! the power lobe, with L = -ln(1 - r^2) and l = L / (e + 1), z = exp(-l), s^2 = 1 - exp(-2 l)
//! formed without cancellation, and s^2 / r^2 is a quotient of normalised numbers.
//!
//! **Densities** are relative to the lobe's peak, which is 1 - LSB.

mod disc;
mod inverse;
mod power;

pub(super) use inverse::Lowered;
pub(super) use power::Q31Exponent;

pub use super::fixed::Q31;
use super::fixed::root::root;
use super::fixed::wide::high;

use super::fixed::FixedExponent;
use super::{Arithmetic, Back, sealed::Sealed};
use crate::coordinates::fold;
use crate::error::Error;
use disc::{Q31Disc, nearest, signed};
use inverse::{above, length_squared};

impl Q31 {
    /// The concentric map, as [`Concentric`](crate::Concentric) stores it: for tables built at
    /// compile time.
    ///
    /// ```
    /// use hemidisc::{Concentric, Q31};
    /// static CENTRE: [Q31; 2] = Q31::concentric([1 << 31, 1 << 31]);
    /// assert_eq!(CENTRE, Concentric::<Q31>::new().sample([1 << 31, 1 << 31]));
    /// ```
    #[must_use]
    #[inline(always)]
    pub const fn concentric(uv: [u32; 2]) -> [Self; 2] {
        disc::concentric::<false>(uv).store()
    }

    /// The polar map, as [`Polar`](crate::Polar) stores it.
    #[must_use]
    #[inline(always)]
    pub const fn polar(uv: [u32; 2]) -> [Self; 2] {
        disc::polar(uv).store()
    }
}

/// The kernels, as `const` functions.
impl Q31 {
    #[inline(always)]
    pub(crate) const fn disc_concentric(uv: [u32; 2]) -> Q31Disc {
        disc::concentric::<true>(uv)
    }

    #[inline(always)]
    pub(crate) const fn disc_polar(uv: [u32; 2]) -> Q31Disc {
        disc::polar(uv)
    }

    #[inline(always)]
    pub(crate) const fn lift_uniform(disc: Q31Disc) -> [Self; 3] {
        // sqrt(1 + (1 - r^2)) / 2, so that a product with it is in LSBs.
        let half = root((1 << 62) + (disc.one_minus_r2 >> 2));
        // Toward zero, because no point may leave the hemisphere.
        let (x, y) = (high(disc.x, half), high(disc.y, half));
        let [x_positive, y_positive] = disc.positive;
        let z = nearest((disc.one_minus_r2 >> 32) as u32);
        [signed(x, x_positive), signed(y, y_positive), z]
    }

    #[inline(always)]
    pub(crate) const fn lift_cosine(disc: Q31Disc) -> [Self; 3] {
        let [x, y] = disc.store();
        [x, y, nearest(root(disc.one_minus_r2))]
    }

    pub(crate) const fn prepared(e: FixedExponent) -> Result<Q31Exponent, Error> {
        Ok(Q31Exponent::new(e))
    }

    #[inline]
    pub(crate) const fn lift_power(exponent: Q31Exponent, disc: Q31Disc) -> [Self; 3] {
        power::lift(exponent, disc)
    }
}

impl Sealed for Q31 {}

impl Arithmetic for Q31 {
    const NAME: &'static str = "q31";
    const ABSOLUTE_DENSITY: bool = false;
    const POINTWISE: bool = true;

    type Real = Self;
    type Disc = Q31Disc;
    type Parameter = FixedExponent;
    type Exponent = Q31Exponent;
    type Back = Self;

    #[inline(always)]
    fn square(uv: [u32; 2]) -> [Self; 2] {
        uv.map(|k| Self::from_bits((k >> 1).cast_signed()))
    }

    /// The magnitude (2m + 1) / 2^32 rounded toward zero, so that inside stays inside.
    #[inline(always)]
    fn centred(uv: [u32; 2]) -> [Self; 2] {
        uv.map(|k| {
            let (m, sign) = fold(k);
            Self::from_bits((m.cast_signed() ^ sign) - sign)
        })
    }

    #[inline(always)]
    fn concentric(uv: [u32; 2]) -> Q31Disc {
        Self::disc_concentric(uv)
    }

    #[inline(always)]
    fn concentric_point(uv: [u32; 2]) -> [Self; 2] {
        Self::concentric(uv)
    }

    #[inline(always)]
    fn polar(uv: [u32; 2]) -> Q31Disc {
        Self::disc_polar(uv)
    }

    #[inline(always)]
    fn store(disc: Q31Disc) -> [Self; 2] {
        disc.store()
    }

    #[inline(always)]
    fn uniform(disc: Q31Disc) -> [Self; 3] {
        Self::lift_uniform(disc)
    }

    #[inline(always)]
    fn cosine(disc: Q31Disc) -> [Self; 3] {
        Self::lift_cosine(disc)
    }

    fn exponent(parameter: FixedExponent) -> Result<Q31Exponent, Error> {
        Self::prepared(parameter)
    }

    fn given(exponent: Q31Exponent) -> FixedExponent {
        exponent.value()
    }

    #[inline]
    fn power(exponent: Q31Exponent, disc: Q31Disc) -> [Self; 3] {
        Self::lift_power(exponent, disc)
    }
}

impl Back for Q31 {
    type Real = Self;
    type Lowered = Lowered;
    type Exponent = Q31Exponent;

    #[inline]
    fn lower_disc([x, y]: [Self; 2]) -> Lowered {
        Lowered::new(x, y, length_squared(x, y))
    }

    #[inline]
    fn lower_uniform(direction: [Self; 3]) -> Lowered {
        inverse::lower_uniform(direction)
    }

    #[inline]
    fn lower_cosine(direction: [Self; 3]) -> Lowered {
        inverse::lower_cosine(direction)
    }

    #[inline]
    fn lower_power(exponent: Q31Exponent, direction: [Self; 3]) -> Lowered {
        power::lower(exponent, direction)
    }

    #[inline]
    fn invert_square(point: [Self; 2]) -> [u32; 2] {
        point.map(|x| x.to_bits().max(0).cast_unsigned() << 1)
    }

    #[inline]
    fn invert_centred(point: [Self; 2]) -> [u32; 2] {
        point.map(|x| inverse::unfold(x.to_bits().unsigned_abs(), !x.to_bits() >> 31))
    }

    #[inline]
    fn invert_concentric(lowered: Lowered) -> [u32; 2] {
        inverse::concentric(lowered)
    }

    #[inline]
    fn invert_polar(lowered: Lowered) -> [u32; 2] {
        inverse::polar(lowered)
    }

    #[inline]
    fn square_density([u, v]: [Self; 2]) -> Self {
        if u >= Self::ZERO && v >= Self::ZERO { Self::MAX } else { Self::ZERO }
    }

    #[inline]
    fn disc_density([x, y]: [Self; 2]) -> Self {
        let square = |x: Self| u64::from(x.to_bits().unsigned_abs()).pow(2);
        if square(x) + square(y) <= 1 << 62 { Self::MAX } else { Self::ZERO }
    }

    #[inline]
    fn uniform_density([_, _, z]: [Self; 3]) -> Self {
        if above(z) { Self::MAX } else { Self::ZERO }
    }

    #[inline]
    fn cosine_density([_, _, z]: [Self; 3]) -> Self {
        if above(z) { z } else { Self::ZERO }
    }

    #[inline]
    fn power_density(exponent: Q31Exponent, direction: [Self; 3]) -> Self {
        power::density(exponent, direction)
    }
}
