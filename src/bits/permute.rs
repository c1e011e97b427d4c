//! Random access into a pseudo-random permutation of 0..len, for any length.
//!
//! Swap-or-not (V. T. Hoang, B. Morris and P. Rogaway, "An Enciphering Scheme Based on a Card
//! Shuffle", CRYPTO 2012): each round pairs x with k - x (mod len) for a round key k, and a hash of
//! the pair decides whether the two swap. Every round is an involution, so the whole is a
//! bijection for every length and key. Against the usual cycle-walking hash (A. Kensler,
//! "Correlated Multi-Jittered Sampling", Pixar TM 13-01, 2013) the cost is a constant, nothing
//! wraps at a length near 2^32, and short lengths reach all their permutations.

use super::hash::mix;

/// Rounds that a length needs until a chi-square test cannot tell the positions of elements, or of
/// pairs of elements, from uniform ones (the tests below; lengths of 8 and less need more, for
/// there the permutations themselves are counted).
const fn rounds(len: u32) -> u32 {
    if len <= 8 { 24 } else { 12 }
}

/// The place of `index` in the permutation of 0..`len` that `seed` selects.
///
/// Takes 12 rounds of two multiplications each (24 for `len` <= 8). An `index` that is not below
/// `len` is returned as it is.
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
        return index;
    }
    let mut x = index;
    let mut state = seed;
    let mut round = rounds(len);
    while round > 0 {
        state = mix(state.wrapping_add(0x9e37_79b9));
        let key = ((state as u64 * len as u64) >> 32) as u32;
        let partner = if key >= x { key - x } else { len - (x - key) };
        let upper = if x > partner { x } else { partner };
        if mix(upper ^ state.rotate_left(16)) & 1 != 0 {
            x = partner;
        }
        round -= 1;
    }
    x
}
