//! Frames and unit vectors: of unit length, orthonormal and right-handed about any vector that has
//! a direction, there and back, and an error for any other.

use super::convert::assert_clear;
use super::roots::{EachRoot, eps, every_root, nearest, wide};
use crate::arithmetics::Tested;
use crate::orthonormal::{LARGEST, deviation, dot};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::arithmetic::{Real, Root};
use hemidisc::invariant::Exact;
use hemidisc::{Cosine, Density, Error, Frame, Invert, Unit};

#[derive(Arbitrary, Debug)]
struct Input {
    vector: [f64; 3],
    local: [f64; 3],
    uv: [u32; 2],
    single: Frame<f32>,
    double: Frame<f64>,
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let mut input: Input = Unstructured::new(data).arbitrary()?;
    every_root(&mut input);
    is_frame(input.single);
    is_frame(input.double);
    Ok(())
}

/// A frame that `Arbitrary` has made is one that the constructors take.
fn is_frame<R: Real>(frame: Frame<R>) {
    let [x, _, z] = frame.axes();
    assert_eq!(Frame::new(z), Ok(frame));
    assert_eq!(Frame::from(frame.unit()), frame);
    assert_eq!(Frame::with_tangent(frame.unit(), x), Ok(frame));
    assert!(orthonormal(frame), "{frame:?}");
}

/// How far the length squared of a unit vector is from 1.
fn beside_1<R: Real>(vector: [R; 3]) -> f64 {
    (dot(vector, vector) - 1.0).abs()
}

/// As close as the lengths of the first and third axis let it be; the sums here round as well.
fn orthonormal<R: Real>(frame: Frame<R>) -> bool {
    let [x, _, z] = frame.axes();
    let length = beside_1(x).max(beside_1(z));
    // A unit vector's is within 16 ulp, and its own sum has rounded.
    beside_1(z) <= 36.0 * eps::<R>()
        && deviation(frame.axes()) <= (LARGEST + 4.0) * eps::<R>() + 3.0 * length
}

impl EachRoot for Input {
    fn each<A: Root<Real: Real> + Tested>(&mut self) {
        let vector = nearest::<A, 3>(self.vector);
        let (square, room) = (dot(vector, vector), 8.0 * eps::<A::Real>());
        match Frame::new(vector) {
            Ok(frame) => {
                assert!(orthonormal(frame), "{} {vector:?}: {frame:?}", A::NAME);
                assert!((square - 1.0).abs() <= 1.0 / 128.0 + room, "{} {vector:?}", A::NAME);
                if (square - 1.0).abs() <= 24.0 * eps::<A::Real>() {
                    assert_eq!(frame.axes()[2], vector);
                }
                assert_eq!(Unit::normalized(vector), Ok(frame.unit()));
                self.turns::<A>(frame);
            }
            Err(error @ Error::NotUnit { length_squared }) => {
                assert_clear(&error);
                // NaN has no direction either.
                let near = (length_squared - 1.0).abs() <= 1.0 / 128.0 - room;
                assert!(!near, "{} {vector:?}", A::NAME);
            }
            Err(other) => panic!("{other}"),
        }
        self.of_any_length::<A>(vector);
        self.of_two::<A>(vector);
        // Numbers that are equal make frames that are equal.
        let zero = A::Real::ZERO;
        let other = vector.map(|x| if x == zero { -x } else { x });
        assert_eq!(Frame::normalized(other), Frame::normalized(vector), "{vector:?}");
    }
}

impl Input {
    fn of_any_length<A: Root<Real: Real> + Tested>(&self, vector: [A::Real; 3]) {
        let exact = wide(vector);
        let has_direction = exact.into_iter().all(f64::is_finite) && exact != [0.0; 3];
        match Frame::normalized(vector) {
            Ok(frame) => {
                assert!(has_direction && orthonormal(frame), "{} {vector:?}: {frame:?}", A::NAME);
                let largest = exact.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                let scaled = exact.map(|x| x / largest);
                let length = dot(scaled, scaled).sqrt();
                // Within 2 ulp, and within 8 as the bits stay where the length is within 8.
                let room = if beside_1(exact) <= 36.0 * eps::<A::Real>() { 20.0 } else { 4.0 };
                for (component, exact) in wide(frame.axes()[2]).into_iter().zip(scaled) {
                    let room = room * eps::<A::Real>();
                    assert!((component - exact / length).abs() <= room, "{} {vector:?}", A::NAME);
                }
                self.turns::<A>(frame);
                self.has_a_tangent::<A>(frame.unit());
            }
            Err(error) => {
                assert_clear(&error);
                assert_eq!((error, has_direction), (Error::NoDirection, false), "{vector:?}");
            }
        }
    }

