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
    /// steradian on the hemisphere; 0 outside. Positive and finite at every sampled point, but for
    /// one that a frame has turned ([`About`](crate::frame::About)).
    fn density(&self, point: Self::Point) -> Component<Self>;

    /// The point of a pair of coordinates and its density: what a weight f / p needs.
    #[inline]
    fn sample_with_density(&self, uv: [u32; 2]) -> (Self::Point, Component<Self>) {
        let point = self.sample(uv);
        (point, self.density(point))
    }

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

/// The points of a block, a component at a time: LLVM vectorises a branchless kernel so, but not where the
/// array is stored whole, nor where a closure hides a long kernel from the inliner. Stored among other
/// components at once, it would fill half of each vector.
#[inline(always)]
pub(crate) fn by_component<R: Copy + Default, const D: usize, M: Map<Point = [R; D]>>(
    map: &M,
    u: &Block,
    v: &Block,
    out: &mut [[R; D]; BLOCK],
) {
    let mut components = [[R::default(); BLOCK]; D];
    for (lane, (u, v)) in u.iter().zip(v).enumerate() {
        for (component, value) in components.iter_mut().zip(map.sample([*u, *v])) {
            component[lane] = value;
        }
    }
    for (lane, slot) in out.iter_mut().enumerate() {
        for (value, component) in slot.iter_mut().zip(&components) {
            *value = component[lane];
        }
    }
}

/// A sample of two uniform words of a generator, u first: `rand`'s trait for every map.
#[cfg(feature = "rand")]
pub(crate) fn draw<M: Map, R: rand::Rng + ?Sized>(map: &M, rng: &mut R) -> M::Point {
    let uv = [rng.next_u32(), rng.next_u32()];
    map.sample(uv)
}
