//! Q31: every map against its contract and its promises; the concentric map, whose kernel is the hottest,
//! over whole rings and, at length, over the square.
//!
//! The reference is the textbook's formula in f64 on the exact coordinate: 2^-53 is 2^-22 LSB, and no
//! formula here loses more than a few hundred of them. At length (about four minutes on two cores):
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --all-features --test arithmetic q31 -- --nocapture

use hemidisc::arithmetic::FixedExponent;
use hemidisc::catalogue::{MapVisitor, maps, power_maps};
use hemidisc::invariant::{self, Exact};
use hemidisc::sequence::Random;
use hemidisc::{
    Concentric, Cosine, Density, Invert, Map, Polar, Power, Q31, Uniform, disc::Rejection,
};
use std::collections::BTreeMap;
use testkit::arithmetics::peak;
use testkit::contract::contract;
use testkit::reference;

const LSB: f64 = 1.0 / 2_147_483_648.0;
const EXPONENTS: [f64; 8] = [0.0, 0.5, 1.0, 10.0, 100.0, 1e4, 1e8, 4_294_967_295.0];

fn exhaustive() -> bool {
    std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some()
}

/// x, y, z, s^2 and the density as a part of its peak.
struct Reference {
    point: [f64; 3],
    s2: f64,
    density: f64,
}

fn reference(kind: &str, name: &str, e: f64, uv: [u32; 2]) -> Reference {
    let exact = reference::reference::<Q31>(kind, name, e, uv);
    Reference {
        point: [exact.x.hi, exact.y.hi, exact.z.map_or(0.0, |z| z.hi)],
        s2: exact.s2.hi,
        density: exact.density.hi / peak(kind, e),
    }
}

/// The largest errors of a map, in LSBs.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    position: f64,
    norm: f64,
    theta: f64,
    density: f64,
    /// What exceeds the first bound of the contract, divided by sqrt e.
    density_slope: f64,
    inverse: f64,
}

impl Errors {
    fn of<const D: usize, M>(map: &M, uv: [u32; 2], e: f64, exact: &Reference, bound: f64) -> Self
    where
        M: Invert<Point = [Q31; D]>,
    {
        let sample = map.sample(uv);
        let point = sample.map(Exact::exact);
        let position =
            point.iter().zip(exact.point).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // Exact: 62 bits and a sum, less what is near it.
        let square = |x: f64| x * x;
        let s2 = square(point[0]) + square(point[1]);
        let s = exact.s2.sqrt();
        let ds = (s2 - exact.s2) / (s2.sqrt() + s);
        let (norm, theta) = if D == 2 {
            (ds, 0.0)
        } else {
            let (z, dz) = (exact.point[2], point[2] - exact.point[2]);
            (s * ds + z * dz, z * ds - s * dz)
        };
        let density = (map.density(sample).exact() - exact.density).abs() / LSB;
        let again = map.sample(map.invert(sample)).map(Exact::exact);
        let apart = point.iter().zip(again).map(|(a, b)| square(a - b)).sum::<f64>().sqrt();
        Self {
            position: position / LSB,
            norm: norm.abs() / LSB,
            theta: theta.abs() / LSB,
            // Between 0 and 1 the density near the horizon hangs on the last bit of z: see tests/accuracy.
            density: if e == 0.0 || e == 1.0 { density } else { 0.0 },
            density_slope: if e > 1.0 { (density - bound).max(0.0) / e.sqrt() } else { 0.0 },
            inverse: apart / LSB,
        }
    }

    fn include(&mut self, other: Self) {
        for (a, b) in [
            (&mut self.position, other.position),
            (&mut self.norm, other.norm),
            (&mut self.theta, other.theta),
            (&mut self.density, other.density),
            (&mut self.density_slope, other.density_slope),
            (&mut self.inverse, other.inverse),
        ] {
            if b.is_nan() || b > *a {
                *a = b;
            }
        }
    }
}

struct Measure<'a> {
    points: &'a [[u32; 2]],
    e: f64,
    found: BTreeMap<(&'static str, String), Errors>,
}

