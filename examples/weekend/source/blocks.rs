//! The samples of `one_by_one`, bit for bit, 64 at a time.
//!
//! The samples of a tile's pixels are a run of indices in the domain of each use. What the camera
//! and the first surfaces of a path draw is filled in blocks, which are vector code. A block of a
//! surface is filled when a path draws there.

use super::one_by_one::{FILM, LENS, OneByOne, SURFACE, about, in_ball};
use super::{Request, Source};
use crate::vector::Vector;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Map, Points, UnitSquare};

/// Surfaces of a path that have blocks. Further on, few paths of 64 draw.
const SURFACES: usize = 3;

#[derive(Debug)]
pub(crate) struct Blocks {
    film: Block<UnitSquare<FastF32>>,
    lens: Block<Concentric<FastF32>>,
    lobes: [Block<Cosine<FastF32>>; SURFACES],
    /// Surfaces that the path has met.
    met: usize,
    rest: OneByOne,
}

impl Blocks {
    /// A cosine-weighted direction about the z axis.
    #[inline]
    fn local(&mut self) -> Vector {
        let path = self.rest.at_surface();
        match self.lobes.get_mut(self.met.wrapping_sub(1)) {
            Some(block) => block.at(path.index()),
            None => path.sample(&Cosine::<FastF32>::new()),
        }
    }
}

impl Source for Blocks {
    fn new(request: &Request) -> Self {
        let picture = request.screen.domain();
        let mut surface = picture;
        let lobes = core::array::from_fn(|_| {
            surface = surface.child(SURFACE);
            Block::new(surface, Cosine::new(), [0.0; 3])
        });
        Self {
            film: Block::new(picture.child(FILM), UnitSquare::new(), [0.0; 2]),
            lens: Block::new(picture.child(LENS), Concentric::new(), [0.0; 2]),
            lobes,
            met: 0,
            rest: OneByOne::new(request),
        }
    }

    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self.rest.pixel(x, y);
    }

    #[inline]
    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2] {
        self.met = 0;
        let index = self.rest.path(sample).index();
        [self.film.at(index), self.lens.at(index)]
    }

    #[inline]
    fn bounce(&mut self) {
        self.met += 1;
        self.rest.bounce();
    }

    #[inline]
    fn lambert(&mut self, normal: Vector) -> Vector {
        about(normal, self.local())
    }

    #[inline]
    fn ball(&mut self) -> Vector {
        in_ball(self.local(), self.rest.at_surface().unit_f32())
    }

    #[inline]
    fn chance(&mut self, probability: f32) -> bool {
        self.rest.chance(probability)
    }
}

const LENGTH: u32 = 64;

/// The points of an aligned block of indices.
#[derive(Debug)]
struct Block<M: Map> {
    points: Points<SobolOwen, M>,
    number: u32,
    filled: [M::Point; LENGTH as usize],
}

impl<M: Map> Block<M> {
    fn new(domain: Domain, map: M, unfilled: M::Point) -> Self {
        let points = Points::new(SobolOwen::in_domain(domain), map);
        // No block of indices has this number.
        Self { points, number: u32::MAX, filled: [unfilled; LENGTH as usize] }
    }

    #[inline]
    fn at(&mut self, index: u32) -> M::Point {
        if self.number != index / LENGTH {
            self.fill(index / LENGTH);
        }
        self.filled[(index % LENGTH) as usize]
    }

    #[cold]
    fn fill(&mut self, number: u32) {
        self.number = number;
        // Points have all indices but the last.
        if let Ok(points) = self.points.range(LENGTH * number..) {
            points.fill(&mut self.filled);
        }
    }
}
