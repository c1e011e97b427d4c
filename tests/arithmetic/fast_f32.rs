//! Fast f32: the rims of the disc, every promise at hard coordinates, and the same bits however
//! asked.
//!
//! By default every 61st point of the rims; all of them, in two minutes of two threads, by
//!
//!     HEMIDISC_EXHAUSTIVE=1 cargo test --release --test arithmetic fast_f32 -- --nocapture

use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{MapVisitor, maps, power_maps};
use hemidisc::invariant::{self, Exact, in_unit_disc};
use hemidisc::sequence::Random;
use hemidisc::{
    Concentric, Coordinates, Cosine, Density, Error, FastF32, Invert, Map, Points, Polar, Power,
    Uniform,
};
use std::array::from_fn;
use testkit::rings::{distinct, outward};

/// A prime, so that the stride shares no factor with a power of two.
fn stride() -> usize {
    if std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some() { 1 } else { 61 }
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
    for minor in distinct::<FastF32>(stride()).map(outward) {
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

/// Four maps hang on 1 - r^2 too, which is not the same at the two ends of what rounds to a radius.
/// `tests/map` walks four radii of every arithmetic, at one magnitude each, in two maps.
#[test]
fn no_point_at_either_end_of_a_radius_is_outside() {
    let [walked, outside] = over_radii(walk_ring);
    println!("{walked} points of {RADII} outer rings in each of 5 maps, {outside} outside");
    assert_eq!(outside, 0);
    assert_eq!(walked, distinct::<FastF32>(stride()).count() as u64 * 2 * u64::from(RADII));
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
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        for &uv in self.0 {
            invariant::disc(&map, uv).unwrap();
            mirrored(name, &map, uv);
        }
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
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
        "concentric" => invariant::mirrored_concentric(map, uv).unwrap(),
        _ => panic!("no symmetry is known of {disc}"),
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
fn blocks_give_the_same_bits_for_every_exponent() {
    for e in EXPONENTS {
        let lobe =
            Points::with_range(Random::new(1), Power::<FastF32>::new(e).unwrap(), 7..307).unwrap();
        let mut filled = [[0.0; 3]; 300];
        assert_eq!(lobe.fill(&mut filled), 300);
        assert!(filled.into_iter().eq(lobe.iter()), "e = {e}");
    }
}

#[test]
fn a_square_is_its_coordinates() {
    for uv in coordinates() {
        assert_eq!(FastF32::square(uv), Coordinates(uv).to_f32());
    }
}

/// Any bits have an inverse and a density.
#[test]
fn the_way_back_is_total() {
    for e in EXPONENTS {
        let (lobe, polar) =
            (Power::<FastF32>::new(e).unwrap(), Power::over(e, Polar::<FastF32>::new()).unwrap());
        for i in 0..20_000 {
            let [[x, y], [z, _]] = [0, 1].map(|half| Random::new(half).at(i).map(f32::from_bits));
            let _ = lobe.invert([x, y, z]);
            let _ = polar.invert([x, y, z]);
            assert!(lobe.density([x, y, z]) >= 0.0, "{x} {y} {z}");
            let _ = lobe.invert([x, y, z].map(|c| c % 1.0));
        }
    }
}
