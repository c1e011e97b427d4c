//! Accuracy contracts: one bound for each arithmetic and map, in one table.
//!
//! Tests assert every bound from both sides: no error exceeds it, and it is less than twice the
//! largest error found. Errors are against the exact map of the exact coordinate, with the exponent
//! rounded to the type.

/// Bounds on the errors of one map in one arithmetic, over both disc maps, in
/// [`unit`](Self::unit)s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contract {
    /// Name of the arithmetic.
    pub arithmetic: &'static str,
    /// Name of the map: `disc`, or a lobe.
    pub map: &'static str,
    /// What the bounds count. For floats it is half an ulp of 1: 2^-24 for f32 and 2^-53 for f64.
    /// For fixed point it is an LSB. For `micromath-f32`, whose errors are a thousand of them, it
    /// is 2^-20.
    pub unit: f64,
    /// Whether the errors of theta, z and density are relative: floats. Those of fixed point are
    /// absolute, in radians and in parts of the lobe's peak.
    pub relative: bool,
    /// Largest error of a component of the point.
    pub position: f64,
    /// Largest deviation of the point's norm from 1 (from r, on the disc).
    pub norm: f64,
    /// Largest error of theta = atan2(hypot(x, y), z), for exponents in [0, 1e8].
    pub theta: f64,
    /// Largest relative error of z: the first, plus the second times |ln z|; for exponents >= 0. In
    /// fixed point z is within `position`, and this is 0.
    pub z: [f64; 2],
    /// Largest error of the density at a sampled point, for exponents in [0, 1e8]: the first, plus
    /// the second times sqrt e, which is how fast a fixed-point direction loses accuracy in a
    /// narrow lobe. In fixed point and 0 < e < 1 the bound also includes the error of z^e by an
    /// error of z within `position`, up to LSB^e at the horizon.
    pub density: [f64; 2],
    /// Largest error of the density that comes with a sample, against that of the exact coordinates,
    /// for exponents in [0, 1e8]: the first, plus the second times |ln z|. In fixed point it is
    /// `density`'s, for the two are one.
    pub sampled: [f64; 2],
    /// Largest distance between a point and the sample of its inverse, for exponents in [0, 1e8].
    pub round_trip: f64,
}

impl Contract {
    /// With the density of a sample better than that of its point.
    const fn sampled(self, sampled: [f64; 2]) -> Self {
        Self { sampled, ..self }
    }
}

const EPS32: f64 = 1.0 / (1_u64 << 24) as f64;
/// A millionth or so, for functions that are good to three digits.
const PPM: f64 = 1.0 / (1_u64 << 20) as f64;
const EPS64: f64 = 1.0 / (1_u64 << 53) as f64;
const LSB15: f64 = 1.0 / (1_u64 << 15) as f64;
const LSB31: f64 = 1.0 / (1_u64 << 31) as f64;

/// What the contracts of an arithmetic have in common.
struct Of {
    arithmetic: &'static str,
    unit: f64,
    relative: bool,
}

const LIBM_F64: Of = Of { arithmetic: "libm-f64", unit: EPS64, relative: true };
const LIBM_F32: Of = Of { arithmetic: "libm-f32", unit: EPS32, relative: true };
const FAST_F32: Of = Of { arithmetic: "fast-f32", unit: EPS32, relative: true };
const MICROMATH_F32: Of = Of { arithmetic: "micromath-f32", unit: PPM, relative: true };
const Q31: Of = Of { arithmetic: "q31", unit: LSB31, relative: false };
const Q15: Of = Of { arithmetic: "q15", unit: LSB15, relative: false };
const Q15_DIV: Of = Of { arithmetic: "q15-div", unit: LSB15, relative: false };

impl Of {
    const fn bounds(
        self,
        map: &'static str,
        [position, norm, theta]: [f64; 3],
        z: [f64; 2],
        density: [f64; 2],
        round_trip: f64,
    ) -> Contract {
        let Self { arithmetic, unit, relative } = self;
        let sampled = density;
        Contract {
            arithmetic,
            map,
            unit,
            relative,
            position,
            norm,
            theta,
            z,
            density,
            sampled,
            round_trip,
        }
    }
}

