//! The arithmetics under test: the list that generic tests run over, and what a test knows of each.
//!
//! The list is the library's, `src/lists.rs`. A new number type is also an `impl Number`.

use crate::digest::Digestible;
use hemidisc::arithmetic::{Arithmetic, Real, Root};
use hemidisc::invariant::Exact;
use std::f64::consts::FRAC_1_PI;

/// One test for each arithmetic: `test_each_arithmetic!(name)` makes them of the generic function
/// `name`. Features are those of the crate that has the tests; they bear the library's names.
#[macro_export]
macro_rules! test_each_arithmetic {
    ($run:ident) => {
        mod $run {
            use $crate::test_each_arithmetic as tests;
            hemidisc::for_each_arithmetic! { tests @ $run }
        }
    };
    (@ $run:ident
        $(#[$cfg:meta] $test:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        $(
            #[$cfg]
            #[test]
            fn $test() {
                super::$run::<hemidisc::$arithmetic>();
            }
        )*
    };
}

/// As [`test_each_arithmetic!`], of the arithmetics of floats.
#[macro_export]
macro_rules! test_each_float {
    ($run:ident) => {
        mod $run {
            use $crate::test_each_float as tests;
            hemidisc::for_each_arithmetic! { tests @ $run }
        }
    };
    (@ $run:ident
        $(#[$cfg:meta] $test:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        $(tests! { $kind $run #[$cfg] $test $arithmetic $name $kind $facts; })*
    };
    (float $run:ident $($arithmetic:tt)*) => {
        $crate::test_each_arithmetic! { @ $run $($arithmetic)* }
    };
    (fixed $run:ident $($arithmetic:tt)*) => {};
}

/// An arithmetic with what the tests must know of it.
pub trait Tested: Arithmetic<Real: Number, Parameter: Exponent> {
    /// Leading bits of a coordinate that it reads; the others change nothing.
    const BITS: u32;
    /// The error of a density at a point that is given exactly, relative or, in fixed point, in
    /// parts of the peak, for moderate exponents.
    const DENSITY_ERROR: f64;
    /// The crate whose version decides the bytes.
    const LIBRARY: Option<&'static str>;
}

/// Something to do with each arithmetic.
pub trait EachArithmetic {
    fn each<A: Tested>(&mut self);
}

macro_rules! implement {
    ($(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident, $bits:literal, $error:expr, $library:expr);
    )*) => {
        $(
            #[$cfg]
            impl Tested for hemidisc::$arithmetic {
                const BITS: u32 = $bits;
                const DENSITY_ERROR: f64 = $error;
                const LIBRARY: Option<&'static str> = $library;
            }
        )*

        /// Visits the arithmetics of this build.
        pub fn every_arithmetic(visitor: &mut impl EachArithmetic) {
            $(
                #[$cfg]
                visitor.each::<hemidisc::$arithmetic>();
            )*
        }
    };
}
hemidisc::for_each_arithmetic!(implement);

/// Something to do with each arithmetic of floats: those that frames and effects take.
pub trait EachRoot {
    fn each<A: Root<Real: Real> + Tested>(&mut self);
}

macro_rules! roots {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        /// Visits the arithmetics of floats of this build.
        pub fn every_root(visitor: &mut impl EachRoot) {
            $(
                #[$cfg]
                roots!(@ $kind visitor $arithmetic);
            )*
        }
    };
    (@ float $visitor:ident $arithmetic:ident) => {
        $visitor.each::<hemidisc::$arithmetic>()
    };
    (@ fixed $visitor:ident $arithmetic:ident) => {};
}
hemidisc::for_each_arithmetic!(roots);

/// The centre of a coordinate's cell, as the arithmetic reads it.
pub fn centre<A: Tested>(k: u32) -> f64 {
    (f64::from(k >> (32 - A::BITS)) + 0.5) * 0.5_f64.powi(A::BITS as i32)
}

/// The largest density of a map, which fixed point takes as 1.
pub fn peak(kind: &str, e: f64) -> f64 {
    match kind {
        "disc" | "cosine" => FRAC_1_PI,
        "uniform" => FRAC_1_PI / 2.0,
        "power" => (e + 1.0) * FRAC_1_PI / 2.0,
        _ => panic!("no peak is known of {kind}"),
    }
}

