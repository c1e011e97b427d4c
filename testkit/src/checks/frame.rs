//! Frames: orthonormal and right-handed about any vector that has a direction, there and back, and
//! an error for any other.

use super::convert::assert_clear;
use super::roots::{EachRoot, eps, every_root, nearest, wide};
use crate::arithmetics::Tested;
use crate::orthonormal::{LARGEST, deviation, dot};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::arithmetic::{Real, Root};
use hemidisc::invariant::Exact;
use hemidisc::{Cosine, Density, Error, Frame, Invert, Map};

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

/// A frame that `Arbitrary` has made is one that the constructor takes.
fn is_frame<R: Real>(frame: Frame<R>) {
    let [_, _, z] = frame.axes();
    assert_eq!(Frame::new(z), Ok(frame));
    assert!(orthonormal(frame), "{frame:?}");
}

/// As close as the length of the third axis lets it be; the sums here round as well.
fn orthonormal<R: Real>(frame: Frame<R>) -> bool {
    let [_, _, z] = frame.axes();
    let length = (dot(z, z) - 1.0).abs();
    deviation(frame.axes()) <= (LARGEST + 4.0) * eps::<R>() + 3.0 * length
}

impl EachRoot for Input {
    fn each<A: Root<Real: Real> + Tested>(&mut self) {
        let vector = nearest::<A, 3>(self.vector);
        match Frame::new(vector) {
            Ok(frame) => {
                assert!(orthonormal(frame), "{} {vector:?}: {frame:?}", A::NAME);
                assert_eq!(frame.axes()[2], vector);
                self.turns::<A>(frame);
            }
            Err(error @ Error::NotUnit { length_squared }) => {
                assert_clear(&error);
                // NaN has no direction either.
                let near = (length_squared - 1.0).abs() <= 32.0 * eps::<A::Real>();
                assert!(!near, "{} {vector:?}", A::NAME);
            }
            Err(other) => panic!("{other}"),
        }
        let exact = wide(vector);
        let has_direction = exact.into_iter().all(f64::is_finite) && exact != [0.0; 3];
        match Frame::normalized::<A>(vector) {
            Ok(frame) => {
                assert!(has_direction, "{} {vector:?}", A::NAME);
                let room = LARGEST * A::DENSITY_ERROR;
                assert!(deviation(frame.axes()) <= 2.0 * room, "{} {vector:?}: {frame:?}", A::NAME);
                let largest = exact.into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                let scaled = exact.map(|x| x / largest);
                let length = dot(scaled, scaled).sqrt();
                for (component, exact) in wide(frame.axes()[2]).into_iter().zip(scaled) {
                    assert!((component - exact / length).abs() <= room, "{} {vector:?}", A::NAME);
                }
                self.turns::<A>(frame);
            }
            Err(error) => {
                assert_clear(&error);
                assert_eq!((error, has_direction), (Error::NoDirection, false), "{vector:?}");
            }
        }
    }
}

impl Input {
    /// To the world and back, and a lobe about the frame.
    fn turns<A: Root<Real: Real> + Tested>(&self, frame: Frame<A::Real>) {
        let Input { local, uv, .. } = *self;
        let local = local.map(|x| if x.abs() <= 1.0 { x } else { 0.5 });
        let local = nearest::<A, 3>(local);
        let room = 2.0 * LARGEST * A::DENSITY_ERROR + 64.0 * eps::<A::Real>();
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
