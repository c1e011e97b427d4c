//! Maps onto the unit disc: density 1 / pi per unit of area.

mod concentric;
mod polar;
mod rejection;

pub use concentric::Concentric;
pub use polar::Polar;
pub use rejection::Rejection;

use super::Map;
use crate::arithmetic::Arithmetic;

/// A one-to-one map onto the disc, which a lobe can lift to the hemisphere.
pub trait DiscMap: Map {
    /// The point before rounding; with its r^2 and 1 - r^2 if `RIM`.
    fn disc<const RIM: bool>(&self, uv: [u32; 2]) -> <Self::Arithmetic as Arithmetic>::Disc;

    /// The coordinates of a point given by its direction (x and y), r^2 and 1 - r^2.
    fn invert_disc(&self, disc: <Self::Arithmetic as Arithmetic>::Disc) -> [u32; 2];
}

/// A disc map whose kernels are the arithmetic's functions of the same names.
macro_rules! disc_map {
    ($map:ident, $kernel:ident, $invert:ident) => {
        impl<A> $map<A> {
            /// The map; it has no parameters.
            pub const fn new() -> Self {
                Self(core::marker::PhantomData)
            }
        }

        impl<A: Arithmetic> Map for $map<A> {
            type Arithmetic = A;
            type Point = [A::Real; 2];

            #[inline(always)]
            fn sample(&self, uv: [u32; 2]) -> [A::Real; 2] {
                A::store(A::$kernel::<false>(uv))
            }

            #[inline(always)]
            fn sample_block(
                &self,
                u: &crate::sequence::Block,
                v: &crate::sequence::Block,
                out: &mut [[A::Real; 2]; crate::sequence::BLOCK],
            ) {
                A::disc_block(self, u, v, out);
            }

            #[inline]
            fn density(&self, point: [A::Real; 2]) -> A::Real {
                A::disc_density(point)
            }

            #[inline]
            fn invert(&self, point: [A::Real; 2]) -> [u32; 2] {
                A::$invert(A::load(point))
            }
        }

        impl<A: Arithmetic> DiscMap for $map<A> {
            #[inline(always)]
            fn disc<const RIM: bool>(&self, uv: [u32; 2]) -> A::Disc {
                A::$kernel::<RIM>(uv)
            }

            #[inline]
            fn invert_disc(&self, disc: A::Disc) -> [u32; 2] {
                A::$invert(disc)
            }
        }

        #[cfg(feature = "rand")]
        impl<A: Arithmetic> rand::distr::Distribution<[A::Real; 2]> for $map<A> {
            /// Draws two words, u first.
            #[inline]
            fn sample<R: rand::Rng + ?Sized>(&self, rng: &mut R) -> [A::Real; 2] {
                crate::map::draw(self, rng)
            }
        }
    };
}
use disc_map;
