//! Another sequence's points in another order: what pairs two sets without correlation.
//!
//! Two sets that both walk their cells row by row (a jittered lens and a jittered light, say) put
//! point i of either into the same cell, and the pairs fill a small part of the product space.
//! Shuffling the order of one, with a key of its own, fixes that.

use super::Sequence;
use super::sobol_owen::shuffle;
use super::walk::repeat;
use crate::bits::permute::permute;
use crate::domain::Domain;

/// The points of `S` in the order that a domain picks.
///
/// Promise: that of `S` for the whole set. An endless sequence is shuffled by a nested-uniform
/// shuffle, which keeps aligned blocks of 2^k together; a set by a permutation of its size. A point
/// costs one of the two in addition.
///
/// ```
/// use hemidisc::{Domain, sequence::{Regular, Shuffled}};
/// let grid = Shuffled::new(Regular::new(8, 8)?, Domain::new(7));
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shuffled<S> {
    sequence: S,
    order: u32,
    /// Kept to be written: an order does not tell it.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    domain: Domain,
}

impl<S> Shuffled<S> {
    /// The set that is shuffled.
    #[must_use]
    pub const fn sequence(&self) -> &S {
        &self.sequence
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn domain(&self) -> Domain {
        self.domain
    }
}

impl<S: Sequence> Shuffled<S> {
    /// `sequence`, in the order of `domain`.
    #[must_use]
    pub const fn new(sequence: S, domain: Domain) -> Self {
        let [order, ..] = domain.keys();
        Self {
            sequence,
            order,
            #[cfg(any(feature = "serde", feature = "defmt"))]
            domain,
        }
    }
}

impl<S: Sequence> Sequence for Shuffled<S> {
    fn size(&self) -> Option<u32> {
        self.sequence.size()
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        self.sequence.at(match self.sequence.size() {
            Some(size) => permute(repeat(index, size), size, self.order),
            None => shuffle(index, self.order),
        })
    }
}