/// A component of a point, to and from f64, and as the command line prints it.
pub trait Number: Exact + Digestible + Into<f64> {
    /// Whether the number is a count of LSBs.
    const FIXED: bool;
    /// The smallest z that is given.
    const SMALLEST: f64;
    /// The nearest number of the type; in fixed point the nearest in its range.
    fn nearest(value: f64) -> Self;
    /// The bits, as `--raw` prints them.
    fn raw(self) -> String;
    /// The decimal that is printed for raw bits: the shortest that reads back exactly, or the exact
    /// one.
    fn decimal(raw: &str) -> String;
}

macro_rules! float {
    ($float:ident, $bits:ident, $digits:literal) => {
        impl Number for $float {
            const FIXED: bool = false;
            const SMALLEST: f64 = $float::MIN_POSITIVE as f64;

            fn nearest(value: f64) -> Self {
                value as $float
            }

            fn raw(self) -> String {
                format!(concat!("0x{:0", $digits, "x}"), self.to_bits())
            }

            fn decimal(raw: &str) -> String {
                let digits = raw.strip_prefix("0x").filter(|text| text.len() == $digits).unwrap();
                let value = $float::from_bits($bits::from_str_radix(digits, 16).unwrap());
                let text = format!("{value:?}");
                assert_eq!(text.parse::<$float>().unwrap().to_bits(), value.to_bits());
                text
            }
        }
    };
}
float!(f32, u32, 8);
float!(f64, u64, 16);

#[cfg(feature = "fixed-point")]
macro_rules! fixed {
    ($number:ident, $bits:ident) => {
        impl Number for hemidisc::$number {
            const FIXED: bool = true;
            const SMALLEST: f64 = hemidisc::$number::LSB.to_f64();

            fn nearest(value: f64) -> Self {
                assert!(!value.is_nan());
                // The conversion saturates.
                Self::from_bits((value / Self::SMALLEST).round() as $bits)
            }

            fn raw(self) -> String {
                format!("{}", self.to_bits())
            }

            /// In integers: the count of LSBs times 10^BITS, without the zeros at the end.
            fn decimal(raw: &str) -> String {
                let bits: $bits = raw.parse().unwrap();
                assert_eq!(raw, bits.to_string());
                let places = $bits::BITS - 1;
                let one = 1_u128 << places;
                let (whole, mut left) = {
                    let magnitude = u128::from(bits.unsigned_abs());
                    (magnitude / one, magnitude % one)
                };
                let mut text = format!("{}{whole}", if bits < 0 { "-" } else { "" });
                if left > 0 {
                    text.push('.');
                }
                while left > 0 {
                    left *= 10;
                    text.push(char::from_digit((left / one) as u32, 10).unwrap());
                    left %= one;
                }
                text
            }
        }
    };
}
#[cfg(feature = "fixed-point")]
fixed!(Q15, i16);
#[cfg(feature = "fixed-point")]
fixed!(Q31, i32);

/// An exponent of the power lobe, as a user gives it.
pub trait Exponent: Copy {
    /// Whether -1 < e < 0 is accepted.
    const NEGATIVE: bool;
    /// The exponent, unless the type does not hold it exactly.
    fn exactly(e: f64) -> Option<Self>;
    /// Any that is accepted, of random bits.
    fn any(bits: u64) -> Option<Self>;
    /// Its value.
    fn value(self) -> f64;
}

impl Exponent for f64 {
    const NEGATIVE: bool = true;

    fn exactly(e: f64) -> Option<f64> {
        Some(e)
    }

    /// An f32: so are the exponents of the f32 arithmetics, and the range is as wide as is
    /// promised.
    fn any(bits: u64) -> Option<f64> {
        f32::any(bits).map(f64::from)
    }

    fn value(self) -> f64 {
        self
    }
}

impl Exponent for f32 {
    const NEGATIVE: bool = true;

    fn exactly(e: f64) -> Option<f32> {
        let single = e as f32;
        (f64::from(single) == e).then_some(single)
    }

    fn any(bits: u64) -> Option<f32> {
        let e = f32::from_bits((bits >> 32) as u32);
        (e > -1.0 && e.is_finite()).then_some(e)
    }

    fn value(self) -> f64 {
        self.into()
    }
}

#[cfg(feature = "fixed-point")]
impl Exponent for hemidisc::arithmetic::FixedExponent {
    const NEGATIVE: bool = false;

    fn exactly(e: f64) -> Option<Self> {
        Self::try_from(e).ok().filter(|fixed| fixed.value() == e)
    }

    /// Of any size: the low bits say how far the others are shifted.
    fn any(bits: u64) -> Option<Self> {
        Some(Self::from_bits(bits >> (bits % 64)))
    }

    fn value(self) -> f64 {
        self.to_bits() as f64 * 0.5_f64.powi(32)
    }
}
