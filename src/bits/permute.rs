//! Random access into a pseudo-random permutation of 0..len, for any length.
//!
//! **Lengths above 8**: swap-or-not (V. T. Hoang, B. Morris and P. Rogaway, "An Enciphering Scheme
//! Based on a Card Shuffle", CRYPTO 2012). Each round pairs x with k - x (mod len) for a round key
//! k, and a hash of the pair decides whether the two swap. Every round is an involution, so the
//! whole is a bijection for every length and key. Unlike the usual cycle-walking hash (A. Kensler,
//! "Correlated Multi-Jittered Sampling", Pixar TM 13-01, 2013), its cost is constant, and nothing
//! overflows at a length near 2^32.
//!
//! **Lengths up to 8**: swap-or-not needs 13 rounds to reach all permutations of 8 evenly, so the
//! whole list is shuffled in the nibbles of one word (Fisher and Yates; R. Durstenfeld, "Algorithm
//! 235", 1964), every permutation as likely as 28 bits can tell: 8! / 2^28 is 0.015 %.

use super::{hash::mix, wide::high};
use crate::block::Block;
use crate::target::{HALVES, WIDE_WORDS};

/// Rounds of swap-or-not. A chi-square test of places, or of pairs of places, can tell 10 rounds
/// from random (tests/bits/permute.rs). A round leaves an element in place with probability
/// 1/2, so log2(len) + 4 rounds leave one more element in 16 sets in place than chance does.
const fn rounds(len: u32) -> u32 {
    let mut rounds = 12;
    if HALVES {
        // Such a core has no `clz`, and short lists end the count at once.
        while rounds < 36 && (len - 1) >> (rounds - 4) > 0 {
            rounds += 1;
        }
    } else if len > 256 {
        rounds = 36 - (len - 1).leading_zeros();
    }
    rounds
}

/// The longest list whose places fit the nibbles of a word.
const SHORT: u32 = 8;

/// The place of `index` in the permutation of 0..`len` that `seed` selects.
///
/// Takes 12 rounds of four multiplications each (log2(len) + 4 above 256), or two hashes and up to
/// 7 swaps for `len` <= 8. An `index` that is not below `len` is returned as it is.
///
/// ```
/// use hemidisc::bits::permute::permute;
/// let mut places = [0, 1, 2, 3, 4].map(|i| permute(i, 5, 7));
/// places.sort();
/// assert_eq!(places, [0, 1, 2, 3, 4]);
/// ```
#[must_use]
#[inline]
pub const fn permute(index: u32, len: u32, seed: u32) -> u32 {
    if index >= len {
        index
    } else if len <= SHORT {
        shuffled(index, len, seed)
    } else {
        swapped_or_not(index, len, seed)
    }
}

const fn swapped_or_not(index: u32, len: u32, seed: u32) -> u32 {
    let mut x = index;
    let mut word = first_word(seed);
    let mut left = rounds(len);
    while left > 0 {
        word = next_word(word);
        let (partner, swap) = pair(x, len, below(len, word), word);
        x = either(x, partner, swap);
        left -= 1;
    }
    x
}

/// Each round takes a word from a linear congruential generator of full period (the multiplier: G.
/// Steele and S. Vigna, "Computationally Easy, Spectrally Good Multipliers", 2022): no word comes
/// twice, or a round would undo another. Neighbouring seeds begin far apart.
#[inline(always)]
const fn first_word(seed: u32) -> u32 {
    mix(seed ^ 0x9e37_79b9)
}

#[inline(always)]
const fn next_word(word: u32) -> u32 {
    word.wrapping_mul(0x915f_77f5).wrapping_add(0x9e37_79b9)
}

/// The partner that a round may swap `x` with, and bits of which the highest decides the swap.
#[inline(always)]
const fn pair(x: u32, len: u32, key: u32, word: u32) -> (u32, u32) {
    let partner = if key >= x { key - x } else { len - (x - key) };
    let upper = if x > partner { x } else { partner };
    (partner, hash(upper ^ word))
}

