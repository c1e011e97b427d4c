//! Fixed point: the numbers of Q15 and Q31, and their exponents.
//!
//! A number is an integer count of LSBs of 2^-15 or 2^-31: the layout of I1F15 and I1F31 of the
//! crate `fixed`, so bits pass between the two as they are. The range is [-1, 1 - LSB]; 1 is not in
//! it, so what would round to 1 becomes 1 - LSB. The maps never give -1 either, so every point has
//! its mirror image.

pub(super) mod root;
pub(super) mod rotation;
pub(super) mod scaled;
pub(super) mod wide;

use crate::error::Error;
use core::fmt;
use core::str::FromStr;
use wide::COUNTS_ZEROS;

macro_rules! number {
    ($(#[$doc:meta])* $number:ident, $bits:ident, $one:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "bytemuck", derive(bytemuck::Pod, bytemuck::Zeroable))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[repr(transparent)]
        pub struct $number($bits);

        impl $number {
            /// 0.
            pub const ZERO: Self = Self(0);
            /// The smallest step.
            pub const LSB: Self = Self(1);
            /// The largest number, 1 - LSB, which stands for 1.
            pub const MAX: Self = Self($bits::MAX);

            /// The number of a count of LSBs.
            #[must_use]
            #[inline]
            pub const fn from_bits(bits: $bits) -> Self {
                Self(bits)
            }

            /// The count of LSBs.
            #[must_use]
            #[inline]
            pub const fn to_bits(self) -> $bits {
                self.0
            }

            /// The same value, exactly.
            #[must_use]
            #[inline]
            pub const fn to_f64(self) -> f64 {
                self.0 as f64 * (1.0 / $one)
            }
        }

        impl From<$number> for f64 {
            /// Exact.
            #[inline]
            fn from(number: $number) -> f64 {
                number.to_f64()
            }
        }

        impl core::ops::Neg for $number {
            type Output = Self;

            /// The mirror image. That of -1, which no map gives, is 1 - LSB.
            #[inline]
            fn neg(self) -> Self {
                Self(self.0.saturating_neg())
            }
        }

        /// The exact decimal value, or rounded to the requested places.
        impl fmt::Display for $number {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                if f.precision().is_some() {
                    return fmt::Display::fmt(&self.to_f64(), f);
                }
                // An odd count of 2^-n has n decimal places; the shortest decimal that reads back
                // as the same f64 would have fewer.
                let places = ($bits::BITS - 1).saturating_sub(self.0.trailing_zeros());
                let width = f.width().unwrap_or(0);
                write!(f, "{:width$.*}", places as usize, self.to_f64())
            }
        }
    };
}

number! {
    /// Fixed point of 16 bits, and the arithmetic on it: a sign and 15 bits of fraction, as
    /// `fixed`'s I1F15.
    Q15, i16, 32_768.0
}
number! {
    /// Fixed point of 32 bits, and the arithmetic on it: a sign and 31 bits of fraction, as
    /// `fixed`'s I1F31.
    Q31, i32, 2_147_483_648.0
}

impl Q15 {
    /// The same value, exactly.
    #[must_use]
    #[inline]
    pub const fn to_f32(self) -> f32 {
        self.0 as f32 * (1.0 / 32_768.0)
    }
}

impl From<Q15> for f32 {
    /// Exact.
    #[inline]
    fn from(number: Q15) -> f32 {
        number.to_f32()
    }
}

impl Q31 {
    /// The nearest `f32` toward zero, so that a point of the disc stays on it; by integers alone.
    #[must_use]
    #[inline]
    pub const fn to_f32(self) -> f32 {
        self.to_f32_by::<COUNTS_ZEROS>()
    }

    #[inline(always)]
    const fn to_f32_by<const COUNTING: bool>(self) -> f32 {
        let mut magnitude = self.0.unsigned_abs();
        if magnitude == 0 {
            return 0.0;
        }
        // Sign and exponent, the latter less the mantissa's upper bit.
        let mut upper = (self.0.cast_unsigned() & 0x8000_0000) + (126 << 23);
        if COUNTING {
            let zeros = magnitude.leading_zeros();
            magnitude <<= zeros;
            upper -= zeros << 23;
        } else {
            // Most magnitudes have one or none.
            while magnitude >> 31 == 0 {
                magnitude <<= 1;
                upper -= 1 << 23;
            }
        }
        f32::from_bits(upper + (magnitude >> 8))
    }
}

/// An exponent of the power lobe in fixed point: 0 <= e < 2^32 in steps of 2^-32.
///
/// ```
/// use hemidisc::arithmetic::FixedExponent;
/// assert_eq!(FixedExponent::from(10), FixedExponent::from_bits(10 << 32));
/// assert_eq!(FixedExponent::try_from(0.5)?, FixedExponent::from_bits(1 << 31));
/// assert!(FixedExponent::try_from(-0.5).is_err());
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FixedExponent(u64);

