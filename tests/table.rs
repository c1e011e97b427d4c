//! Tables that the compiler computes are, byte for byte, what the iterator gives.

use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::Parameters;
use hemidisc::sequence::{self, Hammersley};
use hemidisc::{Error, FastF32, Points, disc, table};

const COUNT: usize = 35;

/// For a table of the sequence of a list's line, through every disc map.
///
/// `table!` takes calls of `new`, which for a seed is `in_domain` of the seed's domain.
macro_rules! same {
    ($arithmetic:ident $parameters:ident $sequence:ident total in_domain(domain)) => {
        let points = sequence::$sequence::in_domain($parameters.domain);
        hemidisc::for_each_disc_map! {
            through $arithmetic points [$sequence::new($parameters.seed)]
        }
    };
    ($arithmetic:ident $parameters:ident $sequence:ident total new($($part:ident),*)) => {
        let points = sequence::$sequence::new($($parameters.$part),*);
        hemidisc::for_each_disc_map! {
            through $arithmetic points [$sequence::new($($parameters.$part),*)]
        }
    };
    ($arithmetic:ident $parameters:ident $sequence:ident checked new($($part:ident),*)) => {
        let points = sequence::$sequence::new($($parameters.$part),*)?;
        hemidisc::for_each_disc_map! {
            through $arithmetic points [$sequence::new($($parameters.$part),*)?]
        }
    };
}

/// A sequence as a value, and as the macro takes it.
macro_rules! through {
    ($arithmetic:ident $points:ident $set:tt $($file:ident $map:ident $name:literal;)*) => {
        $(through!(@ $arithmetic $points $set $map);)*
    };
    (@ $arithmetic:ident $points:ident [$($set:tt)*] $map:ident) => {{
        static TABLE: [[<hemidisc::$arithmetic as Arithmetic>::Real; 2]; COUNT] =
            table!($map<hemidisc::$arithmetic>, $($set)*, COUNT);
        let points = Points::new($points, disc::$map::<hemidisc::$arithmetic>::new());
        let what = stringify!($map $arithmetic $($set)*);
        assert_eq!(points.to_array(), Ok(TABLE), "{what}");
    }};
}

/// Every sequence through the maps of an arithmetic.
macro_rules! every_sequence {
    ($arithmetic:ident $parameters:ident
        $($file:ident $sequence:ident $name:literal $kind:ident $new:ident $parts:tt;)*) => {
        $({
            use sequence::$sequence;
            same!($arithmetic $parameters $sequence $kind $new $parts);
        })*
    };
}

/// A test of each arithmetic whose kernels are `const`.
macro_rules! tables {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $($facts:tt)*);)*) => {
        $(tables! { $form #[$cfg] $file $arithmetic })*
    };
    (const #[$cfg:meta] $file:ident $arithmetic:ident) => {
        #[$cfg]
        #[test]
        fn $file() -> Result<(), Error> {
            const UNSEEDED: Parameters = Parameters::new(COUNT as u32, 0);
            const SEEDED: Parameters = Parameters::new(COUNT as u32, 3);
            hemidisc::for_each_sequence!(every_sequence $arithmetic UNSEEDED);
            hemidisc::for_each_sequence!(every_sequence $arithmetic SEEDED);
            Ok(())
        }
    };
    (runtime #[$cfg:meta] $file:ident $arithmetic:ident) => {};
}
hemidisc::for_each_arithmetic!(tables);

#[test]
fn a_set_of_so_many_points_goes_by_its_name() {
    static BY_NAME: [[f32; 2]; 10] = table!(Concentric<FastF32>, Hammersley, 10);
    static IN_FULL: [[f32; 2]; 10] = table!(Concentric<FastF32>, Hammersley::new(10)?, 10);
    assert_eq!(BY_NAME, IN_FULL);
}
