//! Every sequence: its coordinates into a buffer.

use crate::{COUNT, Visitor};
use core::hint::black_box;
use hemidisc::Error;
use hemidisc::sequence::{
    Correlated, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Random, Regular, Sequence,
    Sobol, SobolOwen,
};

/// A function that fills by a sequence, under its path.
macro_rules! sequences {
    ($visitor:ident: $($name:literal $type:ty, $value:expr;)*) => {$({
        #[unsafe(export_name = concat!("sequence/", $name))]
        #[inline(never)]
        fn fill(sequence: &$type, points: &mut [[u32; 2]]) -> usize {
            sequence.fill_with(0, points, |point| point);
            points.len()
        }
        let sequence = black_box($value);
        $visitor.points(
            concat!("sequence/", $name),
            |_, points: &mut [[u32; 2]]| fill(&sequence, points),
        );
    })*};
}

fn all(visitor: &mut impl Visitor) -> Result<(), Error> {
    let (count, seed) = (COUNT as u32, black_box(7));
    let side = count.isqrt();
    sequences! {
        visitor:
        "regular" Regular, Regular::new(side, side)?;
        "random" Random, Random::new(seed);
        "jittered" Jittered, Jittered::new(side, side, seed)?;
        "nrooks" NRooks, NRooks::new(count, seed)?;
        "multi-jittered" MultiJittered, MultiJittered::new(side, side, seed)?;
        "correlated" Correlated, Correlated::new(side, side, seed)?;
        "hammersley" Hammersley, Hammersley::new(count)?;
        "halton" Halton, Halton::new();
        "sobol" Sobol, Sobol::new(seed);
        "sobol-owen" SobolOwen, SobolOwen::new(seed);
        "r2" R2, R2::new(seed);
    }
    Ok(())
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    // An error leaves sequences out, which the report detects.
    let _ = all(visitor);
}
