//! Accuracy contracts: one bound for each arithmetic and map, in one table.
//!
//! Tests assert every bound from both sides: no error exceeds it, and it is less than twice the
//! largest error found. Errors are against the exact map of the exact coordinate, with the exponent
//! rounded to the type.

/// Bounds on the errors of one map in one arithmetic, over both disc maps, in [`unit`](Self::unit)s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contract {
    /// Name of the arithmetic.
    pub arithmetic: &'static str,
    /// Name of the map: `disc`, or a lobe.
    pub map: &'static str,
    /// What the bounds count: half an ulp of 1, 2^-24 for f32 and 2^-53 for f64; an LSB of fixed point; 2^-20
    /// for `micromath-f32`, which is good to a thousand of them.
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
    /// Largest relative error of z: the first, plus the second times |ln z|; for exponents >= 0. In fixed
    /// point z is within `position`, and this is 0.
    pub z: [f64; 2],
    /// Largest error of the density at a sampled point, for exponents in [0, 1e8]: the first, plus the
    /// second times sqrt e, which is how fast a fixed-point direction loses sight of a narrow lobe. In fixed
    /// point and 0 < e < 1 also what an error of z within `position` makes of z^e, up to LSB^e at the horizon.
    pub density: [f64; 2],
    /// Largest distance between a point and the sample of its inverse, for exponents in [0, 1e8].
    pub inverse: f64,
}

const EPS32: f64 = 1.0 / (1_u64 << 24) as f64;
/// A millionth or so, for functions that are good to three digits.
const PPM: f64 = 1.0 / (1_u64 << 20) as f64;
const EPS64: f64 = 1.0 / (1_u64 << 53) as f64;
const LSB15: f64 = 1.0 / (1_u64 << 15) as f64;
const LSB31: f64 = 1.0 / (1_u64 << 31) as f64;