impl Measure<'_> {
    fn each<const D: usize, M>(&mut self, kind: &'static str, disc: &'static str, map: &M)
    where
        M: Invert<Point = [Q31; D]>,
    {
        let name = if kind == "power" { format!("{disc} e = {}", self.e) } else { disc.into() };
        let total = self.found.entry((kind, name)).or_default();
        let bound = contract("q31", kind).unwrap().density[0];
        for &uv in self.points {
            let exact = reference(kind, disc, self.e, uv);
            total.include(Errors::of(map, uv, self.e, &exact, bound));
        }
    }
}

impl MapVisitor<Q31> for Measure<'_> {
    fn disc<M: Invert<Point = [Q31; 2]>>(&mut self, name: &'static str, map: M) {
        self.each("disc", name, &map);
    }

    fn hemisphere<M: Invert<Point = [Q31; 3]>>(
        &mut self,
        lobe: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.each(lobe, disc, &map);
    }
}

/// Coordinates where trouble lives: powers of two, the centre, the edges, each with neighbours.
fn hard_coordinates() -> Vec<u32> {
    let mut hard = vec![0];
    for bit in 0..32 {
        let step = 1_i64 << bit;
        for base in [step, (1 << 31) + step, (1 << 31) - step, (1 << 32) - step] {
            hard.extend((base - 2..=base + 2).filter_map(|k| u32::try_from(k).ok()));
        }
    }
    hard.sort_unstable();
    hard.dedup();
    hard
}

fn points(count: u32) -> Vec<[u32; 2]> {
    let hard = hard_coordinates();
    let sparse: Vec<u32> = hard.iter().step_by(3).copied().collect();
    let mut points: Vec<_> =
        sparse.iter().flat_map(|&u| sparse.iter().map(move |&v| [u, v])).collect();
    let random = Random::new(31);
    points.extend((0..count).map(|i| {
        let [u, v] = random.at(i);
        let small = u >> (1 + i % 30);
        match i % 8 {
            0 => [small, v],
            1 => [!small, v],
            2 => [0x8000_0000 ^ small, v],
            3 => [v, 0x8000_0000 ^ small],
            4 => [v, !small],
            5 => [u, u ^ small],
            _ => [u, v],
        }
    }));
    points
}

/// Asserts the contracts of the maps measured from both sides: no error exceeds its bound, none is half of
/// it or less.
fn assert_contracts(found: &BTreeMap<(&'static str, String), Errors>) {
    for kind in ["disc", "uniform", "cosine", "power"] {
        let contract = contract("q31", kind).unwrap();
        let mut worst = Errors::default();
        for ((_, name), errors) in found.iter().filter(|((of, _), _)| *of == kind) {
            println!("{kind} {name}: {errors:.3?}");
            worst.include(*errors);
        }
        println!("{kind}: {worst:.3?}");
        for (name, error, bound) in [
            ("position", worst.position, contract.position),
            ("norm", worst.norm, contract.norm),
            ("theta", worst.theta, contract.theta),
            ("density", worst.density, contract.density[0]),
            ("density for large e", worst.density_slope, contract.density[1]),
            ("inverse", worst.inverse, contract.round_trip),
        ] {
            assert!(error <= bound, "{kind}: {name} {error} exceeds {bound}");
            assert!(bound == 0.0 || bound < 2.0 * error, "{kind}: {name} {bound} for {error}");
        }
    }
}

#[test]
fn contracts_hold_and_are_not_stale() {
    let points = points(if exhaustive() { 2_000_000 } else { 150_000 });
    let mut measure = Measure { points: &points, e: 0.0, found: BTreeMap::new() };
    maps::<Q31>(&mut measure);
    for e in EXPONENTS {
        measure.e = e;
        power_maps::<Q31>(FixedExponent::try_from(e).unwrap(), &mut measure).unwrap();
    }
    // Any others, of any size.
    let random = Random::new(9);
    for i in 0..60 {
        let [bits, scale] = random.at(i);
        let e = f64::from(bits) * 0.5_f64.powi(5 + (scale % 28) as i32);
        let e = if e < 1.0 { 1.0 + e } else { e };
        let from = (i as usize * 7919) % (points.len() - 10_000);
        measure.points = &points[from..from + 10_000];
        measure.e = e;
        power_maps::<Q31>(FixedExponent::try_from(e).unwrap(), &mut measure).unwrap();
    }
    assert_contracts(&measure.found);
}

/// What must hold bit for bit at every sample.
struct Promises<'a>(&'a [[u32; 2]]);

