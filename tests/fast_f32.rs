//! Fast f32 in full: each one-dimensional kernel against f64, and the rims of the disc.
//!
//! By default every 61st f32 and point; all of them, in five minutes of two threads, by
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --test fast_f32 -- --nocapture

use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{MapVisitor, maps, power_maps};
use hemidisc::invariant::{self, Exact, in_unit_disc};
use hemidisc::sequence::Random;
use hemidisc::{Concentric, Cosine, Error, FastF32, Map, Points, Polar, Power, Square, Uniform};
use std::array::from_fn;
use std::f64::consts::FRAC_PI_4;

/// Half an ulp of 1, the unit of all errors here.
const EPS: f64 = 0.5 / (1_u64 << 23) as f64;

/// A prime, so that a strided walk is in step with no power of two.
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
        // A NaN stays, and fails the comparison with the bound.
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
        let [cos_gap, sin_gap] = FastF32::gaps(t * t);
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
        near.include(x, relative(FastF32::ln_complement(x, 1.0 - x), exact));
    }
    for rim in floats(0.5_f32.powi(33), 0.5) {
        let exact = f64::from(rim).ln();
        far.include(rim, relative(FastF32::ln_complement(1.0 - rim, rim), exact));
    }
    near.assert();
    far.assert();
}

#[test]
fn exponentials() {
    let (mut exp, mut gap) = (Worst::new("exp", 1.75), Worst::new("1 - exp", 1.75));
    for magnitude in floats(0.5_f32.powi(110), 87.3) {
        let [got, got_gap] = FastF32::exp(-magnitude);
        let x = -f64::from(magnitude);
        exp.include(-magnitude, relative(got, x.exp()));
        gap.include(-magnitude, relative(got_gap, -x.exp_m1()));
    }
    // Densities of exponents below 0.
    for x in floats(0.5_f32.powi(30), 88.0) {
        exp.include(x, relative(FastF32::exp(x)[0], f64::from(x).exp()));
    }
    exp.assert();
    gap.assert();
    assert_eq!(FastF32::exp(0.0), [1.0, 0.0]);
}

#[test]
fn arc_tangents() {
    let mut worst = Worst::new("atan", 1.75);
    for x in floats(f32::MIN_POSITIVE, 1.0) {
        worst.include(x, relative(FastF32::atan(x), f64::from(x).atan()));
    }
    worst.assert();
    assert_eq!(FastF32::atan(0.0), 0.0);
}

/// Magnitudes about the centre as coordinates.
fn outward(magnitude: u32) -> u32 {
    0x8000_0000 + magnitude
}

/// Every m in 0..2^31 whose m + 1/2 is another f32 than that of the m before, and each `stride`-th.
fn distinct_f32(stride: usize) -> impl Iterator<Item = u32> {
    // Below 2^23 each m has its own; above, one in 2^(bit - 23).
    let exact = 0..1_u32 << 23;
    let rounded = (23..31).flat_map(|bit| (1 << bit..1 << (bit + 1)).step_by(1 << (bit - 23)));
    exact.chain(rounded).step_by(stride)
}

/// The eight outermost radii of f32: 1, 1 - eps and so on.
const RADII: u32 = 8;

/// The outermost and the innermost magnitude that round to a radius: 1 - r^2 differs.
fn ends(radius: u32) -> [u32; 2] {
    let middle = 0x8000_0000 - 128 * radius;
    let ends = [(middle + 63).min(0x7fff_ffff), middle - 63];
    let rounded = ends.map(|m| ((m as f32 + 0.5) / 2_147_483_648.0).to_bits());
    assert_eq!(rounded, [1.0_f32.to_bits() - radius; 2]);
    ends
}

fn on_disc(xy: [f32; 2]) -> u64 {
    u64::from(!in_unit_disc(xy.map(f64::from)))
}

