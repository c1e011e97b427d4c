//! The disc light.

mod hit;

use super::{Float, assert_near, dot, each_float, even_mean, mean, wide};
use hemidisc::arithmetic::Real;
use hemidisc::effect::DiscLight;
use hemidisc::sequence::{Random, SobolOwen};
use hemidisc::{Error, Frame, LibmF64, Uniform};
use hit::{
    a_density_keeps_its_digits_in_the_plane, a_radiance_is_weighed_by_the_area,
    a_sampled_direction_hits_its_point, no_ray_hits_where_no_light_arrives,
    weights_are_of_one_point,
};
use std::f64::consts::{PI, TAU};

/// A light of a radius at (0, 0, height) that shines down.
fn lamp<A: Float>(height: f64, radius: f64) -> DiscLight<A> {
    let down = Frame::new(A::vector([0.0, 0.0, -1.0])).unwrap();
    DiscLight::new(A::vector([0.0, 0.0, height]), down, A::real(radius)).unwrap()
}

/// Irradiance of radiance 1 on a receiver at (offset, 0, 0) that faces up.
fn irradiance<A: Float>(light: &DiscLight<A>, offset: f64, uv: [u32; 2]) -> f64 {
    let sample = light.sample(A::vector([offset, 0.0, 0.0]), uv);
    let cosine: f64 = sample.direction[2].into();
    sample.weight.into() * light.area().into() * cosine.max(0.0)
}

/// On a parallel receiver at an offset a from the axis: pi/2
/// (1 - (a^2 + h^2 - r^2) / sqrt((a^2 + h^2 + r^2)^2 - 4 a^2 r^2)), which on the axis is pi
/// r^2 / (h^2 + r^2).
fn irradiance_is_that_of_the_closed_form<A: Float>() {
    for (offset, height, radius) in
        [(0.0, 1.0, 0.5), (0.0, 10.0, 1.0), (0.0, 0.25, 1.0), (1.0, 1.0, 0.5), (2.0, 0.5, 1.0_f64)]
    {
        let square = offset * offset + height * height;
        let sum = square + radius * radius;
        let root = (sum * sum - 4.0 * offset * offset * radius * radius).sqrt();
        let exact = PI / 2.0 * (1.0 - (square - radius * radius) / root);
        let light = lamp::<A>(height, radius);
        let found = even_mean(|uv| irradiance(&light, offset, uv));
        assert_near(found / exact, 1.0, 2e-3 + 4.0 * A::EPS, "even");
        let [found, error] = mean(Random::new(3), |uv| irradiance(&light, offset, uv));
        assert_near(found, exact, 4.0 * error + 4.0 * A::EPS * exact, "random");
    }
}

/// Each sample's density is that of its direction, and all directions together have 1.
fn densities_are_per_steradian<A: Float>() {
    let light = lamp::<A>(1.0, 0.8);
    let receiver = A::vector([0.5, 0.25, 0.0]);
    for i in 0..1000 {
        let sample = light.sample(receiver, SobolOwen::new(8).at(i));
        let [found, exact]: [f64; 2] =
            wide([light.density(receiver, sample.direction), sample.density]);
        // At the rim rounding decides whether a direction hits the light.
        let [x, y, _]: [f64; 3] = wide(sample.point);
        if x.hypot(y) < 0.8 * (1.0 - 4.0 * A::EPS) {
            assert_near(found / exact, 1.0, 40.0 * A::EPS, "density");
        }
    }
    let sky = Uniform::<LibmF64>::new();
    let whole = even_mean(|uv| light.density(receiver, A::vector(sky.sample(uv))).into() * TAU);
    assert_near(whole, 1.0, 0.02, "integral");
    assert_near(light.area_density().into(), 1.0 / (PI * 0.64), A::EPS, "area");
}

/// One side only, or both: never in its plane, and never NaN.
fn no_light_where_none_goes<A: Float>() {
    let one_sided = lamp::<A>(1.0, 0.5);
    let both = one_sided.two_sided();
    let uvs = [[0, 0], [1 << 31, 1 << 31], [u32::MAX, 7], [123_456_789, 987_654_321]];
    for uv in uvs {
        for [x, y, z, lit_by_both] in [
            [0.0, 0.0, 2.0, 1.0],
            [5.0, 1.0, 1.5, 1.0],
            [3.0, 0.0, 1.0, 0.0],
            [0.25, 0.0, 1.0, 0.0],
        ] {
            let receiver = A::vector([x, y, z]);
            for (light, lit) in [(&one_sided, 0.0), (&both, lit_by_both)] {
                let sample = light.sample(receiver, uv);
                let [weight, density]: [f64; 2] = wide([sample.weight, sample.density]);
                assert_eq!((weight > 0.0, density > 0.0), (lit > 0.0, lit > 0.0), "{x} {y} {z}");
                let direction: [f64; 3] = wide(sample.direction);
                assert_near(dot(direction, direction), 1.0, 8.0 * A::EPS, "length");
                let again: f64 = light.density(receiver, sample.direction).into();
                assert!(again.is_finite() && (again == 0.0 || lit > 0.0), "{again}");
            }
        }
        // At the very point, and too far away for the number type.
        let point = both.sample(A::vector([0.0; 3]), uv).point;
        let far = [A::Real::MAX, A::Real::MAX, A::Real::ZERO];
        for receiver in [point, far] {
            let sample = both.sample(receiver, uv);
            assert_eq!(wide([sample.weight, sample.density]), [0.0; 2]);
            assert!(wide(sample.direction).into_iter().all(f64::is_finite));
        }
    }
}

