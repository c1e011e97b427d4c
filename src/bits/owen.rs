//! Owen scrambling of base-2 digits by a hash (nested uniform scrambling).
//!
//! In the reversed-bit domain a bit may depend only on the bits below it, which is true of
//! additions and multiplications: a Laine-Karras hash (S. Laine and T. Karras, "Stratified Sampling
//! for Stochastic Transparency", 2011; B. Burley, "Practical Hash-based Owen Scrambling", JCGT
//! 9(4), 2020) with the constants of N. Vegdahl's 2021 search, as in the crate `sobol_burley`.
//! `seed` must be well mixed already: consecutive integers will not do.

use crate::block::{BLOCK, Block, Lanes};

const MULTIPLIERS: [u32; 3] = [0x3d20_adea, 0x0552_6c56, 0x53a2_2864];

/// Owen-scrambles `x`, whose bits are reversed: bit b of the result depends on bits 0..=b of `x`.
#[must_use]
#[inline(always)]
pub const fn scramble_reversed(mut x: u32, seed: u32) -> u32 {
    x ^= x.wrapping_mul(MULTIPLIERS[0]);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(MULTIPLIERS[1]);
    x ^ x.wrapping_mul(MULTIPLIERS[2])
}

/// Owen-scrambles `x` as a binary fraction: permutes dyadic intervals of every size among their
/// siblings, so every net stays a net.
#[must_use]
#[inline(always)]
pub const fn scramble(x: u32, seed: u32) -> u32 {
    scramble_reversed(x.reverse_bits(), seed).reverse_bits()
}

/// The six low bits of [`scramble`]'s results for N consecutive numbers, the first a multiple of N,
/// which divides 64. They share all other bits.
///
/// Reversed, the six are the highest bits, and the lower 26 do not depend on them. Those are
/// scrambled once, with what each step carries into the six. Modulo 64 a step takes 16 bits: the
/// smallest vector holds eight such lanes, and a product is one operation.
#[inline(always)]
pub(crate) fn scramble_low<const N: usize>(first: u32, seed: u32) -> Lanes<u16, N> {
    const LOWER: u32 = (1 << 26) - 1;
    let carried = |sum: u32| (sum >> 26) as u16;
    let [m0, m1, m2] = MULTIPLIERS.map(|multiplier| multiplier as u16);
    let multiplier = (seed >> 16) | 1;

    let x = first.reverse_bits() & LOWER;
    let p0 = x.wrapping_mul(MULTIPLIERS[0]);
    let sum = ((x ^ p0) & LOWER) + (seed & LOWER);
    let product = (sum & LOWER).wrapping_mul(multiplier);
    let x = product & LOWER;
    let p1 = x.wrapping_mul(MULTIPLIERS[1]);
    let p2 = ((x ^ p1) & LOWER).wrapping_mul(MULTIPLIERS[2]);

    let mut places = [0; N];
    // In a whole block the places are constants.
    let within = if N == BLOCK { 0 } else { first as u16 & 63 };
    for (place, low) in places.iter_mut().zip(0_u16..) {
        *place = ((within | low) << 10).reverse_bits();
    }
    for place in &mut places {
        let mut x = *place;
        x ^= x.wrapping_mul(m0).wrapping_add(carried(p0));
        x = x.wrapping_add(carried(seed)).wrapping_add(carried(sum));
        x = x.wrapping_mul(multiplier as u16).wrapping_add(carried(product));
        x ^= x.wrapping_mul(m1).wrapping_add(carried(p1));
        x ^= x.wrapping_mul(m2).wrapping_add(carried(p2));
        *place = (x << 10).reverse_bits();
    }
    places
}