/// Points of one ring, on both sides of its diagonal, in five maps; and how many are outside.
fn walk_ring(radius: u32) -> [u64; 2] {
    let (disc, cosine) = (Concentric::<FastF32>::new(), Cosine::<FastF32>::new());
    let uniform = Uniform::<FastF32>::new();
    let powers = [1.0, 100.0].map(|e| Power::<FastF32>::new(e).unwrap());
    let [outer, inner] = ends(radius);
    let [mut walked, mut outside] = [0; 2];
    for minor in distinct_f32(stride()).map(outward) {
        for uv in [[outward(outer), minor], [minor, outward(inner)]] {
            let point = disc.sample(uv);
            outside += on_disc(point);
            let [x, y, z] = cosine.sample(uv);
            assert!([x, y] == point && z > 0.0, "{uv:08x?}");
            let directions = [uniform.sample(uv), powers[0].sample(uv), powers[1].sample(uv)];
            for [x, y, z] in directions {
                outside += on_disc([x, y]);
                assert!(z > 0.0, "{uv:08x?}");
            }
            walked += 1;
        }
    }
    [walked, outside]
}

/// Sums what a walk of each radius gives, on two threads.
fn over_radii(walk: impl Fn(u32) -> [u64; 2] + Sync) -> [u64; 2] {
    std::thread::scope(|scope| {
        let walk = &walk;
        let halves = [0, 1].map(|first| {
            scope.spawn(move || (first..RADII).step_by(2).map(walk).collect::<Vec<_>>())
        });
        let counts: Vec<_> = halves.into_iter().flat_map(|half| half.join().unwrap()).collect();
        from_fn(|i| counts.iter().map(|count| count[i]).sum())
    })
}

#[test]
fn no_point_of_the_outer_rings_is_outside() {
    let [walked, outside] = over_radii(walk_ring);
    println!("{walked} points of {RADII} outer rings in each of 5 maps, {outside} outside");
    assert_eq!(outside, 0);
    assert_eq!(walked, distinct_f32(stride()).count() as u64 * 2 * u64::from(RADII));
}

/// The polar map and all lobes place a point by its distance and its t = phi / (pi/4) alone: every t.
#[test]
fn no_distance_and_angle_is_outside() {
    let [walked, outside] = over_radii(|below| {
        let distance = f32::from_bits(1.0_f32.to_bits() - below);
        let [mut walked, mut outside] = [0; 2];
        for t in floats(0.5_f32.powi(33), 1.0) {
            outside += on_disc(FastF32::octant(distance, t));
            walked += 1;
        }
        [walked, outside]
    });
    println!("{walked} points at {RADII} distances, {outside} outside");
    assert_eq!(outside, 0);
    // The next distance inward is far from the rim already.
    let inner = f32::from_bits(1.0_f32.to_bits() - RADII);
    assert!(f64::from(inner).powi(2) < 1.0 - 15.0 * EPS);
}

/// Random coordinates, and near every power of two from the edges and the centre.
fn coordinates() -> Vec<[u32; 2]> {
    let near = |base: u32, step: u32| [base ^ step, base ^ step.wrapping_sub(1), base ^ (step | 1)];
    let hard: Vec<u32> = (0..32)
        .flat_map(|bit| [0, u32::MAX, 1 << 31].map(|base| near(base, 1 << bit)))
        .flatten()
        .step_by(3)
        .chain([0, u32::MAX, 1 << 31, (1 << 31) - 1])
        .collect();
    let pairs = hard.iter().flat_map(|&u| hard.iter().map(move |&v| [u, v]));
    pairs.chain((0..20_000).map(|i| Random::new(5).at(i))).collect()
}

/// The exponents that an f32 can be, from the least to the largest.
const EXPONENTS: [f32; 14] = [
    -1.0 + f32::EPSILON / 2.0,
    -0.999_999,
    -0.9,
    -0.5,
    -1e-7,
    0.0,
    1e-30,
    1.0,
    50.0,
    1e8,
    4.398_046e12,
    4.398_047e12,
    1e30,
    f32::MAX,
];

