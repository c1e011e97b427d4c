//! Q15: points of 16-bit integers.
//!
//! Two arithmetics share the number: [`Q15`] reads the concentric map from a table of lines,
//! without a division. [`Q15Div`] divides and evaluates two short polynomials, without the table's
//! kilobyte. Their concentric points differ in the last bits; all else is the same.
//!
//! A sample reads the top 16 bits of a coordinate and takes 16 x 16 bit products alone. Densities
//! and inverses, which are not for the inner loop, are those of Q31 on the widened point.
//!
//! The lobes narrow as the exponent grows, and at e = 1e8 a direction is (x, y, 1 - LSB) with x and
//! y of at most 16 LSB: accurate to 0.51 LSB, but with few distinct directions, and theta no
//! better.

pub(super) mod disc;
pub(super) mod lobes;
mod tables;

pub use super::fixed::Q15;

use super::Back;
use super::fixed::Q31;
use super::q31::{Lowered, Q31Exponent};

impl Q15 {
    /// The concentric map, as [`Concentric`](crate::Concentric) stores it: for tables built at
    /// compile time.
    ///
    /// ```
    /// use hemidisc::{Concentric, Q15};
    /// static CENTRE: [Q15; 2] = Q15::concentric([1 << 31, 1 << 31]);
    /// assert_eq!(CENTRE, Concentric::<Q15>::new().sample([1 << 31, 1 << 31]));
    /// ```
    #[must_use]
    #[inline(always)]
    pub const fn concentric(uv: [u32; 2]) -> [Self; 2] {
        disc::concentric(uv).store()
    }

    /// The polar map, as [`Polar`](crate::Polar) stores it.
    #[must_use]
    #[inline(always)]
    pub const fn polar(uv: [u32; 2]) -> [Self; 2] {
        disc::polar(uv).store()
    }

    /// The same value, exactly.
    #[inline]
    const fn widened(self) -> Q31 {
        Q31::from_bits((self.to_bits() as i32) << 16)
    }

    /// The nearest number toward zero; not 0 for a positive one.
    #[inline]
    const fn narrowed(wide: Q31) -> Self {
        let bits = wide.to_bits();
        Self::from_bits(if bits > 0 && bits < 1 << 16 { 1 } else { (bits >> 16) as i16 })
    }
}

/// `Arithmetic` for an arithmetic on Q15, which has a concentric kernel of its own.
macro_rules! arithmetic_on_q15 {
    ($arithmetic:ty, $name:literal, $concentric:path) => {
        impl $crate::arithmetic::sealed::Sealed for $arithmetic {}

        /// The kernels, as `const` functions.
        const _: () = {
            use $crate::arithmetic::fixed::{FixedExponent, Q15};
            use $crate::arithmetic::q15::{disc, disc::Q15Disc, lobes, lobes::Q15Exponent};

            impl $arithmetic {
                #[inline(always)]
                pub(crate) const fn disc_concentric(uv: [u32; 2]) -> Q15Disc {
                    $concentric(uv)
                }

                #[inline(always)]
                pub(crate) const fn disc_polar(uv: [u32; 2]) -> Q15Disc {
                    disc::polar(uv)
                }

                #[inline(always)]
                pub(crate) const fn lift_uniform(disc: Q15Disc) -> [Q15; 3] {
                    lobes::uniform(disc)
                }

                #[inline(always)]
                pub(crate) const fn lift_cosine(disc: Q15Disc) -> [Q15; 3] {
                    lobes::cosine(disc)
                }

                pub(crate) const fn prepared(
                    e: FixedExponent,
                ) -> Result<Q15Exponent, $crate::Error> {
                    Ok(Q15Exponent::new(e))
                }

                #[inline]
                pub(crate) const fn lift_power(exponent: Q15Exponent, disc: Q15Disc) -> [Q15; 3] {
                    lobes::power(exponent, disc)
                }
            }
        };

        const _: () = {
            use $crate::arithmetic::fixed::{FixedExponent, Q15};
            use $crate::arithmetic::q15::{
                Widened, disc, disc::Q15Disc, lobes, lobes::Q15Exponent,
            };

            impl $crate::arithmetic::Arithmetic for $arithmetic {
                const NAME: &'static str = $name;
                const ABSOLUTE_DENSITY: bool = false;
                const POINTWISE: bool = true;

                type Real = Q15;
                type Disc = Q15Disc;
                type Parameter = FixedExponent;
                type Exponent = Q15Exponent;
                type Back = Widened;

                #[inline(always)]
                fn square(uv: [u32; 2]) -> [Q15; 2] {
                    uv.map(|k| Q15::from_bits((k >> 17) as i16))
                }

                /// The magnitude of the cell's inner edge, so that inside stays inside.
                #[inline(always)]
                fn centred(uv: [u32; 2]) -> [Q15; 2] {
                    uv.map(|k| {
                        let (a, positive) = disc::odd_magnitude(k);
                        disc::signed(a >> 1, positive)
                    })
                }

                #[inline(always)]
                fn concentric(uv: [u32; 2]) -> Q15Disc {
                    $concentric(uv)
                }

                #[inline(always)]
                fn polar(uv: [u32; 2]) -> Q15Disc {
                    disc::polar(uv)
                }

                #[inline(always)]
                fn store(disc: Q15Disc) -> [Q15; 2] {
                    disc.store()
                }

                #[inline(always)]
                fn uniform(disc: Q15Disc) -> [Q15; 3] {
                    lobes::uniform(disc)
                }

                #[inline(always)]
                fn cosine(disc: Q15Disc) -> [Q15; 3] {
                    lobes::cosine(disc)
                }

                fn exponent(parameter: FixedExponent) -> Result<Q15Exponent, $crate::Error> {
                    Self::prepared(parameter)
                }

                fn given(exponent: Q15Exponent) -> FixedExponent {
                    exponent.value()
                }

                #[inline]
                fn power(exponent: Q15Exponent, disc: Q15Disc) -> [Q15; 3] {
                    lobes::power(exponent, disc)
                }
            }
        };
    };
}
pub(super) use arithmetic_on_q15;
arithmetic_on_q15!(Q15, "q15", disc::concentric);

