//! Owen scrambling of base-2 digits by a hash (nested uniform scrambling).
//!
//! In the reversed-bit domain a bit may depend only on the bits below it, which additions and
//! multiplications do by nature: a Laine-Karras hash (S. Laine and T. Karras, "Stratified Sampling
//! for Stochastic Transparency", 2011; B. Burley, "Practical Hash-based Owen Scrambling", JCGT
//! 9(4), 2020) with the constants of N. Vegdahl's 2021 search, as in the crate `sobol_burley`.
//! `seed` must be well mixed already: consecutive integers will not do.

/// Owen-scrambles `x`, whose bits are reversed: bit b of the result depends on bits 0..=b of `x`.
#[inline(always)]
pub const fn scramble_reversed(mut x: u32, seed: u32) -> u32 {
    x ^= x.wrapping_mul(0x3d20_adea);
    x = x.wrapping_add(seed);
    x = x.wrapping_mul((seed >> 16) | 1);
    x ^= x.wrapping_mul(0x0552_6c56);
    x ^ x.wrapping_mul(0x53a2_2864)
}

/// Owen-scrambles `x` as a binary fraction: permutes dyadic intervals of every size among their
/// siblings, so every net stays a net.
#[inline(always)]
pub const fn scramble(x: u32, seed: u32) -> u32 {
    scramble_reversed(x.reverse_bits(), seed).reverse_bits()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;

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
