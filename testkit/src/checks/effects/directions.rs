//! Directions about a normal: ambient occlusion, and glossy reflection down to grazing light.

use super::super::convert::assert_clear;
use super::super::roots::{eps, nearest, wide};
use super::{Input, all_finite, frame};
use crate::arithmetics::{Exponent, Tested};
use crate::contract::contract;
use crate::orthonormal::dot;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DirectionSample, Glossy};
use hemidisc::invariant::Exact;
use hemidisc::{Error, LibmF64};

/// How far the length of a lobe's turned direction may be from 1.
fn room<A: Root<Real: Real> + Tested>(lobe: &str) -> f64 {
    let contract = contract(A::NAME, lobe).unwrap();
    2.0 * contract.norm * contract.unit
        + 32.0 * A::DENSITY_ERROR.min(1e-6)
        + 32.0 * eps::<A::Real>()
}

fn is_sound<A: Root<Real: Real> + Tested>(
    sample: DirectionSample<A::Real>,
    lobe: &str,
    what: &impl Fn() -> String,
) {
    let [density, weight] = wide([sample.density, sample.weight]);
    assert!(all_finite(sample.direction) && density > 0.0 && density.is_finite(), "{}", what());
    assert!(weight == 0.0 || weight == 1.0, "{}", what());
    let length = dot(sample.direction, sample.direction);
    assert!((length - 1.0).abs() <= 2.0 * room::<A>(lobe), "{}: {length}", what());
}

pub fn occlusion<A: Root<Real: Real> + Tested>(input: &Input) {
    let [reach, met] = nearest::<A, 2>([input.distance, input.radius]);
    match AmbientOcclusion::<A>::new(reach) {
        Ok(occlusion) => {
            assert!(reach > A::Real::ZERO && occlusion.reach() == reach, "{reach:?}");
            let normal = frame::<A>(input.normal);
            let sample = occlusion.sample(&normal, input.uv);
            let what = || format!("{} {input:x?}: {sample:?}", A::NAME);
            is_sound::<A>(sample, "cosine", &what);
            let height = dot(sample.direction, normal.axes()[2]);
            assert!(height >= -room::<A>("cosine") && sample.weight == A::Real::ONE, "{}", what());
            assert_eq!(occlusion.openness(None), A::Real::ONE);
            let hidden = met < reach;
            assert_eq!(occlusion.openness(Some(met)) == A::Real::ZERO, hidden, "{met:?} {reach:?}");
            let [faded] = wide([occlusion.faded_openness(Some(met))]);
            assert!((0.0..=1.0).contains(&faded), "{met:?} {reach:?}: {faded}");
            assert!(hidden || faded == 1.0, "{met:?} {reach:?}: {faded}");
            assert_eq!(occlusion.faded_openness(None), A::Real::ONE);
        }
        Err(error) => {
            let Error::Distance { value } = error else { panic!("{error}") };
            assert_eq!(value.to_bits(), wide([reach])[0].to_bits());
            assert!(value.is_nan() || value <= 0.0, "{value}");
            assert_clear(&error);
        }
    }
}

/// An invalid exponent.
pub fn refused(input: &Input) {
    let exponent = input.arriving[0];
    let made = Glossy::<LibmF64>::new(exponent, input.below);
    assert_eq!(made.is_ok(), exponent > -1.0 && exponent.is_finite(), "{exponent}");
    made.map(|_| ()).as_ref().unwrap_or_else(|error| {
        assert_clear(error);
        &()
    });
}

