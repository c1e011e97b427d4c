//! The samples of `one_by_one`, bit for bit, filled 64 at a time.

use super::sampler::{FILM, LENS, OneByOne, in_ball, turned};
use super::{Request, SURFACE, Source, screen};
use crate::vector::Vector;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Map, Points, UnitSquare};

const BLOCK: usize = 64;
const AHEAD: usize = 3;

/// The points of an aligned block of indices.
#[derive(Debug)]
struct Block<M: Map> {
    points: Points<SobolOwen, M>,
    number: u32,
    filled: [M::Point; BLOCK],
}

impl<M: Map> Block<M> {
    fn new(domain: Domain, map: M, zero: M::Point) -> Self {
        let points = Points::new(SobolOwen::in_domain(domain), map);
        // None has this number.
        Self { points, number: u32::MAX, filled: [zero; BLOCK] }
    }

    #[inline]
    fn at(&mut self, index: u32) -> M::Point {
        let number = index / BLOCK as u32;
        if number != self.number {
            self.fill(number);
        }
        self.filled[index as usize % BLOCK]
    }

    #[cold]
    #[inline(never)]
    fn fill(&mut self, number: u32) {
        self.number = number;
        let first = number * BLOCK as u32;
        if let Ok(points) = self.points.range(first..) {
            points.fill(&mut self.filled);
        }
    }
}

#[derive(Debug)]
pub(crate) struct Blocks {
    one: OneByOne,
    film: Block<UnitSquare<FastF32>>,
    lens: Block<Concentric<FastF32>>,
    lobes: [Block<Cosine<FastF32>>; AHEAD],
    depth: usize,
}

impl Source for Blocks {
    fn new(request: &Request) -> Self {
        let domain = screen(request).domain();
        let mut surface = domain;
        Self {
            one: OneByOne::new(request),
            film: Block::new(domain.child(FILM), UnitSquare::new(), [0.0; 2]),
            lens: Block::new(domain.child(LENS), Concentric::new(), [0.0; 2]),
            lobes: core::array::from_fn(|_| {
                surface = surface.child(SURFACE);
                Block::new(surface, Cosine::new(), [0.0; 3])
            }),
            depth: 0,
        }
    }

    #[inline]
    fn pixel(&mut self, x: u32, y: u32) {
        self.one.pixel(x, y);
    }

    #[inline]
    fn begin(&mut self, sample: u32) -> [[f32; 2]; 2] {
        self.one.path = self.one.pixel.sampler(sample);
        self.depth = 0;
        let index = self.one.path.index();
        [self.film.at(index), self.lens.at(index)]
    }

    #[inline]
    fn bounce(&mut self) {
        self.one.bounce();
        self.depth += 1;
    }

    #[inline]
    fn lambert(&mut self, normal: Vector) -> Vector {
        turned(self.local(), normal)
    }

    #[inline]
    fn ball(&mut self) -> Vector {
        in_ball(self.local(), self.one.path.unit_f32())
    }

    #[inline]
    fn chance(&mut self, probability: f32) -> bool {
        self.one.chance(probability)
    }
}

impl Blocks {
    #[inline]
    fn local(&mut self) -> Vector {
        let path = self.one.path;
        match self.lobes.get_mut(self.depth - 1) {
            Some(lobe) => lobe.at(path.index()),
            None => path.sample(&Cosine::<FastF32>::new()),
        }
    }
}
