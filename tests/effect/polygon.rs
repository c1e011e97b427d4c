//! The polygonal aperture as a map.

use super::{COUNT, Float, assert_near, each_float, wide};
use hemidisc::Density;
use hemidisc::Invert;
use hemidisc::Map;
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

fn points_are_even_and_inside<A: Float>() {
    check::<A, 3>(0.25);
    check::<A, 5>(0.0);
    check::<A, 6>(0.123);
    check::<A, 8>(0.9);
    check::<A, 16>(0.5);
}

each_float!(points_are_even_and_inside the_side_between_two_blades_is_found_again);
