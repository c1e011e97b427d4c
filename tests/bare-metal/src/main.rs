//! Every sequence, every map of every fixed-point arithmetic, with density and inverse, in one image: no symbol of
//! a software float and no path to a panic may be in it. It is linked and looked through, never run.
#![no_std]
#![no_main]

use core::hint::black_box;
use hemidisc::arithmetic::{Arithmetic, FixedExponent};
use hemidisc::catalogue::{MapVisitor, SequenceVisitor, maps, power_maps, sequences};
use hemidisc::disc::Rejection;
use hemidisc::sequence::{Sequence, Shuffled, Sobol};
use hemidisc::{Domain, Map, Points, Q15, Q15Div, Q31, UnitSquare};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

struct Use;

impl SequenceVisitor for Use {
    fn visit<S: Sequence + 'static>(&mut self, _: &'static str, sequence: S) {
        let points = Points::new(sequence, UnitSquare::<Q15>::new());
        let mut buffer = [[Q15::ZERO; 2]; 16];
        black_box(points.fill(&mut buffer));
        black_box(&buffer);
    }
}

fn all<M: Map>(map: M) {
    let points = Points::new(Sobol::new(black_box(0)), map);
    let mut buffer = [M::Point::default(); 16];
    black_box(points.fill(&mut buffer));
    black_box(&buffer);
    for point in buffer {
        black_box(&map.density(point));
        black_box(map.invert(point));
    }
    black_box(&map.sample_with_density(black_box([1, 2])));
}

impl<A: Arithmetic> MapVisitor<A> for Use {
    fn disc<M: Map<Arithmetic = A, Point = [A::Real; 2]>>(&mut self, _: &'static str, map: M) {
        all(map);
    }

    fn hemisphere<M: Map<Arithmetic = A, Point = [A::Real; 3]>>(
        &mut self,
        _: &'static str,
        _: &'static str,
        map: M,
    ) {
        all(map);
    }
}

fn arithmetic<A: Arithmetic<Parameter = FixedExponent>>() {
    all(UnitSquare::<A>::new());
    maps::<A>(&mut Use);
    let e = FixedExponent::from_bits(black_box(10 << 32));
    black_box(power_maps::<A>(e, &mut Use).is_ok());
    let candidates = Shuffled::new(Sobol::new(1), Domain::new(black_box(2)));
    for point in Rejection::<A, _>::of_draws(candidates.iter(0), 16) {
        black_box(&point);
    }
}

#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    black_box(sequences(black_box(64), black_box(7), &mut Use).is_ok());
    arithmetic::<Q31>();
    arithmetic::<Q15>();
    arithmetic::<Q15Div>();
    loop {}
}