/// The contracts of every arithmetic. A disc has no theta and no z.
#[rustfmt::skip]
pub const CONTRACTS: [Contract; 28] = [
    Contract { arithmetic: "libm-f64", map: "disc",    unit: EPS64, relative: true, position: 2.25, norm: 2.0,  theta: 0.0,  z: [0.0, 0.0], density: [1.0, 0.0], inverse: 0.0 },
    Contract { arithmetic: "libm-f64", map: "uniform", unit: EPS64, relative: true, position: 2.75, norm: 2.5,  theta: 3.0,  z: [1.0, 0.0], density: [1.0, 0.0], inverse: 0.0 },
    Contract { arithmetic: "libm-f64", map: "cosine",  unit: EPS64, relative: true, position: 2.25, norm: 2.0,  theta: 2.75, z: [1.5, 0.0], density: [2.0, 0.0], inverse: 0.0 },
    Contract { arithmetic: "libm-f64", map: "power",   unit: EPS64, relative: true, position: 2.5,  norm: 2.5,  theta: 4.0,  z: [3.0, 2.0], density: [300.0, 0.0], inverse: 0.0 },
    Contract { arithmetic: "libm-f32", map: "disc",    unit: EPS32, relative: true, position: 2.75, norm: 2.25, theta: 0.0, z: [0.0, 0.0], density: [1.0, 0.0], inverse: 4.0 },
    Contract { arithmetic: "libm-f32", map: "uniform", unit: EPS32, relative: true, position: 3.0,  norm: 2.5, theta: 3.5, z: [1.0, 0.0], density: [1.0, 0.0], inverse: 5.0 },
    Contract { arithmetic: "libm-f32", map: "cosine",  unit: EPS32, relative: true, position: 2.75, norm: 2.25, theta: 3.25, z: [1.5, 0.0], density: [3.5, 0.0], inverse: 5.0 },
    Contract { arithmetic: "libm-f32", map: "power",   unit: EPS32, relative: true, position: 2.75, norm: 2.25, theta: 4.5, z: [3.0, 2.0], density: [300.0, 0.0], inverse: 6.0 },
    Contract { arithmetic: "fast-f32", map: "disc",    unit: EPS32, relative: true, position: 3.0, norm: 3.25, theta: 0.0, z: [0.0, 0.0], density: [1.0, 0.0], inverse: 4.0 },
    Contract { arithmetic: "fast-f32", map: "uniform", unit: EPS32, relative: true, position: 3.5, norm: 3.75, theta: 5.5, z: [3.5, 0.0], density: [1.0, 0.0], inverse: 5.0 },
    Contract { arithmetic: "fast-f32", map: "cosine",  unit: EPS32, relative: true, position: 3.0, norm: 3.25, theta: 4.25, z: [3.0, 0.0], density: [5.0, 0.0], inverse: 5.0 },
    Contract { arithmetic: "fast-f32", map: "power",   unit: EPS32, relative: true, position: 3.5, norm: 3.5, theta: 6.25, z: [5.0, 2.0], density: [350.0, 0.0], inverse: 6.0 },
    Contract { arithmetic: "micromath-f32", map: "disc",    unit: PPM, relative: true, position: 1150.0, norm: 1060.0, theta: 0.0,    z: [0.0, 0.0],  density: [0.05, 0.0],    inverse: 1060.0 },
    Contract { arithmetic: "micromath-f32", map: "uniform", unit: PPM, relative: true, position: 1150.0, norm: 1060.0, theta: 1060.0, z: [0.07, 0.0], density: [0.05, 0.0],    inverse: 1300.0 },
    Contract { arithmetic: "micromath-f32", map: "cosine",  unit: PPM, relative: true, position: 1150.0, norm: 1060.0, theta: 1060.0, z: [0.3, 0.0],  density: [0.3, 0.0],     inverse: 1060.0 },
    Contract { arithmetic: "micromath-f32", map: "power",   unit: PPM, relative: true, position: 1150.0, norm: 1060.0, theta: 1060.0, z: [15.0, 0.0], density: [72000.0, 0.0], inverse: 2100.0 },
    Contract { arithmetic: "q31",      map: "disc",    unit: LSB31, relative: false, position: 4.0, norm: 4.5, theta: 0.0, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 5.5 },
    Contract { arithmetic: "q31",      map: "uniform", unit: LSB31, relative: false, position: 5.25, norm: 5.75, theta: 3.75, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 7.0 },
    Contract { arithmetic: "q31",      map: "cosine",  unit: LSB31, relative: false, position: 4.0, norm: 4.5, theta: 3.0, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 5.0 },
    Contract { arithmetic: "q31",      map: "power",   unit: LSB31, relative: false, position: 5.5, norm: 6.0, theta: 3.75, z: [0.0, 0.0], density: [5.0, 0.6], inverse: 8.5 },
    Contract { arithmetic: "q15",     map: "disc",    unit: LSB15, relative: false, position: 2.5, norm: 3.25, theta: 0.0, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 3.0 },
    Contract { arithmetic: "q15",     map: "uniform", unit: LSB15, relative: false, position: 3.5, norm: 4.5, theta: 3.0, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 5.0 },
    Contract { arithmetic: "q15",     map: "cosine",  unit: LSB15, relative: false, position: 2.5, norm: 3.25, theta: 2.5, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 3.5 },
    Contract { arithmetic: "q15",     map: "power",   unit: LSB15, relative: false, position: 4.75, norm: 4.75, theta: 4.0, z: [0.0, 0.0], density: [3.0, 1.0], inverse: 8.0 },
    Contract { arithmetic: "q15-div", map: "disc",    unit: LSB15, relative: false, position: 2.5, norm: 3.25, theta: 0.0, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 3.0 },
    Contract { arithmetic: "q15-div", map: "uniform", unit: LSB15, relative: false, position: 3.5, norm: 4.5, theta: 3.0, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 6.0 },
    Contract { arithmetic: "q15-div", map: "cosine",  unit: LSB15, relative: false, position: 2.5, norm: 3.25, theta: 2.5, z: [0.0, 0.0], density: [1.25, 0.0], inverse: 4.0 },
    Contract { arithmetic: "q15-div", map: "power",   unit: LSB15, relative: false, position: 4.75, norm: 4.75, theta: 4.0, z: [0.0, 0.0], density: [3.0, 1.0], inverse: 8.5 },
];

/// The contract of a map in an arithmetic, by their names.
pub fn contract(arithmetic: &str, map: &str) -> Option<Contract> {
    CONTRACTS.into_iter().find(|row| row.arithmetic == arithmetic && row.map == map)
}
