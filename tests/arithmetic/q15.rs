//! Q15 over all 2^32 pairs of its coordinates, for every map and the lobes of e = 1, 10 and 100: on
//! the disc in integers, z at least 1 LSB, mirror images, errors within the contract, which is not
//! stale.
//!
//! A plain run takes the hard radii and a sample of the others; all of them:
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --all-features --test arithmetic \
//!         q15 -- --nocapture

mod rim;

use hemidisc::arithmetic::{Arithmetic, FixedExponent};
use hemidisc::catalogue::{LOBES, MapVisitor, POWER_LOBES, maps, power_maps};
use hemidisc::{Invert, Map, Polar, Power, Q15, Q15Div};
use indicatif::{MultiProgress, ProgressBar, ProgressStyle};
use std::f64::consts::{FRAC_PI_4, TAU};
use std::sync::LazyLock;
use testkit::contract::contract;
use testkit::reference::is_polar;

const ONE: f64 = 32_768.0;
/// Cells of an axis.
const CELLS: u32 = 1 << 16;
/// Magnitudes about the centre.
const MAGNITUDES: u32 = 1 << 15;

/// The bars of the tests, which run side by side.
static BARS: LazyLock<MultiProgress> = LazyLock::new(MultiProgress::new);

/// The largest errors in LSBs and how many points were tried.
#[derive(Clone, Copy, Debug, Default)]
struct Found {
    points: u64,
    position: f64,
    norm: f64,
    theta: f64,
}

impl Found {
    fn include(&mut self, other: Self) {
        self.points += other.points;
        self.position = self.position.max(other.position);
        self.norm = self.norm.max(other.norm);
        self.theta = self.theta.max(other.theta);
    }
}

/// sin theta and z, or r and nothing, on a circle of the disc.
#[derive(Clone, Copy)]
struct Circle {
    s: f64,
    z: Option<f64>,
}

/// The lobe of an exponent on the circle of r^2, straight from the definition.
fn circle(kind: &str, e: f64, r2: f64, rim: f64) -> Circle {
    let n = match kind {
        "disc" => return Circle { s: r2.sqrt(), z: None },
        "uniform" => 1.0,
        "cosine" => 2.0,
        "power" => e + 1.0,
        _ => panic!("no lobe is known as {kind}"),
    };
    let log = if r2 < 0.5 { (-r2).ln_1p() } else { rim.ln() } / n;
    Circle { s: (-(2.0 * log).exp_m1()).sqrt(), z: Some(log.exp()) }
}

/// One map over all its coordinates.
struct Sweep<'a> {
    /// The disc map to sweep.
    over: &'static str,
    found: &'a mut Vec<(String, Found)>,
    exponent: f64,
}

/// The error of a point, and its promises.
#[inline]
fn error<const D: usize>(point: [Q15; D], cos: f64, sin: f64, circle: Circle) -> Found {
    let [x, y] = [point[0], point[1]].map(|c| i32::from(c.to_bits()));
    assert!(x * x + y * y <= 1 << 30, "outside: {point:?}");
    let (exact_x, exact_y) = (circle.s * cos * ONE, circle.s * sin * ONE);
    let (x, y) = (f64::from(x), f64::from(y));
    let mut position = (x - exact_x).abs().max((y - exact_y).abs());
    let s2 = x * x + y * y;
    let Some(exact_z) = circle.z else {
        let norm = (s2.sqrt() - circle.s * ONE).abs();
        return Found { points: 0, position, norm, theta: 0.0 };
    };
    let z = point[2].to_bits();
    assert!(z >= 1, "z: {point:?}");
    let z = f64::from(z);
    position = position.max((z - exact_z * ONE).abs());
    let length = (s2 + z * z).sqrt();
    // The sine of the angle between the two in their plane.
    let theta = (s2.sqrt() * exact_z - z * circle.s).abs() / length * ONE;
    Found { points: 0, position, norm: (length - ONE).abs(), theta }
}

fn assert_mirrored<const D: usize>(image: [Q15; D], point: [Q15; D], negated: [bool; 2]) {
    for axis in 0..D {
        let negate = axis < 2 && negated[axis];
        let expected = if negate { -point[axis] } else { point[axis] };
        assert_eq!(
            image[axis], expected,
            "{point:?} has no mirror image in {negated:?}: {image:?}"
        );
    }
}

