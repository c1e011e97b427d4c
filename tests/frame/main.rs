//! Frames: orthonormal about any unit vector, exact near z = -1, and world-space sampling.
#![cfg(feature = "libm")]

mod axes;
mod normals;

use hemidisc::arithmetic::Real;
use hemidisc::sequence::{Random, SobolOwen};
use hemidisc::{Cosine, Density, Error, Frame, LibmF32, LibmF64, Points, Power, Unit, UnitSquare};
use proptest::prelude::*;
use testkit::orthonormal::{LARGEST, deviation, dot};

/// A unit vector in f32 from any direction, rounded once.
fn unit([x, y, z]: [f64; 3]) -> [f32; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|component| (component / length) as f32)
}

const EPS: f64 = f32::EPSILON as f64 / 2.0;

/// As close to orthonormal as the lengths of its axes let it be, which are those of unit vectors.
#[track_caller]
fn assert_orthonormal(frame: Frame<f32>) {
    let [x, _, z] = frame.axes();
    let lengths = [x, z].map(|axis| (dot(axis, axis) - 1.0).abs());
    // Within 16 ulp, and the sum that says so has rounded.
    assert!(lengths.into_iter().all(|length| length <= 36.0 * EPS), "{lengths:?}");
    let room = LARGEST * EPS + 3.0 * lengths[0].max(lengths[1]);
    let found = deviation(frame.axes());
    assert!(found <= room, "{frame:?}: {found:e}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn any_unit_vector_has_an_orthonormal_frame(
        x in -1.0..1.0_f64, y in -1.0..1.0_f64, z in -1.0..1.0_f64, flat in 0..40_i32, pole in any::<bool>(),
    ) {
        // As close to either pole as f32 can tell, one time in two.
        let scale = if pole { 0.5_f64.powi(flat) } else { 1.0 };
        prop_assume!(z != 0.0);
        let normal = unit([x * scale, y * scale, z]);
        let frame = Frame::new(normal).unwrap();
        prop_assert!(deviation(frame.axes()) < LARGEST * EPS, "{normal:?}: {}", deviation(frame.axes()) / EPS);
        prop_assert_eq!(frame.axes()[2], normal);
        let local = [0.25_f32, -0.5, 0.75];
        let back = frame.to_local(frame.to_world(local));
        for (a, b) in local.into_iter().zip(back) {
            prop_assert!(f64::from(a - b).abs() < 12.0 * EPS);
        }
    }
}

#[test]
fn the_poles_are_exact() {
    for (normal, x, y) in [
        ([0.0, 0.0, 1.0_f32], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]),
    ] {
        let [got_x, got_y, got_z] = Frame::new(normal).unwrap().axes();
        assert_eq!((got_x, got_y, got_z), (x, y, normal));
    }
}

/// Either sign of a zero is the same number: equal normals have equal frames.
#[test]
fn a_zero_of_either_sign_has_the_same_frame() {
    let zeros = [0.0, -0.0_f32];
    for signs in 0..8 {
        let [a, b, c] = [signs & 1, signs >> 1 & 1, signs >> 2].map(|sign| zeros[sign]);
        for (normal, same) in [
            ([1.0, b, c], [1.0, 0.0, 0.0]),
            ([a, -1.0, c], [0.0, -1.0, 0.0]),
            ([a, b, 1.0], [0.0, 0.0, 1.0]),
            ([a, b, -1.0], [0.0, 0.0, -1.0]),
            ([0.6, -0.8, c], [0.6, -0.8, 0.0]),
            ([a, 0.6, -0.8], [0.0, 0.6, -0.8]),
        ] {
            let (frame, same) = (Frame::new(normal).unwrap(), Frame::new(same).unwrap());
            assert_eq!(frame, same, "{normal:?}");
            assert!(deviation(frame.axes()) < 4.0 * EPS, "{normal:?}");
            let tangent = [0.1, 0.2, 0.3];
            let of = |normal| Frame::with_tangent(Unit::new(normal).unwrap(), tangent).unwrap();
            assert_eq!(of(normal), of(same.axes()[2]), "{normal:?}");
        }
    }
}

