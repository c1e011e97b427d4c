//! Positive numbers of any size, and their logarithm and exponential: what the power lobe needs.
//!
//! - -ln(1 - x): below x = 2^-7 by its series, so that small x keep all digits; else by a table of
//!   64 reciprocals c that take 1 - x to 1 + u with 0 <= u < 2^-5.9, and the series of ln(1 + u).
//! - exp(-x) = 2^-n 2^(-j/32) exp(-y), 0 <= y < 2^-5.5: a table and a series.
//! - 1 - exp(-x): below x = 2^-4 by its series, else by difference.
//!
//! Series stop where the next term is below 2^-38: what is left is less than a hundredth of an LSB
//! of Q31. All variables of 64 bits are in units of 2^-64 unless a comment or a suffix says
//! another.
//!
//! tests/derive/fixed.py derives the tables and constants.

use super::wide::high_64;

/// A number mantissa 2^(exponent - 64) whose mantissa has its top bit set; 0 has none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::arithmetic) struct Scaled {
    pub(in crate::arithmetic) mantissa: u64,
    pub(in crate::arithmetic) exponent: i32,
}

/// ln 2 in units of 2^-64, floor.
const LN_2: u64 = 0xb172_17f7_d1cf_79ab;
/// 1 / ln 2 in units of 2^-63, floor.
const LOG2_E: u64 = 0xb8aa_3b29_5c17_f0bb;

/// 1 / n in units of 2^-64, floor (for n = 2^k one less).
const fn over(n: u64) -> u64 {
    u64::MAX / n
}

/// c in units of 2^-15: 1 / m for the lowest m of a part of [1/2, 1), rounded up, so that m c >= 1.
/// The lowest m is (64 + part) / 128.
const fn factor(part: usize) -> u64 {
    ((1 << 22) as u64).div_ceil(64 + part as u64)
}

/// ln c of each part in units of 2^-63.
static LOGARITHMS: [u64; 64] = {
    let mut table = [0; 64];
    let mut part = 0;
    while part < 64 {
        // 2 atanh w, w = (c - 1) / (c + 1) in units of 2^-63; c and one in units of 2^-15.
        let (c, one) = (factor(part) as u128, 1_u128 << 15);
        let w = ((c - one) << 63) / (c + one);
        let (mut power, mut sum, mut odd) = (w << 1, 0, 1);
        while power > 0 {
            sum += power / odd;
            odd += 2;
            power = (((power * w) >> 63) * w) >> 63;
        }
        table[part] = sum as u64;
        part += 1;
    }
    table
};

/// 2^(-j/32) in units of 2^-63.
static POWERS: [u64; 32] = {
    let mut table = [0; 32];
    let mut j = 0;
    while j < 32 {
        // The series of exp(-x), x = j ln 2 / 32; all in units of 2^-63.
        let x = (LN_2 as i128 >> 1) * j as i128 / 32;
        let (mut power, mut sum, mut order) = (1_i128 << 63, 0, 1);
        while power != 0 {
            sum += power;
            power = -power * x / (order << 63);
            order += 1;
        }
        table[j] = sum as u64;
        j += 1;
    }
    table
};

impl Scaled {
    /// mantissa 2^(exponent - 64), whatever its leading zeros.
    #[inline]
    pub(in crate::arithmetic) const fn new(mantissa: u64, exponent: i32) -> Self {
        let zeros = mantissa.leading_zeros();
        if zeros == 64 {
            return Self { mantissa: 0, exponent: 0 };
        }
        Self { mantissa: mantissa << zeros, exponent: exponent - zeros.cast_signed() }
    }

    /// 1 / self; self is not 0.
    pub(in crate::arithmetic) const fn reciprocal(self) -> Self {
        // In (2^63, 2^64], less 1 where it would be 2^64.
        let quotient = (u128::MAX / (self.mantissa | 1 << 63) as u128) >> 1;
        let mantissa = if quotient >> 64 == 0 { quotient as u64 } else { u64::MAX };
        Self::new(mantissa, 1 - self.exponent)
    }

    #[inline]
    pub(in crate::arithmetic) const fn times(self, other: Self) -> Self {
        Self::new(high_64(self.mantissa, other.mantissa), self.exponent + other.exponent)
    }

    #[inline]
    pub(in crate::arithmetic) const fn doubled(self) -> Self {
        Self { exponent: self.exponent + 1, ..self }
    }

    /// floor(self 2^bits), at most 2^64 - 1.
    #[inline]
    pub(in crate::arithmetic) const fn floor(self, bits: i32) -> u64 {
        let shift = 64 - bits - self.exponent;
        match shift {
            ..0 => {
                if self.mantissa == 0 {
                    0
                } else {
                    u64::MAX
                }
            }
            0..64 => self.mantissa >> shift,
            _ => 0,
        }
    }
}

