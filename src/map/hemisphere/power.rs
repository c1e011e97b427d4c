//! Cosine-power lobe: z = (1 - r^2)^(1 / (e + 1)), density (e + 1) z^e / (2 pi) per steradian
//! (K. Suffern, "Ray Tracing from the Ground Up", 2007, chapter 7).

use super::lobe;
use crate::arithmetic::Arithmetic;
use crate::error::Error;

/// z = (1 - r^2)^(1 / (e + 1)): the tighter about the pole the larger e; e = 0 is uniform, 1
/// cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerLobe<A: Arithmetic> {
    exponent: A::Exponent,
}

impl<A: Arithmetic> PowerLobe<A> {
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub(super) fn new(exponent: A::Parameter) -> Result<Self, Error> {
        Ok(Self { exponent: A::exponent(exponent)? })
    }

    /// Of a checked exponent.
    pub(super) const fn of(exponent: A::Exponent) -> Self {
        Self { exponent }
    }

    /// The exponent with its precomputed values.
    pub(crate) const fn prepared(&self) -> A::Exponent {
        self.exponent
    }

    pub(super) fn exponent(&self) -> A::Parameter {
        A::given(self.exponent)
    }
}

lobe! {
    PowerLobe, power, power_block, lower_power, power_density, exponent, power_with_density
}
