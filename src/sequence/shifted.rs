//! Another sequence's points, shifted along the torus (R. Cranley and T. Patterson, "Randomization
//! of Number Theoretic Methods for Multiple Integration", 1976).

use super::Sequence;
use crate::domain::Domain;

/// The points of `S`, moved by a random vector of a domain modulo 1.
///
/// Promise: an axis with one point in each of N equal strata keeps that within one point, and the
/// discrepancy grows by a factor of at most 4. Elementary intervals are not kept: for Sobol points
/// [`SobolOwen`](super::SobolOwen) is better. A point costs two additions more.
///
/// ```
/// use hemidisc::{Domain, sequence::{Halton, Sequence, Shifted}};
/// let [a, b] = [1, 2].map(|seed| Shifted::new(Halton::new(), Domain::new(seed)));
/// // The points of both differ by one vector.
/// let step = |i| b.at(i)[0].wrapping_sub(a.at(i)[0]);
/// assert_eq!(step(5), step(0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shifted<S> {
    sequence: S,
    shift: [u32; 2],
    /// Kept to be written: the shift does not tell it.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    domain: Domain,
}

impl<S> Shifted<S> {
    /// `sequence`, shifted by the vector of `domain`.
    #[must_use]
    #[inline]
    pub const fn new(sequence: S, domain: Domain) -> Self {
        let [_, u, v] = domain.keys();
        Self {
            sequence,
            shift: [u, v],
            #[cfg(any(feature = "serde", feature = "defmt"))]
            domain,
        }
    }

    /// The sequence that is shifted.
    #[must_use]
    pub const fn sequence(&self) -> &S {
        &self.sequence
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn domain(&self) -> Domain {
        self.domain
    }
}

impl<S: Sequence> Sequence for Shifted<S> {
    fn size(&self) -> Option<u32> {
        self.sequence.size()
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        let [u, v] = self.sequence.at(index);
        [u.wrapping_add(self.shift[0]), v.wrapping_add(self.shift[1])]
    }
}