/// -ln(1 - x), x and 1 - x in units of 2^-64; that of 2^-64 for 1 - x = 0.
#[inline]
pub(in crate::arithmetic) const fn log(x: u64, rest: u64) -> Scaled {
    if x >> 57 == 0 {
        // x (1 + x/2 + x^2/3 + x^3/4 + x^4/5)
        let h = over(4) + high_64(x, over(5));
        let h = over(3) + high_64(x, h);
        let h = over(2) + high_64(x, h);
        let h = high_64(x, h);
        let x = Scaled::new(x, 0);
        return Scaled::new((x.mantissa >> 1) + (high_64(x.mantissa, h) >> 1), x.exponent + 1);
    }
    let rest = if rest == 0 { 1 } else { rest };
    let zeros = rest.leading_zeros();
    let normal = rest << zeros;
    // m = 1 - x scaled to [1/2, 1): 6 bits below its top bit are the part.
    let part = (normal >> 57 & 63) as usize;
    // m in units of 2^-48 times c in units of 2^-15 is 1 + u in units of 2^-63. Less 1, and in
    // units of 2^-64.
    let u = ((normal >> 16) * factor(part)).wrapping_sub(1 << 63) << 1;
    // ln(1 + u) = u (1 - u/2 + u^2/3 - u^3/4 + u^4/5 - u^5/6)
    let h = over(5) - high_64(u, over(6));
    let h = over(4) - high_64(u, h);
    let h = over(3) - high_64(u, h);
    let h = over(2) - high_64(u, h);
    let log = u - high_64(u, high_64(u, h));
    // In units of 2^-58: at most 64 ln 2.
    let sum = zeros as u64 * (LN_2 >> 6) + (LOGARITHMS[part] >> 5) - (log >> 6);
    Scaled::new(sum, 6)
}

/// exp(-x) in units of 2^-64, at most 1 less one of them.
#[inline]
pub(in crate::arithmetic) const fn exp(x: Scaled) -> u64 {
    if x.exponent > 6 {
        return 0;
    }
    // x / ln 2 in units of 2^-57.
    let binary = high_64(x.floor(58), LOG2_E);
    // Its bits: 57 and up are n, 52 to 56 are j, and those below, times ln 2, are y.
    let y = high_64((binary & ((1 << 52) - 1)) << 7, LN_2);
    // 1 - exp(-y) = y (1 - y/2 + y^2/6 - y^3/24 + y^4/120 - y^5/720)
    let h = over(120) - high_64(y, over(720));
    let h = over(24) - high_64(y, h);
    let h = over(6) - high_64(y, h);
    let h = over(2) - high_64(y, h);
    let fall = y - high_64(y, high_64(y, h));
    // 2^(-j/32) exp(-y) in units of 2^-63.
    let power = POWERS[(binary >> 52 & 31) as usize];
    let power = power - high_64(power, fall);
    match binary >> 57 {
        0 => {
            if power >> 63 == 0 {
                power << 1
            } else {
                u64::MAX
            }
        }
        n @ 1..64 => power >> (n - 1),
        _ => 0,
    }
}

/// 1 - exp(-x), of which exp(-x) is known in units of 2^-64.
#[inline]
pub(in crate::arithmetic) const fn fall(x: Scaled, exp: u64) -> Scaled {
    if exp == 0 {
        return Scaled { mantissa: 1 << 63, exponent: 1 };
    }
    if x.exponent > -4 {
        return Scaled::new(exp.wrapping_neg(), 0);
    }
    // x (1 - x/2 + x^2/6 - x^3/24 + x^4/120 - x^5/720 + x^6/5040)
    let small = x.floor(64);
    let h = over(720) - high_64(small, over(5040));
    let h = over(120) - high_64(small, h);
    let h = over(24) - high_64(small, h);
    let h = over(6) - high_64(small, h);
    let h = over(2) - high_64(small, h);
    Scaled::new(x.mantissa - high_64(x.mantissa, high_64(small, h)), x.exponent)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::fixed::derived::{FIXED_TABLES, assert_derived};

    #[test]
    fn tables_are_those_of_the_script() {
        assert_derived(FIXED_TABLES, "LN_2", &[LN_2]);
        assert_derived(FIXED_TABLES, "LOG2_E", &[LOG2_E]);
        assert_derived(FIXED_TABLES, "FACTORS", &core::array::from_fn::<_, 64, _>(factor));
        assert_derived(FIXED_TABLES, "LOGARITHMS", &LOGARITHMS);
        assert_derived(FIXED_TABLES, "POWERS", &POWERS);
    }
}
