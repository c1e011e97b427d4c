//! Random points by a counter hash: white noise with random access.

use super::Sequence;
use crate::bits::hash::pair;
use crate::domain::Domain;

/// Independent uniform points: a hash of index and domain.
///
/// Promise: none about strata; unlike a generator it has no state, so any index costs the same
/// (three hashes of two multiplications each). The hashes are bijections: no coordinate of an axis
/// comes twice in 2^32 points, where truly independent ones begin to repeat after some 2^16.
///
/// ```
/// use hemidisc::sequence::Random;
/// assert_ne!(Random::new(1).at(0), Random::new(2).at(0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Random {
    keys: [u32; 3],
}

impl Random {
    /// The points of `Domain::new(seed)`; every seed, 0 too, is hashed.
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self::in_domain(Domain::new(seed))
    }

    /// The points of a domain.
    #[must_use]
    #[inline]
    pub const fn in_domain(domain: Domain) -> Self {
        Self { keys: domain.keys() }
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn domain(&self) -> Domain {
        let [order, u, _] = self.keys;
        Domain::of_keys([order, u])
    }

    /// How many points there are: `None`, for it is endless.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        None
    }

    /// The point of any index.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        pair(self.keys, index)
    }
}

impl Sequence for Random {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }
}
