//! The kernels of fast f32 in full: each function of one dimension against f64.
//!
//! By default every 61st f32; all of them, in three minutes, by
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --lib fast_f32 -- --nocapture

use super::FastF32;
use super::back::Functions;
use super::disc::{
    self, FastDisc, centre, centre_down, centre_nearest, direction, gaps, inward, squares,
};
use super::functions::{self, exp_2, exp_2_1, ln_complement};
use super::lobes::elevation;
use super::root::{by_digits, by_floats, by_products, now};
use crate::arithmetic::Float;
use crate::invariant::in_unit_disc;
use crate::target::form::{BRANCHES, LANE, ONE, WORDS};
use std::f64::consts::{FRAC_PI_4, LN_2};
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

/// A test of every form of a kernel: all are compiled everywhere, though a target uses two.
macro_rules! each_form {
    ($test:ident) => {
        $test::<LANE>();
        $test::<WORDS>();
        $test::<BRANCHES>();
    };
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

/// Each way and the processor's own: all mantissas in two neighbouring binades; the other binades,
/// which scale them by powers of two, sampled. IEEE 754's root of f64 rounds twice, and yet once: it
/// has more than twice the digits.
#[test]
fn square_roots_are_correctly_rounded() {
    let mut checked = 0_u64;
    let mut check = |x: f32| {
        let exact = f64::from(x).sqrt() as f32;
        assert_eq!([by_floats(x), by_digits(x), FastF32::sqrt(x)], [exact; 3], "{x:e}");
        if x >= 0.5_f32.powi(110) {
            assert_eq!([by_products(x), now(x)], [exact; 2], "{x:e}");
        }
        checked += 1;
    };
    floats(1.0, 4.0).for_each(&mut check);
    for exponent in 1..255_u32 {
        (0..1 << 23).step_by(4093).for_each(|m| check(f32::from_bits(exponent << 23 | m)));
        // Next to squares of numbers of 24 and of 12 bits.
        for root in [1.0_f32, 1.5, 1.9375, 1.999_511_7, 1.999_999_9, 1.3] {
            let square = (root * root).to_bits() & 0x007f_ffff | exponent << 23;
            let last = (square + 2).min(f32::MAX.to_bits());
            ((square - 2).max(1 << 23)..=last).for_each(|x| check(f32::from_bits(x)));
        }
    }
    floats(f32::MAX * 0.999, f32::MAX).for_each(check);
    println!("{checked} f32, each the nearest");
    assert_eq!(FastF32::sqrt(0.0), 0.0);
    for m in (1..1 << 23).step_by(4093) {
        let x = f32::from_bits(m);
        assert_eq!(FastF32::sqrt(x), f64::from(x).sqrt() as f32, "{x:e}");
    }
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
    each_form!(logarithms_of);
}

fn logarithms_of<const FORM: u8>() {
    let (mut near, mut far) = (Worst::new("ln, x", 3.5), Worst::new("ln, 1 - x", 2.1));
    let least = 0.5_f32.powi(66);
    for x in floats(least, 0.5) {
        let exact = (-f64::from(x)).ln_1p();
        near.include(x, relative(ln_complement::<FORM>(x, 1.0 - x), exact));
    }
    for complement in floats(0.5_f32.powi(33), 0.5) {
        let exact = f64::from(complement).ln();
        far.include(
            complement,
            relative(ln_complement::<FORM>(1.0 - complement, complement), exact),
        );
    }
    near.assert();
    far.assert();
}

#[test]
fn exponentials() {
    let (mut exp, mut gap) = (Worst::new("exp", 1.75), Worst::new("1 - exp", 1.75));
    for magnitude in floats(0.5_f32.powi(110), 87.3) {
        let [got, got_gap] = functions::exp(-magnitude);
        let x = -f64::from(magnitude);
        exp.include(-magnitude, relative(got, x.exp()));
        gap.include(-magnitude, relative(got_gap, -x.exp_m1()));
    }
    // Densities of exponents below 0.
    for x in floats(0.5_f32.powi(30), 88.0) {
        exp.include(x, relative(functions::exp(x)[0], f64::from(x).exp()));
    }
    exp.assert();
    gap.assert();
    assert_eq!(functions::exp(0.0), [1.0, 0.0]);
}

/// The power lobe's: 2^x and 1 - 2^x, in two parts.
#[test]
fn powers_of_2() {
    let (mut power, mut gap) = (Worst::new("2^x", 2.0), Worst::new("1 - 2^x", 3.0));
    for magnitude in floats(0.5_f32.powi(110), 126.0) {
        let [whole, excess] = exp_2(-magnitude, 0.0);
        let x = -f64::from(magnitude);
        power.include(-magnitude, relative(whole + excess, x.exp2()));
        let exact_gap = -(x * LN_2).exp_m1();
        gap.include(-magnitude, relative((1.0 - whole) - excess, exact_gap));
        if magnitude <= 0.5 {
            assert_eq!([whole, excess], [1.0, exp_2_1(-magnitude)], "{magnitude:e}");
        }
    }
    power.assert();
    gap.assert();
    assert_eq!(exp_2(0.0, 0.0), [1.0, 0.0]);
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

/// The polar map, and all lobes, place a point by its distance and its t = phi / (pi/4) alone: every
/// t. A map subtracts gaps from a point of the octant, and a lobe multiplies a direction of it.
#[test]
fn no_distance_and_angle_is_outside() {
    let [mut walked, mut outside] = [0_u64; 2];
    for below in 0..RADII {
        let distance = f32::from_bits(1.0_f32.to_bits() - below);
        for t in floats(0.5_f32.powi(33), 1.0) {
            let point = FastDisc::at_fraction::<ONE>(distance, t);
            let of_lobe = FastDisc::lobe_at_fraction::<ONE>(distance, t);
            let lane = direction(t, gaps(t * t)).map(|x| x * distance);
            for point in [point, of_lobe, inward(lane)] {
                outside += u64::from(!in_unit_disc(point.map(f64::from)));
                walked += 1;
            }
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
    each_form!(centres_of);
}

fn centres_of<const FORM: u8>() {
    for k in words().chain((0..1 << 20).map(|i: u32| i.wrapping_mul(0x9e37_79b1))) {
        let exact = (f64::from(k) + 0.5) / 4_294_967_296.0;
        let nearest = exact as f32;
        let down = if f64::from(nearest) > exact { nearest.next_down() } else { nearest };
        assert_eq!([centre_nearest::<FORM>(k), centre_down(k)], [nearest, down], "{k:x}");
        let n = k >> 1;
        assert_eq!(
            centre::<FORM, 31>(n),
            (n.cast_signed() as f32 + 0.5) * 0.5_f32.powi(31),
            "{n:x}"
        );
    }
}

/// The concentric or the polar map in a form.
fn discs<const FORM: u8>(uv: [u32; 2]) -> [FastDisc; 2] {
    let squares = squares::<FORM>(uv);
    [disc::concentric::<FORM>(uv), disc::polar::<FORM>(uv, squares, now(squares[0]))]
}

/// All forms are compiled everywhere, though a target uses only two.
#[test]
fn a_form_does_not_change_a_bit() {
    for u in words() {
        for v in words() {
            let uv = [u, v];
            let expected = discs::<LANE>(uv);
            assert_eq!([discs::<WORDS>(uv), discs::<BRANCHES>(uv)], [expected; 2], "{u:x} {v:x}");
        }
    }
    for (u, below) in words().zip((0..64).cycle()) {
        let distance = f32::from_bits(1.0_f32.to_bits() - below);
        for uv in [[u, !u], [u, u.rotate_left(9)]] {
            for disc in discs::<LANE>(uv) {
                let expected = disc.place_at::<LANE>(distance, 1.0);
                assert_eq!(disc.place_at::<WORDS>(distance, 1.0), expected);
                assert_eq!(disc.place_at::<BRANCHES>(distance, 1.0), expected);
            }
        }
    }
}

/// From every float of a range of ln(1 - r^2), and of exponents from -1 to the largest.
#[test]
fn a_form_does_not_change_an_elevation() {
    for e in [-0.999_999_9, -0.5, 0.0, 1.0, 50.0, 1e4, 1e12, 1e20, f32::MAX] {
        let exponent = FastF32::prepared(e).unwrap();
        for complement in words().map(centre_nearest::<LANE>) {
            let [x, ln] = [1.0 - complement, ln_complement::<LANE>(1.0 - complement, complement)];
            let expected = elevation::<LANE>(exponent, ln);
            assert_eq!(ln_complement::<WORDS>(x, complement), ln, "{complement:e}");
            assert_eq!(ln_complement::<BRANCHES>(x, complement), ln, "{complement:e}");
            assert_eq!(elevation::<WORDS>(exponent, ln), expected, "{e:e} {complement:e}");
            assert_eq!(elevation::<BRANCHES>(exponent, ln), expected, "{e:e} {complement:e}");
        }
    }
}
