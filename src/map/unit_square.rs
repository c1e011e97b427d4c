//! The unit square itself as a map: coordinates as numbers.

use super::{Map, by_component};
use crate::arithmetic::Arithmetic;
use crate::sequence::{BLOCK, Block};
use core::marker::PhantomData;

/// The identity: coordinates as numbers in [0, 1), rounded toward zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnitSquare<A>(PhantomData<A>);

impl<A: Arithmetic> UnitSquare<A> {
    /// The map; it has no parameters.
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<A: Arithmetic> Map for UnitSquare<A> {
    type Arithmetic = A;
    type Point = [A::Real; 2];

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> [A::Real; 2] {
        A::square(uv)
    }

    #[inline(always)]
    fn sample_block(&self, u: &Block, v: &Block, out: &mut [Self::Point; BLOCK]) {
        by_component(self, u, v, out);
    }

    #[inline]
    fn density(&self, point: [A::Real; 2]) -> A::Real {
        A::square_density(point)
    }

    #[inline]
    fn invert(&self, point: [A::Real; 2]) -> [u32; 2] {
        A::invert_square(point)
    }
}

#[cfg(feature = "rand")]
impl<A: Arithmetic> rand::distr::Distribution<[A::Real; 2]> for UnitSquare<A> {
    /// Draws two words, u first.
    #[inline]
    fn sample<R: rand::Rng + ?Sized>(&self, rng: &mut R) -> [A::Real; 2] {
        super::draw(self, rng)
    }
}
