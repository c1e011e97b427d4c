//! Where a ray hits the disc light: the sample of that point, and nothing where no light arrives.

use super::super::{Float, assert_near, even_mean, wide};
use super::{PI, lamp};
use hemidisc::arithmetic::Real;
use hemidisc::effect::{DiscLight, LightSample, balance_heuristic};
use hemidisc::sequence::SobolOwen;
use hemidisc::{Cosine, Density, Frame, LibmF64};

/// A light that leans, and receivers in front of it, from near to far.
fn leaning<A: Float>() -> (DiscLight<A>, [[f64; 3]; 4]) {
    let frame = Frame::from_normal(A::vector([0.3, -0.9, 0.2]));
    let light = DiscLight::new(A::vector([1.0, 3.0, -2.0]), frame, A::real(0.8)).unwrap();
    (light, [[1.1, 2.8, -1.9], [1.0, 1.0, -2.0], [5.0, -1.0, 2.0], [100.0, -700.0, 30.0]])
}

/// The ray along a sample's direction hits the light in the sample's point: with its distance,
/// density and weights, and with the density that the direction has.
pub fn a_sampled_direction_hits_its_point<A: Float>() {
    let (light, receivers) = leaning::<A>();
    let mut met = 0;
    for receiver in receivers {
        let receiver = A::vector(receiver);
        for i in 0..1000 {
            let sample = light.sample(receiver, SobolOwen::new(8).at(i));
            let hit = light.hit(receiver, sample.direction);
            let density: f64 = light.density(receiver, sample.direction).into();
            assert_eq!(hit.is_some(), density > 0.0, "{sample:?}");
            // At the rim, seen from afar, rounding decides whether the ray hits.
            let Some(hit) = hit else { continue };
            met += 1;
            let LightSample { distance, .. } = sample;
            let far: f64 = distance.into();
            let room = 40.0 * A::EPS.min(1e-5);
            let pairs = [
                (hit.distance, sample.distance),
                (hit.density, sample.density),
                (hit.weight, sample.weight),
                (hit.radiance_weight, sample.radiance_weight),
            ];
            for (found, expected) in pairs.map(|(a, b)| (a.into(), b.into())) {
                assert_near(found / expected, 1.0, room, &format!("{hit:?} {sample:?}"));
            }
            assert_near(density / hit.density.into(), 1.0, room, "density");
            for (a, b) in wide(hit.point).into_iter().zip(wide(sample.point)) {
                assert_near(a, b, room * (1.0 + far), "point");
            }
            // A vector of another length stands for its direction.
            let long = light.hit(receiver, sample.direction.map(|x| x * A::real(7.0))).unwrap();
            assert_near((long.distance / hit.distance).into(), 1.0, room, "length");
        }
    }
    assert!(met >= 3900, "{met} of 4000");
}

