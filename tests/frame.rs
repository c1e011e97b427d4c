//! Frames: orthonormal about any unit vector, exact near z = -1, and world-space sampling.
#![cfg(feature = "libm")]

use hemidisc::sequence::{Random, SobolOwen};
use hemidisc::{Cosine, Density, Error, Frame, LibmF32, LibmF64, Map, Points, Power, UnitSquare};
use proptest::prelude::*;
use testkit::orthonormal::{LARGEST, deviation, dot};

/// A unit vector in f32 from any direction, rounded once.
fn unit([x, y, z]: [f64; 3]) -> [f32; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x, y, z].map(|component| (component / length) as f32)
}

const EPS: f64 = f32::EPSILON as f64 / 2.0;

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
    // Either sign of a zero z has its frame.
    for z in [0.0, -0.0_f32] {
        for normal in [[1.0, 0.0, z], [0.0, -1.0, z], unit([1.0, 1.0, z.into()])] {
            assert!(deviation(Frame::new(normal).unwrap().axes()) < 4.0 * EPS, "{normal:?}");
        }
    }
}

#[test]
fn vectors_are_checked() {
    for bad in
        [[0.0_f32; 3], [2.0, 0.0, 0.0], [0.0, 0.999_99, 0.0], [f32::NAN, 0.0, 1.0], [f32::MAX; 3]]
    {
        assert!(matches!(Frame::new(bad), Err(Error::NotUnit { .. })), "{bad:?}");
    }
    let error = Frame::new([0.0_f32, 2.0, 0.0]).unwrap_err();
    assert_eq!(error.to_string(), "a vector with length squared 4; accepted: 1 within 16 ulp");
    for bad in [[0.0_f32; 3], [f32::NAN, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0]] {
        assert_eq!(Frame::normalized::<LibmF32>(bad), Err(Error::NoDirection), "{bad:?}");
    }
}

#[test]
fn any_length_is_normalized() {
    let smallest = f32::from_bits(1);
    for vector in
        [[3.0_f32, -4.0, 12.0], [f32::MAX; 3], [smallest, 0.0, -smallest], [1e-38, 1e-42, 0.0]]
    {
        let frame = Frame::normalized::<LibmF32>(vector).unwrap();
        assert!(deviation(frame.axes()) < LARGEST * EPS, "{vector:?}");
        let exact = unit(vector.map(f64::from));
        for (a, b) in frame.axes()[2].into_iter().zip(exact) {
            assert!(f64::from(a - b).abs() < 3.0 * EPS, "{vector:?}");
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
