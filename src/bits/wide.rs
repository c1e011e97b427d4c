//! The product of two `u32`, and its upper half.
//!
//! A core without a 32 x 32 -> 64 multiplier (Armv6-M) calls a 64 x 64 routine for the product of
//! two `u32`; four products of halves are a third of its cost. A factor from a table comes in
//! halves: the compiler would join those of one word and call the routine all the same. Every form
//! gives the same bits.

use crate::target::HALVES;

/// a b.
#[inline(always)]
pub(crate) const fn product(a: u32, b: u32) -> u64 {
    if HALVES { product_by_halves(a, b) } else { a as u64 * b as u64 }
}

#[inline(always)]
const fn product_by_halves(a: u32, b: u32) -> u64 {
    let (a1, a0) = (a >> 16, a & 0xffff);
    let (b1, b0) = (b >> 16, b & 0xffff);
    let least = a0 * b0;
    // Each sum is at most (2^16 - 1)^2 + 2^16 - 1 < 2^32.
    let middle = a1 * b0 + (least >> 16);
    let other = a0 * b1 + (middle & 0xffff);
    let upper = a1 * b1 + (middle >> 16) + (other >> 16);
    (upper as u64) << 32 | (other << 16 | least & 0xffff) as u64
}

/// floor(a b / 2^32).
#[inline(always)]
pub(crate) const fn high(a: u32, b: u32) -> u32 {
    if HALVES {
        high_by_halves(a, [(b >> 16) as u16, b as u16])
    } else {
        (product(a, b) >> 32) as u32
    }
}

/// [`high`] by products of 16 bits, of a factor in halves, the upper first.
#[inline(always)]
pub(crate) const fn high_by_halves(a: u32, [b1, b0]: [u16; 2]) -> u32 {
    let (a1, a0) = (a >> 16, a & 0xffff);
    let (b1, b0) = (b1 as u32, b0 as u32);
    // Each sum is at most (2^16 - 1)^2 + 2^16 - 1 < 2^32.
    let middle = a1 * b0 + ((a0 * b0) >> 16);
    let other = a0 * b1 + (middle & 0xffff);
    a1 * b1 + (middle >> 16) + (other >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;

    #[test]
    fn every_form_gives_the_same_bits() {
        let edges = [0, 1, 2, 0xffff, 0x1_0000, 0x1_0001, 1 << 31, u32::MAX, u32::MAX << 16];
        let pairs = edges.into_iter().flat_map(|a| edges.map(|b| (a, b)));
        let hashed = (0..100_000).map(|i| (mix(i) >> (i % 32), mix(!i) >> (i / 32 % 32)));
        for (a, b) in pairs.chain(hashed) {
            let exact = u64::from(a) * u64::from(b);
            assert_eq!(product(a, b), exact);
            assert_eq!(product_by_halves(a, b), exact);
            assert_eq!(u64::from(high(a, b)), exact >> 32, "{a:#x} {b:#x}");
            let by_halves = high_by_halves(a, [(b >> 16) as u16, b as u16]);
            assert_eq!(u64::from(by_halves), exact >> 32, "{a:#x} {b:#x}");
        }
    }
}
