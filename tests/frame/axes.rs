//! Frames from two vectors: a normal and a tangent, two axes, a camera.

use super::{EPS, assert_orthonormal, unit};
use hemidisc::effect::ThinLens;
use hemidisc::sequence::Random;
use hemidisc::{Concentric, Error, Frame, LibmF32, LibmF64, Points, Unit, UnitSquare};
use testkit::orthonormal::dot;

/// Across n_z = 0 the frame about a normal turns; that of a tangent does not.
#[test]
fn a_tangent_makes_frames_continuous() {
    for i in 0..1000 {
        let [a, b] = Points::new(Random::new(4), UnitSquare::<LibmF64>::new()).get(i).unwrap();
        let (sin, cos) = (a * std::f64::consts::TAU).sin_cos();
        let (up, down) = (unit([cos, sin, 1e-6]), unit([cos, sin, -1e-6]));
        let tangent = [-sin as f32, cos as f32, b as f32];
        let of = |normal| Frame::with_tangent(Unit::new(normal).unwrap(), tangent).unwrap();
        let (above, below) = (of(up), of(down));
        for frame in [above, below] {
            assert_orthonormal(frame);
        }
        for (a, b) in above.axes().into_iter().zip(below.axes()) {
            for (a, b) in a.into_iter().zip(b) {
                assert!((a - b).abs() < 4e-6, "{above:?} {below:?}");
            }
        }
        assert!(dot(above.axes()[0], tangent) > 0.0);
        // The frame is a function of its third and first axis.
        let [x, _, z] = above.axes();
        assert_eq!(Frame::with_tangent(Unit::new(z).unwrap(), x), Ok(above));
        let plain = Frame::new(up).unwrap();
        assert_eq!(Frame::with_tangent(plain.unit(), plain.axes()[0]), Ok(plain));
    }
    let turned = |z: f32| Frame::new([1.0, 0.0, z]).unwrap().axes()[1];
    assert!(dot(turned(1e-6), turned(-1e-6)) < -0.99, "documented at Frame");
}

/// A normal at either end of what is taken to be of unit length, and a tangent almost along it.
#[test]
fn a_normal_within_16_ulp_has_an_orthonormal_frame() {
    for size in [1.0 - 7.0 * f32::EPSILON, 1.0 + 7.0 * f32::EPSILON] {
        let normal = Unit::new([-1e-7, size, 0.0]).unwrap();
        assert_eq!(normal.get(), [-1e-7, size, 0.0]);
        for tangent in [[-1e-7, 999_999.5, 0.6], [1.0, 1e5, 0.0], [0.3, 2.0, -7.0_f32]] {
            if let Ok(frame) = Frame::with_tangent(normal, tangent) {
                assert_orthonormal(frame);
                assert_eq!(Frame::with_tangent(normal, frame.axes()[0]), Ok(frame));
            }
        }
        assert!(Frame::with_tangent(normal, [-1e-7, 999_999.5, 0.6]).is_err());
    }
}

/// However little a tangent leaves the normal, the frame is orthonormal, or there is none.
#[test]
fn a_tangent_along_the_normal_is_refused() {
    let normal = unit([0.3, -0.5, 0.7]);
    let up = Unit::new(normal).unwrap();
    let [across, ..] = Frame::from(up).axes();
    let mut refused = 0;
    for halvings in 0..40 {
        for sign in [1.0, -1.0] {
            let k = 0.5_f32.powi(halvings);
            let tangent = core::array::from_fn(|i| sign * 7.0 * (normal[i] + k * across[i]));
            match Frame::with_tangent(up, tangent) {
                Ok(frame) => assert_orthonormal(frame),
                Err(error) => {
                    let Error::Parallel { cosine } = error else { panic!("{error}") };
                    assert!((cosine - f64::from(sign)).abs() < 4.0 * EPS, "{cosine}");
                    refused += 1;
                }
            }
        }
    }
    assert!((34..=46).contains(&refused), "{refused}");
    let error = Frame::with_tangent(up, normal).unwrap_err().to_string();
    assert!(error.starts_with("two vectors with the cosine "), "{error}");
}

/// A vector of any direction and length, of a random number.
fn any(i: u32) -> [f32; 3] {
    let [a, b] = Points::new(Random::new(11), UnitSquare::<LibmF64>::new()).get(i).unwrap();
    let size = 10_f64.powf(40.0 * (b * 31.0).fract() - 20.0);
    [a - 0.5, b - 0.5, (a * 7.0).fract() - 0.5].map(|x| (x * size) as f32)
}