/// Every promise at every coordinate.
struct Promises<'a>(&'a [[u32; 2]]);

impl<A: Arithmetic<Real: Exact>> MapVisitor<A> for Promises<'_> {
    fn disc<M: Map<Arithmetic = A, Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        for &uv in self.0 {
            invariant::disc(&map, uv).unwrap();
            mirrored(name, &map, uv);
        }
    }

    fn hemisphere<M: Map<Arithmetic = A, Point = [A::Real; 3]>>(
        &mut self,
        lobe: &'static str,
        disc: &'static str,
        map: M,
    ) {
        for &uv in self.0 {
            invariant::hemisphere(&map, uv).unwrap_or_else(|v| panic!("{lobe} {disc}: {v}"));
            mirrored(disc, &map, uv);
        }
    }
}

fn mirrored<R: Exact, const D: usize>(disc: &str, map: &impl Map<Point = [R; D]>, uv: [u32; 2]) {
    match disc {
        "polar" => invariant::mirrored_polar(map, uv).unwrap(),
        _ => invariant::mirrored_concentric(map, uv).unwrap(),
    }
}

#[test]
fn every_promise_holds_for_every_exponent() {
    let coordinates = coordinates();
    maps::<FastF32>(&mut Promises(&coordinates));
    for e in EXPONENTS {
        power_maps::<FastF32>(e, &mut Promises(&coordinates)).unwrap();
    }
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, -1.5, f32::MIN] {
        assert!(matches!(Power::<FastF32>::new(bad), Err(Error::Exponent { .. })), "{bad}");
    }
}

#[test]
fn constants_blocks_and_traits_give_the_same_bits() {
    const UV: [u32; 2] = [0x0123_4567, 0xfedc_ba98];
    const AT_COMPILE_TIME: [[f32; 2]; 2] = [FastF32::concentric(UV), FastF32::polar(UV)];
    let uv = std::hint::black_box(UV);
    assert_eq!(AT_COMPILE_TIME, [FastF32::concentric(uv), FastF32::polar(uv)]);
    for uv in coordinates() {
        assert_eq!(FastF32::concentric(uv), Concentric::<FastF32>::new().sample(uv));
        assert_eq!(
            FastF32::concentric(uv),
            FastF32::store(<FastF32 as Arithmetic>::concentric::<true>(uv))
        );
        assert_eq!(FastF32::polar(uv), Polar::<FastF32>::new().sample(uv));
        assert_eq!(FastF32::square(uv), Square(uv).to_f32());
    }
    for e in EXPONENTS {
        let lobe =
            Points::of_range(Random::new(1), Power::<FastF32>::new(e).unwrap(), 7, 300).unwrap();
        let mut filled = [[0.0; 3]; 300];
        assert_eq!(lobe.fill(&mut filled), 300);
        assert!(filled.into_iter().eq(lobe.iter()), "e = {e}");
    }
}

/// A point that no map gives comes back on the disc, and any bits have an inverse and a density.
#[test]
fn the_rest_is_total() {
    let stored = |point| FastF32::store(FastF32::load(point));
    for point in [[1.0, 0.0], [0.0, -1.0], [0.0, 0.0], [-1.0, 1e-45], [5.0, 0.0]] {
        assert_eq!(on_disc(stored(point)), 0, "{point:?}");
    }
    for e in EXPONENTS {
        let (lobe, polar) =
            (Power::<FastF32>::new(e).unwrap(), Power::<FastF32, _>::polar(e).unwrap());
        for i in 0..20_000 {
            let [[x, y], [z, _]] = [0, 1].map(|half| Random::new(half).at(i).map(f32::from_bits));
            lobe.invert([x, y, z]);
            polar.invert([x, y, z]);
            assert!(lobe.density([x, y, z]) >= 0.0, "{x} {y} {z}");
            lobe.invert([x, y, z].map(|c| c % 1.0));
        }
    }
}
