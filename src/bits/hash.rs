//! Integer hashes: counter-based random numbers and seeds.
//!
//! - [`mix`]: a bijection of `u32` with full avalanche: two multiplications, three xor-shifts; the
//!   constants are those of the hash prospector's 2-round search (bias 0.107; C. Wellons and
//!   contributors, "hash-prospector", 2018-2022).
//! - [`absorb`]: three Feistel rounds of `mix` that take a key into two words.

/// A bijection of `u32` that sends 0 to 0 and flips each output bit with probability about 1/2.
#[must_use]
#[inline]
pub const fn mix(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x21f0_aaad);
    x ^= x >> 15;
    x = x.wrapping_mul(0xd35a_2d97);
    x ^ (x >> 15)
}

/// Takes `key` into a state of two words: a bijection of the state for each key, and different
/// keys always lead to different states.
#[must_use]
#[inline]
pub const fn absorb([mut l, mut r]: [u32; 2], key: u32) -> [u32; 2] {
    l ^= mix(r.wrapping_add(key));
    r ^= mix(l.wrapping_add(0x9e37_79b9));
    l ^= mix(r.wrapping_add(0x7f4a_7c15));
    [l, r]
}

/// The number that [`mix`] sends to `x`.
#[cfg(any(feature = "serde", feature = "defmt"))]
pub(crate) const fn unmix(mut x: u32) -> u32 {
    x ^= x >> 15 ^ x >> 30;
    // The reciprocals of the factors of `mix` modulo 2^32.
    x = x.wrapping_mul(0x3713_2227);
    x ^= x >> 15 ^ x >> 30;
    x = x.wrapping_mul(0x333c_4925);
    x ^ (x >> 16)
}

/// The shifts of both axes for a seed: 0 for seed 0, else a hash and a hash of the hash.
///
/// With this rotation no seed but 0 shifts both axes alike: tests/sequence/noise.rs tries all.
#[inline]
pub(crate) const fn shift(seed: u32) -> [u32; 2] {
    let first = mix(seed);
    [first, mix(first.rotate_left(13))]
}

/// The other word of the state that takes a seed's purpose: any will do.
const KEYS: u32 = 0x6865_6d69;

/// A 32-bit key of a seed for a purpose: a name of four letters, no other set's, so that sets of
/// one seed have nothing in common.
#[inline]
pub(crate) const fn key(seed: u32, purpose: [u8; 4]) -> u32 {
    absorb([seed, KEYS], u32::from_be_bytes(purpose))[0]
}

/// A pair of independent uniform words of an index, by three keys.
///
/// Both axes hash the same hashed index, one under a sum and one under a xor, so that neither is a
/// reordering of the other.
#[inline(always)]
pub(crate) const fn pair([order, u, v]: [u32; 3], index: u32) -> [u32; 2] {
    let hashed = mix(index ^ order);
    [mix(hashed.wrapping_add(u)), mix(hashed ^ v)]
}

/// A counter hash from an index to a pair of independent uniform fractions of 16 bits: to jitter a
/// point within its cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Jitter {
    key: u32,
    /// Kept to be written: a key does not tell it.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    seed: u32,
}

impl Jitter {
    /// The jitter of a seed for a purpose, [`key`]'s.
    pub(crate) const fn new(seed: u32, purpose: [u8; 4]) -> Self {
        Self {
            key: key(seed, purpose),
            #[cfg(any(feature = "serde", feature = "defmt"))]
            seed,
        }
    }

    /// The seed that it was made of.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn seed(self) -> u32 {
        self.seed
    }

    /// Below 2^16 each.
    #[inline(always)]
    pub(crate) const fn at(self, index: u32) -> [u32; 2] {
        let word = mix(index ^ self.key);
        [word >> 16, word & 0xffff]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every flip of an input bit flips each output bit in 45-55 % of 4,096 inputs.
    fn avalanche(function: impl Fn(u32) -> u32) {
        for input_bit in 0..32 {
            let mut flips = [0_u32; 32];
            for i in 0..4096_u32 {
                let x = i.wrapping_mul(0x9e37_79b9);
                let changed = function(x) ^ function(x ^ (1 << input_bit));
                for (bit, count) in flips.iter_mut().enumerate() {
                    *count += changed >> bit & 1;
                }
            }
            for (bit, count) in flips.into_iter().enumerate() {
                assert!((1843..2253).contains(&count), "bit {input_bit} -> {bit}: {count} of 4096");
            }
        }
    }

    #[test]
    fn mix_avalanches() {
        avalanche(mix);
        assert_eq!(mix(0), 0);
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    #[test]
    fn what_was_hashed_is_found_again() {
        let words = (0..1000_u32).map(|i| i.wrapping_mul(0x9e37_79b9)).chain([u32::MAX, 1 << 31]);
        for word in words {
            assert_eq!(unmix(mix(word)), word);
        }
    }

    #[test]
    fn keys_avalanche_in_seed_and_stream() {
        avalanche(|seed| key(seed, *b"test"));
        avalanche(|purpose| key(7, purpose.to_be_bytes()));
    }

    #[test]
    fn pairs_avalanche() {
        let keys = [0x1234_5678, 0x9abc_def0, 0x0fed_cba9];
        avalanche(|index| pair(keys, index)[0]);
        avalanche(|index| pair(keys, index)[1]);
        avalanche(|index| pair(keys, index)[0].wrapping_add(pair(keys, index)[1]));
    }

    #[test]
    fn jitter_avalanches() {
        let word = |[u, v]: [u32; 2]| u << 16 | v;
        let jitter = Jitter::new(1, *b"test");
        avalanche(|index| word(jitter.at(index)));
        avalanche(|seed| word(Jitter::new(seed, *b"test").at(5)));
    }

    #[test]
    fn shifts_avalanche() {
        assert_eq!(shift(0), [0, 0]);
        avalanche(|seed| shift(seed)[0]);
        avalanche(|seed| shift(seed)[1]);
        avalanche(|seed| shift(seed)[0] ^ shift(seed)[1]);
    }
}