    /// A normal has a frame, whatever it is; two axes, and a camera, have one or a clear error.
    fn of_two<A: Root<Real: Real> + Tested>(&self, vector: [A::Real; 3]) {
        let z_axis = nearest::<A, 3>([0.0, 0.0, 1.0]);
        let expected = Frame::normalized(vector).or(Frame::new(z_axis));
        assert_eq!(Ok(Frame::from_normal(vector)), expected, "{} {vector:?}", A::NAME);
        let other = nearest::<A, 3>(self.local);
        let what = || format!("{} {vector:?} {other:?}", A::NAME);
        let units = [vector, other].map(Unit::normalized);
        for (camera, made) in
            [(false, Frame::from_axes(vector, other)), (true, Frame::look_to(vector, other))]
        {
            match (made, units) {
                (Ok(frame), [Ok(first), Ok(second)]) => {
                    assert!(orthonormal(frame), "{}: {frame:?}", what());
                    let [x, y, z] = frame.axes();
                    assert_eq!(Frame::with_tangent(frame.unit(), x), Ok(frame), "{}", what());
                    assert_eq!(if camera { z } else { x }, first.get(), "{}", what());
                    let side = dot(y, second.get());
                    assert!(if camera { side < 0.0 } else { side > 0.0 }, "{}: {side}", what());
                }
                (Err(error @ Error::Parallel { cosine }), [Ok(_), Ok(_)]) => {
                    assert_clear(&error);
                    assert!((cosine.abs() - 1.0).abs() <= 40.0 * eps::<A::Real>(), "{}", what());
                }
                (made, units) => {
                    assert_eq!(made.map(|_| ()), Err(Error::NoDirection), "{}", what());
                    assert!(units.iter().any(Result::is_err), "{}", what());
                }
            }
        }
    }

    /// The frame of any tangent.
    fn has_a_tangent<A: Root<Real: Real> + Tested>(&self, normal: Unit<A::Real>) {
        let tangent = nearest::<A, 3>(self.local);
        let what = || format!("{} {normal:?} {tangent:?}", A::NAME);
        match Frame::with_tangent(normal, tangent) {
            Ok(frame) => {
                assert!(orthonormal(frame), "{}: {frame:?}", what());
                assert_eq!(frame.unit(), normal);
                let [x, ..] = frame.axes();
                let along = Unit::normalized(tangent).unwrap().get();
                assert!(dot(x, along) > 0.0, "{}: {frame:?}", what());
                assert_eq!(Frame::with_tangent(normal, x), Ok(frame), "{}", what());
                self.turns::<A>(frame);
            }
            Err(error @ Error::Parallel { cosine }) => {
                assert_clear(&error);
                assert!((cosine.abs() - 1.0).abs() <= 40.0 * eps::<A::Real>(), "{}", what());
            }
            Err(error) => {
                assert_eq!(error, Error::NoDirection);
                assert!(Unit::normalized(tangent).is_err(), "{}", what());
            }
        }
    }

    /// To the world and back, and a lobe about the frame.
    fn turns<A: Root<Real: Real> + Tested>(&self, frame: Frame<A::Real>) {
        let Input { local, uv, .. } = *self;
        let local = local.map(|x| if x.abs() <= 1.0 { x } else { 0.5 });
        let local = nearest::<A, 3>(local);
        let room = 2.0 * LARGEST * eps::<A::Real>() + 64.0 * eps::<A::Real>();
        for (a, b) in wide(local).into_iter().zip(wide(frame.to_local(frame.to_world(local)))) {
            assert!((a - b).abs() <= 3.0 * room, "{} {frame:?}: {a} became {b}", A::NAME);
        }
        let lobe = Cosine::<A>::new();
        let about = lobe.about(frame);
        let (direction, density) = about.sample_with_density(uv);
        assert_eq!(direction, about.sample(uv));
        assert_eq!(direction, frame.to_world(lobe.sample(uv)));
        assert_eq!(density.exact(), lobe.density(lobe.sample(uv)).exact());
        let cosine = dot(direction, frame.axes()[2]);
        let height: f64 = lobe.sample(uv)[2].exact();
        assert!((cosine - height).abs() <= 3.0 * room, "{} {frame:?}: {cosine} {height}", A::NAME);
        assert!(about.density(direction).exact() >= 0.0);
        assert_eq!(*about.frame(), frame);
        let _ = about.invert(direction);
    }
}