impl MapVisitor<Q31> for Promises<'_> {
    fn disc<M: Invert<Point = [Q31; 2]>>(&mut self, name: &'static str, map: M) {
        for &uv in self.0 {
            on_disc(map.sample(uv), uv);
            assert!(map.density(map.sample(uv)) > Q31::ZERO);
            mirrored(name, &map, uv);
        }
    }

    fn hemisphere<M: Invert<Point = [Q31; 3]>>(
        &mut self,
        _: &'static str,
        disc: &'static str,
        map: M,
    ) {
        for &uv in self.0 {
            let direction @ [x, y, z] = map.sample(uv);
            on_disc([x, y], uv);
            assert!(z > Q31::ZERO && map.density(direction) > Q31::ZERO, "{uv:08x?}");
            mirrored(disc, &map, uv);
        }
    }
}

fn on_disc(point: [Q31; 2], uv: [u32; 2]) {
    let [x, y] = point.map(|x| i128::from(x.to_bits()));
    assert!(x * x + y * y <= 1 << 62, "{uv:08x?}: {x} {y}");
}

fn mirrored<const D: usize>(disc: &str, map: &impl Map<Point = [Q31; D]>, uv: [u32; 2]) {
    match disc {
        "polar" => invariant::mirrored_polar(map, uv),
        _ => invariant::mirrored_concentric(map, uv),
    }
    .unwrap();
}

#[test]
fn every_promise_holds() {
    let mut points = points(100_000);
    // The outer rings, and the last coordinates of polar.
    let random = Random::new(77);
    points.extend((0..if exhaustive() { 3_000_000 } else { 150_000 }).map(|i| {
        let [a, b] = random.at(i);
        let small = if i % 2 == 0 { a & 7 } else { a >> (14 + i % 16) };
        match i % 4 {
            0 => [b, !small],
            1 => [!small, b],
            2 => [!small, (!small).wrapping_sub(b >> (4 + i % 28))],
            _ => [b >> (1 + i % 31), !small],
        }
    }));
    let mut promises = Promises(&points);
    maps::<Q31>(&mut promises);
    for e in EXPONENTS {
        power_maps::<Q31>(FixedExponent::try_from(e).unwrap(), &mut promises).unwrap();
    }
    println!("{} points through every map", points.len());
}

/// Walks rings of the square; the other side of the diagonal has x and y swapped.
fn walk(majors: std::ops::Range<u32>, minors: impl Iterator<Item = u32> + Clone) -> u64 {
    let mut walked = 0;
    for major in majors {
        for minor in minors.clone().filter(|minor| *minor <= major) {
            let uv = [0x8000_0000 | major, 0x8000_0000 | minor];
            let [x, y] = Q31::concentric(uv).map(|x| i64::from(x.to_bits()));
            assert!(x >= 0 && y >= 0 && x * x + y * y <= 1 << 62, "{uv:08x?}: {x} {y}");
            walked += 1;
        }
    }
    walked
}

#[test]
fn no_point_of_the_outer_rings_is_outside() {
    let start = std::time::Instant::now();
    let mut walked = 0;
    for bit in 7..31 {
        let stride = 1_usize << bit;
        let at_most = if exhaustive() { 1 << 24 } else { 1 << 12 };
        walked += walk(0x7fff_fff8..0x8000_0000, (0..1 << 31).step_by(stride).take(at_most));
        walked += walk(0x7fff_fff8..0x8000_0000, (0..1 << 31).rev().step_by(stride).take(at_most));
    }
    if exhaustive() {
        // The last ring whole.
        walked += std::thread::scope(|scope| {
            let half = |minors| scope.spawn(move || walk(0x7fff_ffff..0x8000_0000, minors));
            [half(0..1 << 30), half(1 << 30..1 << 31)]
                .map(|t| t.join().unwrap())
                .iter()
                .sum::<u64>()
        });
    }
    // The one that a table longer by 0.2 LSB left outside, in 10^9 points.
    on_disc(Q31::concentric([u32::MAX, 0xfb0a_5800]), [u32::MAX, 0xfb0a_5800]);
    println!("{walked} points of the outer rings, 0 outside, in {:.0?}", start.elapsed());
}

