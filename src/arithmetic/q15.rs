//! Q15: points of 16-bit integers.
//!
//! Two arithmetics share the number: [`Q15`] reads the concentric map from a table of lines, without a
//! division; [`Q15Div`] divides and takes two short polynomials, without that kilobyte. Their concentric
//! points differ in the last bits; all else is the same.
//!
//! A sample reads the top 16 bits of a coordinate and takes 16 x 16 bit products alone. Densities and
//! inverses, which are not for the inner loop, are those of Q31 on the widened point.
//!
//! The lobes narrow as the exponent grows, and at e = 1e8 a direction is (x, y, 1 - LSB) with x and y of
//! at most 16 LSB: right to 0.51 of one, but with few directions to tell apart, and theta no better.

use super::fixed::{FixedExponent, Q15, Q31};
use super::{Arithmetic, Q15Div, Q31Disc};
use crate::error::Error;

mod disc;
mod lobes;
mod tables;

pub use disc::Q15Disc;
pub(super) use disc::concentric;
pub use lobes::Q15Exponent;

impl Q15 {
    /// The concentric map, as [`Concentric`](crate::Concentric) stores it: for tables built at compile time.
    ///
    /// ```
    /// use hemidisc::{Concentric, Map, Q15};
    /// static CENTRE: [Q15; 2] = Q15::concentric([1 << 31, 1 << 31]);
    /// assert_eq!(CENTRE, Concentric::<Q15>::new().sample([1 << 31, 1 << 31]));
    /// ```
    #[inline(always)]
    pub const fn concentric(uv: [u32; 2]) -> [Self; 2] {
        disc::concentric::<false>(uv).store()
    }

    /// The polar map, as [`Polar`](crate::Polar) stores it.
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
macro_rules! arithmetic {
    ($arithmetic:ty, $name:literal, $divides:literal) => {
        impl Arithmetic for $arithmetic {
            const NAME: &'static str = $name;
            const ABSOLUTE_DENSITY: bool = false;
            const BLOCKED: bool = cfg!(not(any(target_arch = "arm", target_arch = "riscv32")));

            type Real = Q15;
            type Disc = Q15Disc;
            type Parameter = FixedExponent;
            type Exponent = Q15Exponent;

            #[inline(always)]
            fn square(uv: [u32; 2]) -> [Q15; 2] {
                uv.map(|k| Q15::from_bits((k >> 17) as i16))
            }

            /// The magnitude of the cell's inner edge, so that inside stays inside.
            #[inline(always)]
            fn centred(uv: [u32; 2]) -> [Q15; 2] {
                uv.map(|k| {
                    let (a, sign) = disc::fold(k);
                    disc::signed(a >> 1, sign)
                })
            }

            #[inline(always)]
            fn concentric<const RIM: bool>(uv: [u32; 2]) -> Q15Disc {
                disc::concentric::<$divides>(uv)
            }

            #[inline(always)]
            fn polar<const RIM: bool>(uv: [u32; 2]) -> Q15Disc {
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

            fn exponent(parameter: FixedExponent) -> Result<Q15Exponent, Error> {
                Ok(Q15Exponent::new(parameter))
            }

            #[inline]
            fn power(exponent: Q15Exponent, disc: Q15Disc) -> [Q15; 3] {
                lobes::power(exponent, disc)
            }

            #[inline]
            fn load(point: [Q15; 2]) -> Q15Disc {
                Q31::load(point.map(Q15::widened)).into()
            }

            #[inline]
            fn lower_uniform(direction: [Q15; 3]) -> Q15Disc {
                Q31::lower_uniform(direction.map(Q15::widened)).into()
            }

            #[inline]
            fn lower_cosine(direction: [Q15; 3]) -> Q15Disc {
                Q31::lower_cosine(direction.map(Q15::widened)).into()
            }

            #[inline]
            fn lower_power(exponent: Q15Exponent, direction: [Q15; 3]) -> Q15Disc {
                Q31::lower_power(exponent.wide(), direction.map(Q15::widened)).into()
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
            fn invert_concentric(disc: Q15Disc) -> [u32; 2] {
                Q31::invert_concentric(disc.into())
            }

            #[inline]
            fn invert_polar(disc: Q15Disc) -> [u32; 2] {
                Q31::invert_polar(disc.into())
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
            fn power_density(exponent: Q15Exponent, direction: [Q15; 3]) -> Q15 {
                Q15::narrowed(Q31::power_density(exponent.wide(), direction.map(Q15::widened)))
            }
        }
    };
}
arithmetic!(Q15, "q15", false);
arithmetic!(Q15Div, "q15-div", true);

impl From<Q31Disc> for Q15Disc {
    /// For the inverses: the direction, and r^2, which is not 0.
    fn from(wide: Q31Disc) -> Self {
        let r2 = (wide.r2 >> 32) as u32;
        Self { magnitude: [wide.x >> 1, wide.y >> 1], sign: wide.signs, r2: r2.max(1) }
    }
}

impl From<Q15Disc> for Q31Disc {
    fn from(disc: Q15Disc) -> Self {
        let ([x, y], r2) = (disc.magnitude, u64::from(disc.r2) << 32);
        // At most 2^31 each.
        let wide = |magnitude: u32| magnitude.saturating_mul(2);
        Self { x: wide(x), y: wide(y), signs: disc.sign, r2, rim: r2.wrapping_neg() }
    }
}
