//! Glossy reflection.

use super::{COUNT, Float, assert_near, dot, each_float, even_mean, wide};
use hemidisc::effect::{BelowHorizon, Glossy};
use hemidisc::sequence::SobolOwen;
use hemidisc::{Error, LibmF64, Map, Uniform};
use std::f64::consts::TAU;

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const POLICIES: [BelowHorizon; 3] = [BelowHorizon::Reject, BelowHorizon::Flip, BelowHorizon::Zero];

fn gloss<A: Float>(e: f64, below: BelowHorizon) -> Glossy<A> {
    Glossy::new(A::parameter(e), below).unwrap()
}

/// Light that comes down at a slope, and its mirror direction.
fn arriving(sine: f64) -> ([f64; 3], [f64; 3]) {
    let cosine = (1.0 - sine * sine).sqrt();
    ([sine, 0.0, -cosine], [sine, 0.0, cosine])
}

/// Straight down nothing is below: the mean cosine to the mirror direction is (e + 1) / (e + 2),
/// for any policy the same sample.
fn the_mean_cosine_is_that_of_the_lobe<A: Float>() {
    for e in [0.5, 1.0, 10.0, 1000.0] {
        for below in POLICIES {
            let gloss = gloss::<A>(e, below);
            let found = even_mean(|uv| {
                let sample = gloss.sample(A::vector([0.0, 0.0, -1.0]), A::vector(UP), uv).unwrap();
                assert_eq!(sample.weight.into(), 1.0);
                sample.direction[2].into()
            });
            assert_near(found, (e + 1.0) / (e + 2.0), 1e-3 + A::EPS, "mean cosine");
        }
    }
}

/// At a grazing angle: what is rejected is what has no weight; flipping leaves nothing below; and a
/// density integrates over the upper half to what its policy keeps.
fn energy_is_accounted_for<A: Float>() {
    for (e, sine) in [(1.0, 0.9), (20.0, 0.98), (5.0, 1.0_f64)] {
        let (down, mirror) = arriving(sine);
        let (down, up) = (A::vector(down), A::vector(UP));
        let [reject, flip, zero] = POLICIES.map(|below| gloss::<A>(e, below));
        let mut kept = 0;
        for i in 0..COUNT {
            let uv = SobolOwen::new(4).at(i);
            let (rejected, zero) =
                (reject.sample(down, up, uv), zero.sample(down, up, uv).unwrap());
            assert_eq!(rejected.is_none(), zero.weight.into() == 0.0);
            if let Some(sample) = rejected {
                assert_eq!(sample, zero);
                kept += 1;
            }
            let flipped = flip.sample(down, up, uv).unwrap();
            assert!(flipped.direction[2].into() >= 0.0 && flipped.weight.into() == 1.0);
            let again: f64 = flip.density(down, up, flipped.direction).into();
            if flipped.direction[2].into() > 1e-3 {
                let tolerance = 1e-3 + 100.0 * (e + 1.0) * A::EPS;
                assert_near(again / flipped.density.into(), 1.0, tolerance, "flipped density");
            }
            // Flipped or not, the lobe's own density is a part of it.
            let cosine = dot(wide(zero.direction), mirror).max(0.0);
            let expected = (e + 1.0) * cosine.powf(e) / TAU;
            let tolerance = 40.0 * (e + 1.0).powi(2) * A::EPS;
            assert_near(zero.density.into(), expected, tolerance, "density");
            assert!(flipped.density.into() >= zero.density.into());
        }
        let kept = f64::from(kept) / f64::from(COUNT);
        let sky = Uniform::<LibmF64>::new();
        for (policy, expected) in [(&zero, kept), (&reject, kept), (&flip, 1.0)] {
            let whole =
                even_mean(|uv| policy.density(down, up, A::vector(sky.sample(uv))).into() * TAU);
            assert_near(whole, expected, 0.02, "integral");
        }
        if sine == 1.0 {
            assert_near(kept, 0.5, 0.02, "half");
        } else {
            assert!(kept > 0.5 && kept < 0.99, "{kept}");
        }
    }
}

/// At e = 1e8 a sample leaves the mirror direction by less than 7e-4: the least of 2^32 radii has
/// the cosine 2^(-33 / (e + 1)), which is that of sqrt(66 ln 2 / e).
fn a_very_sharp_lobe_is_a_mirror<A: Float>() {
    let (down, mirror) = arriving(0.6);
    for below in POLICIES {
        let gloss = gloss::<A>(1e8, below);
        for i in 0..COUNT {
            let uv = SobolOwen::new(6).at(i);
            let sample = gloss.sample(A::vector(down), A::vector(UP), uv).unwrap();
            let found: [f64; 3] = wide(sample.direction);
            let away = (0..3).map(|i| (found[i] - mirror[i]).powi(2)).sum::<f64>().sqrt();
            assert!(away < 7e-4 + 4.0 * A::EPS, "{away}");
            assert!(sample.density.into().is_finite());
        }
    }
}

/// From below, the opposite normal applies. Along the surface only the policy loses samples.
fn both_sides_reflect<A: Float>() {
    let gloss = gloss::<A>(30.0, BelowHorizon::Flip);
    for i in 0..100 {
        let uv = SobolOwen::new(6).at(i);
        let from_below = gloss.sample(A::vector([0.6, 0.0, 0.8]), A::vector(UP), uv).unwrap();
        assert!(from_below.direction[2].into() <= 0.0);
        let along = gloss.sample(A::vector([1.0, 0.0, 0.0]), A::vector(UP), uv).unwrap();
        assert!(along.direction[2].into() >= 0.0);
    }
}

fn a_bad_exponent_is_refused<A: Float>() {
    for e in [-1.0, f64::NAN, f64::INFINITY] {
        let found = Glossy::<A>::new(A::parameter(e), BelowHorizon::Zero);
        assert!(matches!(found, Err(Error::Exponent { .. })), "{e}");
    }
}

each_float!(
    the_mean_cosine_is_that_of_the_lobe energy_is_accounted_for a_very_sharp_lobe_is_a_mirror
    both_sides_reflect a_bad_exponent_is_refused
);