/// `scramble_reversed(x ^ low, seed).reverse_bits()` of each `low`, by halves: twice as many
/// numbers to a vector, and reversed bits need no exchange of the halves.
#[inline(always)]
pub(crate) fn scramble_siblings<const N: usize>(
    x: u32,
    low: &Lanes<u16, N>,
    seed: u32,
    out: &mut Block<N>,
) {
    let x = Halves::new(x);
    let (mut lower, mut upper) = ([0; N], [0; N]);
    for ((lower, upper), low) in lower.iter_mut().zip(&mut upper).zip(low) {
        let scrambled = Halves { lower: x.lower ^ low, upper: x.upper }.scramble_reversed(seed);
        (*lower, *upper) = (scrambled.lower, scrambled.upper);
    }
    for (lower, upper) in lower.iter_mut().zip(&mut upper) {
        (*lower, *upper) = (lower.reverse_bits(), upper.reverse_bits());
    }
    for ((slot, lower), upper) in out.iter_mut().zip(lower).zip(upper) {
        *slot = u32::from(lower) << 16 | u32::from(upper);
    }
}

/// A number of 32 bits as two of 16, each in a vector of its kind.
#[derive(Clone, Copy)]
struct Halves {
    lower: u16,
    upper: u16,
}

impl Halves {
    const fn new(x: u32) -> Self {
        Self { lower: x as u16, upper: (x >> 16) as u16 }
    }

    /// [`scramble_reversed`].
    #[inline(always)]
    fn scramble_reversed(self, seed: u32) -> Self {
        let x = self.xor_product(MULTIPLIERS[0]);
        let Self { lower, upper } = Self::new(seed);
        let sum = x.lower.wrapping_add(lower);
        let carry = u16::from(sum < lower);
        let x = Self { lower: sum, upper: x.upper.wrapping_add(upper).wrapping_add(carry) };
        x.product((seed >> 16) | 1).xor_product(MULTIPLIERS[1]).xor_product(MULTIPLIERS[2])
    }

    /// x ^ x m.
    #[inline(always)]
    fn xor_product(self, m: u32) -> Self {
        let Self { lower, upper } = self.product(m);
        Self { lower: self.lower ^ lower, upper: self.upper ^ upper }
    }

    /// x m.
    #[inline(always)]
    fn product(self, m: u32) -> Self {
        let m = Self::new(m);
        // Vectors have the upper half of this product (pmulhuw) as well as the lower (pmullw).
        let carry = ((u32::from(self.lower) * u32::from(m.lower)) >> 16) as u16;
        let upper = self.upper.wrapping_mul(m.lower).wrapping_add(self.lower.wrapping_mul(m.upper));
        Self { lower: self.lower.wrapping_mul(m.lower), upper: upper.wrapping_add(carry) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;
    use crate::block::SHORT_BLOCK;

    #[test]
    fn low_bits_of_a_block_are_those_of_its_numbers() {
        low_bits::<BLOCK>();
        low_bits::<SHORT_BLOCK>();
    }

    fn low_bits<const N: usize>() {
        let within = N as u32 - 1;
        for trial in 0..2000_u32 {
            let (first, seed) = (mix(trial) & !within, mix(!trial));
            for (x, low) in (first..=first | within).zip(scramble_low::<N>(first, seed)) {
                let others = scramble(first, seed) & !63;
                assert_eq!(others | u32::from(low), scramble(x, seed), "{x:#x} {seed:#x}");
            }
        }
    }

    #[test]
    fn siblings_are_scrambled_as_one_by_one() {
        for trial in 0..2000_u32 {
            let (x, seed) = (mix(trial), mix(!trial));
            let low = core::array::from_fn(|place| mix(place as u32 ^ trial) as u16);
            let mut siblings = [0; SHORT_BLOCK];
            scramble_siblings(x, &low, seed, &mut siblings);
            let one_by_one =
                low.map(|low| scramble_reversed(x ^ u32::from(low), seed).reverse_bits());
            assert_eq!(siblings, one_by_one, "{x:#x} {seed:#x}");
        }
    }

    #[test]
    fn prefixes_map_to_prefixes() {
        for trial in 0..2000_u32 {
            let (x, seed) = (mix(trial), mix(!trial));
            for bits in 0..32 {
                let sibling = x ^ mix(trial + 1) >> bits;
                let changed = scramble(x, seed) ^ scramble(sibling, seed);
                let shared = (x ^ sibling).leading_zeros();
                assert_eq!(changed.leading_zeros(), shared, "{x:#x} {sibling:#x} {seed:#x}");
            }
        }
    }
}
