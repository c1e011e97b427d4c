//! R2: a Kronecker sequence on the plastic number (M. Roberts, "The Unreasonable Effectiveness of
//! Quasirandom Sequences", 2018).
//!
//! With g = 1.3247..., the real root of g^3 = g + 1, the steps are 2^32 / g and 2^32 / g^2. The
//! second is rounded to an odd integer, so that both axes run through all 2^32 values.

use super::Sequence;
use crate::bits::hash::shift;
#[cfg(any(feature = "serde", feature = "defmt"))]
use crate::bits::hash::unmix;

/// The R2 sequence: (i + 1) (0xC13FA9A9, 0x91E10DA5) modulo 2^32, with an optional additive shift.
///
/// Promise: low discrepancy for every N, without strata that could be proved; each axis visits
/// every cell once in 2^32 points. A point costs two multiplications: the cheapest sequence here.
///
/// ```
/// use hemidisc::sequence::R2;
/// assert_eq!(R2::new(0).at(0), [0xc13f_a9a9, 0x91e1_0da5]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct R2 {
    shift: [u32; 2],
}

impl R2 {
    /// Seed 0 is the textbook sequence; any other shifts both axes by a hash of the seed.
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { shift: shift(seed) }
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn seed(&self) -> u32 {
        unmix(self.shift[0])
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
        let step = index.wrapping_add(1);
        [
            step.wrapping_mul(0xc13f_a9a9).wrapping_add(self.shift[0]),
            step.wrapping_mul(0x91e1_0da5).wrapping_add(self.shift[1]),
        ]
    }
}

impl Sequence for R2 {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }
}
