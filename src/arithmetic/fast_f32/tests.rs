//! The kernels of fast f32 in full: each function of one dimension against f64.
//!
//! By default every 61st f32; all of them, in three minutes, by
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --lib fast_f32 -- --nocapture

use super::FastF32;
use super::back::Functions;
use super::disc::{FastDisc, centre_down, centre_nearest, concentric, gaps, polar};
use super::functions::{self, ln_complement};
use crate::arithmetic::Float;
use crate::invariant::in_unit_disc;
use crate::target::BRANCHES;
use std::f64::consts::FRAC_PI_4;
use std::println;

/// The radii of f32 next to 1: 1, 1 - eps and so on.
const RADII: u32 = 8;

/// Half an ulp of 1, the unit of all errors here.
const EPS: f64 = 0.5 / (1_u64 << 23) as f64;

/// A prime, so that the stride shares no factor with a power of two.
fn stride() -> usize {
    if std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some() { 1 } else { 61 }
}

/// Every `stride`-th f32 of [from, to], and its two ends.
fn floats(from: f32, to: f32) -> impl Iterator<Item = f32> {
    assert!(0.0 <= from && from <= to);
    let inner = (from.to_bits()..=to.to_bits()).step_by(stride());
    inner.chain([to.to_bits()]).map(f32::from_bits)
}

/// The largest error, which must not exceed its bound, and must be more than half of it.
struct Worst {
    kernel: &'static str,
    bound: f64,
    found: f64,
    at: f32,
    count: u64,
}

impl Worst {
    fn new(kernel: &'static str, bound: f64) -> Self {
        Self { kernel, bound, found: 0.0, at: 0.0, count: 0 }
    }

    /// An error in units of 2^-24.
    fn include(&mut self, x: f32, error: f64) {
        let error = error.abs() / EPS;
        // A NaN propagates, and fails the comparison with the bound.
        if error > self.found || error.is_nan() {
            (self.found, self.at) = (error, x);
        }
        self.count += 1;
    }

    fn assert(&self) {
        let Self { kernel, bound, found, at, count } = self;
        println!("{kernel}: {count} f32, largest error {found:.4} eps at {at:e}");
        assert!(found <= bound, "{kernel} of {at:e}: {found} exceeds {bound}");
        assert!(*bound < 2.0 * found, "{kernel}: bound {bound} is stale, found {found}");
    }
}

fn relative(value: f32, exact: f64) -> f64 {
    (f64::from(value) - exact) / exact
}

/// All mantissas in two neighbouring binades; the other binades, which scale them by powers of two,
/// sampled.
#[test]
fn square_roots() {
    let mut worst = Worst::new("sqrt", 1.6);
    let mut include = |x: f32| worst.include(x, relative(FastF32::sqrt(x), f64::from(x).sqrt()));
    floats(1.0, 4.0).for_each(&mut include);
    for exponent in 0..255_u32 {
        (0..1 << 23).step_by(4093).for_each(|m| include(f32::from_bits(exponent << 23 | m | 1)));
    }
    floats(f32::MAX * 0.999, f32::MAX).for_each(include);
    worst.assert();
    assert_eq!(FastF32::sqrt(0.0), 0.0);
    assert_eq!([1.0, 4.0, 0.25].map(FastF32::sqrt), [1.0, 2.0, 0.5]);
}

#[test]
fn sines_and_cosines() {
    // Below 2^-32 there is no coordinate.
    let (mut cos, mut sin) = (Worst::new("cosine", 0.75), Worst::new("sine", 1.0));
    for t in floats(0.5_f32.powi(32), 1.0) {
        let [cos_gap, sin_gap] = gaps(t * t);
        let (exact_sin, exact_cos) = (FRAC_PI_4 * f64::from(t)).sin_cos();
        cos.include(t, 1.0 - f64::from(cos_gap) - exact_cos);
        let exact_ratio = exact_sin / f64::from(t);
        sin.include(t, (1.0 - f64::from(sin_gap) - exact_ratio) / exact_ratio);
    }
    cos.assert();
    sin.assert();
}

