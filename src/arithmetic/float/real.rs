//! f32 and f64 as the kernels see them: constants, conversions from integers, and exact tests.

use super::{exponent, length, vector};
use crate::coordinates::{centre_f32, centre_f64};
use crate::error::Error;
use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};
use core::str::FromStr;

/// f32 or f64: what a renderer generic over both needs of a float. Sealed.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Into<f64>
    + FromStr<Err: Display>
    + RealKernel
{
    /// 0.
    const ZERO: Self;
    /// 1/2.
    const HALF: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// 4.
    const FOUR: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The smallest positive normal number.
    const MIN_POSITIVE: Self;
    /// The largest finite number.
    const MAX: Self;
    /// 1 / pi.
    const FRAC_1_PI: Self;

    /// The absolute value.
    #[must_use]
    fn magnitude(self) -> Self;
    /// This magnitude with the sign of another number.
    #[must_use]
    fn with_sign(self, sign: Self) -> Self;
    /// Whether it is neither infinite nor NaN.
    fn finite(self) -> bool;
    /// The largest integer that is not above it, between 0 and 2^32 - 1; 0 for NaN.
    fn floor_u32(self) -> u32;
}

/// What only the kernels need.
#[doc(hidden)]
pub trait RealKernel: Copy + sealed::Sealed {
    /// Far above the smallest normal number, far below 1.
    const TINY: Self;
    const FRAC_PI_4: Self;
    const FRAC_4_PI: Self;
    /// exp(-UNSEEN) of a number is below half an ulp of it.
    const UNSEEN: Self;
    /// n / 2^32, correctly rounded.
    fn over_2_32(n: u32) -> Self;
    /// n / 2^64, correctly rounded.
    fn over_2_64(n: u64) -> Self;
    /// (2k + 1) / 2^33, correctly rounded.
    fn centre(k: u32) -> Self;
    /// (2k + 1) / 2^33, toward zero.
    fn centre_down(k: u32) -> Self;
    /// floor(2^bits x), saturating at 0 and 2^32 - 1; 0 for NaN.
    fn cell(self, bits: u32) -> u32;
    /// The next number toward zero; for positive numbers.
    fn below(self) -> Self;
    /// Whether a^2 + b^2 > 1, without false negatives; 1/2 <= a <= 2, 0 <= b <= a.
    fn outside(a: Self, b: Self) -> bool;
    /// The nearest number.
    fn nearest(x: f64) -> Self;

