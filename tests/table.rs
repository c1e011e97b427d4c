//! Tables that the compiler computes are, byte for byte, what the iterator gives.

use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::Parameters;
use hemidisc::sequence::{self, Correlated, Hammersley, SobolOwen, Stored};
use hemidisc::{
    Concentric, Cosine, Domain, Error, FastF32, Map, Points, Polar, Power, Uniform, disc, table,
};

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

const LENGTH: usize = 12;
const SOBOL: sequence::Sobol = sequence::Sobol::new(9);

fn assert_same<M: Map, const N: usize>(table: [M::Point; N], map: M)
where
    M::Point: PartialEq + std::fmt::Debug,
{
    assert_eq!(Points::new(SOBOL, map).to_array(), Ok(table));
}

/// Lobes over either disc map, and an exponent that is checked.
macro_rules! hemispheres {
    ($arithmetic:ident, $exponent:expr) => {{
        type Real = <hemidisc::$arithmetic as Arithmetic>::Real;
        use hemidisc::$arithmetic;
        static UNIFORM: [[Real; 3]; LENGTH] = table!(Uniform<$arithmetic>, { SOBOL }, LENGTH);
        assert_same(UNIFORM, Uniform::<$arithmetic>::new());
        static COSINE: [[Real; 3]; LENGTH] = table!(Cosine<$arithmetic>, { SOBOL }, LENGTH);
        assert_same(COSINE, Cosine::<$arithmetic>::new());
        static OVER_POLAR: [[Real; 3]; LENGTH] =
        table!(Cosine<$arithmetic, Polar<$arithmetic>>, { SOBOL }, LENGTH);
        assert_same(OVER_POLAR, Cosine::over(Polar::<$arithmetic>::new()));
        static POWER: [[Real; 3]; LENGTH] =
            table!(Power::<$arithmetic>::const_new($exponent)?, { SOBOL }, LENGTH);
        let Ok(lobe) = Power::<$arithmetic>::new($exponent) else { panic!() };
        assert_same(POWER, lobe);
    }};
}

#[test]
fn hemispheres_have_tables() {
    hemispheres!(FastF32, 50.0);
    #[cfg(feature = "fixed-point")]
    {
        use hemidisc::arithmetic::FixedExponent;
        hemispheres!(Q31, FixedExponent::from_bits(50 << 32));
        hemispheres!(Q15, FixedExponent::from_bits(50 << 32));
        hemispheres!(Q15Div, FixedExponent::from_bits(50 << 32));
    }
}

/// In a function whose parameter is the length.
fn generic<const N: usize>() -> [[f32; 2]; N] {
    table!(Concentric<FastF32>, SobolOwen::in_domain(Domain::new(7).child(1)), N)
}

#[test]
fn any_constant_expression_is_a_sequence() {
    let set = SobolOwen::in_domain(Domain::new(7).child(1));
    let points = Points::new(set, Concentric::<FastF32>::new());
    assert_eq!(points.to_array(), Ok(generic::<7>()));

    type Lens = disc::Polar<FastF32>;
    static BY_PATH: [[f32; 2]; LENGTH] = table!(Lens, sequence::Sobol::new(9), LENGTH);
    assert_same(BY_PATH, Polar::<FastF32>::new());
    static FULL: [[f32; 2]; LENGTH] =
        table!(hemidisc::Polar<FastF32>, hemidisc::sequence::Sobol::new(9), LENGTH);
    assert_eq!(FULL, BY_PATH);
    static RECORDED: [[u32; 2]; 3] = [[1, 2], [3, 4], [5, 6]];
    static STORED: [[f32; 2]; 3] = table!(Concentric<FastF32>, Stored::new(&RECORDED)?, 3);
    assert_eq!(STORED, RECORDED.map(FastF32::concentric));
}

/// The compiler would stop at a lint after two million steps.
#[test]
fn a_large_table_builds() -> Result<(), Error> {
    static LARGE: [[f32; 2]; 4096] = table!(Concentric<FastF32>, Correlated::new(64, 64, 7)?, 4096);
    let points = Points::new(Correlated::new(64, 64, 7)?, Concentric::<FastF32>::new());
    assert!(points.iter().eq(LARGE));
    Ok(())
}

/// The names of the prelude may mean anything where the macro is called.
mod elsewhere {
    #![allow(dead_code, non_snake_case, non_camel_case_types, reason = "they are in the way")]

    struct Some;
    struct None;
    struct Err;
    struct Option;
    struct Result;
    struct u32;
    struct usize;
    mod core {}
    mod std {}
    pub struct Ok<T>(T);

    pub static LENS: [[f32; 2]; 8] =
        hemidisc::table!(Concentric<hemidisc::FastF32>, hemidisc::sequence::Hammersley::new(8)?, 8);
}

#[test]
fn what_is_in_scope_does_not_matter() {
    assert_eq!(elsewhere::LENS, table!(Concentric<FastF32>, Hammersley, 8));
}
