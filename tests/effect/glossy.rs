//! Glossy reflection.

mod flip;

use super::{COUNT, Float, assert_near, dot, each_float, even_mean, wide};
use flip::a_flipped_density_is_a_sum;
use hemidisc::effect::{BelowHorizon, Glossy};
use hemidisc::sequence::SobolOwen;
use hemidisc::{Error, LibmF64, Uniform, Unit};
use std::f64::consts::TAU;

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const POLICIES: [BelowHorizon; 3] = [BelowHorizon::Reject, BelowHorizon::Flip, BelowHorizon::Zero];

fn unit<A: Float>(vector: [f64; 3]) -> Unit<A::Real> {
    Unit::new(A::vector(vector)).unwrap()
}

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
                let sample = gloss.sample(unit::<A>([0.0, 0.0, -1.0]), unit::<A>(UP), uv).unwrap();
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
        let (down, up) = (unit::<A>(down), unit::<A>(UP));
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
            let sample = gloss.sample(unit::<A>(down), unit::<A>(UP), uv).unwrap();
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
        let from_below = gloss.sample(unit::<A>([0.6, 0.0, 0.8]), unit::<A>(UP), uv).unwrap();
        assert!(from_below.direction[2].into() <= 0.0);
        let along = gloss.sample(unit::<A>([1.0, 0.0, 0.0]), unit::<A>(UP), uv).unwrap();
        assert!(along.direction[2].into() >= 0.0);
    }
}

/// Of any normal and arriving direction that a frame or a `Unit` takes, a sample is of unit length,
/// and its density is that of its direction, for all policies. The first pair gave a length of 0.78
/// and densities of 8.12 and 1.14.
fn a_sample_is_of_unit_length_and_has_its_density<A: Float>() {
    let pairs = (0..60).map(|i| {
        let uvs = [SobolOwen::new(11).at(i), SobolOwen::new(12).at(i)];
        let sphere = |uv: [u32; 2]| {
            let [x, y, z] = Uniform::<LibmF64>::new().sample([uv[0] << 1, uv[1]]);
            [x, y, if uv[0] >> 31 == 0 { z } else { -z }]
        };
        (sphere(uvs[0]), sphere(uvs[1]))
    });
    let given = [([0.597, -0.796, 0.0995], [0.0, 0.9, 0.0]), ([0.6, -0.8, 0.0], [0.0, 1.002, 0.0])];
    for (arriving, normal) in given.into_iter().chain(pairs) {
        let [arriving, normal] =
            [arriving, normal].map(|v| Unit::normalized(A::vector(v)).unwrap());
        for (e, below) in
            [0.5, 1.0, 10.0, 50.0, 1000.0].into_iter().flat_map(|e| POLICIES.map(|b| (e, b)))
        {
            let gloss = gloss::<A>(e, below);
            for i in 0..64 {
                let uv = SobolOwen::new(3).at(i);
                let Some(sample) = gloss.sample(arriving, normal, uv) else { continue };
                let direction: [f64; 3] = wide(sample.direction);
                assert_near(dot(direction, direction), 1.0, 4.0 * A::EPS, "length");
                let [again, first] =
                    wide([gloss.density(arriving, normal, sample.direction), sample.density]);
                let peak: f64 = (e + 1.0) / TAU;
                // An eps of the angle to the axis counts sqrt e, and near the lobe's own horizon a
                // small exponent makes much of it.
                let room: f64 = if e < 1.0 { 2e-2 } else { 1e-7 };
                let room = f64::max(room, 20.0 * A::EPS * f64::sqrt(e).max(1.0)) * peak;
                assert_near(again, first, room, &format!("{e} {below:?} {sample:?}"));
            }
        }
    }
}

/// A vector of another length stands for its direction, and one without a direction for none.
fn the_length_of_a_direction_does_not_count<A: Float>() {
    let (down, up) = (unit::<A>(arriving(0.6).0), unit::<A>(UP));
    for gloss in POLICIES.map(|below| gloss::<A>(20.0, below)) {
        let direction = gloss.sample(down, up, [1 << 30, 1 << 30]).unwrap().direction;
        let exact: f64 = gloss.density(down, up, direction).into();
        for size in [1e-30, 0.5, 0.999, 1.001, 7.0, 1e30] {
            let found = gloss.density(down, up, direction.map(|x| x * A::real(size))).into();
            assert_near(found / exact, 1.0, 20.0 * A::EPS, "density");
        }
        for none in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, 0.0, f64::INFINITY]] {
            assert_eq!(gloss.density(down, up, A::vector(none)).into(), 0.0, "{none:?}");
        }
    }
}