#[test]
fn vectors_are_checked() {
    for bad in
        [[0.0_f32; 3], [2.0, 0.0, 0.0], [0.0, 0.996, 0.0], [f32::NAN, 0.0, 1.0], [f32::MAX; 3]]
    {
        assert!(matches!(Frame::new(bad), Err(Error::NotUnit { .. })), "{bad:?}");
        assert!(Unit::new(bad).is_err(), "{bad:?}");
    }
    let error = Frame::new([0.0_f32, 2.0, 0.0]).unwrap_err();
    assert_eq!(error.to_string(), "a vector with length squared 4; accepted: 1 within 1/128");
    for bad in [[0.0_f32; 3], [f32::NAN, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0]] {
        assert_eq!(Frame::normalized(bad), Err(Error::NoDirection), "{bad:?}");
        let up = Unit::new([0.0, 0.0, 1.0]).unwrap();
        assert_eq!(Frame::with_tangent(up, bad), Err(Error::NoDirection), "{bad:?}");
    }
}

/// How far a vector is from one of unit length along the same direction, both in f64.
fn from_exact<R: Real>(found: [R; 3], vector: [R; 3]) -> f64 {
    let exact = vector.map(Into::into);
    let largest = exact.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    let [x, y, z] = exact.map(|x| x / largest);
    let length = (x * x + y * y + z * z).sqrt();
    let pairs = found.into_iter().zip([x, y, z]);
    pairs.fold(0.0, |worst, (found, x)| worst.max((found.into() - x / length).abs()))
}

/// From 1 - 1/128 to 1 + 1/128 of the length squared: accepted, and brought to unit length. Within
/// 16 ulp the bits stay. f64 is held to f64's own digits.
#[test]
fn what_is_near_unit_length_becomes_a_unit_vector() {
    for i in 0..4000 {
        let [a, b] = Points::new(Random::new(2), UnitSquare::<LibmF64>::new()).get(i).unwrap();
        let direction = [a - 0.5, b - 0.5, (a * 7.0).fract() - 0.5];
        let length = (direction.iter().map(|x| x * x).sum::<f64>()).sqrt();
        let stretch = (1.0 + (f64::from(i) / 2000.0 - 1.0) / 128.001).sqrt();
        let near = direction.map(|x| x / length * stretch);
        let found = Unit::new(near).unwrap().get();
        assert!((dot(found, found) - 1.0).abs() <= 6.0 * f64::EPSILON, "{near:?}");
        assert!(from_exact(found, near) <= 2.0 * f64::EPSILON, "{near:?}");
        assert_eq!(Unit::new(found).unwrap().get(), found);
        assert_eq!(Unit::normalized(near).unwrap().get(), found);
        let single = near.map(|x| x as f32);
        let found = Unit::new(single).unwrap().get();
        assert!((dot(found, found) - 1.0).abs() <= 12.0 * EPS, "{single:?}");
        assert!(from_exact(found, single) <= 4.0 * EPS, "{single:?}");
        assert_eq!(Frame::new(single).unwrap().axes()[2], found);
        let kept = unit(direction);
        assert_eq!(Unit::new(kept).unwrap().get(), kept);
    }
    for outside in [1.0 - 1.0 / 127.0, 1.0 + 1.0 / 127.0_f64] {
        assert!(Unit::new([0.0, outside.sqrt(), 0.0]).is_err(), "{outside}");
    }
}

