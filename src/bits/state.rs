//! A 64-bit state: keys enter by a linear congruential step, words leave by a finaliser.
//!
//! A renderer derives a state for each bounce and effect, and draws from few of them. So a step is
//! one multiplication, and the finaliser alone makes the words of related states independent.
//!
//! - [`step`]: s -> (s + k) M + 1 modulo 2^64, a full-period generator for k = 0. States that
//!   differ in their last key never meet, nor do those that differ in the last two. Of the last
//!   three, keys below 2^21 never meet either: `tests/derive/domain.py` has the multiplier's
//!   lattice.
//! - [`finish`]: a bijection with full avalanche. Its form is that of A. Appleby's MurmurHash3
//!   (2008): multiplications between xor-shifts, here by half the width, which a 32-bit core does
//!   in one instruction.

use super::wide::product;
use crate::target::HALVES;

/// Of 32 bits, so that a small core multiplies less.
const STEP: u32 = 0xed78_52cd;
const FINISH: [u64; 2] = [0xd6e8_feb8_6659_fd93, 0x9fb2_1c65_1e98_df25];

/// A state of its two words, the lower first.
#[inline(always)]
pub(crate) const fn of_words([lower, upper]: [u32; 2]) -> u64 {
    (upper as u64) << 32 | lower as u64
}

/// The two words of a state, the lower first.
#[inline(always)]
pub(crate) const fn to_words(state: u64) -> [u32; 2] {
    [state as u32, (state >> 32) as u32]
}

/// a b modulo 2^64.
#[inline(always)]
const fn times(a: u64, b: u64) -> u64 {
    if HALVES {
        let [[a0, a1], [b0, b1]] = [to_words(a), to_words(b)];
        let upper = a1.wrapping_mul(b0).wrapping_add(a0.wrapping_mul(b1));
        product(a0, b0).wrapping_add((upper as u64) << 32)
    } else {
        a.wrapping_mul(b)
    }
}

/// Takes a key into a state: a bijection of the state for each key, and of the key for each state.
#[must_use]
#[inline(always)]
pub const fn step(state: u64, key: u64) -> u64 {
    times(state.wrapping_add(key), STEP as u64).wrapping_add(1)
}

/// The words of a state: a bijection that flips each output bit with probability about 1/2.
#[must_use]
#[inline(always)]
pub const fn finish(mut state: u64) -> u64 {
    state ^= state >> 32;
    state = times(state, FINISH[0]);
    state ^= state >> 32;
    state = times(state, FINISH[1]);
    state ^ state >> 32
}

/// The state that [`finish`] sends to `words`.
#[cfg(any(feature = "serde", feature = "defmt"))]
pub(crate) const fn unfinish(mut words: u64) -> u64 {
    words ^= words >> 32;
    words = words.wrapping_mul(UNFINISH[1]);
    words ^= words >> 32;
    words = words.wrapping_mul(UNFINISH[0]);
    words ^ words >> 32
}

/// The reciprocals of [`FINISH`] modulo 2^64.
#[cfg(any(feature = "serde", feature = "defmt"))]
const UNFINISH: [u64; 2] = [reciprocal(FINISH[0]), reciprocal(FINISH[1])];

/// 1 / n modulo 2^64 of an odd number: each Newton step doubles the bits that are right, of which n
/// itself has three.
#[cfg(any(feature = "serde", feature = "defmt"))]
const fn reciprocal(n: u64) -> u64 {
    let (mut inverse, mut bits) = (n, 3);
    while bits < 64 {
        inverse = inverse.wrapping_mul(2_u64.wrapping_sub(n.wrapping_mul(inverse)));
        bits *= 2;
    }
    inverse
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;

    fn states() -> impl Iterator<Item = u64> {
        let edges = [0, 1, u64::MAX, 1 << 32, (1 << 32) - 1, 1 << 63];
        edges.into_iter().chain((0..10_000).map(|i| of_words([mix(i), mix(!i)])))
    }

    #[test]
    fn products_by_halves_are_the_same() {
        for (a, b) in states().zip(states().skip(1)) {
            let [[a0, a1], [b0, b1]] = [a, b].map(to_words);
            let upper = a1.wrapping_mul(b0).wrapping_add(a0.wrapping_mul(b1));
            let sum = product(a0, b0).wrapping_add(u64::from(upper) << 32);
            assert_eq!(sum, a.wrapping_mul(b));
            assert_eq!(times(a, b), sum);
        }
    }

    /// Odd multipliers, of which that of the step is 5 modulo 8 and the increment odd: the step is
    /// a bijection, and for key 0 all 2^64 states are one cycle.
    #[test]
    fn steps_are_bijections() {
        assert_eq!(STEP % 8, 5);
        assert!(FINISH.iter().all(|multiplier| multiplier % 2 == 1));
        for state in states() {
            let expected = state.wrapping_add(5).wrapping_mul(STEP.into()).wrapping_add(1);
            assert_eq!(step(state, 5), expected);
        }
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    #[test]
    fn what_was_finished_is_found_again() {
        for state in states() {
            assert_eq!(unfinish(finish(state)), state);
        }
    }
}