/// All points of a circle of the concentric map: the square ring of a major magnitude.
fn concentric_ring<const D: usize>(
    sample: &impl Fn([u32; 2]) -> [Q15; D],
    major: u32,
    lobe: impl Fn(f64, f64) -> Circle,
) -> Found {
    let a = f64::from(2 * major + 1) / f64::from(CELLS);
    let circle = lobe(a * a, (1.0 - a) * (1.0 + a));
    let mut found = Found::default();
    let cell = |m: u32, negative: bool| {
        let c = if negative { MAGNITUDES - 1 - m } else { MAGNITUDES + m };
        // The low half is not read.
        c << 16 | m & 0xffff
    };
    for minor in 0..=major {
        let (sin, cos) =
            (FRAC_PI_4 * f64::from(2 * minor + 1) / f64::from(2 * major + 1)).sin_cos();
        for steep in [false, true] {
            if steep && minor == major {
                continue;
            }
            let (m_u, m_v) = if steep { (minor, major) } else { (major, minor) };
            let point = sample([cell(m_u, false), cell(m_v, false)]);
            let (x, y) = if steep { (sin, cos) } else { (cos, sin) };
            found.include(error(point, x, y, circle));
            for negated in [[true, false], [false, true], [true, true]] {
                let image = sample([cell(m_u, negated[0]), cell(m_v, negated[1])]);
                assert_mirrored(image, point, negated);
            }
            found.points += 4;
        }
    }
    found
}

/// All points of a circle of the polar map: one v.
fn polar_ring<const D: usize>(
    sample: &impl Fn([u32; 2]) -> [Q15; D],
    v: u32,
    directions: &[(f64, f64)],
    lobe: impl Fn(f64, f64) -> Circle,
) -> Found {
    let centre = |v: u32| (f64::from(v) + 0.5) / f64::from(CELLS);
    let circle = lobe(centre(v), centre(CELLS - 1 - v));
    let mut found = Found::default();
    for (u, &(sin, cos)) in (0..).zip(directions) {
        let point = sample([u << 16 | v, v << 16 | u]);
        found.include(error(point, cos, sin, circle));
        let image = sample([(CELLS - 1 - u) << 16, v << 16]);
        assert_mirrored(image, point, [false, true]);
        found.points += 2;
    }
    found
}

/// The radii that are tried: all, or the hard ones and a sample.
fn radii(count: u32) -> Vec<u32> {
    if std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some() {
        return (0..count).rev().collect();
    }
    let hard = (0..count).filter(|r| {
        let near = |edge: u32| r.abs_diff(edge) <= 1;
        count - r <= 4
            || (0..16).any(|bit| near(1 << bit))
            || near(count / 2)
            || near(count / 4 * 3)
    });
    let mut radii: Vec<u32> = hard.chain((0..count).step_by(count as usize / 24)).collect();
    radii.sort_unstable();
    radii.dedup();
    radii.reverse();
    radii
}

impl Sweep<'_> {
    fn map<A: Arithmetic, const D: usize>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: impl Map<Point = [Q15; D]>,
    ) {
        if disc != self.over {
            return;
        }
        let polar = is_polar(disc);
        let exponent = self.exponent;
        let rows = radii(if polar { CELLS } else { MAGNITUDES });
        let directions: Vec<(f64, f64)> = (0..CELLS / 2)
            .map(|u| (TAU * (f64::from(u) + 0.5) / f64::from(CELLS)).sin_cos())
            .collect();
        let label = format!("{} {kind} over {disc}", A::NAME);
        let label = if kind == "power" { format!("{label}, e = {exponent}") } else { label };
        let bar = BARS.add(ProgressBar::new(rows.len() as u64)).with_message(label.clone());
        bar.set_style(
            ProgressStyle::with_template("{msg:40} {bar:30} {percent:>3} % {elapsed}").unwrap(),
        );
        let sample = |uv| map.sample(uv);
        let lobe = |r2, rim| circle(kind, exponent, r2, rim);
        let mut found = Found::default();
        for row in rows {
            found.include(if polar {
                polar_ring(&sample, row, &directions, lobe)
            } else {
                concentric_ring(&sample, row, lobe)
            });
            bar.inc(1);
        }
        let elapsed = bar.elapsed();
        bar.finish_and_clear();
        println!(
            "{label}: {} points, 0 outside; position {:.3}, norm {:.3}, theta {:.3} LSB; {elapsed:.0?}",
            found.points, found.position, found.norm, found.theta
        );
        let contract = contract(A::NAME, kind).unwrap();
        for (name, error, bound) in [
            ("position", found.position, contract.position),
            ("norm", found.norm, contract.norm),
            ("theta", found.theta, contract.theta),
        ] {
            assert!(error <= bound, "{label}: {name} error {error} exceeds {bound}");
        }
        self.found.push((kind.to_string(), found));
    }
}

