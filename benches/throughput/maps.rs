//! Every map of every arithmetic, from stored coordinates.

use crate::buffers::{Coordinates, Visitor, candidates, filler};
use benches::EXPONENT;
use benches::failure::Failure;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{self, ArithmeticVisitor, MapVisitor};
use hemidisc::disc::Rejection;
use hemidisc::sequence::{Sequence, Stored};
use hemidisc::{Invert, Map, UnitSquare};
use std::hint::black_box;

pub(crate) fn every<'a>(
    coordinates: &'a Coordinates,
    points: usize,
    visitor: &mut impl Visitor<'a>,
) -> Result<(), Failure> {
    let mut maps = Maps { coordinates, points, visitor, result: Ok(()) };
    catalogue::arithmetics(&mut maps);
    maps.result
}

struct Maps<'a, 'v, V> {
    coordinates: &'a Coordinates,
    points: usize,
    visitor: &'v mut V,
    result: Result<(), Failure>,
}

impl<'a, V: Visitor<'a>> Maps<'a, '_, V> {
    fn of<A: Arithmetic>(&mut self) -> Result<(), Failure> {
        let stored = Stored::new(self.coordinates.windows(self.points))?;
        self.rejection::<A>();
        Through::new("map".into(), stored, self.points, self.visitor).maps::<A>()
    }

    /// The map that `Points` cannot be, for it keeps only some of the coordinates.
    fn rejection<A: Arithmetic>(&mut self) {
        self.visitor.fill(&format!("map/disc/rejection/{}", A::NAME), || {
            let candidates = candidates(self.points);
            let mut windows = self.coordinates.windows(candidates).chunks_exact(candidates).cycle();
            let mut buffer = vec![<[A::Real; 2]>::default(); self.points];
            move || {
                if let Some(candidates) = windows.next() {
                    reject::<A>(black_box(candidates), black_box(&mut buffer));
                }
            }
        });
    }
}

#[inline(never)]
fn reject<A: Arithmetic>(candidates: &[[u32; 2]], buffer: &mut [[A::Real; 2]]) {
    let kept = Rejection::<A, _>::new(candidates.iter().copied());
    for (slot, point) in buffer.iter_mut().zip(kept) {
        *slot = point;
    }
}

impl<'a, V: Visitor<'a>> ArithmeticVisitor for Maps<'a, '_, V> {
    fn visit<A: Arithmetic>(&mut self) {
        if self.result.is_ok() {
            self.result = self.of::<A>();
        }
    }
}

/// One sequence through the maps.
pub(crate) struct Through<'v, S, V> {
    /// What stands before MAP/DISC/ARITHMETIC in a path.
    prefix: String,
    sequence: S,
    points: usize,
    visitor: &'v mut V,
}

impl<'a, 'v, S: Sequence + 'a, V: Visitor<'a>> Through<'v, S, V> {
    pub(crate) fn new(prefix: String, sequence: S, points: usize, visitor: &'v mut V) -> Self {
        Self { prefix, sequence, points, visitor }
    }

    /// Every one-to-one map of an arithmetic.
    pub(crate) fn maps<A: Arithmetic>(&mut self) -> Result<(), Failure> {
        self.map::<A, _>("square", "-", UnitSquare::<A>::new());
        catalogue::maps::<A>(self);
        let exponent = EXPONENT.to_string().parse::<A::Parameter>();
        catalogue::power_maps::<A>(exponent.map_err(|error| error.to_string())?, self)?;
        Ok(())
    }

    fn map<A: Arithmetic, M: Map<Point: 'static> + 'static>(
        &mut self,
        name: &str,
        disc: &str,
        map: M,
    ) {
        let path = format!("{}/{name}/{disc}/{}", self.prefix, A::NAME);
        self.visitor.fill(&path, || filler(self.sequence, map, self.points));
    }
}

impl<'a, A: Arithmetic, S: Sequence + 'a, V: Visitor<'a>> MapVisitor<A> for Through<'_, S, V> {
    fn disc<M: Invert<Point = [A::Real; 2]> + 'static>(&mut self, name: &'static str, map: M) {
        self.map::<A, _>("disc", name, map);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]> + 'static>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.map::<A, _>(name, disc, map);
    }
}