/// A density integrates over all directions to 1 for `Flip` and `Zero`, and for `Reject` to the
/// share that is kept.
fn densities_integrate_to_what_is_sampled<A: Float>() {
    let sky = Uniform::<LibmF64>::new();
    for (e, sine) in [(1.0, 0.9), (5.0, 0.98), (10.0, 80_f64.to_radians().sin()), (5.0, 1.0)] {
        let (down, _) = arriving(sine);
        let (down, up) = (unit::<A>(down), unit::<A>(UP));
        for below in POLICIES {
            let gloss = gloss::<A>(e, below);
            let whole = even_mean(|uv| {
                let [x, y, z] = sky.sample(uv);
                let half = |z| gloss.density(down, up, A::vector([x, y, z])).into() * TAU;
                half(z) + half(-z)
            });
            let kept: f64 = gloss.kept_share(down, up).into();
            let exact = if below == BelowHorizon::Reject { kept } else { 1.0 };
            assert_near(whole, exact, 0.02, &format!("{e} {sine} {below:?}"));
        }
    }
}

/// Student's distribution function with e + 1 degrees of freedom at sqrt(e + 1) tan a, from sin a,
/// by Python's mpmath: `1 - betainc((e + 1) / 2, 0.5, 0, 1 - s**2, regularized=True) / 2`, and for
/// the largest exponents `0.5 + quad(f, [0, a]) / quad(f, [0, pi / 2]) / 2` with f = cos(t)**e.
const SHARES: [(f64, f64, f64); 25] = [
    (-0.999_023_437_5, 0.5, 0.500_268_021_715),
    (-0.999_023_437_5, 0.984_375, 0.501_181_071_653),
    (-0.5, 0.125, 0.523_930_124_632),
    (-0.5, 0.9375, 0.772_150_706_609),
    (0.0, 0.5, 2.0 / 3.0),
    (0.0, 0.75, 0.769_946_543_837),
    (1.0, 0.0625, 0.531_25),
    (1.0, 0.5, 0.75),
    (3.75, 0.375, 0.789_828_031_949),
    (10.0, 0.173_648_177_666_930_35, 0.714_762_096_010),
    (10.0, 0.171_875, 0.712_760_929_186),
    (10.0, 0.5, 0.959_067_884_417),
    (11.5, 0.25, 0.810_709_539_369),
    (12.0, 0.25, 0.815_576_854_108),
    (50.0, 0.0625, 0.671_692_763_568),
    (50.0, 0.25, 0.964_495_230_009),
    (1000.0, 0.031_25, 0.838_595_107_728),
    (10_000.0, 0.007_812_5, 0.782_681_512_019),
    (134_217_728.0, 0.000_122_070_312_5, 0.921_350_397_635),
    (134_217_728.0, 0.000_061_035_156_25, 0.760_249_939_520),
    (1_267_650_600_228_229_401_496_703_205_376.0, 8.881_784_197_001_252e-16, 0.841_344_746_069),
    (1_267_650_600_228_229_401_496_703_205_376.0, 4.440_892_098_500_626e-16, 0.691_462_461_274),
    (1_267_650_600_228_229_401_496_703_205_376.0, 3.552_713_678_800_501e-15, 0.999_968_328_758),
    // Along the surface, and straight down.
    (7.0, 0.0, 0.5),
    (-0.5, 1.0, 1.0),
];

fn the_share_that_is_kept_is_students<A: Float>() {
    // What `micromath-f32` has for functions is good to 8e-6.
    let room = if A::EPS > 1e-3 { 3e-5 } else { 1e-5 };
    let up = unit::<A>(UP);
    for (e, sine, exact) in SHARES {
        let down = A::vector([(1.0 - sine * sine).sqrt(), 0.0, -sine]);
        let gloss = gloss::<A>(e, BelowHorizon::Reject);
        for (arriving, normal) in [(down, up), (down.map(|x| -x), up), (down, -up)] {
            let found = gloss.kept_share(Unit::new(arriving).unwrap(), normal).into();
            assert_near(found, exact, room, &format!("{e} {sine}"));
            assert!((0.5..=1.0).contains(&found), "{found}");
        }
    }
    // It rises with the sine, for exponents on both sides of each step.
    for e in [-0.999_999, -0.9, 0.49, 0.51, 2.0, 9.4, 10.6, 11.4, 11.6, 1e6, 1e30] {
        let gloss = gloss::<A>(e, BelowHorizon::Zero);
        let mut before = 0.5;
        for step in 0..=64 {
            let sine = (f64::from(step) / 64.0 * 6.0 / (e + 1.0_f64).sqrt()).min(1.0);
            let down = A::vector([(1.0 - sine * sine).sqrt(), 0.0, -sine]);
            let share = gloss.kept_share(Unit::new(down).unwrap(), up).into();
            assert!(share >= before - 1e-5 && share <= 1.0, "{e} {sine}: {share} {before}");
            before = share;
        }
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
    both_sides_reflect a_sample_is_of_unit_length_and_has_its_density
    the_length_of_a_direction_does_not_count densities_integrate_to_what_is_sampled the_share_that_is_kept_is_students
    a_bad_exponent_is_refused a_flipped_density_is_a_sum
);