/// A receiver as near to a point light as numbers allow: weights stay finite, and are 0 where the
/// squared distance underflows.
fn nearness_has_an_end<A: Float>() {
    let light = lamp::<A>(0.0, 0.0);
    let (mut distance, mut lit) = (A::Real::ONE, 0);
    while distance > A::Real::ZERO {
        let sample = light.sample([A::Real::ZERO, A::Real::ZERO, -distance], [0, 0]);
        let [weight, density]: [f64; 2] = wide([sample.weight, sample.density]);
        assert!(weight.is_finite() && density.is_finite(), "{weight} {density}");
        let exact = 1.0 / distance.into().powi(2);
        if exact < A::Real::MAX.into() / 2.0 {
            assert_near(weight / exact, 1.0, A::EPS, "weight");
            lit += 1;
        } else if exact > A::Real::MAX.into() {
            assert_eq!([weight, density], [0.0; 2]);
            let direction: [f64; 3] = wide(sample.direction);
            assert_eq!(dot(direction, direction), 1.0);
        }
        distance = distance * A::Real::HALF;
    }
    assert!(lit >= 63, "{lit}");
}

/// A light of radius 0 is a point: cos / d^2 for any coordinates, and no direction hits it.
fn a_point_light_is_exact<A: Float>() {
    let light = lamp::<A>(2.0, 0.0);
    let receiver = A::vector([1.5, 0.0, 0.0]);
    let first = light.sample(receiver, [0, 0]);
    assert_near(first.distance.into(), 2.5, 3.0 * A::EPS, "distance");
    assert_near(first.weight.into(), 0.8 / 6.25, A::EPS, "weight");
    assert!(first.density.into() > 1e30 && first.density.into().is_finite());
    for i in 0..100 {
        assert_eq!(light.sample(receiver, SobolOwen::new(9).at(i)), first);
    }
    assert_eq!(light.density(receiver, first.direction).into(), 0.0);
    assert_eq!(light.area().into(), 0.0);
}

/// The largest light: its area and its samples are finite.
fn the_largest_light_is_finite<A: Float>() {
    let up = Frame::new(A::vector([0.0, 0.0, 1.0])).unwrap();
    let most: f64 = A::Real::MAX.into();
    let largest = A::real((most / PI).sqrt() * (1.0 - 1e-6));
    let light = DiscLight::<A>::new(A::vector([0.0; 3]), up, largest).unwrap();
    assert_near(light.area().into() / most, 1.0, 3e-6, "area");
    for height in [1.0, 1e9, most.sqrt()] {
        let sample = light.sample(A::vector([0.0, 0.0, height]), [1 << 31, 1 << 31]);
        let [weight, density]: [f64; 2] = wide([sample.weight, sample.density]);
        assert!(weight.is_finite() && density.is_finite());
        assert_eq!(weight > 0.0, density > 0.0);
        assert!(sample.point.into_iter().all(|x| x.into().is_finite()));
    }
    // Its rim would overflow.
    let found = DiscLight::<A>::new([A::Real::MAX; 3], up, A::Real::ONE);
    assert!(found.is_ok());
    let found = DiscLight::<A>::new([A::Real::MAX; 3], up, largest + largest);
    assert!(matches!(found, Err(Error::Radius { .. })));
}

/// For any light, a receiver in its plane gets nothing, since rounding may put it on either side.
/// One that is off by more than the rounding error gets the right weight.
fn a_plane_is_as_thick_as_coordinates_round<A: Float>() {
    for (normal, place) in [
        ([0.3, -0.8, 0.5], [0.0, 0.0, 0.0]),
        ([0.3, -0.8, 0.5], [2.0, 7.0, -3.0]),
        ([-0.6, 0.1, 0.7], [100.0, -30.0, 5.0]),
    ] {
        let frame = Frame::normalized(A::vector(normal)).unwrap();
        let light = DiscLight::<A>::new(A::vector(place), frame, A::real(0.5)).unwrap();
        let both = light.two_sided();
        for i in 0..1000 {
            let [u, v] = Random::new(5).at(i);
            let [u, v] = [u, v].map(|k| A::real((f64::from(k) / 2_f64.powi(31) - 1.0) * 1.5));
            let at = |height: f64| {
                let up = frame.to_world([u, v, A::real(height)]);
                core::array::from_fn(|i| A::real(place[i]) + up[i])
            };
            let uv = SobolOwen::new(1).at(i);
            for light in [light, both] {
                let sample = light.sample(at(0.0), uv);
                assert_eq!(wide([sample.weight, sample.density]), [0.0; 2], "{i}");
                assert_eq!(light.density(at(0.0), sample.direction).into(), 0.0);
            }
            let lit = light.sample(at(0.01), uv);
            let distance: f64 = lit.distance.into();
            let found = lit.weight.into() * distance.powi(3);
            // Coordinates of 100 have a step of 8e-6 in f32.
            assert_near(found, 0.01, 2e-5 + A::EPS * 0.01, "near");
            assert_eq!(light.sample(at(-0.01), uv).weight.into(), 0.0);
            assert!(both.sample(at(-0.01), uv).weight.into() > 0.0);
        }
    }
}

