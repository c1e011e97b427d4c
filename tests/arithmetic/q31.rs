//! Q31: the concentric map over whole rings and, at length, over 10^9 pairs; and raw bits of any
//! value as points. What holds for every arithmetic, Q31 among them, is in `tests/map`.
//!
//! The reference is the textbook's formula in f64 on the exact coordinate: 2^-53 is 2^-22 LSB, and
//! no formula here loses more than a few hundred of them. At length (about four minutes on two cores):
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --all-features --test arithmetic \
//!         q31 -- --nocapture

use hemidisc::arithmetic::FixedExponent;
use hemidisc::invariant::Exact;
use hemidisc::sequence::Random;
use hemidisc::{
    Concentric, Cosine, Density, Invert, Polar, Power, Q31, Uniform, UnitSquare, disc::Rejection,
};
use testkit::contract::contract;
use testkit::errors::{EachMap, Errors, each_power_map, hard_coordinates};
use testkit::reference;

const LSB: f64 = 1.0 / 2_147_483_648.0;

fn exhaustive() -> bool {
    std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some()
}

fn on_disc(point: [Q31; 2], uv: [u32; 2]) {
    let [x, y] = point.map(|x| i128::from(x.to_bits()));
    assert!(x * x + y * y <= 1 << 62, "{uv:08x?}: {x} {y}");
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

/// Every minor coordinate at length, where `tests/map` takes those whose leading 24 bits differ.
#[test]
fn no_point_of_the_last_eight_rings_is_outside() {
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

/// Position and norm of the concentric map over random pairs, 10^9 of them at length.
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

/// Hard pairs and random ones.
fn pairs() -> Vec<[u32; 2]> {
    let hard = hard_coordinates();
    let sparse = hard.iter().step_by(3);
    let pairs = sparse.flat_map(|&u| hard.iter().map(move |&v| [u, v]));
    pairs.chain((0..100_000).map(|i| Random::new(31).at(i))).collect()
}

/// The errors of the lobe of an exponent, against its contract.
struct Largest(f64);

impl EachMap<Q31> for Largest {
    fn each<const D: usize, M: Invert<Point = [Q31; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let (contract, e) = (contract("q31", kind).unwrap(), self.0);
        for uv in pairs() {
            let exact = reference::reference::<Q31>(kind, disc, e, uv);
            let errors = Errors::at::<Q31, _>(&map, uv, e, exact, &contract);
            let label = format_args!("{kind}/{disc} e = {e} at {uv:08x?}");
            errors.assert_within(&contract, true, true, &label);
        }
    }
}

/// From 2^32 - 1 on e + 1 takes one bit more than 64. `tests/map` has no exponent as large.
#[test]
fn the_largest_exponents_hold_the_contract() {
    for e in [1e9, 4_294_967_295.0] {
        each_power_map::<Q31>(FixedExponent::try_from(e).unwrap(), &mut Largest(e));
    }
}

/// Any bits are a point or a direction to an inverse and to a density. An answer comes without a
/// panic, also at the ends of 32 bits, and nothing has a density below the horizon.
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
            let _ = map.invert(direction);
        }
        let _ = Uniform::<Q31>::new().invert(direction);
        let _ = Uniform::over(Polar::<Q31>::new()).invert(direction);
        let _ = Cosine::<Q31>::new().invert(direction);
        let _ = Concentric::<Q31>::new().invert([x, y]);
        let _ = Polar::<Q31>::new().invert([x, y]);
        let _ = UnitSquare::<Q31>::new().invert([x, y]);
        let _ = Rejection::<Q31>::invert([x, y]);
        let _ = Rejection::<Q31>::density([x, y]);
    }
}

#[test]
fn the_square_and_rejection_come_back() {
    for uv in pairs() {
        let square = UnitSquare::<Q31>::new();
        assert_eq!(square.invert(square.sample(uv)), uv.map(|k| k & !1));
        assert_eq!(square.density(square.sample(uv)), Q31::MAX);
        if let Some(point) = Rejection::<Q31>::sample(uv) {
            on_disc(point, uv);
            assert_eq!(Rejection::<Q31>::sample(Rejection::<Q31>::invert(point)), Some(point));
            assert_eq!(Rejection::<Q31>::density(point), Q31::MAX);
        }
    }
}
