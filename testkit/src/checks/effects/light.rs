//! The disc light: from near, from far, grazing, from behind, of radius 0, and with NaN.

use super::super::convert::assert_clear;
use super::super::roots::{eps, nearest, smallest, wide};
use super::{Input, all_finite, frame};
use crate::arithmetics::{Number, Tested};
use crate::contract::contract;
use crate::orthonormal::dot;
use hemidisc::Error;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{DiscLight, LightSample};
use hemidisc::invariant::Exact;

pub fn check<A: Root<Real: Real> + Tested>(input: &Input) {
    let [radius] = nearest::<A, 1>([input.radius]);
    let centre = nearest::<A, 3>(input.centre);
    let area_is_finite = (radius * radius / A::Real::FRAC_1_PI).finite();
    let radius_is_good = radius >= A::Real::ZERO && radius.finite() && area_is_finite;
    match DiscLight::<A>::new(centre, frame::<A>(input.normal), radius) {
        Ok(light) => {
            assert!(radius_is_good && all_finite(centre), "{centre:?} {radius:?}");
            samples(light, input);
        }
        Err(error) => {
            assert_clear(&error);
            match error {
                Error::Radius { value } => {
                    assert!(!radius_is_good && value.to_bits() == wide([radius])[0].to_bits());
                }
                Error::Position { value } => {
                    let [limit] = wide([A::Real::MAX]);
                    let near = |x: f64| x.abs() / 2.0 + wide([radius])[0] <= limit / 2.0;
                    let first = wide(centre).into_iter().find(|x| !near(*x)).map(f64::to_bits);
                    assert_eq!(first, Some(value.to_bits()), "{centre:?} {radius:?}");
                }
                other => panic!("{other}"),
            }
        }
    }
}

fn samples<A: Root<Real: Real> + Tested>(light: DiscLight<A>, input: &Input) {
    let receiver = nearest::<A, 3>(input.receiver);
    if !all_finite(receiver) {
        let sample = light.sample(receiver, input.uv);
        assert_eq!(wide([sample.weight, sample.density]), [0.0; 2], "{input:x?}");
        return;
    }
    let two_sided = light.two_sided();
    for light in [light, two_sided] {
        let sample = light.sample(receiver, input.uv);
        let what = || format!("{} {input:x?}: {sample:?}", A::NAME);
        is_sound::<A>(&light, sample, input, &what);
        is_exact::<A>(&light, sample, input, &what);
        met(&light, receiver, sample.direction, Some(sample), input);
        super::shares_a_direction(
            sample.density,
            light.is_delta(),
            A::Real::nearest(input.distance),
        );
    }
    let [one, both] = [light, two_sided].map(|light| light.sample(receiver, input.uv));
    if one.weight > A::Real::ZERO {
        assert_eq!(one, both, "{input:x?}");
    }
    assert_eq!(light.is_delta(), light.area() == A::Real::ZERO, "{input:x?}");
    if input.radius == 0.0 {
        assert!(light.is_delta(), "{input:x?}");
        assert_eq!(one, light.sample(receiver, input.other), "{input:x?}");
    }
    // Any direction gives a number.
    let anything = nearest::<A, 3>(input.arriving);
    for light in [light, two_sided] {
        met(&light, receiver, anything, None, input);
    }
}

