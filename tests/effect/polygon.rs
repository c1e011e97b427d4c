//! The polygonal aperture as a map.

use super::{COUNT, Float, assert_near, each_float, wide};
use hemidisc::Density;
use hemidisc::Invert;
use hemidisc::Map;
use hemidisc::arithmetic::Real;
use hemidisc::effect::Polygon;
use hemidisc::sequence::SobolOwen;
use std::f64::consts::{PI, TAU};

/// Points of a polygon with a corner at `turns` (which is 6e-11 short of the circle): within the
/// disc and every side, evenly over the blades and over the inner and outer half of their area, and
/// found again from their place.
fn check<A: Float, const N: usize>(turns: f64) {
    let polygon = Polygon::<A, N>::new((turns * 4_294_967_296.0) as u32);
    let (apothem, n) = ((PI / N as f64).cos(), N as f64);
    let mut blades = [0_u32; N];
    let mut inner = 0;
    let count = COUNT * 4;
    for i in 0..count {
        let uv = SobolOwen::new(3).at(i);
        let point = polygon.sample(uv);
        let [x, y] = wide(point);
        assert!(x.mul_add(x, y * y) <= 1.0, "{x} {y}");
        let turn = (y.atan2(x) / TAU - turns).rem_euclid(1.0);
        let blade = ((turn * n) as usize).min(N - 1);
        blades[blade] += 1;
        // Distance to the side of its blade.
        let middle = TAU * (turns + (blade as f64 + 0.5) / n);
        let out = (x * middle.cos() + y * middle.sin()) / apothem;
        assert!(out <= 1.0 + 4.0 * A::EPS, "{N}: {x} {y}: {out}");
        inner += u32::from(out * out < 0.5);
        let area = n / 2.0 * (TAU / n).sin();
        assert_near(polygon.density(point).into(), 1.0 / area, 2e-10 + 4.0 * A::EPS, "density");
        let again = wide(polygon.sample(polygon.invert(point)));
        assert_near((again[0] - x).hypot(again[1] - y), 0.0, 8.0 * A::EPS, "inverse");
    }
    for points in blades.into_iter().map(f64::from).chain([f64::from(inner) / n * 2.0]) {
        let even = f64::from(count) / n;
        assert!((points - even).abs() < 0.02 * even, "{N}: {blades:?} {inner}");
    }
    for outside in [[1.01, 0.0], [0.0, -1.01], [f64::NAN, 0.0], [f64::INFINITY, 0.0]] {
        assert_eq!(polygon.density(outside.map(A::real)).into(), 0.0, "{outside:?}");
    }
}

/// On the first side of a blade u is its smallest, which must not be rounded down into the blade
/// before.
fn the_side_between_two_blades_is_found_again<A: Float>() {
    let polygon = Polygon::<A, 5>::new(0);
    for blade in 0..5_u64 {
        let u = (blade << 32).div_ceil(5) as u32;
        for v in [1 << 20, 1 << 30, 3 << 30] {
            let point = polygon.sample([u, v]);
            let [there, again] = [point, polygon.sample(polygon.invert(point))].map(wide);
            let moved = (again[0] - there[0]).hypot(again[1] - there[1]);
            assert_near(moved, 0.0, 8.0 * A::EPS, "inverse");
        }
    }
}

/// The density is 1 / area to the last digits for any number of blades, and that of a sample.
fn one_density<A: Float, const N: usize>() {
    let polygon = Polygon::<A, N>::new(1 << 20);
    let exact = 2.0 / (N as f64 * (TAU / N as f64).sin());
    for i in 0..100 {
        let (point, density) = polygon.sample_with_density(SobolOwen::new(3).at(i));
        let wide: f64 = density.into();
        // The quotient here rounds as well.
        let room = f64::max(A::Real::EPSILON.into(), 4.0 * f64::EPSILON);
        assert!((wide / exact - 1.0).abs() <= room, "{N}: {wide} {exact}");
        assert_eq!(polygon.density(point), density, "{N}: {point:?}");
    }
}

/// 1 / (N/2 sin(2 pi / N)) by mpmath for 3 and 4096 blades; for others by f64's sine.
fn the_area_has_no_rounding_of_its_blades<A: Float>() {
    for (found, exact) in [
        (Polygon::<A, 3>::new(0).sample_with_density([7, 7]).1, 0.769_800_358_919_501),
        (Polygon::<A, 4096>::new(0).sample_with_density([7, 7]).1, 0.318_310_011_019_501_f64),
    ] {
        let room = f64::max(A::Real::EPSILON.into(), 2.0 * f64::EPSILON);
        assert!((found.into() / exact - 1.0).abs() <= room, "{found:?}");
    }
    one_density::<A, 3>();
    one_density::<A, 4>();
    one_density::<A, 5>();
    one_density::<A, 7>();
    one_density::<A, 16>();
    one_density::<A, 100>();
    one_density::<A, 1000>();
    one_density::<A, 5000>();
}

/// A generator's two words are the coordinates; `Default` has a corner on the x axis.
fn a_generator_draws_from_it<A: Float>() {
    let polygon = Polygon::<A, 6>::default();
    assert_eq!(polygon, Polygon::new(0));
    #[cfg(feature = "rand")]
    {
        use rand::distr::Distribution;
        use rand::{Rng, SeedableRng, rngs::SmallRng};
        let mut generator = SmallRng::seed_from_u64(3);
        let mut same = generator.clone();
        for _ in 0..10 {
            let point: [A::Real; 2] = Distribution::sample(&polygon, &mut generator);
            assert_eq!(point, Map::sample(&polygon, [same.next_u32(), same.next_u32()]));
        }
    }
}

fn points_are_even_and_inside<A: Float>() {
    check::<A, 3>(0.25);
    check::<A, 5>(0.0);
    check::<A, 6>(0.123);
    check::<A, 8>(0.9);
    check::<A, 16>(0.5);
}

each_float!(
    points_are_even_and_inside the_side_between_two_blades_is_found_again
    the_area_has_no_rounding_of_its_blades a_generator_draws_from_it
);
