//! Hammersley set of N points: u = i / N, v = the radical inverse of i in base 2
//! (J. Hammersley, "Monte Carlo Methods for Solving Multivariable Problems", 1960).

use super::walk::Reversed;
use super::walk::repeat;
use super::walk::{Walk, walks};
use super::{Sequence, not_empty};
use crate::bits::strata::Strata;
use crate::error::Error;

/// The N-point Hammersley set: u = ceil(2^32 i / N), v = i with its bits reversed.
///
/// Promise: each of the N strata of u holds one point; for N = 2^k the set is a (0, k, 2)-net, that
/// is, every elementary interval of area 1/N holds exactly one. Takes no seed.
///
/// ```
/// use hemidisc::sequence::Hammersley;
/// assert_eq!(Hammersley::new(4)?.at(3), [0xc000_0000, 0xc000_0000]);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Hammersley {
    strata: Strata,
}

impl Hammersley {
    /// A set of `count` points.
    ///
    /// # Errors
    /// [`Error::EmptySet`] if `count` is 0.
    pub const fn new(count: u32) -> Result<Self, Error> {
        match not_empty(count) {
            Ok(()) => Ok(Self { strata: Strata::new(count) }),
            Err(error) => Err(error),
        }
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn count(&self) -> u32 {
        self.strata.count()
    }

    /// How many points there are.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        Some(self.strata.count())
    }

    /// The point of any index; the set repeats after `count` points.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let index = repeat(index, self.strata.count());
        [self.strata.first(index), index.reverse_bits()]
    }
}

impl Sequence for Hammersley {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    walks!();
}

impl Walk for Hammersley {
    type State = (Reversed, u32);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let index = repeat(index, self.strata.count());
        ((Reversed::new(index), self.strata.first(index)), self.strata.count() - index)
    }

    #[inline(always)]
    fn step(&self, (v, u): &mut Self::State) -> [u32; 2] {
        let point = [*u, v.bits()];
        (*v, *u) = (v.after(), self.strata.after(*u));
        point
    }
}