/// The direction of a vector, in doubles.
fn direction(vector: [f32; 3]) -> [f64; 3] {
    let wide = vector.map(f64::from);
    let length = dot(wide, wide).sqrt();
    wide.map(|x| x / length)
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[track_caller]
fn assert_along(found: [f32; 3], exact: [f64; 3], room: f64) {
    let length = dot(exact, exact).sqrt();
    for axis in 0..3 {
        let off = (f64::from(found[axis]) - exact[axis] / length).abs();
        assert!(off <= room, "{found:?}, not {exact:?}: {} eps", off / EPS);
    }
}

/// x is along the first axis given, z is x cross y, and y is on the side of the second.
#[test]
fn two_axes_make_a_right_handed_frame() {
    for i in 0..4000 {
        let (x, y) = (any(2 * i), any(2 * i + 1));
        let frame = Frame::from_axes(x, y).unwrap();
        assert_orthonormal(frame);
        let [exact_x, exact_y] = [x, y].map(direction);
        let z = cross(exact_x, exact_y);
        // The smaller the angle, the less the plane of the two is known.
        let room = 8.0 * EPS / dot(z, z).sqrt();
        assert_along(frame.axes()[0], exact_x, 4.0 * EPS);
        assert_along(frame.axes()[2], z, room);
        assert_along(frame.axes()[1], cross(z, exact_x), room);
        assert!(dot(frame.axes()[1], y) > 0.0);
        let [first, _, third] = frame.axes();
        assert_eq!(Frame::with_tangent(Unit::new(third).unwrap(), first), Ok(frame));
    }
    let turned = Frame::from_axes([1.0, 0.0, 0.0], [0.0, -2.0, 0.0_f32]).unwrap();
    assert_eq!(turned.axes()[2], [0.0, 0.0, -1.0]);
}

/// However small the angle between two axes, the frame is orthonormal, or there is none.
#[test]
fn axes_that_span_no_plane_are_refused() {
    let x = [0.3, -0.5, 0.7_f32];
    let [beside, ..] = Frame::normalized(x).unwrap().axes();
    let mut refused = 0;
    for halvings in 0..40 {
        for sign in [1.0, -1.0_f32] {
            let k = 0.5_f32.powi(halvings);
            let y = [0, 1, 2].map(|i| sign * (x[i] + k * beside[i]));
            for made in [Frame::from_axes(x, y), Frame::look_to(x, y)] {
                match made {
                    Ok(frame) => assert_orthonormal(frame),
                    Err(error) => {
                        let Error::Parallel { cosine } = error else { panic!("{error}") };
                        assert!((cosine - f64::from(sign)).abs() < 8.0 * EPS, "{cosine}");
                        refused += 1;
                    }
                }
            }
        }
    }
    assert!((64..=96).contains(&refused), "{refused}");
    let x = [1.0, 0.0, 0.0_f32];
    for bad in [[0.0; 3], [f32::NAN, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0]] {
        for made in [Frame::from_axes(bad, x), Frame::from_axes(x, bad)] {
            assert_eq!(made, Err(Error::NoDirection), "{bad:?}");
        }
        for made in [Frame::look_to(bad, x), Frame::look_to(x, bad)] {
            assert_eq!(made, Err(Error::NoDirection), "{bad:?}");
        }
    }
}

/// Ahead is z, x is level and to the right, y is down, for any two vectors.
#[test]
fn a_camera_looks_ahead_with_y_down() {
    for i in 0..4000 {
        let (ahead, up) = (any(2 * i), any(2 * i + 1));
        let camera = Frame::look_to(ahead, up).unwrap();
        assert_orthonormal(camera);
        let [exact, level] = [ahead, up].map(direction);
        let right = cross(exact, level);
        let room = 8.0 * EPS / dot(right, right).sqrt();
        assert_along(camera.axes()[2], exact, 4.0 * EPS);
        assert_along(camera.axes()[0], right, room);
        assert!(dot(camera.axes()[1], up) < 0.0, "y is down");
    }
    // The usual world: y up, the camera looks along -z, x is to the right.
    let camera = Frame::look_to([0.0, 0.0, -3.0_f32], [0.0, 7.0, -1.0]).unwrap();
    assert_eq!(camera.axes(), [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]);
}

/// All rays of a pixel meet at the point in focus, in the world as well.
#[test]
fn rays_of_a_lens_meet_in_the_world() {
    let (eye, at) = ([13.0, 2.0, 3.0_f32], [0.0, 0.5, 0.0]);
    let camera = Frame::look_to([0, 1, 2].map(|i| at[i] - eye[i]), [0.0, 1.0, 0.0]).unwrap();
    let lens = ThinLens::new(Concentric::<LibmF32>::new(), 0.3, 10.0).unwrap();
    let pixel = [0.1, -0.05];
    let focus = camera.to_world([1.0, -0.5, 10.0]);
    for i in 0..100 {
        let ray = lens.ray(pixel, Random::new(3).at(i));
        let (origin, direction) = (camera.to_world(ray.origin), camera.to_world(ray.direction));
        for axis in 0..3 {
            assert!((origin[axis] + 10.0 * direction[axis] - focus[axis]).abs() < 4e-6);
        }
    }
    // A pixel above the middle looks up.
    let above = camera.to_world(lens.ray([0.0, -0.1], [1 << 31, 1 << 31]).direction);
    let middle = camera.to_world(lens.ray([0.0, 0.0], [1 << 31, 1 << 31]).direction);
    assert!(above[1] > middle[1] + 0.05);
}
