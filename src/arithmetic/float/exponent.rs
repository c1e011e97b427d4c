//! Exponents of power lobes, checked, as `const fn` on f32 and f64.

macro_rules! exponents {
    ($float:ident) => {
        pub mod $float {
            use crate::error::Error;

            /// e + 1, rounded, and what that has lost of it, relative.
            ///
            /// # Errors
            /// [`Error::Exponent`] for a value that is not a finite number above -1.
            pub const fn plus_1(e: $float) -> Result<[$float; 2], Error> {
                let e_plus_1 = e + 1.0;
                // No e above -1 rounds to e + 1 = 0; NaN fails the comparison.
                if !(e_plus_1 > 0.0 && e.is_finite()) {
                    return Err(Error::Exponent { value: e as f64 });
                }
                // The two-sum (D. Knuth, TAOCP 4.2.2): e_plus_1 + lost is e + 1 exactly.
                let one_part = e_plus_1 - e;
                let lost = (e - (e_plus_1 - one_part)) + (1.0 - one_part);
                Ok([e_plus_1, lost / e_plus_1])
            }

            /// 2 / (e + 1) / scale^2, and the scale, a power of two. Without it the quotient is
            /// subnormal at the largest exponents: a processor that flushes subnormal numbers to 0
            /// would divide 0 by 0 later.
            pub const fn spread(e_plus_1: $float) -> [$float; 2] {
                let scale = if e_plus_1 > 1.0 { $float::EPSILON } else { 1.0 };
                [2.0 / (e_plus_1 * scale * scale), scale]
            }
        }
    };
}
exponents!(f32);
exponents!(f64);