    // The functions of `vector`, `length` and `exponent`, which are `const` on a type that is known.
    fn dot(a: [Self; 3], b: [Self; 3]) -> Self;
    fn unit(vector: [Self; 3]) -> Result<[Self; 3], Error>;
    fn normalized(vector: [Self; 3]) -> Result<[Self; 3], Error>;
    fn normal(vector: [Self; 3]) -> [Self; 3];
    fn basis(z: [Self; 3]) -> [[Self; 3]; 2];
    fn checked_distance(distance: Self) -> Result<Self, Error>;
    fn nearness(radius: Self, focal_distance: Self) -> Result<Self, Error>;
    fn checked_centre(centre: [Self; 3], radius: Self) -> Result<[Self; 3], Error>;
    fn size(point: [Self; 3], normal: [Self; 3]) -> Self;
    fn plus_1(e: Self) -> Result<[Self; 2], Error>;
    fn spread(e_plus_1: Self) -> [Self; 2];
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! real {
    ($float:ident, $bits:literal, $integer:ident, $fine:literal, $centre_down:ident) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const FOUR: Self = 4.0;
            const EPSILON: Self = $float::EPSILON;
            const MIN_POSITIVE: Self = $float::MIN_POSITIVE;
            const MAX: Self = $float::MAX;
            const FRAC_1_PI: Self = core::$float::consts::FRAC_1_PI;

            #[inline(always)]
            fn magnitude(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn with_sign(self, sign: Self) -> Self {
                self.copysign(sign)
            }
            #[inline(always)]
            fn finite(self) -> bool {
                self.is_finite()
            }
            #[inline(always)]
            fn floor_u32(self) -> u32 {
                self as u32
            }
        }

        impl RealKernel for $float {
            const TINY: Self = $float::MIN_POSITIVE * (1_u64 << 32) as $float;
            const FRAC_PI_4: Self = core::$float::consts::FRAC_PI_4;
            const FRAC_4_PI: Self = 4.0 * core::$float::consts::FRAC_1_PI;
            const UNSEEN: Self =
                ($float::MANTISSA_DIGITS + 2) as $float * core::$float::consts::LN_2;

            #[inline(always)]
            fn over_2_32(n: u32) -> Self {
                n as $float * (1.0 / 4_294_967_296.0)
            }
            #[inline(always)]
            fn over_2_64(n: u64) -> Self {
                n as $float * (1.0 / 18_446_744_073_709_551_616.0)
            }
            #[inline(always)]
            fn centre(k: u32) -> Self {
                (2 * u64::from(k) + 1) as $float * (1.0 / 8_589_934_592.0)
            }
            #[inline(always)]
            fn centre_down(k: u32) -> Self {
                $centre_down(k)
            }
            #[inline(always)]
            fn cell(self, bits: u32) -> u32 {
                (self * (1_u64 << bits) as $float) as u32
            }
            #[inline(always)]
            fn below(self) -> Self {
                Self::from_bits(self.to_bits() - 1)
            }
            /// `a` is a multiple of 2^-bits, so its square is exact in the integer; `b` is rounded
            /// up to a multiple of 2^-fine, finer than any step of `a`.
            #[inline]
            fn outside(a: Self, b: Self) -> bool {
                const ONE: $integer = 1 << $bits;
                const FINE: $float = (1_u64 << $fine) as $float;
                let a = (a * ONE as $float) as $integer;
                if a > ONE {
                    return true;
                }
                let scaled = b * FINE;
                let floor = scaled as $integer;
                let b = floor + $integer::from((floor as $float) < scaled);
                let room = ((ONE - a) * (ONE + a)) << (2 * ($fine - $bits));
                b.checked_mul(b).is_none_or(|square| square > room)
            }
            #[inline(always)]
            fn nearest(x: f64) -> Self {
                x as $float
            }

            #[inline(always)]
            fn dot(a: [Self; 3], b: [Self; 3]) -> Self {
                vector::$float::dot(a, b)
            }
            #[inline(always)]
            fn unit(vector: [Self; 3]) -> Result<[Self; 3], Error> {
                vector::$float::unit(vector)
            }
            #[inline(always)]
            fn normalized(vector: [Self; 3]) -> Result<[Self; 3], Error> {
                vector::$float::normalized(vector)
            }
            #[inline(always)]
            fn normal(vector: [Self; 3]) -> [Self; 3] {
                vector::$float::normal(vector)
            }
            #[inline(always)]
            fn basis(z: [Self; 3]) -> [[Self; 3]; 2] {
                vector::$float::basis(z)
            }
            fn checked_distance(distance: Self) -> Result<Self, Error> {
                length::$float::distance(distance)
            }
            fn nearness(radius: Self, focal_distance: Self) -> Result<Self, Error> {
                length::$float::nearness(radius, focal_distance)
            }
            fn checked_centre(centre: [Self; 3], radius: Self) -> Result<[Self; 3], Error> {
                length::$float::centre(centre, radius)
            }
            #[inline]
            fn size(point: [Self; 3], normal: [Self; 3]) -> Self {
                length::$float::size(point, normal)
            }
            fn plus_1(e: Self) -> Result<[Self; 2], Error> {
                exponent::$float::plus_1(e)
            }
            fn spread(e_plus_1: Self) -> [Self; 2] {
                exponent::$float::spread(e_plus_1)
            }
        }
    };
}
real!(f32, 24, u64, 32, centre_f32);
real!(f64, 53, u128, 63, centre_f64);