/// Every direction of the crate's own maps is a unit vector, coarse as its arithmetic may be, and so
/// is every normal of a sphere in f32: 97 % and up to 27 % of them were refused.
#[test]
fn directions_and_hits_are_unit_vectors() {
    #[cfg(feature = "micromath")]
    for i in 0..4000 {
        let uv = SobolOwen::new(1).at(i);
        let coarse = hemidisc::Uniform::<hemidisc::MicromathF32>::new().sample(uv);
        let frame = Frame::new(coarse).unwrap_or_else(|error| panic!("{coarse:?}: {error}"));
        assert_orthonormal(frame);
    }
    for (radius, offset) in [(0.1_f32, 100.0), (1.0, 3.0), (50.0, 0.25)] {
        for i in 0..1000 {
            let outward = Cosine::<LibmF32>::new().sample(SobolOwen::new(2).at(i));
            let hit = outward.map(|x| offset + radius * x);
            let normal = hit.map(|x| (x - offset) / radius);
            assert!(Frame::new(normal).is_ok(), "{normal:?}");
        }
    }
}

#[test]
fn any_length_is_normalized() {
    let smallest = f32::from_bits(1);
    for vector in
        [[3.0_f32, -4.0, 12.0], [f32::MAX; 3], [smallest, 0.0, -smallest], [1e-38, 1e-42, 0.0]]
    {
        let frame = Frame::normalized(vector).unwrap();
        assert!(deviation(frame.axes()) < LARGEST * EPS, "{vector:?}");
        let exact = unit(vector.map(f64::from));
        for (a, b) in frame.axes()[2].into_iter().zip(exact) {
            assert!(f64::from(a - b).abs() < 3.0 * EPS, "{vector:?}");
        }
    }
    // Of every size from the smallest number to the largest, to the last digits.
    for i in 0..4000 {
        let [a, b] = Points::new(Random::new(3), UnitSquare::<LibmF64>::new()).get(i).unwrap();
        let direction = [a - 0.5, b - 0.5, (a * 7.0).fract() - 0.5];
        for size in [1e-308, 1e-160, 1e-3, 1.0, 100.0, 1e200, 1e308_f64] {
            let vector = direction.map(|x| x * size);
            let found = Unit::normalized(vector).unwrap().get();
            assert!(from_exact(found, vector) <= 2.0 * f64::EPSILON, "{vector:?}");
        }
        for size in [1e-44, 1e-38, 1e-20, 1e-3, 1.0, 100.0, 1e20, 3e38_f64] {
            let vector = direction.map(|x| (x * size) as f32);
            if vector == [0.0; 3] {
                continue;
            }
            let found = Unit::normalized(vector).unwrap().get();
            assert!(from_exact(found, vector) <= 4.0 * EPS, "{vector:?}");
        }
    }
}

#[test]
fn world_samples_are_the_local_ones_turned() {
    for i in 0..200 {
        let [a, b] = Points::new(Random::new(9), UnitSquare::<LibmF64>::new()).get(i).unwrap();
        let normal = unit([a - 0.5, b - 0.5, (a * 7.0).fract() - 0.5]);
        let frame = Frame::new(normal).unwrap();
        let cosine = Cosine::<LibmF32>::new();
        let world = cosine.about(frame);
        let glossy = Power::<LibmF32>::new(1e4).unwrap().about(frame);
        let points = SobolOwen::new(i);
        for uv in (0..64).map(|index| points.at(index)) {
            let direction = world.sample(uv);
            assert_eq!(direction, frame.to_world(cosine.sample(uv)));
            assert!(dot(direction, normal) > -4.0 * EPS, "{direction:?} below {normal:?}");
            assert!((dot(direction, direction) - 1.0).abs() < 12.0 * EPS);
            let (same, exact) = world.sample_with_density(uv);
            assert_eq!((same, exact), (direction, cosine.density(cosine.sample(uv))));
            assert!(exact > 0.0);
            let density = f64::from(world.density(direction));
            let expected = dot(direction, normal) / std::f64::consts::PI;
            assert!((density - expected).abs() < 8.0 * EPS);
            // About the mirror direction of a sharp lobe every sample is near it.
            assert!(dot(glossy.sample(uv), normal) > 0.99);
        }
    }
}