/// Near a light far from the origin: coordinates of 1e6 have a step of 1/16 in f32. Dark is what is
/// within a step, lit what is two steps away or more, by the right weight.
fn far_from_the_origin_a_step_counts<A: Float>() {
    let down = Frame::new(A::vector([0.0, -1.0, 0.0])).unwrap();
    let centre = A::vector([0.0, 1e6, 0.0]);
    let light = DiscLight::<A>::new(centre, down, A::real(0.1)).unwrap();
    let middle = [1 << 31, 1 << 31];
    let at = |y: f64| light.sample(A::vector([0.0, y, 0.0]), middle);
    let near = at(999_999.5);
    assert_near(near.weight.into(), 4.0, 4.0 * A::EPS, "weight");
    let receiver = A::vector([0.0, 999_999.5, 0.0]);
    let density: f64 = light.density(receiver, near.direction).into();
    assert_near(density / near.density.into(), 1.0, 40.0 * A::EPS, "density");
    let step: f64 = (centre[1] * A::Real::EPSILON).into();
    let steps = [1.0, 2.0, 3.0, 8.0, 16.0].map(|k| k * 2_f64.powi(step.log2().floor() as i32));
    for (number, below) in steps.into_iter().enumerate() {
        let weight: f64 = at(1e6 - below).weight.into();
        if number > 0 {
            assert_near(weight * below * below, 1.0, 0.1, "steps below");
        }
        assert_eq!(at(1e6 + below).weight.into(), 0.0, "{below} above");
        assert!(
            light.two_sided().sample(A::vector([0.0, 1e6 + 4.0 * below, 0.0]), middle).weight
                > A::Real::ZERO
        );
    }
    assert_eq!(at(1e6).weight.into(), 0.0);
}

/// A vector of another length stands for its direction, and one without a direction for none.
fn the_length_of_a_direction_does_not_count<A: Float>() {
    let light = lamp::<A>(1.0, 0.8);
    let receiver = A::vector([0.5, 0.25, 0.0]);
    let direction = light.sample(receiver, [1 << 30, 1 << 29]).direction;
    let exact: f64 = light.density(receiver, direction).into();
    for size in [1e-30, 0.5, 0.999, 1.001, 7.0, 1e30] {
        let long = direction.map(|x| x * A::real(size));
        let found: f64 = light.density(receiver, long).into();
        assert_near(found / exact, 1.0, 20.0 * A::EPS.min(1e-6), "density");
    }
    for none in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, 0.0, f64::INFINITY]] {
        assert_eq!(light.density(receiver, A::vector(none)).into(), 0.0, "{none:?}");
    }
}

fn a_bad_radius_is_refused<A: Float>() {
    let up = Frame::new(A::vector([0.0, 0.0, 1.0])).unwrap();
    let large = A::Real::MAX.into().sqrt();
    for radius in [-0.5, f64::NAN, f64::INFINITY, large] {
        let found = DiscLight::<A>::new(A::vector([0.0; 3]), up, A::real(radius));
        assert!(matches!(found, Err(Error::Radius { .. })), "{radius}");
    }
}

fn a_bad_centre_is_refused<A: Float>() {
    let up = Frame::new(A::vector([0.0, 0.0, 1.0])).unwrap();
    for component in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let centre = A::vector([0.0, component, 0.0]);
        let found = DiscLight::<A>::new(centre, up, A::Real::ONE);
        assert!(matches!(found, Err(Error::Position { .. })), "{component}");
    }
}

each_float!(
    irradiance_is_that_of_the_closed_form densities_are_per_steradian no_light_where_none_goes
    nearness_has_an_end a_point_light_is_exact the_largest_light_is_finite
    a_plane_is_as_thick_as_coordinates_round far_from_the_origin_a_step_counts
    the_length_of_a_direction_does_not_count a_bad_radius_is_refused a_bad_centre_is_refused
    a_sampled_direction_hits_its_point no_ray_hits_where_no_light_arrives
    a_density_keeps_its_digits_in_the_plane a_radiance_is_weighed_by_the_area
    weights_are_of_one_point
);