/// The contracts of every arithmetic: the map, the largest errors of position, norm and theta,
/// those of z and of the density, each with its slope, and that of the round trip. A disc has no
/// theta and no z.
#[rustfmt::skip]
pub const CONTRACTS: &[Contract] = &[
    LIBM_F64.bounds("disc",    [2.25, 2.0, 0.0], [0.0, 0.0], [1.0, 0.0], 0.0),
    LIBM_F64.bounds("uniform", [2.75, 2.5, 3.0], [1.0, 0.0], [1.0, 0.0], 0.0),
    LIBM_F64.bounds("cosine",  [2.25, 2.0, 2.75], [1.5, 0.0], [2.0, 0.0], 0.0),
    LIBM_F64.bounds("power",   [2.5, 2.5, 4.0], [3.0, 2.0], [300.0, 0.0], 0.0).sampled([5.0, 2.0]),
    LIBM_F32.bounds("disc",    [2.75, 2.25, 0.0], [0.0, 0.0], [1.0, 0.0], 4.0),
    LIBM_F32.bounds("uniform", [3.0, 2.5, 3.5], [1.0, 0.0], [1.0, 0.0], 5.0),
    LIBM_F32.bounds("cosine",  [2.75, 2.25, 3.25], [1.5, 0.0], [3.5, 0.0], 5.0),
    LIBM_F32.bounds("power",   [2.75, 2.25, 4.5], [3.0, 2.0], [300.0, 0.0], 6.0).sampled([5.0, 2.0]),
    FAST_F32.bounds("disc",    [3.0, 3.25, 0.0], [0.0, 0.0], [1.0, 0.0], 4.0),
    FAST_F32.bounds("uniform", [3.5, 3.75, 5.5], [3.5, 0.0], [1.0, 0.0], 5.0),
    FAST_F32.bounds("cosine",  [3.0, 3.25, 4.25], [3.0, 0.0], [5.0, 0.0], 5.0),
    FAST_F32.bounds("power",   [3.5, 3.5, 6.25], [5.0, 2.5], [300.0, 0.0], 6.0).sampled([7.0, 2.5]),
    MICROMATH_F32.bounds("disc",    [1150.0, 1060.0, 0.0], [0.0, 0.0], [0.05, 0.0], 1060.0),
    MICROMATH_F32.bounds("uniform", [1150.0, 1060.0, 1060.0], [0.07, 0.0], [0.05, 0.0], 1300.0),
    MICROMATH_F32.bounds("cosine",  [1150.0, 1060.0, 1060.0], [0.3, 0.0], [0.3, 0.0], 1060.0),
    MICROMATH_F32.bounds("power",   [1150.0, 1060.0, 1060.0], [15.0, 0.0], [72000.0, 0.0], 2100.0).sampled([15.0, 0.0]),
    Q31.bounds("disc",    [4.0, 4.5, 0.0], [0.0, 0.0], [1.25, 0.0], 5.5),
    Q31.bounds("uniform", [5.25, 5.75, 3.75], [0.0, 0.0], [1.25, 0.0], 7.0),
    Q31.bounds("cosine",  [4.0, 4.5, 3.0], [0.0, 0.0], [1.25, 0.0], 5.0),
    Q31.bounds("power",   [5.5, 6.0, 3.75], [0.0, 0.0], [5.0, 0.6], 8.5),
    Q15.bounds("disc",    [2.5, 3.25, 0.0], [0.0, 0.0], [1.25, 0.0], 3.0),
    Q15.bounds("uniform", [3.5, 4.5, 3.0], [0.0, 0.0], [1.25, 0.0], 5.0),
    Q15.bounds("cosine",  [2.5, 3.25, 2.5], [0.0, 0.0], [1.25, 0.0], 3.5),
    Q15.bounds("power",   [4.75, 4.75, 4.0], [0.0, 0.0], [3.0, 1.0], 8.0),
    Q15_DIV.bounds("disc",    [2.5, 3.25, 0.0], [0.0, 0.0], [1.25, 0.0], 3.0),
    Q15_DIV.bounds("uniform", [3.5, 4.5, 3.0], [0.0, 0.0], [1.25, 0.0], 6.0),
    Q15_DIV.bounds("cosine",  [2.5, 3.25, 2.5], [0.0, 0.0], [1.25, 0.0], 4.0),
    Q15_DIV.bounds("power",   [4.75, 4.75, 4.0], [0.0, 0.0], [3.0, 1.0], 8.5),
];

/// The contract of a map in an arithmetic, by their names.
pub fn contract(arithmetic: &str, map: &str) -> Option<Contract> {
    CONTRACTS.iter().copied().find(|row| row.arithmetic == arithmetic && row.map == map)
}
