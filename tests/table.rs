//! Tables that the compiler computes are, byte for byte, what the iterator gives.

use hemidisc::arithmetic::Arithmetic;
use hemidisc::sequence::{
    Correlated, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Random, Regular, Sobol,
    SobolOwen,
};
use hemidisc::{Concentric, FastF32, Points, Polar, table};

const COUNT: usize = 35;

/// One set as the macro takes it, and as a value.
macro_rules! same {
    ($arithmetic:ty, [$($set:tt)*], $sequence:expr) => {
        static CONCENTRIC: [[<$arithmetic as Arithmetic>::Real; 2]; COUNT] =
            table!(Concentric<$arithmetic>, $($set)*, COUNT);
        static POLAR: [[<$arithmetic as Arithmetic>::Real; 2]; COUNT] =
            table!(Polar<$arithmetic>, $($set)*, COUNT);
        let points = Points::new($sequence, Concentric::<$arithmetic>::new());
        assert_eq!(points.to_array(), Ok(CONCENTRIC), stringify!($arithmetic $($set)*));
        let points = Points::new($sequence, Polar::<$arithmetic>::new());
        assert_eq!(points.to_array(), Ok(POLAR), stringify!($arithmetic $($set)*));
    };
}

/// Every sequence through both maps of one arithmetic.
macro_rules! every_sequence {
    ($test:ident, $arithmetic:ty) => {
        #[test]
        fn $test() {
            {
                same!($arithmetic, [Regular::new(5, 7)?], Regular::new(5, 7).unwrap());
            }
            {
                same!($arithmetic, [Random::new(3)], Random::new(3));
            }
            {
                same!($arithmetic, [Jittered::new(5, 7, 3)?], Jittered::new(5, 7, 3).unwrap());
            }
            {
                same!($arithmetic, [NRooks::new(35, 3)?], NRooks::new(35, 3).unwrap());
            }
            {
                same!(
                    $arithmetic,
                    [MultiJittered::new(5, 7, 3)?],
                    MultiJittered::new(5, 7, 3).unwrap()
                );
            }
            {
                same!($arithmetic, [Correlated::new(5, 7, 3)?], Correlated::new(5, 7, 3).unwrap());
            }
            {
                same!($arithmetic, [Hammersley::new(35)?], Hammersley::new(35).unwrap());
            }
            {
                same!($arithmetic, [Halton::new()], Halton::new());
            }
            {
                same!($arithmetic, [Sobol::new(0)], Sobol::new(0));
            }
            {
                same!($arithmetic, [SobolOwen::new(3)], SobolOwen::new(3));
            }
            {
                same!($arithmetic, [R2::new(3)], R2::new(3));
            }
        }
    };
}
every_sequence!(fast_f32, FastF32);
#[cfg(feature = "fixed-point")]
every_sequence!(q31, hemidisc::Q31);
#[cfg(feature = "fixed-point")]
every_sequence!(q15, hemidisc::Q15);
#[cfg(feature = "fixed-point")]
every_sequence!(q15_div, hemidisc::Q15Div);

#[test]
fn a_set_of_so_many_points_goes_by_its_name() {
    static BY_NAME: [[f32; 2]; 10] = table!(Concentric<FastF32>, Hammersley, 10);
    static IN_FULL: [[f32; 2]; 10] = table!(Concentric<FastF32>, Hammersley::new(10)?, 10);
    assert_eq!(BY_NAME, IN_FULL);
}
