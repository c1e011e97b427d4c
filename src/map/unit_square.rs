//! The unit square itself as a map: coordinates as numbers.

use super::{Density, Invert, Map};
use crate::arithmetic::{Arithmetic, Back, assert_rounds};
use core::marker::PhantomData;

/// The identity: coordinates as numbers in [0, 1), rounded toward zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct UnitSquare<A>(PhantomData<A>);

impl<A: Arithmetic> UnitSquare<A> {
    /// The map; it has no parameters.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<A: Arithmetic> Map for UnitSquare<A> {
    type Point = [A::Real; 2];

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> [A::Real; 2] {
        assert_rounds::<A>();
        A::square(uv)
    }
}

impl<A: Arithmetic> Density for UnitSquare<A> {
    #[inline]
    fn density(&self, point: [A::Real; 2]) -> A::Real {
        assert_rounds::<A>();
        A::Back::square_density(point)
    }
}

impl<A: Arithmetic> Invert for UnitSquare<A> {
    #[inline]
    fn invert(&self, point: [A::Real; 2]) -> [u32; 2] {
        assert_rounds::<A>();
        A::Back::invert_square(point)
    }
}

super::sampled!([A: Arithmetic] UnitSquare<A>, [A::Real; 2]);
