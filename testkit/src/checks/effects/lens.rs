//! Lenses and their apertures.

use super::super::convert::assert_clear;
use super::super::roots::{eps, nearest, smallest, wide};
use super::{Input, all_finite};
use crate::arithmetics::{Number, Tested};
use crate::contract::contract;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{Polygon, ThinLens};
use hemidisc::invariant::{self, Exact};
use hemidisc::{Concentric, Density, Error, Invert, Polar};

/// A lens of a radius and a focal distance, with either round aperture.
pub fn lens<A: Root<Real: Real> + Tested>(input: &Input) {
    let [radius, focus] = nearest::<A, 2>([input.radius, input.distance]);
    let made = ThinLens::new(Concentric::<A>::new(), radius, focus);
    let [r, f] = wide([radius, focus]);
    let area_is_finite = (radius * radius / A::Real::FRAC_1_PI).finite();
    let (radius_is_good, distance_is_good) = (r >= 0.0 && area_is_finite, f > 0.0);
    match made {
        Ok(lens) => {
            assert!(radius_is_good && distance_is_good, "{r:e} {f:e}");
            let slope = A::Real::nearest(r * (1.0 - 4.0 * eps::<A::Real>()) / f);
            // As near as a number goes is as near as it is taken to be.
            assert!(slope.finite() || !A::Real::nearest(1.0 / f).finite(), "{r:e} / {f:e}");
            rays::<A, _>(lens, input);
            let polar = ThinLens::new(Polar::<A>::new(), radius, focus).unwrap();
            rays::<A, _>(polar, input);
        }
        Err(error) => {
            assert_clear(&error);
            match error {
                Error::Radius { value } => {
                    assert!(!radius_is_good && value.to_bits() == r.to_bits(), "{r:e}");
                }
                Error::Distance { value } => {
                    assert!(radius_is_good && value.to_bits() == f.to_bits(), "{f:e}");
                    // Also refused where radius / distance overflows.
                    let steep = !A::Real::nearest(r / f * (1.0 + 4.0 * eps::<A::Real>())).finite();
                    assert!(!distance_is_good || steep, "{r:e} / {f:e}");
                }
                other => panic!("{other}"),
            }
        }
    }
}

fn rays<A: Root<Real: Real> + Tested, M: Invert<Point = [A::Real; 2]>>(
    lens: ThinLens<M, A::Real>,
    input: &Input,
) {
    let ahead = nearest::<A, 2>(input.ahead.map(|x| if x.abs() < 1e6 { x } else { 0.25 }));
    let [[r, f], d] = [[input.radius, input.distance], wide(ahead)];
    let [r, f] = wide(nearest::<A, 2>([r, f]));
    let ray = lens.ray(ahead, input.uv);
    let what = || format!("{} {input:x?}: {ray:?}", A::NAME);
    let origin = wide(ray.origin);
    assert!(all_finite(ray.origin) && all_finite([ray.density, ray.weight]), "{}", what());
    let eps = eps::<A::Real>();
    assert!(origin[0].abs() <= r && origin[1].abs() <= r && origin[2] == 0.0, "{}", what());
    assert_eq!(wide([ray.weight, ray.direction[2]]), [1.0; 2], "{}", what());
    assert!(wide([ray.density])[0] > 0.0, "{}", what());
    assert_eq!(lens.sample(input.uv), [ray.origin[0], ray.origin[1]], "{}", what());
    let slope = r / f;
    if slope < A::Real::MAX.into() * 0.25 {
        assert!(all_finite(ray.direction), "{}", what());
    }
    if r == 0.0 {
        assert_eq!(ray.direction, [ahead[0], ahead[1], A::Real::ONE], "{}", what());
        assert_eq!(ray.origin, [A::Real::ZERO; 3], "{}", what());
    }
    // All rays of a pixel meet in focus.
    if (1e-6..1e6).contains(&f) && r < 1e6 {
        let room = 8.0 * eps * (r + f * (d[0].abs() + d[1].abs() + slope))
            + 8.0 * (1.0 + f) * smallest::<A::Real>();
        for axis in 0..2 {
            let there = origin[axis] + f * wide(ray.direction)[axis];
            assert!((there - f * d[axis]).abs() <= room, "{}: {there:e}", what());
        }
    }
    let [distance, far] = nearest::<A, 2>([input.receiver[0], f64::INFINITY]);
    let blurs = [far, distance].map(|distance| wide([lens.circle_of_confusion(distance)])[0]);
    assert!(blurs.into_iter().all(|blur| blur >= 0.0 && blur.is_finite()), "{}", what());
    let expected = if r == 0.0 || f.is_infinite() { r } else { A::Real::MAX.into() };
    assert_eq!(blurs[0], expected, "{}", what());
    assert_eq!(lens.is_delta(), A::Real::nearest(r) * A::Real::nearest(r) == A::Real::ZERO);
    if distance.finite() {
        let blur: f64 = lens.circle_of_confusion(distance).exact();
        let exact = r * (1.0 - wide([distance])[0] / f).abs();
        assert!(blur.is_finite() && blur >= 0.0, "{}: blur {blur:e}", what());
        if (1e-6..1e6).contains(&f) && r < 1e6 && exact < 1e30 {
            let room = 8.0 * eps * (r + exact) + f64::from(f32::MIN_POSITIVE);
            assert!((blur - exact).abs() <= room, "{}: {blur:e}, not {exact:e}", what());
        }
    }
}

/// An aperture of N blades: a map onto the disc like the round ones.
pub fn blades<A: Root<Real: Real> + Tested, const N: usize>(input: &Input) {
    let polygon = Polygon::<A, N>::new(input.rotation);
    let what = || format!("{} of {N} blades, {input:x?}", A::NAME);
    invariant::disc(&polygon, input.uv).unwrap_or_else(|v| panic!("{}: {v}", what()));
    let point = polygon.sample(input.uv);
    assert_eq!(
        polygon.sample_with_density(input.uv),
        (point, polygon.density(point)),
        "{}",
        what()
    );
    let again = polygon.sample(polygon.invert(point));
    // Its corners are as good as the polar map's points, and a place in it is a sum of two of them.
    let disc = contract(A::NAME, "disc").unwrap();
    let room = 2.0 * disc.round_trip.max(disc.norm) * disc.unit;
    for (a, b) in wide(point).into_iter().zip(wide(again)) {
        assert!((a - b).abs() <= room, "{}: {point:?} became {again:?}", what());
    }
    // Any numbers have a density and coordinates.
    let [x, y, _] = nearest::<A, 3>(input.receiver);
    let density: f64 = polygon.density([x, y]).exact();
    assert!(density >= 0.0 && density.is_finite(), "{}: {density}", what());
    let _ = polygon.invert([x, y]);
    let [x, y] = wide([x, y]);
    // A share of a corner may be 4 ulp over 1, and as much more as its blade is small.
    let inside = x.hypot(y) <= 1.0 + room + 10.0 * eps::<A::Real>();
    assert!(inside || density == 0.0, "{}: {density} outside", what());
}