/// The way back of Q15: that of Q31 on the widened point.
#[derive(Clone, Copy, Debug)]
pub struct Widened;

impl Back for Widened {
    type Real = Q15;
    type Lowered = Lowered;
    type Exponent = Q31Exponent;

    #[inline]
    fn lower_disc(point: [Q15; 2]) -> Lowered {
        Q31::lower_disc(point.map(Q15::widened))
    }

    #[inline]
    fn lower_uniform(direction: [Q15; 3]) -> Lowered {
        Q31::lower_uniform(direction.map(Q15::widened))
    }

    #[inline]
    fn lower_cosine(direction: [Q15; 3]) -> Lowered {
        Q31::lower_cosine(direction.map(Q15::widened))
    }

    #[inline]
    fn lower_power(exponent: Q31Exponent, direction: [Q15; 3]) -> Lowered {
        Q31::lower_power(exponent, direction.map(Q15::widened))
    }

    #[inline]
    fn invert_square(point: [Q15; 2]) -> [u32; 2] {
        Q31::invert_square(point.map(Q15::widened))
    }

    #[inline]
    fn invert_centred(point: [Q15; 2]) -> [u32; 2] {
        Q31::invert_centred(point.map(Q15::widened))
    }

    #[inline]
    fn invert_concentric(lowered: Lowered) -> [u32; 2] {
        Q31::invert_concentric(lowered)
    }

    #[inline]
    fn invert_polar(lowered: Lowered) -> [u32; 2] {
        Q31::invert_polar(lowered)
    }

    #[inline]
    fn square_density(point: [Q15; 2]) -> Q15 {
        Q15::narrowed(Q31::square_density(point.map(Q15::widened)))
    }

    #[inline]
    fn disc_density(point: [Q15; 2]) -> Q15 {
        Q15::narrowed(Q31::disc_density(point.map(Q15::widened)))
    }

    #[inline]
    fn uniform_density(direction: [Q15; 3]) -> Q15 {
        Q15::narrowed(Q31::uniform_density(direction.map(Q15::widened)))
    }

    #[inline]
    fn cosine_density(direction: [Q15; 3]) -> Q15 {
        Q15::narrowed(Q31::cosine_density(direction.map(Q15::widened)))
    }

    #[inline]
    fn power_density(exponent: Q31Exponent, direction: [Q15; 3]) -> Q15 {
        Q15::narrowed(Q31::power_density(exponent, direction.map(Q15::widened)))
    }
}
