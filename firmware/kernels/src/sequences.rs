//! Every sequence: its coordinates into a buffer. And what a path draws, a number of one domain each.

use crate::{COUNT, Visitor};
use core::hint::black_box;
use hemidisc::catalogue::Parameters;
use hemidisc::sequence::Sequence;
use hemidisc::{Domain, Error, Sampler, Screen, sequence};

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

/// A function that draws for each pair of words, which is a domain or a pixel, under its path.
macro_rules! draws {
    ($visitor:ident: $($name:literal $point:ty, |$screen:ident, $pair:pat_param| $draw:expr;)*) => {$({
        #[unsafe(export_name = concat!("sequence/", $name))]
        #[inline(never)]
        fn fill($screen: &Screen, pairs: &[[u32; 2]], points: &mut [$point]) -> usize {
            let mut filled = 0;
            for (point, $pair) in points.iter_mut().zip(pairs.iter().copied()) {
                *point = $draw;
                filled += 1;
            }
            filled
        }
        if let Ok(screen) = Screen::new(Domain::new(black_box(7)), [64; 2], 16) {
            $visitor.points(
                concat!("sequence/", $name),
                |pairs, points: &mut [$point]| fill(&screen, pairs, points),
            );
        }
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
    draws! {
        visitor:
        "child-and-pair" [u32; 2], |_screen, pair| {
            Sampler::new(Domain::from_words(pair), 5).child(3).pair()
        };
        "screen-and-pair" [u32; 2], |screen, [x, y]| match screen.pixel(x & 63, y & 63) {
            Ok(pixel) => pixel.sampler(5).child(3).pair(),
            Err(_) => [0; 2],
        };
        "child-and-four" [u32; 4], |_screen, pair| {
            let [[u, v], [w, x]] = Sampler::new(Domain::from_words(pair), 5).child(3).joint();
            [u, v, w, x]
        };
    }
}