/// Position and norm of the concentric map over random pairs, and that its two kernels agree.
#[test]
fn concentric_over_random_pairs() {
    let start = std::time::Instant::now();
    let each = if exhaustive() { 500_000_000 } else { 1_000_000 };
    let sample = |seed: u32| {
        let random = Random::new(seed);
        let (mut position, mut norm) = (0.0_f64, 0.0_f64);
        for i in 0..each {
            let uv = random.at(i);
            let point = Q31::concentric(uv);
            assert_eq!(point, Concentric::<Q31>::new().sample(uv));
            on_disc(point, uv);
            let [x, y] = point.map(Exact::exact);
            let ([cos, sin], r2, _) = reference::disc::<Q31>("concentric", uv);
            let r = r2.sqrt();
            position = position.max((x - r * cos).abs()).max((y - r * sin).abs());
            norm = norm.max((x.hypot(y) - r).abs());
        }
        (position / LSB, norm / LSB)
    };
    let found = std::thread::scope(|scope| {
        [1, 2].map(|seed| scope.spawn(move || sample(seed))).map(|thread| thread.join().unwrap())
    });
    println!(
        "{} pairs: position and norm {found:.3?}, in {:.0?}",
        2 * u64::from(each),
        start.elapsed()
    );
    let bounds = contract("q31", "disc").unwrap();
    assert!(
        found.iter().all(|(position, norm)| *position <= bounds.position && *norm <= bounds.norm)
    );
}

/// Any bits are a point or a direction to an inverse and to a density: an answer comes, without a panic, and
/// nothing has a density below the horizon.
#[test]
fn inverses_and_densities_are_total() {
    let edges = [i32::MIN, i32::MIN + 1, -1, 0, 1, 2, 1 << 30, i32::MAX - 1, i32::MAX, 0x5a82_7999];
    let mut directions = Vec::new();
    for x in edges {
        directions.extend(edges.iter().flat_map(|&y| edges.map(|z| [x, y, z])));
    }
    let random = Random::new(3);
    directions.extend((0..20_000).map(|i| {
        let ([x, y], [z, s]) = (random.at(2 * i), random.at(2 * i + 1));
        [x, y, z].map(|bits| bits.cast_signed() >> (s % 32))
    }));
    let powers = [0, 1, 1 << 31, 1 << 32, 10 << 32, u64::MAX - (1 << 32), u64::MAX];
    let powers = powers.map(|bits| Power::<Q31>::new(FixedExponent::from_bits(bits)).unwrap());
    for direction in directions.into_iter().map(|bits| bits.map(Q31::from_bits)) {
        let [x, y, z] = direction;
        let mut densities =
            vec![Uniform::<Q31>::new().density(direction), Cosine::<Q31>::new().density(direction)];
        densities.extend(powers.map(|map| map.density(direction)));
        assert!(
            densities.iter().all(|density| (*density > Q31::ZERO) == (z > Q31::ZERO)),
            "{direction:?}"
        );
        for map in powers {
            map.invert(direction);
        }
        Uniform::<Q31>::new().invert(direction);
        Uniform::over(Polar::<Q31>::new()).invert(direction);
        Cosine::<Q31>::new().invert(direction);
        Concentric::<Q31>::new().invert([x, y]);
        Polar::<Q31>::new().invert([x, y]);
        hemidisc::UnitSquare::<Q31>::new().invert([x, y]);
        Rejection::<Q31>::invert([x, y]);
        Rejection::<Q31>::density([x, y]);
    }
}

#[test]
fn the_square_and_rejection_come_back() {
    for uv in points(100_000) {
        let square = hemidisc::UnitSquare::<Q31>::new();
        assert_eq!(square.invert(square.sample(uv)), uv.map(|k| k & !1));
        assert_eq!(square.density(square.sample(uv)), Q31::MAX);
        if let Some(point) = Rejection::<Q31>::sample(uv) {
            on_disc(point, uv);
            assert_eq!(Rejection::<Q31>::sample(Rejection::<Q31>::invert(point)), Some(point));
            assert_eq!(Rejection::<Q31>::density(point), Q31::MAX);
        }
    }
}
