//! Every sequence: its coordinates into a buffer.

use crate::{COUNT, Visitor};
use core::hint::black_box;
use hemidisc::catalogue::Parameters;
use hemidisc::sequence::Sequence;
use hemidisc::{Error, sequence};

/// A function that fills by each sequence, under its path.
macro_rules! sequences {
    ($visitor:ident $parameters:ident
        $($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*
    ) => {$({
        #[unsafe(export_name = concat!("sequence/", $name))]
        #[inline(never)]
        fn fill(sequence: &sequence::$sequence, points: &mut [[u32; 2]]) -> usize {
            sequence.fill_with(0, points, |point| point);
            points.len()
        }
        let made = sequence::$sequence::$new($($parameters.$part),*);
        let sequence = black_box(hemidisc::made_by!($kind made));
        $visitor.points(
            concat!("sequence/", $name),
            |_, points: &mut [[u32; 2]]| fill(&sequence, points),
        );
    })*};
}

fn all(visitor: &mut impl Visitor) -> Result<(), Error> {
    let parameters = Parameters::new(COUNT as u32, black_box(7));
    hemidisc::for_each_sequence!(sequences visitor parameters);
    Ok(())
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    // An error leaves sequences out, which the report detects.
    let _ = all(visitor);
}
