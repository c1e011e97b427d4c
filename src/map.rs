//! Maps: from coordinates on the unit square to points of the disc and directions of the hemisphere.
//!
//! | map | point | density |
//! | --- | --- | --- |
//! | [`UnitSquare`] | (u, v) in [0, 1)^2 | 1 |
//! | [`Rejection`](disc::Rejection) | the candidates of [-1, 1]^2 inside the unit disc | 1 / pi |
//! | [`Polar`] | r = sqrt v, phi = 2 pi u | 1 / pi |
//! | [`Concentric`] | squares about the centre to circles (Shirley and Chiu 1997) | 1 / pi |
//! | [`Uniform`] | z = 1 - r^2 of a disc map's point | 1 / (2 pi) |
//! | [`Cosine`] | z = sqrt(1 - r^2) | z / pi |
//! | [`Power`] | z = (1 - r^2)^(1 / (e + 1)) | (e + 1) z^e / (2 pi) |

pub mod disc;
pub mod hemisphere;
mod unit_square;

pub use disc::{Concentric, DiscMap, Polar};
pub use hemisphere::{Cosine, Hemisphere, Lobe, Power, Uniform};
pub use unit_square::UnitSquare;

use crate::arithmetic::Arithmetic;
use crate::sequence::{BLOCK, Block};

/// A component of the points of a map.
pub type Component<M> = <<M as Map>::Arithmetic as Arithmetic>::Real;

/// A one-to-one map of the unit square onto a disc, a hemisphere or itself.
pub trait Map: Copy {
    /// The arithmetic it computes in.
    type Arithmetic: Arithmetic;
    /// Its points: `[Real; 2]` or `[Real; 3]`.
    type Point: Copy + Default;

    /// The point of a pair of coordinates; every bit pattern is valid.
    fn sample(&self, uv: [u32; 2]) -> Self::Point;

    /// The density of samples at a point: per unit of area on the square and the disc, per
    /// steradian on the hemisphere; 0 outside. Positive and finite at every sampled point.
    fn density(&self, point: Self::Point) -> Component<Self>;

    /// The coordinates that [`sample`](Self::sample) sends to a point, or the nearest it can tell.
    ///
    /// Total: a point off the disc or the hemisphere, or not a number, gives some coordinates.
    fn invert(&self, point: Self::Point) -> [u32; 2];

    /// The points of a block of coordinates; the same bits as [`sample`](Self::sample) gives.
    #[inline(always)]
    fn sample_block(&self, u: &Block, v: &Block, out: &mut [Self::Point; BLOCK]) {
        for (slot, (u, v)) in out.iter_mut().zip(u.iter().zip(v)) {
            *slot = self.sample([*u, *v]);
        }
    }
}

/// Implements `rand`'s trait for a map: a sample of two uniform words.
#[cfg(feature = "rand")]
macro_rules! distribution {
    ($($generics:ident: $bound:path),*; $map:ty => $point:ty) => {
        impl<$($generics: $bound),*> rand::distr::Distribution<$point> for $map {
            /// Draws two words, u first.
            #[inline]
            fn sample<R: rand::Rng + ?Sized>(&self, rng: &mut R) -> $point {
                let uv = [rng.next_u32(), rng.next_u32()];
                crate::map::Map::sample(self, uv)
            }
        }
    };
}
#[cfg(feature = "rand")]
pub(crate) use distribution;