/// Beside the rim, from behind, in the plane, without a direction, and of a point there is no hit.
pub fn no_ray_hits_where_no_light_arrives<A: Float>() {
    let light = lamp::<A>(1.0, 0.5);
    let both = light.two_sided();
    let hit = |light: &DiscLight<A>, receiver, direction| {
        let (receiver, direction) = (A::vector(receiver), A::vector(direction));
        let found = light.hit(receiver, direction);
        assert_eq!(light.density(receiver, direction).into() > 0.0, found.is_some());
        found.map(|hit| wide(hit.point))
    };
    let below = [0.0; 3];
    for (x, met) in [(0.0, true), (0.499, true), (-0.499, true), (0.501, false), (7.0, false)] {
        assert_eq!(hit(&light, below, [x, 0.0, 1.0]).is_some(), met, "{x}");
        assert_eq!(hit(&both, below, [x, 0.0, 1.0]).is_some(), met, "{x}");
    }
    // Away from the light, and along its plane.
    for light in [&light, &both] {
        assert_eq!(hit(light, below, [0.0, 0.0, -1.0]), None);
        assert_eq!(hit(light, below, [1.0, 0.0, 0.0]), None);
        assert_eq!(hit(light, [-1.0, 0.0, 1.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(hit(light, [0.25, 0.0, 1.0], [0.0, 0.0, 1.0]), None);
    }
    assert_eq!(hit(&light, [0.0, 0.0, 2.0], [0.0, 0.0, -1.0]), None, "from behind");
    let from_behind = hit(&both, [0.25, 0.0, 2.0], [0.0, 0.0, -1.0]).unwrap();
    assert_near(from_behind[0], 0.25, A::EPS, "x");
    assert_near(from_behind[2], 1.0, A::EPS, "z");
    for none in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, 0.0, f64::INFINITY]] {
        assert_eq!(hit(&both, below, none), None, "{none:?}");
        assert_eq!(hit(&both, none.map(|x| x + f64::NAN), [0.0, 0.0, 1.0]), None, "{none:?}");
    }
    assert_eq!(hit(&lamp::<A>(1.0, 0.0), below, [0.0, 0.0, 1.0]), None, "a point");
}

/// A direction's density keeps its digits where the product of area and cosine has none: d^2 / (area
/// cos t), from a receiver nearly in the plane of a small light.
pub fn a_density_keeps_its_digits_in_the_plane<A: Float>() {
    let least: f64 = A::Real::MIN_POSITIVE.into();
    let light = lamp::<A>(0.0, 2.0_f64.powi(-28));
    let height = least * 1024.0;
    let receiver = A::vector([0.0, 0.0, -height]);
    for distance in [-29, -31, -35].map(|power| 2.0_f64.powi(power)) {
        let direction = A::vector([1.0, 0.0, height / distance]);
        let hit = light.hit(receiver, direction).unwrap();
        let exact = distance.powi(3) / height / (PI * 2.0_f64.powi(-56));
        assert_near(hit.density.into() / exact, 1.0, 16.0 * A::EPS, "of the hit");
        let density: f64 = light.density(receiver, direction).into();
        assert_near(density / exact, 1.0, 16.0 * A::EPS, "of the direction");
    }
}

/// Radiance times the cosine and `radiance_weight` is irradiance, as by the lobe's own samples that
/// hit the light, and as by both together: pi r^2 / (h^2 + r^2) on the axis.
pub fn a_radiance_is_weighed_by_the_area<A: Float>() {
    let (height, radius) = (1.0, 0.8);
    let (light, receiver) = (lamp::<A>(height, radius), A::vector([0.0; 3]));
    let exact = PI * radius * radius / (height * height + radius * radius);
    let lobe = Cosine::<LibmF64>::new();
    let by_light = |uv, share: bool| {
        let sample = light.sample(receiver, uv);
        let cosine: f64 = sample.direction[2].into();
        let others = A::real(cosine.max(0.0) / PI);
        let part = balance_heuristic(sample.density, light.is_delta(), others);
        let part = if share { part.into() } else { 1.0 };
        part * sample.radiance_weight.into() * cosine
    };
    let by_lobe = |uv, share: bool| {
        let (direction, density) = lobe.sample_with_density(uv);
        let Some(hit) = light.hit(receiver, A::vector(direction)) else { return 0.0 };
        let part = balance_heuristic(density, lobe.is_delta(), hit.density.into());
        PI * if share { part } else { 1.0 }
    };
    for (what, mean, room) in [
        ("light", even_mean(|uv| by_light(uv, false)), 2e-3),
        ("lobe", even_mean(|uv| by_lobe(uv, false)), 2e-2),
        ("both", even_mean(|uv| by_light(uv, true)) + even_mean(|uv| by_lobe(uv, true)), 1e-2),
    ] {
        assert_near(mean / exact, 1.0, room + 4.0 * A::EPS, what);
    }
}

/// `radiance_weight` is the area times `weight` and the reciprocal of the density; of a point, which
/// has no radiance, it is 0, and it is never infinite.
pub fn weights_are_of_one_point<A: Float>() {
    let (light, receivers) = leaning::<A>();
    for receiver in receivers.map(A::vector) {
        for i in 0..100 {
            let sample = light.sample(receiver, SobolOwen::new(3).at(i));
            let [weight, density, other]: [f64; 3] =
                wide([sample.weight, sample.density, sample.radiance_weight]);
            assert_near(other / (light.area().into() * weight), 1.0, 1e-6, "area");
            assert_near(other * density, 1.0, 1e-6, "density");
        }
    }
    let point = lamp::<A>(2.0, 0.0).sample(A::vector([0.0; 3]), [1 << 30, 7]);
    assert!(point.weight > A::Real::ZERO && point.radiance_weight == A::Real::ZERO);
    let behind = lamp::<A>(2.0, 1.0).sample(A::vector([0.0, 0.0, 3.0]), [1 << 30, 7]);
    assert_eq!(wide([behind.weight, behind.radiance_weight, behind.density]), [0.0; 3]);
    let size = A::real((A::Real::MAX.into() / 4.0).sqrt());
    let up = Frame::from_normal(A::vector([0.0, 0.0, -1.0]));
    let large = DiscLight::<A>::new(A::vector([0.0; 3]), up, size).unwrap();
    // As near to a point of it as the square of the distance is a number.
    let near = [A::Real::ZERO, A::Real::ZERO, -A::real(A::Real::MIN_POSITIVE.into().sqrt() * 2.0)];
    let sample = large.sample(near, [1 << 31, 1 << 31]);
    assert!(wide([sample.weight, sample.radiance_weight]).into_iter().all(f64::is_finite));
    let nearer = [A::Real::ZERO, A::Real::ZERO, near[2] * A::Real::HALF * A::Real::HALF];
    assert!(large.hit(nearer, A::vector([0.0, 0.0, 1.0])).is_none(), "nearer than numbers tell");
    let hit = large.hit(near, A::vector([0.0, 0.0, 1.0])).unwrap();
    assert!(wide([hit.weight, hit.radiance_weight, hit.density]).into_iter().all(f64::is_finite));
    assert_eq!(hit.radiance_weight, A::Real::MAX);
}
