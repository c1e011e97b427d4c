//! The floor of a square root.
//!
//! A table gives y near 1 / sqrt x. Two Newton steps, y (3 - x y^2) / 2, make it good to 24 bits;
//! then g = x y, a step g + (n - g^2) y / 2 for the root itself, and a correction by one to the
//! exact floor.
//!
//! tests/derive/fixed.py derives the table. A suffix `_q30` says that a variable counts units of
//! 2^-30.

use super::wide::{COUNTS_ZEROS, HALVES, high, product};

/// 1 / sqrt x in units of 2^-15 for x in the middle of [k, k + 1) / 128, k from 32 on: floor, of 16
/// bits.
static SEEDS: [u16; 128] = {
    let mut table = [0; 128];
    let mut k = 32;
    while k < 128 {
        // sqrt(2^30 / x), x = (2 k + 1) / 256.
        let mut seed = ((1_u64 << 38) / (2 * k as u64 + 1)).isqrt();
        if seed > 0xffff {
            seed = 0xffff;
        }
        table[k] = seed as u16;
        k += 1;
    }
    table
};

/// floor(sqrt n): in units of 2^-32 for n in units of 2^-64.
#[inline]
pub(in crate::arithmetic) const fn root(n: u64) -> u32 {
    root_by::<HALVES>(n)
}

/// The result is the floor, whichever products are used.
#[inline(always)]
const fn root_by<const BY_HALVES: bool>(n: u64) -> u32 {
    if n == 0 {
        return 0;
    }
    // From 1/4 to 1, in units of 2^-64.
    let (normal, shift) = if COUNTS_ZEROS && !BY_HALVES { counted(n) } else { shifted(n) };
    let x_q32 = (normal >> 32) as u32;
    let seed_q15 = SEEDS[(x_q32 >> 25) as usize] as u32;
    let three_q30 = 3 << 30;
    // 3 - x y^2 in 2^-14 times y in 2^-15 is 2^-29, and its half 2^-30.
    let less_q30 = three_q30 - near_high::<BY_HALVES>(x_q32, seed_q15 * seed_q15);
    let y_q30 = seed_q15 * (less_q30 >> 16);
    // 2^-31 2^-31 = 2^-62, of which the upper half.
    let square_q30 = near_high::<BY_HALVES>(y_q30 << 1, y_q30 << 1);
    let less_q30 = three_q30 - near_high::<BY_HALVES>(x_q32, square_q30);
    // 2^-30 2^-30 = 2^-60, the upper half 2^-28, and its half 2^-29.
    let y_q29 = near_high::<BY_HALVES>(y_q30, less_q30);
    // Good to 24 bits; the residual of the square gives the rest.
    let g = near_high::<BY_HALVES>(x_q32, y_q29) << 3;
    let residual_q64 = normal.wrapping_sub(product(g, g)).cast_signed();
    // Each is at most 2^15 units. Of the product, in 2^-52, 20 places lead to 2^-32, and one more
    // to the half that a step is.
    let (residual_q38, y_q14) = ((residual_q64 >> 26) as i32, (y_q29 >> 15).cast_signed());
    let step = (residual_q38 * y_q14) >> 21;
    let g = g as i64 + step as i64;
    let mut g = if g > 0xffff_ffff { u32::MAX } else { g as u32 };
    // Within one of the floor.
    if product(g, g) > normal {
        g -= 1;
    } else if normal - product(g, g) > 2 * g as u64 {
        g += 1;
    }
    g >> (shift / 2)
}

/// a b / 2^32, by halves too low by at most 2: the compiler joins halves of two words, of which all
/// four products are formed, to a product of 64 bits.
#[inline(always)]
const fn near_high<const BY_HALVES: bool>(a: u32, b: u32) -> u32 {
    if BY_HALVES {
        let ((a1, a0), (b1, b0)) = ((a >> 16, a & 0xffff), (b >> 16, b & 0xffff));
        a1 * b1 + ((a1 * b0) >> 16) + ((a0 * b1) >> 16)
    } else {
        high(a, b)
    }
}

/// n 2^shift in [2^62, 2^64) by an even shift; n > 0.
#[inline(always)]
const fn counted(n: u64) -> (u64, u32) {
    let shift = n.leading_zeros() & !1;
    (n << shift, shift)
}

/// The same for a core that does not count zeros in one instruction: most of a disc has none.
#[inline(always)]
const fn shifted(n: u64) -> (u64, u32) {
    let (mut normal, mut shift) = (n, 0);
    while normal >> 62 == 0 {
        normal <<= 2;
        shift += 2;
    }
    (normal, shift)
}

#[cfg(test)]
mod tests {
    use super::{SEEDS, root_by};
    use crate::arithmetic::fixed::derived::{FIXED_TABLES, assert_derived};

    #[test]
    fn seeds_are_those_of_the_script() {
        assert_derived(FIXED_TABLES, "SEEDS", &SEEDS);
    }

    /// By either kind of product.
    fn root(n: u64) -> u32 {
        let root = root_by::<false>(n);
        assert_eq!(root, root_by::<true>(n), "{n:#x}");
        root
    }

    #[test]
    fn it_is_the_floor() {
        let mut state = 7_u64;
        for i in 0..3_000_000_u64 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let n = state >> (i % 64);
            assert_eq!(u64::from(root(n)), n.isqrt(), "{n:#x}");
        }
        // Squares and their neighbours, at every scale and every edge of the table.
        for k in 0..1_u64 << 16 {
            for g in [k, k << 16, k << 16 | 0xffff, !k & 0xffff_ffff] {
                for n in [g * g, (g * g).wrapping_sub(1), g * g + g, (g * g).wrapping_add(2 * g)] {
                    assert_eq!(u64::from(root(n)), n.isqrt(), "{n:#x}");
                }
            }
        }
        for n in [1, 2, 3, u64::MAX, u64::MAX - 1, 1 << 63, 1 << 62] {
            assert_eq!(u64::from(root(n)), n.isqrt(), "{n:#x}");
        }
    }
}
