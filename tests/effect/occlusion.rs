//! Ambient occlusion.

use super::{Float, assert_near, each_float, even_mean, wide};
use hemidisc::effect::AmbientOcclusion;
use hemidisc::{Error, Frame};
use std::f64::consts::PI;

/// The mean openness at the origin of the plane z = 0, of what a direction meets in f64.
fn openness<A: Float>(reach: f64, met: impl Fn([f64; 3]) -> Option<f64>) -> f64 {
    let occlusion = AmbientOcclusion::<A>::new(A::real(reach)).unwrap();
    let ground = Frame::new(A::vector([0.0, 0.0, 1.0])).unwrap();
    even_mean(|uv| {
        let sample = occlusion.sample(&ground, uv);
        let direction: [f64; 3] = wide(sample.direction);
        assert_near(sample.density.into(), direction[2] / PI, 2.0 * A::EPS, "density");
        let open: f64 = occlusion.openness(met(direction).map(A::real)).into();
        open * sample.weight.into()
    })
}

/// An endless wall of height H at a distance d hides (1 - d / sqrt(d^2 + H^2)) / 2.
fn beside_a_wall<A: Float>() {
    for (distance, height) in [(1.0, 1.0), (0.5, 3.0), (2.0, 0.5_f64)] {
        let wall = |[x, _, z]: [f64; 3]| {
            let t = distance / x;
            (x > 0.0 && t * z < height).then_some(t)
        };
        let hidden = 0.5 * (1.0 - distance / distance.hypot(height));
        let found = openness::<A>(f64::INFINITY, wall);
        assert_near(found, 1.0 - hidden, 2e-3 + A::EPS, "wall");
    }
}

/// Within a reach R an endless, high wall at d hides what has x > c = d / R: (acos c - c
/// sqrt(1 - c^2)) / pi.
fn within_a_reach<A: Float>() {
    for c in [0.0, 0.25, 0.7, 0.99_f64] {
        let wall = |[x, ..]: [f64; 3]| (x > 0.0).then(|| c / x);
        let hidden = (c.acos() - c * (1.0 - c * c).sqrt()) / PI;
        assert_near(openness::<A>(1.0, wall), 1.0 - hidden, 2e-3 + A::EPS, "reach");
    }
}

/// A sphere of radius r straight above, its centre at height h, hides (r / h)^2.
fn under_a_sphere<A: Float>() {
    for (radius, height) in [(1.0, 1.5), (0.2, 2.0), (1.0, 1.001_f64)] {
        let sphere = |[_, _, z]: [f64; 3]| {
            let along = height * z;
            let square = along * along - height * height + radius * radius;
            (square >= 0.0).then(|| along - square.sqrt())
        };
        let hidden = (radius / height).powi(2);
        let found = openness::<A>(f64::INFINITY, sphere);
        assert_near(found, 1.0 - hidden, 2e-3 + A::EPS, "sphere");
    }
}

/// What is at the reach, or beyond, hides nothing.
fn the_reach_is_open<A: Float>() {
    let occlusion = AmbientOcclusion::<A>::new(A::real(2.0)).unwrap();
    let openness = |met: Option<f64>| -> f64 { occlusion.openness(met.map(A::real)).into() };
    assert_eq!([Some(1.999), Some(2.0), Some(2.001), None].map(openness), [0.0, 1.0, 1.0, 1.0]);
}

/// 1 - (1 - d / R)^2, without an edge at the reach R.
fn what_is_near_fades<A: Float>() {
    let occlusion = AmbientOcclusion::<A>::new(A::real(2.0)).unwrap();
    let faded = |met: f64| -> f64 { occlusion.faded_openness(Some(A::real(met))).into() };
    for (met, exact) in [(0.0, 0.0), (0.5, 0.4375), (1.0, 0.75), (1.5, 0.9375), (-1.0, 0.0)] {
        assert_near(faded(met), exact, A::EPS.min(1e-6), "fade");
    }
    assert_near(faded(2.0 - 1e-4), 1.0, 1e-8 + A::EPS.min(1e-6), "before the reach");
    assert_eq!([2.0, 2.5, f64::INFINITY, f64::NAN].map(faded), [1.0; 4]);
    assert_eq!(occlusion.faded_openness(None), occlusion.openness(None));
    // Below a ceiling at a height h < R, c = h / R: cos t > c is within the reach, and the mean is
    // the integral of 2 cos t (2 c / cos t - c^2 / cos^2 t) there, and of 2 cos t beyond it.
    for c in [0.1, 0.5, 0.9_f64] {
        let exact = 4.0 * c * (1.0 - c) + 2.0 * c * c * c.ln() + c * c;
        let found = even_mean(|uv| {
            let ground = Frame::new(A::vector([0.0, 0.0, 1.0])).unwrap();
            let sample = occlusion.sample(&ground, uv);
            faded(2.0 * c / sample.direction[2].into())
        });
        assert_near(found, exact, 2e-3 + A::EPS, "ceiling");
    }
    // Within an infinite reach anything hides, as without fading.
    let endless = AmbientOcclusion::<A>::new(A::real(f64::INFINITY)).unwrap();
    for met in [Some(0.0), Some(1e30), Some(f64::INFINITY), None] {
        let met = met.map(A::real);
        assert_eq!(endless.faded_openness(met), endless.openness(met), "{met:?}");
    }
}

fn a_bad_reach_is_refused<A: Float>() {
    for reach in [0.0, -1.0, f64::NAN] {
        let found = AmbientOcclusion::<A>::new(A::real(reach));
        assert!(matches!(found, Err(Error::Distance { .. })), "{reach}");
    }
}

each_float!(
    beside_a_wall within_a_reach the_reach_is_open under_a_sphere what_is_near_fades
    a_bad_reach_is_refused
);
