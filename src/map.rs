//! Maps: from coordinates on the unit square to points of the disc and directions of the
//! hemisphere.
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
//!
//! Every map here has `sample` as a method of its own: [`Map`] is for functions that are generic
//! over maps. `rand`'s `Distribution` has a method of the same name. Where both are in scope,
//! `map.sample([u, v])` is the map's, and `rng.sample(map)` draws u and v from a generator, with the
//! feature `rand` and `rand` 0.10. `map.sample([rng.random(), rng.random()])` needs no feature and
//! takes a generator of any version.
#![cfg_attr(
    feature = "rand",
    doc = r#"
```
use hemidisc::{Concentric, FastF32, Map};
use rand::{prelude::*, rngs::SmallRng};

/// A function that is generic over maps means the map's, too.
fn middle<M: Map>(map: M) -> M::Point {
    map.sample([1 << 31, 1 << 31])
}

let disc = Concentric::<FastF32>::new();
let mut rng = SmallRng::seed_from_u64(7);
let (fixed, drawn) = (disc.sample([1 << 31, 1 << 31]), rng.sample(disc));
assert!(fixed == middle(disc) && fixed != drawn);
let point = disc.sample([rng.random(), rng.random()]);
assert!(point[0] * point[0] + point[1] * point[1] <= 1.0);
```
"#
)]

pub mod disc;
pub mod hemisphere;
mod unit_square;

pub use disc::{Concentric, Polar};
pub use hemisphere::{Cosine, Power, Uniform};
pub use unit_square::UnitSquare;

pub use crate::block::Point;

use crate::block::Block;

/// A component of the points of a map.
pub type Component<M> = <<M as Map>::Point as Point>::Component;

/// A map of the unit square onto a disc, a hemisphere or itself.
///
/// A map of your own needs [`sample`](Self::sample) alone. With [`Density`] it can be the aperture
/// of a lens and has weights. [`Invert`] is for maps that are one-to-one.
///
/// ```
/// use hemidisc::{FastF32, Map, Points, sequence::Sobol};
///
/// /// A ring: the unit disc without a disc of half its radius.
/// #[derive(Clone, Copy)]
/// struct Ring;
///
/// impl Map for Ring {
///     type Point = [f32; 2];
///
///     fn sample(&self, [u, v]: [u32; 2]) -> [f32; 2] {
///         // The polar map reads v as r^2.
///         FastF32::polar([u, v - v / 4 + (1 << 30)])
///     }
/// }
///
/// let points: [[f32; 2]; 16] = Points::new(Sobol::new(0), Ring).to_array()?;
/// assert!(points.iter().all(|[x, y]| x * x + y * y >= 0.249));
/// # Ok::<(), hemidisc::Error>(())
/// ```
pub trait Map: Copy {
    /// Its points: `[Real; 2]` or `[Real; 3]`.
    type Point: Point;

    /// Whether [`sample`](Self::sample) is no vector code, so that a block of points is stored
    /// point by point where points are interleaved. The bits are the same.
    #[doc(hidden)]
    const POINTWISE: bool = false;

    /// The point of a pair of coordinates; every bit pattern is valid.
    #[must_use]
    fn sample(&self, uv: [u32; 2]) -> Self::Point;

    /// The points of a block of coordinates, one array a component: the same bits as
    /// [`sample`](Self::sample) gives.
    ///
    /// LLVM vectorises a branchless kernel where components are stored into arrays of their own.
    #[inline(always)]
    fn sample_block<const N: usize>(
        &self,
        u: &Block<N>,
        v: &Block<N>,
        out: &mut <Self::Point as Point>::Components<N>,
    ) {
        for (lane, (u, v)) in u.iter().zip(v).enumerate() {
            self.sample([*u, *v]).put::<N>(out, lane);
        }
    }
}

/// A map whose density is known.
pub trait Density: Map {
    /// The density of samples at a point: per unit of area on the square and the disc, per
    /// steradian on the hemisphere; 0 outside.
    ///
    /// It is positive and finite at every sampled point, except one that a frame has turned
    /// ([`About`](crate::frame::About)).
    #[must_use]
    fn density(&self, point: Self::Point) -> Component<Self>;

    /// The point of a pair of coordinates and its density: what a weight f / p needs.
    ///
    /// The point is that of [`sample`](Map::sample), bit for bit. The density is that of the
    /// coordinates, which a map may know better than the rounded point tells; it is
    /// [`density`](Self::density) of the point within the rounding of both, and the two may differ
    /// in their last digits. Accuracy is promised of each: of `density`, at a sampled point, and of
    /// this one.
    #[must_use]
    #[inline]
    fn sample_with_density(&self, uv: [u32; 2]) -> (Self::Point, Component<Self>) {
        let point = self.sample(uv);
        (point, self.density(point))
    }
}

/// A one-to-one map.
pub trait Invert: Density {
    /// The coordinates that [`sample`](Map::sample) sends to a point, or the nearest that can be
    /// recovered.
    ///
    /// Total: a point off the disc or the hemisphere, or NaN, gives some coordinates.
    #[must_use]
    fn invert(&self, point: Self::Point) -> [u32; 2];
}

/// `sample` as a method of the type's own, and `rand`'s trait.
///
/// The two traits have a method of one name: where both are in scope, a call of `sample` on a type
/// that implements both would be ambiguous, and a feature that some dependency turns on would break
/// the build. A type's own method comes before a trait's.
macro_rules! sampled {
    ([$($generics:tt)*] $map:ty, $point:ty) => {
        impl<$($generics)*> $map {
            /// The point of a pair of coordinates, u first; every bit pattern is valid. It is
            /// [`Map::sample`](crate::Map::sample), without the trait in scope.
            #[must_use]
            #[inline(always)]
            pub fn sample(&self, uv: [u32; 2]) -> $point {
                $crate::map::Map::sample(self, uv)
            }
        }

        #[cfg(feature = "rand")]
        impl<$($generics)*> rand::distr::Distribution<$point> for $map {
            /// Draws two words, u first.
            #[inline]
            fn sample<G: rand::Rng + ?Sized>(&self, rng: &mut G) -> $point {
                let uv = [rng.next_u32(), rng.next_u32()];
                $crate::map::Map::sample(self, uv)
            }
        }
    };
}
pub(crate) use sampled;

mod sealed {
    pub trait Sealed {}
}
