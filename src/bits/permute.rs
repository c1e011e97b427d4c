//! Random access into a pseudo-random permutation of 0..len, for any length.
//!
//! **Lengths above 8**: swap-or-not (V. T. Hoang, B. Morris and P. Rogaway, "An Enciphering Scheme
//! Based on a Card Shuffle", CRYPTO 2012). Each round pairs x with k - x (mod len) for a round key k,
//! and a hash of the pair decides whether the two swap. Every round is an involution, so the whole is
//! a bijection for every length and key. Against the usual cycle-walking hash (A. Kensler,
//! "Correlated Multi-Jittered Sampling", Pixar TM 13-01, 2013) the cost is a constant, and nothing
//! wraps at a length near 2^32.
//!
//! **Lengths up to 8**: swap-or-not needs 13 rounds to reach all permutations of 8 evenly, so the
//! whole list is shuffled in the nibbles of one word (Fisher and Yates; R. Durstenfeld, "Algorithm
//! 235", 1964), every permutation as likely as 28 bits can tell: 8! / 2^28 is 0.015 %.

use super::hash::mix;

/// Rounds of swap-or-not. A chi-square test of places, or of pairs of places, can tell 10 from random
/// (tests/promises/permutation.rs); and a round leaves an element where it is with probability 1/2,
/// so log2(len) + 4 leave one element in 16 sets more in its place than chance does.
const fn rounds(len: u32) -> u32 {
    let enough = 36 - len.leading_zeros();
    if enough > 12 { enough } else { 12 }
}

/// The longest list whose places fit the nibbles of a word.
const SHORT: u32 = 8;

/// The place of `index` in the permutation of 0..`len` that `seed` selects.
///
/// Takes 12 rounds of two hashes each (log2(len) + 4 above 256), or two hashes and up to 7 swaps for
/// `len` <= 8. An `index` that is not below `len` is returned as it is.
///
/// ```
/// use hemidisc::bits::permute::permute;
/// let mut places = [0, 1, 2, 3, 4].map(|i| permute(i, 5, 7));
/// places.sort();
/// assert_eq!(places, [0, 1, 2, 3, 4]);
/// ```
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
    let mut state = seed;
    let mut left = rounds(len);
    while left > 0 {
        // The number of the round, or a seed would repeat one key, and each round undo the last.
        state = mix(state.wrapping_add(0x9e37_79b9) ^ left);
        let key = ((state as u64 * len as u64) >> 32) as u32;
        let partner = if key >= x { key - x } else { len - (x - key) };
        let upper = if x > partner { x } else { partner };
        if mix(upper ^ state.rotate_left(16)) & 1 != 0 {
            x = partner;
        }
        left -= 1;
    }
    x
}

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