/// A direction has a density where its ray hits the light, and the hit has it, a point of the light
/// and weights. A sample's direction hits the sample's point, as well as the direction is known.
fn met<A: Root<Real: Real> + Tested>(
    light: &DiscLight<A>,
    receiver: [A::Real; 3],
    direction: [A::Real; 3],
    sample: Option<LightSample<A::Real>>,
    input: &Input,
) {
    let [density] = wide([light.density(receiver, direction)]);
    assert!(density >= 0.0 && density.is_finite(), "{input:x?}: {density:e}");
    let hit = light.hit(receiver, direction);
    assert_eq!(hit.is_some(), density > 0.0, "{input:x?}: {density:e} {hit:?}");
    let Some(hit) = hit else { return };
    let what = || format!("{} {input:x?}: {hit:?} {sample:?}", A::NAME);
    is_sound(light, hit, input, &what);
    let [smallest, largest] = wide([A::Real::MIN_POSITIVE, A::Real::MAX]);
    let unit = contract(A::NAME, "uniform").unwrap().unit;
    let near = |found: f64, expected: f64, room: f64| {
        // Where a result leaves the normal numbers, each is cut off on its own.
        let is_number = |x: f64| x > 4.0 * smallest / unit && x < largest * 0.25;
        let apart = (found / expected - 1.0).abs();
        let cut = !(is_number(found) && is_number(expected));
        assert!(cut || apart <= room, "{}: {found:e}, not {expected:e}", what());
    };
    let [area] = wide([light.area()]);
    if area > smallest / unit {
        near(hit.density.exact(), density, 16.0 * unit);
    }
    let Some(sample) = sample else { return };
    let [distance, weight] = wide([sample.distance, sample.weight]);
    if weight == 0.0 {
        return;
    }
    // An eps of the direction, and of the coordinates, is cos t times as much of the distance.
    let centre = nearest::<A, 3>(input.centre);
    let [size, farther] = [centre, receiver].map(|v| dot(v, v).sqrt());
    let size = size + farther + wide(nearest::<A, 1>([input.radius]))[0];
    let cosine = weight * distance * distance;
    let room = 64.0 * unit.max(A::DENSITY_ERROR) * (1.0 + size / distance) / cosine;
    if room < 0.1 && distance * distance < largest * 0.25 {
        for (found, expected) in [
            (hit.distance, sample.distance),
            (hit.weight, sample.weight),
            (hit.density, sample.density),
            (hit.radiance_weight, sample.radiance_weight),
        ] {
            near(found.exact(), expected.exact(), 4.0 * room);
        }
    }
}

/// Numbers, of the right sign, and together zero or not.
fn is_sound<A: Root<Real: Real> + Tested>(
    light: &DiscLight<A>,
    sample: LightSample<A::Real>,
    input: &Input,
    what: &impl Fn() -> String,
) {
    let [weight, density, distance] = wide([sample.weight, sample.density, sample.distance]);
    assert!(all_finite([weight, density, distance]), "{}", what());
    assert!(weight >= 0.0 && density >= 0.0 && distance >= 0.0, "{}", what());
    assert_eq!(density > 0.0, weight > 0.0, "{}", what());
    assert!(all_finite(sample.direction), "{}", what());
    let length = dot(sample.direction, sample.direction);
    // It may be the light's normal: within 16 ulp, and its own sum has rounded.
    assert!((length - 1.0).abs() <= 36.0 * A::DENSITY_ERROR, "{}: {length}", what());
    let [area, other] = wide([light.area(), sample.radiance_weight]);
    assert!(other >= 0.0 && other.is_finite() && (weight > 0.0 || other == 0.0), "{}", what());
    let [least, most] = wide([A::Real::MIN_POSITIVE, A::Real::MAX]);
    if area * weight > least && area * weight < most {
        let unit = contract(A::NAME, "uniform").unwrap().unit;
        assert!((other / (area * weight) - 1.0).abs() <= 4.0 * unit, "{}", what());
    }
    assert!(all_finite([light.area(), light.area_density()]), "{}", what());
    assert!(all_finite(sample.point), "{}", what());
    let [radius] = wide(nearest::<A, 1>([input.radius]));
    let centre = wide(nearest::<A, 3>(input.centre));
    let from_centre = [0, 1, 2].map(|i| wide(sample.point)[i] - centre[i]);
    let largest = centre.into_iter().fold(radius, |a, b| a.max(b.abs()));
    let room = 32.0 * eps::<A::Real>() * largest + 4.0 * smallest::<A::Real>();
    let away = from_centre.into_iter().fold(0.0_f64, |a, b| a.hypot(b));
    assert!(away <= radius + room, "{}: {away:e} from the centre", what());
}

