//! Other shapes of a fill, in fast f32 from stored coordinates: components apart, and lobes that a
//! frame has turned. Each is compared with the plain fill of the same map.

use crate::buffers::{Coordinates, Visitor, WINDOWS, filler};
use benches::EXPONENT;
use benches::failure::Failure;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{self, MapVisitor};
use hemidisc::frame::About;
use hemidisc::sequence::Stored;
use hemidisc::{FastF32, Frame, Invert, Map, Points, UnitSquare};
use std::hint::black_box;

pub(crate) fn every<'a>(
    coordinates: &'a Coordinates,
    points: usize,
    visitor: &mut impl Visitor<'a>,
) -> Result<(), Failure> {
    let stored = Stored::new(coordinates.windows(points))?;
    let frame = Frame::new([0.6, 0.0, 0.8])?;
    let mut shapes = Shapes { stored, frame, points, visitor };
    shapes.apart("square", "-", UnitSquare::<FastF32>::new());
    catalogue::maps::<FastF32>(&mut shapes);
    catalogue::power_maps::<FastF32>(EXPONENT, &mut shapes)?;
    Ok(())
}

struct Shapes<'a, 'v, V> {
    stored: Stored<'a>,
    frame: Frame<f32>,
    points: usize,
    visitor: &'v mut V,
}

impl<'a, V: Visitor<'a>> Shapes<'a, '_, V> {
    fn apart<M: Map<Point = [f32; D]> + 'static, const D: usize>(
        &mut self,
        name: &str,
        disc: &str,
        map: M,
    ) {
        let (stored, points) = (self.stored, self.points);
        let path = format!("apart/{name}/{disc}/{}", FastF32::NAME);
        self.visitor.fill(&path, || {
            let mut buffers = [(); D].map(|()| vec![0.0; points]);
            let all = Points::new(stored, map);
            let windows = (all.len() as usize / points).min(WINDOWS);
            let mut window = 0;
            move || {
                window = (window + 1) % windows;
                let range = (window * points) as u32..((window + 1) * points) as u32;
                if let Ok(points) = all.range(range) {
                    fill(black_box(&points), black_box(&mut buffers));
                }
            }
        });
    }
}

/// A function of its own for each set, as for plain fills.
#[inline(never)]
fn fill<'a, M: Map<Point = [f32; D]>, const D: usize>(
    points: &Points<Stored<'a>, M>,
    buffers: &mut [Vec<f32>; D],
) {
    points.fill_components(buffers.each_mut().map(Vec::as_mut_slice));
}

impl<'a, V: Visitor<'a>> MapVisitor<FastF32> for Shapes<'a, '_, V> {
    fn disc<M: Invert<Point = [f32; 2]> + 'static>(&mut self, name: &'static str, map: M) {
        self.apart("disc", name, map);
    }

    fn hemisphere<M: Invert<Point = [f32; 3]> + 'static>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.apart(name, disc, map);
        let (stored, points, turned) = (self.stored, self.points, About::new(map, self.frame));
        let path = format!("turned/{name}/{disc}/{}", FastF32::NAME);
        self.visitor.fill(&path, || filler(stored, turned, points));
    }
}
