//! Vectors of f32 and f64: unit length, and a basis about a unit vector, as `const fn`.
//!
//! **Unit length** without a square root. With a length squared of 1 + d the factor is
//! 1 / sqrt(1 + d) = 1 - d/2 + 3/8 d^2 - 5/16 d^3 + ..: for d within 1/128 four terms leave
//! 0.27 d^4 < 2^-29 and eight 0.2 d^8 < 2^-58, so the series of the type is exact to its last digit.
//! Two steps of four terms are, to f64's, for any d within 0.112. A vector of another length is
//! divided by its largest component. Its length squared l is then in [1, 3], where 1.145 - 0.2 l is
//! 1 / sqrt l within 5.7 %, so that d is within 0.112.
//!
//! Of the normals that a ray tracer computes in f32, some are more than 16 ulp off, and no predictor
//! of branches can learn which. So where branches cost more than a polynomial the factor is always
//! computed, and is 1 within 16 ulp.
//!
//! **Basis**: T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin,
//! "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.

macro_rules! vectors {
    ($float:ident, $series:expr) => {
        pub mod $float {
            use crate::error::Error;
            use crate::target::form::{BRANCHES, ONE};

            #[inline(always)]
            pub const fn dot(a: [$float; 3], b: [$float; 3]) -> $float {
                a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
            }

            #[inline(always)]
            const fn times([x, y, z]: [$float; 3], k: $float) -> [$float; 3] {
                [x * k, y * k, z * k]
            }

            /// A step towards unit length.
            #[inline(always)]
            const fn step(vector: [$float; 3]) -> [$float; 3] {
                let d = dot(vector, vector) - 1.0;
                times(vector, 1.0 - d * (0.5 - d * (0.375 - d * 0.3125)))
            }

            /// (1 - 1 / sqrt(1 + d)) / d, |d| <= 1/128.
            #[inline(always)]
            const fn series(d: $float) -> $float {
                const TERMS: &[$float] = &$series;
                let (mut sum, mut rest) = (0.0, TERMS);
                while let [others @ .., term] = rest {
                    sum = *term - d * sum;
                    rest = others;
                }
                sum
            }

            /// A vector with length squared 1 + d, |d| <= 1/128: as it is within 16 ulp.
            #[inline(always)]
            const fn corrected(vector: [$float; 3], d: $float) -> [$float; 3] {
                let as_it_is = d.abs() <= KEPT;
                if ONE == BRANCHES && as_it_is {
                    return vector;
                }
                let less = d * series(d);
                times(vector, if as_it_is { 1.0 } else { 1.0 - less })
            }

            /// How far from 1 the length squared of a vector may be that keeps its bits.
            const KEPT: $float = 16.0 * $float::EPSILON;

            /// How far from 1 the length squared of a vector may be that is taken to be a unit
            /// vector.
            const NEAR: $float = 1.0 / 128.0;

            /// # Errors
            /// [`Error::NotUnit`] for a vector that is not near unit length.
            #[inline(always)]
            pub const fn unit(vector: [$float; 3]) -> Result<[$float; 3], Error> {
                let length_squared = dot(vector, vector);
                let d = length_squared - 1.0;
                if d.abs() <= NEAR {
                    Ok(corrected(vector, d))
                } else {
                    Err(Error::NotUnit { length_squared: length_squared as f64 })
                }
            }

            /// # Errors
            /// [`Error::NoDirection`] for a vector that is zero, infinite or not a number.
            #[inline(always)]
            pub const fn normalized(vector: [$float; 3]) -> Result<[$float; 3], Error> {
                let d = dot(vector, vector) - 1.0;
                // Directions mostly are of unit length: a branch that is predicted.
                if d.abs() <= KEPT {
                    Ok(vector)
                } else if d.abs() <= NEAR {
                    Ok(corrected(vector, d))
                } else {
                    of_any_length(vector)
                }
            }

            /// [`normalized`], of a vector that mostly is a little off unit length; the z axis for
            /// one without a direction.
            #[inline(always)]
            pub const fn normal(vector: [$float; 3]) -> [$float; 3] {
                let d = dot(vector, vector) - 1.0;
                if d.abs() <= NEAR { corrected(vector, d) } else { of_any_length_or_z(vector) }
            }

            #[cold]
            #[inline(never)]
            const fn of_any_length_or_z(vector: [$float; 3]) -> [$float; 3] {
                match of_any_length(vector) {
                    Ok(unit) => unit,
                    Err(_) => [0.0, 0.0, 1.0],
                }
            }

            #[cold]
            #[inline(never)]
            const fn of_any_length([x, y, z]: [$float; 3]) -> Result<[$float; 3], Error> {
                let larger = if x.abs() > y.abs() { x.abs() } else { y.abs() };
                let largest = if larger > z.abs() { larger } else { z.abs() };
                let finite = x.is_finite() && y.is_finite() && z.is_finite();
                if !finite || largest == 0.0 {
                    return Err(Error::NoDirection);
                }
                // The reciprocal of a subnormal number would be infinite.
                let scaled = [x / largest, y / largest, z / largest];
                Ok(step(step(times(scaled, 1.145 - 0.2 * dot(scaled, scaled)))))
            }

            /// The first two axes of the basis about a unit vector. Either sign of a zero has the
            /// same.
            #[inline(always)]
            pub const fn basis([x, y, z]: [$float; 3]) -> [[$float; 3]; 2] {
                let sign = if z < 0.0 { -1.0 } else { 1.0 };
                let a = -1.0 / (sign + z);
                let b = x * y * a;
                [[1.0 + sign * (x * x * a), sign * b, -(sign * x)], [b, sign + y * y * a, -y]]
            }
        }
    };
}
vectors!(f32, [0.5, 0.375, 0.3125]);
vectors!(f64, [0.5, 0.375, 0.312_5, 0.273_437_5, 0.246_093_75, 0.225_585_937_5, 0.209_472_656_25,]);