/// cos t / d^2 of the point that was given, where neither leaves the range of normal numbers.
fn is_exact<A: Root<Real: Real> + Tested>(
    light: &DiscLight<A>,
    sample: LightSample<A::Real>,
    input: &Input,
    what: &impl Fn() -> String,
) {
    let to_light = wide([0, 1, 2].map(|i| sample.point[i] - nearest::<A, 3>(input.receiver)[i]));
    let square = dot(to_light, to_light);
    let [_, _, normal] = frame::<A>(input.normal).axes();
    let [smallest, largest] = wide([A::Real::MIN_POSITIVE, A::Real::MAX]);
    // Squares of components that are subnormal have lost digits.
    if !(square > smallest / A::DENSITY_ERROR && square < largest * 0.25) {
        return;
    }
    let cosine = -dot(to_light, wide(normal)) / square.sqrt();
    // The light's plane is as thick as the coordinates' rounding, and that of the height.
    let [centre, receiver] = [input.centre, input.receiver].map(|v| wide(nearest::<A, 3>(v)));
    let size = |v: [f64; 3]| dot(v.map(f64::abs), wide(normal).map(f64::abs));
    let above = [0, 1, 2].map(|i| receiver[i] - centre[i]);
    let sizes = [centre, receiver].map(size);
    let given_and_lost = [sizes[0] + sizes[1], size(above)];
    knows_its_side::<A>(light, sample, dot(above, wide(normal)), given_and_lost);
    let [radius] = wide(nearest::<A, 1>([input.radius]));
    // A point of it is off by its own rounding error.
    let size = sizes[0] + sizes[1] + radius;
    // The disc leans by as much as its normal is from unit length.
    let lean = (dot(normal, normal) - 1.0).abs() * radius;
    let thick = (4.0 * eps::<A::Real>() * size + lean) / square.sqrt();
    let [weight] = wide([sample.weight]);
    let exact = if weight > 0.0 { cosine.abs() } else { cosine.min(0.0) } / square;
    let room = (16.0 * A::DENSITY_ERROR + thick) / square + smallest;
    // From behind, or in its plane, the weight is 0; a light to both sides has one there.
    if weight > 0.0 {
        assert!((weight - exact).abs() <= room, "{}: {exact:e}", what());
    } else {
        assert!(cosine / square <= room, "{}: {cosine:e}", what());
    }
    let distance: f64 = sample.distance.exact();
    assert!((distance - square.sqrt()).abs() <= 8.0 * A::DENSITY_ERROR * distance, "{}", what());
    let [area] = wide(nearest::<A, 1>([input.radius])).map(|r| r * r * core::f64::consts::PI);
    let density = 1.0 / (area * weight);
    if weight > 0.0 && density > smallest && density < largest * 0.5 && area > smallest {
        let [found] = wide([sample.density]);
        let unit = contract(A::NAME, "uniform").unwrap().unit;
        assert!((found / density - 1.0).abs() <= 16.0 * unit, "{}: density {density:e}", what());
    }
}

/// Which side a receiver is on is unknown within a step of its coordinates and the light's, half of
/// each, and the rounding of the height. Within the step it is dark, beyond both it is lit, and from
/// behind it never is.
fn knows_its_side<A: Root<Real: Real> + Tested>(
    light: &DiscLight<A>,
    sample: LightSample<A::Real>,
    height: f64,
    [given, lost]: [f64; 2],
) {
    let lit = sample.weight > A::Real::ZERO;
    let what = || format!("{}: {height:e} of {given:e} and {lost:e}: {sample:?}", A::NAME);
    // A double's own sums round as much as it does.
    let own = 8.0 * f64::EPSILON * (given + lost);
    let eps = eps::<A::Real>();
    let (step, rounding) = (eps * given, 4.0 * eps * lost);
    if height.abs() <= step - own - smallest::<A::Real>() {
        assert!(!lit, "{}", what());
    }
    if !light.is_two_sided() && height < -own {
        assert!(!lit, "{}", what());
    }
    let seen = height > 0.0 || light.is_two_sided();
    let [distance, least] = wide([sample.distance, A::Real::MIN_POSITIVE]);
    let is_number = height.abs() / distance.powi(3) > least && height.abs() > least / eps;
    if seen && is_number && height.abs() > 1.1 * (step + 2.0 * rounding) + own {
        assert!(lit, "{}", what());
    }
}