/// [`permute`] of a block of places, all of them below `len`, by one seed. Each round runs over the
/// whole block, in vectors.
#[inline(always)]
pub(crate) fn permute_block(places: &mut Block, len: u32, seed: u32) {
    if len <= SHORT {
        places.iter_mut().for_each(|place| *place = shuffled(*place, len, seed));
        return;
    }
    let mut word = first_word(seed);
    for _ in 0..rounds(len) {
        word = next_word(word);
        let key = below(len, word);
        for place in places.iter_mut() {
            let (partner, swap) = pair(*place, len, key, word);
            *place = chosen(*place, partner, swap);
        }
    }
}

/// [`permute_block`] by a seed for each place.
#[inline(always)]
pub(crate) fn permute_each(places: &mut Block, len: u32, mut seeds: Block) {
    let both = places.iter_mut().zip(&mut seeds);
    if len <= SHORT {
        both.for_each(|(place, seed)| *place = shuffled(*place, len, *seed));
        return;
    }
    both.for_each(|(_, word)| *word = first_word(*word));
    for _ in 0..rounds(len) {
        for (place, word) in places.iter_mut().zip(&mut seeds) {
            *word = next_word(*word);
            let (partner, swap) = pair(*place, len, below(len, *word), *word);
            *place = chosen(*place, partner, swap);
        }
    }
}

/// [`either`] without a look-up, for vectors.
#[inline(always)]
const fn chosen(first: u32, second: u32, bits: u32) -> u32 {
    first ^ (first ^ second) & (bits.cast_signed() >> 31).cast_unsigned()
}

/// A number below `len`: floor(`len` bits / 2^32), by two products where `len` is half a word.
#[inline(always)]
const fn below(len: u32, bits: u32) -> u32 {
    if HALVES && len < 1 << 16 {
        ((bits >> 16) * len + (((bits & 0xffff) * len) >> 16)) >> 16
    } else {
        high(bits, len)
    }
}

/// Of two numbers the second where the highest bit of `bits` is set.
///
/// A wide core would mispredict a branch every other time. Compilers turn any visible choice into a
/// branch, but not a look-up.
#[inline(always)]
const fn either(first: u32, second: u32, bits: u32) -> u32 {
    if WIDE_WORDS {
        const MASKS: [u32; 2] = [0, u32::MAX];
        first ^ (first ^ second) & MASKS[(bits >> 31) as usize]
    } else if bits >> 31 == 0 {
        first
    } else {
        second
    }
}

/// A hash whose highest bit depends on all of `x`, for which two multiplications suffice.
#[inline(always)]
const fn hash(x: u32) -> u32 {
    let x = x.wrapping_mul(0x21f0_aaad);
    (x ^ (x >> 15)).wrapping_mul(0xd35a_2d97)
}

// Apart, for it is long once the compiler has unrolled it, and short lists are rare.
#[inline(never)]
const fn shuffled(index: u32, len: u32, seed: u32) -> u32 {
    const BITS: u32 = 28;
    let mut places = 0x7654_3210_u32;
    // A fraction of 28 bits; its digits in the mixed radix len, len - 1, ... pick what to swap.
    let mut fraction = mix(mix(seed.wrapping_add(0x9e37_79b9))) >> (32 - BITS);
    let mut left = len;
    while left > 1 {
        fraction *= left;
        let pick = 4 * (fraction >> BITS);
        fraction &= (1 << BITS) - 1;
        left -= 1;
        let last = 4 * left;
        let difference = (places >> last ^ places >> pick) & 0xf;
        places ^= difference << last | difference << pick;
    }
    places >> (4 * index) & 0xf
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::block::BLOCK;

    #[test]
    fn blocks_are_permuted_as_their_places_are() {
        let lengths = [1, 2, 7, 8, 9, 64, 100, 256, 257, 4096, 65_537, (1 << 31) + 5, u32::MAX];
        for (len, seed) in lengths.into_iter().flat_map(|len| [(len, 7), (len, mix(len))]) {
            let places: Block = core::array::from_fn(|lane| mix(lane as u32) % len);
            let mut block = places;
            permute_block(&mut block, len, seed);
            assert_eq!(block, places.map(|place| permute(place, len, seed)), "{len} {seed}");
            let seeds: Block = core::array::from_fn(|lane| mix(seed + lane as u32));
            let mut each = places;
            permute_each(&mut each, len, seeds);
            for lane in 0..BLOCK {
                assert_eq!(each[lane], permute(places[lane], len, seeds[lane]), "{len} {lane}");
            }
        }
    }
}