impl<A: Arithmetic<Real = Q15>> MapVisitor<A> for Sweep<'_> {
    fn disc<M: Invert<Point = [Q15; 2]>>(&mut self, name: &'static str, map: M) {
        self.map::<A, _>("disc", name, map);
    }

    fn hemisphere<M: Invert<Point = [Q15; 3]>>(
        &mut self,
        lobe: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.map::<A, _>(lobe, disc, map);
    }
}

fn sweep<A: Arithmetic<Real = Q15, Parameter = FixedExponent>>(over: &'static str) {
    let mut found = Vec::new();
    let mut sweep = Sweep { over, found: &mut found, exponent: f64::NAN };
    maps::<A>(&mut sweep);
    // e = 0 is the uniform lobe by the longer way: with the sample of a plain run it is worth its
    // time.
    let full = std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some();
    let exponents = &[0, 1, 10, 100][usize::from(full)..];
    for e in exponents.iter().copied() {
        sweep.exponent = e.into();
        power_maps::<A>(e.into(), &mut sweep).unwrap();
    }
    let powers = POWER_LOBES.len();
    assert_eq!(found.len(), 1 + LOBES.len() - powers + powers * exponents.len());
    for kind in ["disc"].iter().chain(LOBES) {
        let contract = contract(A::NAME, kind).unwrap();
        let mut worst = Found::default();
        found.iter().filter(|(name, _)| name == kind).for_each(|(_, f)| worst.include(*f));
        for (name, error, bound) in [
            ("position", worst.position, contract.position),
            ("norm", worst.norm, contract.norm),
            ("theta", worst.theta, contract.theta),
        ] {
            // A contract is over both disc maps, so one of them may have much less.
            let fresh = bound == 0.0 || bound < 2.5 * error;
            assert!(fresh, "{} {kind}: {name} bound {bound} is stale: {error}", A::NAME);
        }
    }
}

#[test]
fn every_coordinate_over_polar() {
    sweep::<Q15>("polar");
}

#[test]
fn every_coordinate_over_concentric() {
    sweep::<Q15>("concentric");
}

// Over polar Q15Div has the kernels of Q15.
#[test]
fn every_coordinate_over_the_divided_concentric() {
    sweep::<Q15Div>("concentric");
}

/// The result where 16 bits are too few: the pole and 16 LSB about it, each to half an LSB.
#[test]
fn little_is_left_of_the_lobe_at_e_1e8() {
    let exponent = FixedExponent::from(100_000_000);
    let map = Power::<Q15>::new(exponent).unwrap();
    let (mut largest, mut worst) = (0, 0.0_f64);
    for major in radii(MAGNITUDES) {
        let a = f64::from(2 * major + 1) / f64::from(CELLS);
        let circle = circle("power", 1e8, a * a, (1.0 - a) * (1.0 + a));
        for minor in (0..=major).step_by(7) {
            let [x, y, z] = map.sample([(MAGNITUDES + major) << 16, (MAGNITUDES + minor) << 16]);
            assert_eq!(z, Q15::MAX);
            let t = f64::from(2 * minor + 1) / f64::from(2 * major + 1);
            let (sin, cos) = (FRAC_PI_4 * t).sin_cos();
            for (found, exact) in [(x, cos), (y, sin)] {
                let found = f64::from(found.to_bits());
                worst = worst.max((found - circle.s * exact * ONE).abs());
                largest = largest.max(found as i32);
            }
        }
    }
    let rim = Power::over(exponent, Polar::<Q15>::new()).unwrap().sample([0, u32::MAX]);
    assert_eq!(rim, [Q15::from_bits(16), Q15::ZERO, Q15::MAX]);
    println!("e = 1e8: at most {largest} LSB from the pole, within {worst:.3} LSB");
    assert!(largest == 15 && worst > 0.49 && worst <= 0.51, "{largest}, {worst}");
}

#[cfg(feature = "bytemuck")]
#[test]
fn a_buffer_of_numbers_is_one_of_their_bits() {
    use hemidisc::{Concentric, Points, Q31, sequence::Sobol};
    let points = Points::new(Sobol::new(0), Concentric::<Q15>::new());
    let buffer: [[Q15; 2]; 8] = points.to_array().unwrap();
    let bits: &[i16] = bytemuck::cast_slice(&buffer);
    assert!(
        bits.iter().eq(buffer
            .as_flattened()
            .iter()
            .map(|c| c.to_bits())
            .collect::<Vec<_>>()
            .iter())
    );
    let bits: [i32; 2] = bytemuck::cast([Q31::LSB, -Q31::LSB]);
    assert_eq!(bits, [1, -1]);
}