/// Both arguments as the maps have them: the complement to within rounding, each from 2^-33 up.
#[test]
fn logarithms() {
    let (mut near, mut far) = (Worst::new("ln, x", 3.5), Worst::new("ln, 1 - x", 1.75));
    let least = 0.5_f32.powi(66);
    for x in floats(least, 0.5) {
        let exact = (-f64::from(x)).ln_1p();
        near.include(x, relative(ln_complement(x, 1.0 - x), exact));
    }
    for complement in floats(0.5_f32.powi(33), 0.5) {
        let exact = f64::from(complement).ln();
        far.include(complement, relative(ln_complement(1.0 - complement, complement), exact));
    }
    near.assert();
    far.assert();
}

#[test]
fn exponentials() {
    let (mut exp, mut gap) = (Worst::new("exp", 1.75), Worst::new("1 - exp", 1.75));
    for magnitude in floats(0.5_f32.powi(110), 87.3) {
        let [got, got_gap] = functions::exp(-magnitude, 0.0);
        let x = -f64::from(magnitude);
        exp.include(-magnitude, relative(got, x.exp()));
        gap.include(-magnitude, relative(got_gap, -x.exp_m1()));
    }
    // Densities of exponents below 0.
    for x in floats(0.5_f32.powi(30), 88.0) {
        exp.include(x, relative(functions::exp(x, 0.0)[0], f64::from(x).exp()));
    }
    exp.assert();
    gap.assert();
    assert_eq!(functions::exp(0.0, 0.0), [1.0, 0.0]);
}

#[test]
fn arc_tangents() {
    let mut worst = Worst::new("atan", 1.75);
    for x in floats(f32::MIN_POSITIVE, 1.0) {
        worst.include(x, relative(Functions::atan(x), f64::from(x).atan()));
    }
    worst.assert();
    assert_eq!(Functions::atan(0.0), 0.0);
}

/// The polar map and all lobes place a point by its distance and its t = phi / (pi/4) alone: every
/// t.
#[test]
fn no_distance_and_angle_is_outside() {
    let [mut walked, mut outside] = [0_u64; 2];
    for below in 0..RADII {
        let distance = f32::from_bits(1.0_f32.to_bits() - below);
        for t in floats(0.5_f32.powi(33), 1.0) {
            let point = FastDisc::at_fraction::<BRANCHES>(distance, t);
            outside += u64::from(!in_unit_disc(point.map(f64::from)));
            walked += 1;
        }
    }
    println!("{walked} points at {RADII} distances, {outside} outside");
    assert_eq!(outside, 0);
    // The next distance inward is already far from the rim.
    let inner = f32::from_bits(1.0_f32.to_bits() - RADII);
    assert!(f64::from(inner).powi(2) < 1.0 - 15.0 * EPS);
}

/// Words near powers of two from both ends and the middle, and across the tests for the rim.
fn words() -> impl Iterator<Item = u32> + Clone {
    let steps = (0..31).flat_map(|bit| [1 << bit, (1 << bit) - 1, (1 << bit) + 5]);
    let rim = (0..1 << 13).step_by(61);
    steps.chain(rim).flat_map(|step: u32| [step, !step, step ^ 0x8000_0000, step ^ 0x7fff_ffff])
}

/// In f64 the centre of a cell is exact.
#[test]
fn centres_are_rounded_as_they_say() {
    for k in words().chain((0..1 << 20).map(|i: u32| i.wrapping_mul(0x9e37_79b1))) {
        let exact = (f64::from(k) + 0.5) / 4_294_967_296.0;
        let nearest = exact as f32;
        let down = if f64::from(nearest) > exact { nearest.next_down() } else { nearest };
        assert_eq!([centre_nearest(k), centre_down(k)], [nearest, down], "{k:x}");
    }
}

/// Both forms are compiled everywhere, though a target uses only one.
#[test]
fn branches_do_not_change_a_bit() {
    for u in words() {
        for v in words() {
            let uv = [u, v];
            assert_eq!(concentric::<true>(uv), concentric::<false>(uv), "{u:x} {v:x}");
            assert_eq!(polar::<true>(uv), polar::<false>(uv), "{u:x} {v:x}");
        }
    }
    for (u, below) in words().zip((0..64).cycle()) {
        let distance = f32::from_bits(1.0_f32.to_bits() - below);
        for disc in [concentric::<true>([u, !u]), polar::<true>([u, u.rotate_left(9)])] {
            assert_eq!(disc.place_at::<true>(distance), disc.place_at::<false>(distance));
        }
    }
}