/// The density of a sample's direction is the sample's.
///
/// Turning the direction there and back moves it by an eps or two, which a lobe multiplies by sqrt e
/// at most where its density counts. A lobe that does not fall off to its horizon, e < 1, has an edge
/// there: `heights` above it are those of the direction and of its image in the surface.
fn agrees<A: Root<Real: Real> + Tested>(
    again: A::Real,
    sample: DirectionSample<A::Real>,
    exponent: A::Parameter,
    heights: [f64; 2],
    what: &impl Fn() -> String,
) {
    let (e, [again, first]) = (exponent.value(), wide([again, sample.density]));
    const EDGE: f64 = 1e-2;
    if e < 1.0 && heights.into_iter().any(|height| height.abs() < EDGE) {
        return;
    }
    let contract = contract(A::NAME, "power").unwrap();
    let eps = (contract.norm * contract.unit).max(eps::<A::Real>());
    let steep = if e < 0.0 { EDGE.powf(e - 1.0) } else { e.sqrt().max(1.0) };
    let room = 64.0 * eps * steep * (e + 1.0) / core::f64::consts::TAU;
    assert!((again - first).abs() <= room, "{}: {again:e}, not {first:e}", what());
}

pub fn glossy<A: Root<Real: Real> + Tested>(input: &Input, exponent: A::Parameter) {
    let [arriving, normal] = [input.arriving, input.normal].map(|vector| frame::<A>(vector).unit());
    let of = |below| Glossy::<A>::new(exponent, below).unwrap();
    let sample = |below| of(below).sample(arriving, normal, input.uv);
    let [reject, flip, zero] =
        [BelowHorizon::Reject, BelowHorizon::Flip, BelowHorizon::Zero].map(sample);
    let what = || format!("{} {input:x?}: {reject:?} {flip:?} {zero:?}", A::NAME);
    let (Some(flip), Some(zero)) = (flip, zero) else { panic!("{}", what()) };
    let room = room::<A>("power");
    for sample in [flip, zero].into_iter().chain(reject) {
        is_sound::<A>(sample, "power", &what);
    }
    for (below, sample) in [
        (BelowHorizon::Reject, reject),
        (BelowHorizon::Flip, Some(flip)),
        (BelowHorizon::Zero, Some(zero)),
    ] {
        let Some(sample) = sample else { continue };
        let again = of(below).density(arriving, normal, sample.direction);
        let [a, n, d] = [arriving.get(), normal.get(), sample.direction].map(wide);
        // The height above the lobe's horizon is d (a - 2 (a n) n), and the image is d - 2 (d n) n.
        let (along, image) = (dot(a, d), 2.0 * dot(a, n) * dot(d, n));
        agrees::<A>(again, sample, exponent, [along - image, along], &what);
    }
    let share = of(input.below).kept_share(arriving, normal).exact();
    assert!((0.5..=1.0).contains(&share), "{}: {share}", what());
    let anything = nearest::<A, 3>(input.receiver.map(|x| if x.abs() <= 1.0 { x } else { 1.0 }));
    let density = of(input.below).density(arriving, normal, anything).exact();
    assert!(density >= 0.0 && density.is_finite(), "{}: {density}", what());
    // The same sample, or none where the other has no weight.
    assert_eq!(reject.is_none(), zero.weight == A::Real::ZERO, "{}", what());
    assert!(reject.is_none_or(|sample| sample == zero), "{}", what());
    assert_eq!(flip.weight, A::Real::ONE, "{}", what());
    assert!(flip.density >= zero.density, "{}", what());
    let (arriving, mut normal) = (arriving.get(), normal.get());
    // On the side that the light comes from, which rounding decides along the surface.
    let [x, y, z] = [0, 1, 2].map(|i| arriving[i] * normal[i]);
    if x + y + z > A::Real::ZERO {
        normal = normal.map(|component| -component);
    }
    assert!(dot(flip.direction, normal) >= -room, "{}", what());
    assert!(reject.is_none_or(|sample| dot(sample.direction, normal) >= -room), "{}", what());
    // Seen from the mirror direction, it is the lobe's: narrow for a large exponent.
    let mirror: f64 = dot(arriving, normal);
    let axis = [0, 1, 2].map(|i| wide(arriving)[i] - 2.0 * mirror * wide(normal)[i]);
    let cosine = dot(wide(zero.direction), axis);
    assert!(cosine >= -room, "{}: behind the mirror direction, {cosine}", what());
}
