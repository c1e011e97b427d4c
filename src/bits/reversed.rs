//! An index with its bits reversed, counted on: the radical inverse in base 2.
//!
//! A core that cannot reverse bits in one instruction takes some 20. Counting on with a carry from
//! the highest bit down changes two bits on average.

use crate::target::REVERSES_BITS;

/// An index and its radical inverse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Reversed {
    index: u32,
    bits: u32,
}

impl Reversed {
    pub(crate) const fn new(index: u32) -> Self {
        Self { index, bits: index.reverse_bits() }
    }

    /// The bits of the index in reverse.
    pub(crate) const fn bits(self) -> u32 {
        self.bits
    }

    /// The next index; 0 after the last.
    #[inline(always)]
    pub(crate) const fn after(self) -> Self {
        let index = self.index.wrapping_add(1);
        Self { index, bits: if REVERSES_BITS { index.reverse_bits() } else { carried(self.bits) } }
    }
}

/// The sum with the highest bit, carried downwards.
#[inline(always)]
const fn carried(mut bits: u32) -> u32 {
    let mut bit = 1 << 31;
    while bits & bit != 0 {
        bits ^= bit;
        bit >>= 1;
    }
    bits | bit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_as_the_index_does() {
        let powers = (0..32).map(|bit| (1_u32 << bit) - 1);
        for index in powers.chain(0..10_000).chain(u32::MAX - 10_000..=u32::MAX) {
            let next = index.wrapping_add(1);
            assert_eq!(carried(index.reverse_bits()), next.reverse_bits(), "{index}");
            assert_eq!(Reversed::new(index).after(), Reversed::new(next), "{index}");
        }
    }
}
