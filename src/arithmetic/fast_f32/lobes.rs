//! The lobes of fast f32: the power lobe and its exponent, and all three over a block of points.

use super::back::Functions;
use super::disc::{FastDisc, in_octant, less_gaps, root_to_1, to_places};
use super::functions::{exp, ln_complement, normal_sqrt, sqrt};
use crate::arithmetic::DiscKernel;
use crate::arithmetic::float::{PowerExponent, exponent};
use crate::block::{BLOCK, Block, Lanes};
use crate::error::Error;
use crate::target::BRANCHES;

/// An exponent e > -1 with the power lobe's precomputed values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FastExponent {
    exact: PowerExponent<f32>,
    /// 4^k / (e + 1), rounded, and its relative rounding error.
    rate: f32,
    lost: f32,
    /// 2^-k: 1 up to e + 1 = 2^42.
    shrink: f32,
}

impl FastExponent {
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub(super) const fn new(e: f32) -> Result<Self, Error> {
        let parts = match exponent::f32::plus_1(e) {
            Ok(parts) => parts,
            Err(error) => return Err(error),
        };
        let [square, scale] = exponent::f32::spread(parts[0]);
        let exact = PowerExponent::of_parts(e, parts, sqrt(square) * scale);
        // From 2^42 on sin theta is proportional to 1 / sqrt(e + 1) in f32, and 1 - r^2 may be
        // 1 - 2^-64: the lobe is that of an exponent between 2^40 and 2^42, shrunk, so that nothing
        // underflows.
        let e_plus_1 = e as f64 + 1.0;
        let binade = e_plus_1.to_bits() >> 52;
        let k = binade.saturating_sub(1023 + 40) / 2;
        let inverse = f64::from_bits((1023 + 2 * k) << 52) / e_plus_1;
        let rate = inverse as f32;
        let lost = ((inverse - rate as f64) / inverse) as f32;
        let shrink = 1.0 / (1_u64 << k) as f32;
        Ok(Self { exact, rate, lost, shrink })
    }

    /// sin theta from sin^2 theta 4^k.
    #[inline(always)]
    pub(super) const fn distance(self, square: f32) -> f32 {
        root_to_1(square) * self.shrink
    }

    /// The density of a sample of the lobe, from the 1 - r^2 that it was lifted from.
    #[inline(always)]
    pub(super) fn density_of_sample(self, one_minus_r2: f32, direction: [f32; 3]) -> f32 {
        self.exact.density_of_sample::<Functions>(one_minus_r2, direction)
    }

    /// The exponent as the user gave it.
    pub fn value(self) -> f32 {
        self.exact.value()
    }
}

impl From<FastExponent> for PowerExponent<f32> {
    fn from(exponent: FastExponent) -> Self {
        exponent.exact
    }
}

/// The power lobe.
#[inline(always)]
pub(super) const fn power(exponent: FastExponent, disc: FastDisc) -> [f32; 3] {
    let [square, z] = elevation(exponent, ln_complement(disc.r2, disc.one_minus_r2));
    let [x, y] = disc.place_at::<BRANCHES>(exponent.distance(square));
    [x, y, z]
}

/// Below the logarithm of the smallest normal number by more than all errors, so that z becomes that
/// number, whether a processor flushes subnormal results to 0 or not.
const LN_BELOW_MIN: f32 = -87.34;

/// sin^2 theta 4^k, which exceeds 1 by rounding at most, and z = cos theta, from ln(1 - r^2).
///
/// With z = exp(l), sin^2 theta = 1 - z^2 = (1 - z) (1 + z), and 1 - z is accurate near the pole.
#[inline(always)]
pub(super) const fn elevation(exponent: FastExponent, log: f32) -> [f32; 2] {
    let log = log * exponent.rate;
    // Below e = 0 the exact z underflows in the last cells.
    let log = if log > LN_BELOW_MIN { log } else { LN_BELOW_MIN };
    let [z, gap] = exp(log, exponent.lost);
    let z = if z > f32::MIN_POSITIVE { z } else { f32::MIN_POSITIVE };
    [gap * (1.0 + z), z]
}

/// The uniform lobe over them.
#[inline(always)]
pub(super) fn uniform_passes<D: DiscKernel<Disc = FastDisc>>(
    u: &Block,
    v: &Block,
    [x, y, z]: &mut [Lanes<f32>; 3],
) {
    for lane in 0..BLOCK {
        let FastDisc { r2, one_minus_r2, .. } = D::disc([u[lane], v[lane]]);
        x[lane] = r2 * (1.0 + one_minus_r2);
        z[lane] = one_minus_r2;
    }
    for sin in x.iter_mut() {
        *sin = root_to_1(*sin);
    }
    at_distances::<D>(u, v, x, y);
}

/// The cosine lobe over them.
#[inline(always)]
pub(super) fn cosine_passes<D: DiscKernel<Disc = FastDisc>>(
    u: &Block,
    v: &Block,
    [x, y, z]: &mut [Lanes<f32>; 3],
) {
    for lane in 0..BLOCK {
        z[lane] = D::disc([u[lane], v[lane]]).one_minus_r2;
    }
    for z in z {
        *z = normal_sqrt(*z);
    }
    in_octant::<D>(u, v, x, y);
    to_places::<D>(u, v, x, y);
}

/// The power lobe over them.
#[inline(always)]
pub(super) fn power_passes<D: DiscKernel<Disc = FastDisc>>(
    exponent: FastExponent,
    u: &Block,
    v: &Block,
    [x, y, z]: &mut [Lanes<f32>; 3],
) {
    for lane in 0..BLOCK {
        let FastDisc { r2, one_minus_r2, .. } = D::disc([u[lane], v[lane]]);
        z[lane] = ln_complement(r2, one_minus_r2);
    }
    for (square, z) in x.iter_mut().zip(z) {
        [*square, *z] = elevation(exponent, *z);
    }
    for sin in x.iter_mut() {
        *sin = exponent.distance(*sin);
    }
    at_distances::<D>(u, v, x, y);
}

/// Points in the directions of a disc map's points, at the distances from the axis in x.
#[inline(always)]
fn at_distances<D: DiscKernel<Disc = FastDisc>>(
    u: &Block,
    v: &Block,
    x: &mut Lanes<f32>,
    y: &mut Lanes<f32>,
) {
    let mut t = [0.0; BLOCK];
    for lane in 0..BLOCK {
        t[lane] = D::disc([u[lane], v[lane]]).t;
        y[lane] = x[lane] * t[lane];
    }
    less_gaps(x, y, &t);
    to_places::<D>(u, v, x, y);
}
