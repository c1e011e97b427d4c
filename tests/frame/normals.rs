//! Frames of the normals that a renderer's inner loop has, without an error.

use super::{EPS, assert_orthonormal, from_exact};
use hemidisc::domain::Domain;
use hemidisc::sequence::{Random, SobolOwen};
use hemidisc::{Concentric, Cosine, FastF32, Frame, LibmF32, Unit, effect::ThinLens};
use testkit::orthonormal::dot;

type Vector = [f32; 3];

fn along(a: Vector, k: f32, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] + k * b[i])
}

fn dot_f32(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The last scene of P. Shirley, T. Black and S. Hollasch, "Ray Tracing in One Weekend": the ground,
/// three spheres, and small ones all over.
fn weekend() -> Vec<(Vector, f32)> {
    let mut spheres = vec![
        ([0.0, -1000.0, 0.0], 1000.0),
        ([0.0, 1.0, 0.0], 1.0),
        ([-4.0, 1.0, 0.0], 1.0),
        ([4.0, 1.0, 0.0], 1.0),
    ];
    let places = Random::new(1);
    for (i, (a, b)) in (0..).zip((-11..11).flat_map(|a| (-11..11).map(move |b| (a, b)))) {
        let [x, z] = places.at(i).map(|k| k as f32 / 4_294_967_296.0);
        let centre = [a as f32 + 0.9 * x, 0.2, b as f32 + 0.9 * z];
        if dot_f32(along(centre, -1.0, [4.0, 0.2, 0.0]), [1.0; 3]).abs() > 0.9 {
            spheres.push((centre, 0.2));
        }
    }
    spheres
}

/// The book's: the nearer root of the quadratic beyond 0.001, the point, and (p - c) / r.
fn hit(spheres: &[(Vector, f32)], origin: Vector, direction: Vector) -> Option<[Vector; 2]> {
    let mut nearest = f32::INFINITY;
    let mut found = None;
    for (centre, radius) in spheres {
        let oc = along(*centre, -1.0, origin);
        let (a, h) = (dot_f32(direction, direction), dot_f32(direction, oc));
        let discriminant = h * h - a * (dot_f32(oc, oc) - radius * radius);
        if discriminant < 0.0 {
            continue;
        }
        let root = discriminant.sqrt();
        for t in [(h - root) / a, (h + root) / a] {
            if t > 1e-3 && t < nearest {
                nearest = t;
                let point = along(origin, t, direction);
                found = Some([point, [0, 1, 2].map(|i| (point[i] - centre[i]) / radius)]);
            }
        }
    }
    found
}

/// Of every hit of the scene in f32, through bounces: a frame, orthonormal, about the normal. A part
/// of the normals is farther from unit length than 16 ulp, which refused them once.
#[test]
fn every_hit_of_a_scene_has_a_frame() {
    let spheres = weekend();
    let (eye, up) = ([13.0, 2.0, 3.0_f32], [0.0, 1.0, 0.0]);
    let camera = Frame::look_to(eye.map(|x| -x), up).unwrap();
    let lens = ThinLens::new(Concentric::<FastF32>::new(), 0.052, 10.0).unwrap();
    let (mut hits, mut off, mut worst) = (0, 0, 0.0_f64);
    for pixel in 0..150 * 100 {
        let (x, y) = (pixel % 150, pixel / 150);
        let domain = Domain::new(3).pixel(x, y);
        let ahead = [x as f32 - 74.5, y as f32 - 49.5].map(|p| p * 0.3527 / 100.0);
        let ray = lens.ray(ahead, SobolOwen::in_domain(domain).at(0));
        let mut origin = along(eye, 1.0, camera.to_world(ray.origin));
        let mut direction = camera.to_world(ray.direction);
        for bounce in 1..6 {
            let Some([point, normal]) = hit(&spheres, origin, direction) else { break };
            let length = dot(normal, normal) - 1.0;
            let frame = Frame::from_normal(normal);
            assert_orthonormal(frame);
            // Kept bits are off by as much as the length; 16 ulp of its square are 8 of it.
            let room = if length.abs() > 36.0 * EPS { 4.0 } else { 20.0 };
            assert!(from_exact(frame.axes()[2], normal) <= room * EPS, "{normal:?}");
            (hits, worst) = (hits + 1, worst.max(length.abs()));
            off += i32::from(length.abs() > 32.0 * EPS);
            let lobe = Cosine::<FastF32>::new().about(frame);
            let uv = SobolOwen::in_domain(domain.child(bounce)).at(0);
            (origin, direction) = (point, lobe.sample(uv));
            assert!(dot(direction, normal) > -8.0 * EPS, "{direction:?} below {normal:?}");
            assert!((dot(direction, direction) - 1.0).abs() <= 96.0 * EPS, "{direction:?}");
        }
    }
    let share = f64::from(off) / f64::from(hits);
    println!("{hits} hits, {share:.3} off by more than 16 ulp, at most {worst:.2e}");
    assert!(hits > 20_000 && share > 0.05 && worst > 1e-5, "the scene has no bad normals");
}

/// A vector of any length has the frame of `normalized`, and one without a direction that of the z
/// axis.
#[test]
fn any_vector_has_a_frame() {
    for size in [1e-44, 1e-20, 0.5, 0.999, 1.0, 1.001, 7.0, 1e20, 3e38_f32] {
        for i in 0..200 {
            let normal =
                Cosine::<LibmF32>::new().sample(SobolOwen::new(2).at(i)).map(|x| -x * size);
            let frame = Frame::from_normal(normal);
            assert_eq!(Frame::normalized(normal), Ok(frame), "{normal:?}");
            assert_eq!(Unit::normalized_or_z(normal), frame.unit(), "{normal:?}");
            if (0.998..1.002).contains(&size) {
                assert_eq!(Frame::new(normal), Ok(frame), "{normal:?}");
            }
        }
    }
    let z = Frame::new([0.0, 0.0, 1.0_f32]).unwrap();
    for none in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for axis in 0..3 {
            let mut normal = [0.6, 0.0, -0.8];
            normal[axis] = none;
            assert_eq!(Frame::from_normal(normal), z, "{normal:?}");
        }
    }
    for zero in [[0.0; 3], [-0.0; 3]] {
        assert_eq!(Frame::from_normal(zero), z);
        assert_eq!(Unit::normalized_or_z(zero).get(), [0.0, 0.0, 1.0]);
    }
}
