//! Wide products: 32 x 32 and 64 x 64 bits, and the upper half of either.
//!
//! The unsigned ones of 32 bits are `bits::wide`'s, which says why there are forms by halves.

pub(in crate::arithmetic) use crate::bits::wide::{high, high_by_halves, product};
pub(in crate::arithmetic) use crate::target::{COUNTS_ZEROS, HALVES};

use crate::target::WIDE_WORDS;

/// floor(a b / 2^32); |a| is below 2^31 - 2^16.
#[inline(always)]
pub(in crate::arithmetic) const fn high_signed(a: i32, b: u32) -> i32 {
    ((a as i64 * b as i64) >> 32) as i32
}

/// [`high_signed`] by products of 16 bits, of a factor in halves, the upper first.
#[inline(always)]
pub(in crate::arithmetic) const fn high_signed_by_halves(a: i32, [b1, b0]: [u16; 2]) -> i32 {
    let (a1, a0) = (a >> 16, a.cast_unsigned() & 0xffff);
    let middle = a1 * b0 as i32 + ((a0 * b0 as u32) >> 16).cast_signed();
    let other = a0 * b1 as u32 + (middle.cast_unsigned() & 0xffff);
    a1 * b1 as i32 + (middle >> 16) + (other >> 16).cast_signed()
}

/// floor(a b / 2^64).
#[inline(always)]
pub(in crate::arithmetic) const fn high_64(a: u64, b: u64) -> u64 {
    if WIDE_WORDS { ((a as u128 * b as u128) >> 64) as u64 } else { high_64_by_words(a, b) }
}

#[inline(always)]
const fn high_64_by_words(a: u64, b: u64) -> u64 {
    let (a1, a0) = ((a >> 32) as u32, a as u32);
    let (b1, b0) = ((b >> 32) as u32, b as u32);
    let middle = product(a1, b0) + (product(a0, b0) >> 32);
    let other = product(a0, b1) + (middle & 0xffff_ffff);
    product(a1, b1) + (middle >> 32) + (other >> 32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_form_gives_the_same_bits() {
        let mut state = 1_u64;
        let edges = [0, 1, 2, 0xffff, 0x1_0000, 0x1_0001, 1 << 31, u64::MAX, u64::MAX << 32];
        let mut last = 0;
        for i in 0..100_000_usize {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let next = if i < 81 { edges[i % 9] } else { state >> (i % 64) };
            let (a, b) = if i < 81 { (edges[i / 9], next) } else { (last, next) };
            last = state ^ state >> 31;
            let (words, wide) = ((a as u32, b as u32), u128::from(a) * u128::from(b));
            let halves = [(words.1 >> 16) as u16, words.1 as u16];
            for signed in [words.0.cast_signed() / 2, -(words.0.cast_signed() / 2)] {
                let exact = (i64::from(signed) * i64::from(words.1)) >> 32;
                assert_eq!(i64::from(high_signed(signed, words.1)), exact);
                assert_eq!(i64::from(high_signed_by_halves(signed, halves)), exact);
            }
            assert_eq!(high_64_by_words(a, b), (wide >> 64) as u64);
            assert_eq!(high_64(a, b), (wide >> 64) as u64);
        }
    }
}