impl FixedExponent {
    /// The exponent of a count of 2^-32.
    #[must_use]
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    /// The count of 2^-32.
    #[must_use]
    pub const fn to_bits(self) -> u64 {
        self.0
    }
}

impl From<u32> for FixedExponent {
    fn from(e: u32) -> Self {
        Self(u64::from(e) << 32)
    }
}

impl TryFrom<f64> for FixedExponent {
    type Error = Error;

    /// The nearest multiple of 2^-32.
    ///
    /// # Errors
    /// [`Error::FixedExponent`] for a value that is not a number in [0, 2^32).
    fn try_from(e: f64) -> Result<Self, Error> {
        if (0.0..4_294_967_296.0).contains(&e) {
            // The product, its floor and what is above that are exact; a sum with 1/2 is not.
            let scaled = e * 4_294_967_296.0;
            let floor = scaled as u64;
            Ok(Self(floor + u64::from(scaled - floor as f64 >= 0.5)))
        } else {
            Err(Error::FixedExponent { value: e })
        }
    }
}

impl FromStr for FixedExponent {
    type Err = Error;

    /// A decimal, rounded to the nearest multiple of 2^-32.
    fn from_str(text: &str) -> Result<Self, Error> {
        Self::try_from(text.parse().unwrap_or(f64::NAN))
    }
}

/// What the scripts of `tests/derive` wrote for the tables and constants.
#[cfg(test)]
pub(super) mod derived {
    use std::vec::Vec;

    pub(in crate::arithmetic) const Q15_TABLES: &str =
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/derive/q15.txt"));
    pub(in crate::arithmetic) const FIXED_TABLES: &str =
        include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/derive/fixed.txt"));

    /// The values of a table: a line of its file, the name and numbers in hex.
    fn committed(file: &str, name: &str) -> Vec<u64> {
        let line = file.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
        let words = line.unwrap_or_else(|| panic!("{name}")).split(' ');
        words.map(|word| u64::from_str_radix(word, 16).unwrap()).collect()
    }

    /// A table of the crate is that of the script.
    pub(in crate::arithmetic) fn assert_derived<T: Copy + Into<u64>>(
        file: &str,
        name: &str,
        table: &[T],
    ) {
        let table: Vec<u64> = table.iter().map(|&value| value.into()).collect();
        assert_eq!(table, committed(file, name), "{name}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;
    use std::vec;

    #[test]
    fn decimals_are_exact() {
        for (number, text) in [
            (Q31::ZERO, "0"),
            (Q31::LSB, "0.0000000004656612873077392578125"),
            (-Q31::LSB, "-0.0000000004656612873077392578125"),
            (Q31::MAX, "0.9999999995343387126922607421875"),
            (Q31::from_bits(i32::MIN), "-1"),
            (Q31::from_bits(-3 << 29), "-0.75"),
        ] {
            assert_eq!(number.to_string(), text);
        }
        assert_eq!(Q15::LSB.to_string(), "0.000030517578125");
        assert_eq!(Q15::MAX.to_string(), "0.999969482421875");
        assert_eq!(std::format!("{:7} {:.2}", Q15::from_bits(1 << 14), Q15::MAX), "    0.5 1.00");
    }

    #[test]
    fn exponents_are_the_nearest() {
        let lsb = 1.0 / 4_294_967_296.0;
        for (lsbs, bits) in [
            (0.0, 0),
            (0.5_f64.next_down(), 0),
            (0.5, 1),
            (1.5_f64.next_down(), 1),
            // Odd, and so large that adding 1/2 is a tie.
            (7_318_349_394_477_157.0, 7_318_349_394_477_157),
            (18_446_744_073_709_551_616.0_f64.next_down(), u64::MAX - 2047),
        ] {
            assert_eq!(FixedExponent::try_from(lsbs * lsb), Ok(FixedExponent(bits)), "{lsbs}");
        }
    }

    #[test]
    fn floats_are_the_nearest_toward_0() {
        let mut bits = vec![0, 1, i32::MAX, i32::MIN];
        for bit in 0..31 {
            bits.extend((-2..=2).map(|d| (1_i32 << bit).saturating_add(d)));
            bits.extend([i32::MAX >> bit, 0x5a82_7999 >> bit, (0x00ff_ffff << 7) >> bit]);
        }
        for bits in bits.into_iter().flat_map(|bits| [bits, bits.saturating_neg()]) {
            let (exact, float) = (Q31::from_bits(bits).to_f64(), Q31::from_bits(bits).to_f32());
            let [counted, shifted] =
                [Q31::to_f32_by::<true>, Q31::to_f32_by::<false>].map(|f| f(Q31::from_bits(bits)));
            assert_eq!([counted, shifted].map(f32::to_bits), [float.to_bits(); 2]);
            assert_eq!(float == 0.0, bits == 0);
            assert!(bits != 0 || float.is_sign_positive());
            assert!(f64::from(float.abs()) <= exact.abs() && f64::from(float) * exact >= 0.0);
            assert!(f64::from(float.abs().next_up()) > exact.abs(), "{bits:#x}: {float:e}");
        }
    }
}
