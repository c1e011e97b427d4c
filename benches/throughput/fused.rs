//! Sequence, map and buffer in one fill: every sequence through every map of fast f32, and Sobol
//! through every map of the other arithmetics.

use crate::buffers::Visitor;
use crate::maps::Through;
use benches::failure::Failure;
use benches::random::SEED;
use hemidisc::FastF32;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{self, ArithmeticVisitor, SequenceVisitor};
use hemidisc::sequence::{Sequence, Sobol};

pub(crate) fn every<'a>(points: usize, visitor: &mut impl Visitor<'a>) -> Result<(), Failure> {
    let mut fused = Fused { points, visitor, result: Ok(()) };
    catalogue::sequences(u32::try_from(points)?, SEED, &mut fused)?;
    catalogue::arithmetics(&mut fused);
    fused.result
}

struct Fused<'v, V> {
    points: usize,
    visitor: &'v mut V,
    result: Result<(), Failure>,
}

impl<'a, V: Visitor<'a>> Fused<'_, V> {
    fn through<S: Sequence + 'static, A: Arithmetic>(&mut self, name: &str, sequence: S) {
        if self.result.is_ok() {
            let prefix = format!("fused/{name}");
            let mut maps = Through::new(prefix, sequence, self.points, self.visitor);
            self.result = maps.maps::<A>();
        }
    }
}

impl<'a, V: Visitor<'a>> SequenceVisitor for Fused<'_, V> {
    fn visit<S: Sequence + 'static>(&mut self, name: &'static str, sequence: S) {
        self.through::<S, FastF32>(name, sequence);
    }
}

impl<'a, V: Visitor<'a>> ArithmeticVisitor for Fused<'_, V> {
    fn visit<A: Arithmetic>(&mut self) {
        if A::NAME != FastF32::NAME {
            self.through::<Sobol, A>("sobol", Sobol::new(SEED));
        }
    }
}
