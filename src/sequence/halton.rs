//! Halton sequence in bases 2 and 3 (J. Halton, "On the Efficiency of Certain Quasi-random
//! Sequences of Points in Evaluating Multi-dimensional Integrals", 1960).
//!
//! The radical inverse mirrors the digits of the index at the radix point. A coordinate is
//! ceil(2^32 x) of the exact rational x, so that it lies in the stratum of every base that x does.

use super::Sequence;

/// The Halton sequence: radical inverses of the index in base 2 (u) and base 3 (v).
///
/// Promise: any 2^a 3^b consecutive points hit each of the 2^a x 3^b elementary intervals once, for
/// b <= 19. (3^20 intervals are as narrow as a cell, and rounding up to a cell may cross an edge.)
/// Takes no seed. A point costs up to 20 divisions by 3.
///
/// ```
/// use hemidisc::sequence::Halton;
/// // 1 / 2 and ceil(2^32 / 3)
/// assert_eq!(Halton::new().at(1), [0x8000_0000, 0x5555_5556]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Halton;

impl Halton {
    /// The sequence; it has no parameters.
    pub const fn new() -> Self {
        Self
    }

    /// The point of any index.
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        [index.reverse_bits(), radical_inverse_3(index)]
    }
}

/// ceil(2^32 x) for the radical inverse x of `index` in base 3.
///
/// A `u32` has at most 21 ternary digits. The lowest 20, mirrored, make an integer below
/// 3^20 < 2^32; the last one, at weight 3^-21, joins the remainder of the division by 3^20.
const fn radical_inverse_3(index: u32) -> u32 {
    const DIGITS: u32 = 20;
    const SCALE: u64 = 3_u64.pow(DIGITS);
    let mut rest = index;
    let mut mirrored = 0;
    let mut weight = 3_u32.pow(DIGITS - 1);
    while rest > 0 && weight > 0 {
        mirrored += rest % 3 * weight;
        rest /= 3;
        weight /= 3;
    }
    let scaled = (mirrored as u64) << 32;
    let remainder = 3 * (scaled % SCALE) + ((rest as u64) << 32);
    (scaled / SCALE + remainder.div_ceil(3 * SCALE)) as u32
}

impl Sequence for Halton {
    fn size(&self) -> Option<u32> {
        None
    }

    #[inline(always)]
    fn point(&self, index: u32) -> [u32; 2] {
        self.at(index)
    }
}
