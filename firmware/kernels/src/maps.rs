//! Every map of every arithmetic, from stored coordinates; and some from a sequence, about a frame
//! or into a buffer for each component.

use crate::{COUNT, Visitor};
use core::hint::black_box;
use hemidisc::arithmetic::{Arithmetic, FixedExponent};
use hemidisc::disc::{self, Rejection};
use hemidisc::frame::About;
use hemidisc::sequence::{Sobol, SobolOwen, Stored};
use hemidisc::{
    Concentric, Cosine, Error, FastF32, Frame, Map, Points, Power, Q15, Q31, UnitSquare, hemisphere,
};

type Slot<A> = <A as Arithmetic>::Real;

/// A function that fills by a map, under its path.
macro_rules! fill {
    ($visitor:ident, $path:expr, $map:ty, $point:ty, $value:expr) => {{
        #[unsafe(export_name = $path)]
        #[inline(never)]
        fn fill(map: &$map, coordinates: &[[u32; 2]], points: &mut [$point]) -> usize {
            let Ok(stored) = Stored::new(coordinates) else { return 0 };
            Points::new(stored, *map).fill(points)
        }
        let map = black_box($value);
        $visitor
            .points($path, |coordinates, points: &mut [$point]| fill(&map, coordinates, points));
    }};
}

/// The lobes without a parameter over every disc map, and those of a prepared exponent.
macro_rules! lobes {
    ($visitor:ident $name:literal $arithmetic:ident $exponent:expr,
        $($file:ident $type:ident $over:ident $lobe:literal $taken:tt;)*) => {
        $(lobes!(@ $taken $visitor $name $arithmetic $exponent, $over $lobe);)*
    };
    (@ () $visitor:ident $name:literal $arithmetic:ident $exponent:expr,
        $over:ident $lobe:literal) => {
        hemidisc::for_each_disc_map!(lobe $visitor $name $arithmetic $over $lobe)
    };
    (@ (exponent) $visitor:ident $name:literal $arithmetic:ident $exponent:expr,
        $over:ident $lobe:literal) => {
        hemidisc::for_each_disc_map!(power $visitor $name $arithmetic $exponent, $over $lobe)
    };
}

macro_rules! lobe {
    ($visitor:ident $name:literal $arithmetic:ident $over:ident $lobe:literal
        $($file:ident $map:ident $disc:literal;)*) => {$(
        fill!(
            $visitor, concat!("map/", $lobe, "/", $disc, "/", $name),
            hemisphere::$over<$arithmetic, disc::$map<$arithmetic>>, [Slot<$arithmetic>; 3],
            hemisphere::$over::over(disc::$map::new())
        );
    )*};
}

/// A function that prepares an exponent, and that exponent's maps.
macro_rules! power {
    ($visitor:ident $name:literal $arithmetic:ident $exponent:expr, $over:ident $lobe:literal
        $($file:ident $map:ident $disc:literal;)*) => {{
        #[unsafe(export_name = concat!("exponent/", $name))]
        #[inline(never)]
        fn prepare(
            exponent: <$arithmetic as Arithmetic>::Parameter,
        ) -> Option<($(hemisphere::$over<$arithmetic, disc::$map<$arithmetic>>,)*)> {
            Some(($(hemisphere::$over::over(exponent, disc::$map::new()).ok()?,)*))
        }
        if let Some(($($file,)*)) = prepare(black_box($exponent)) {
            $(fill!(
                $visitor, concat!("map/", $lobe, "/", $disc, "/", $name),
                hemisphere::$over<$arithmetic, disc::$map<$arithmetic>>, [Slot<$arithmetic>; 3],
                $file
            );)*
        }
    }};
}

macro_rules! discs {
    ($visitor:ident $name:literal $arithmetic:ident $($file:ident $map:ident $disc:literal;)*) => {$(
        fill!(
            $visitor, concat!("map/disc/", $disc, "/", $name), disc::$map<$arithmetic>,
            [Slot<$arithmetic>; 2], disc::$map::new()
        );
    )*};
}

/// Every map of an arithmetic.
macro_rules! maps {
    ($visitor:ident $name:literal $arithmetic:ident $exponent:expr) => {
        fill!(
            $visitor, concat!("map/square/-/", $name), UnitSquare<$arithmetic>,
            [Slot<$arithmetic>; 2], UnitSquare::new()
        );
        {
            #[unsafe(export_name = concat!("map/disc/rejection/", $name))]
            #[inline(never)]
            fn fill(coordinates: &[[u32; 2]], points: &mut [[Slot<$arithmetic>; 2]]) -> usize {
                let mut kept = Rejection::<$arithmetic, _>::new(coordinates.iter().copied());
                let mut filled = 0;
                for (slot, point) in points.iter_mut().zip(&mut kept) {
                    *slot = point;
                    filled += 1;
                }
                filled
            }
            $visitor.points(concat!("map/disc/rejection/", $name), fill);
        }
        hemidisc::for_each_disc_map!(discs $visitor $name $arithmetic);
        hemidisc::for_each_lobe!(lobes $visitor $name $arithmetic $exponent,);
    };
}

/// The arithmetics in the order of the report: integers, of which the narrowest come first, then
/// floats, of which those come first of which boards have the most effects.
macro_rules! arithmetics {
    ($visitor:ident $(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident, $bits:literal, $error:expr, $library:expr);
    )*) => {
        for place in [
            (16, "nothing"), (32, "nothing"), (32, "pictures"), (32, "fills"), (32, "digests"),
        ] {$(
            if place == ($bits, stringify!($boards)) {
                use hemidisc::$arithmetic;
                arithmetics!(@ $kind $visitor $name $arithmetic);
            }
        )*}
    };
    (@ fixed $visitor:ident $name:literal $arithmetic:ident) => {
        maps!($visitor $name $arithmetic FixedExponent::from(50));
    };
    (@ float $visitor:ident $name:literal $arithmetic:ident) => {
        maps!($visitor $name $arithmetic 50.0);
    };
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    hemidisc::for_each_arithmetic!(arithmetics visitor);
    converted(visitor);
}

/// Floats by integers: Q31's points, each component toward zero.
fn converted(visitor: &mut impl Visitor) {
    #[unsafe(export_name = "map/disc/concentric/q31-to-f32")]
    #[inline(never)]
    fn fill(map: &Concentric<Q31>, coordinates: &[[u32; 2]], points: &mut [[f32; 2]]) -> usize {
        let mut filled = 0;
        for (uv, point) in coordinates.iter().zip(points) {
            *point = map.sample(*uv).map(Q31::to_f32);
            filled += 1;
        }
        filled
    }
    let map = black_box(Concentric::new());
    visitor.points("map/disc/concentric/q31-to-f32", |coordinates, points: &mut [[f32; 2]]| {
        fill(&map, coordinates, points)
    });
}

macro_rules! fused {
    ($visitor:ident: $($sequence:literal $type:ty, $path:literal $map:ty, $point:ty, $value:expr;)*) => {$({
        #[unsafe(export_name = concat!("fused/", $sequence, "/", $path))]
        #[inline(never)]
        fn fill(sequence: $type, map: &$map, points: &mut [$point]) -> usize {
            Points::new(sequence, *map).fill(points)
        }
        let map = black_box($value);
        $visitor.points(
            concat!("fused/", $sequence, "/", $path),
            |_, points: &mut [$point]| fill(<$type>::new(black_box(7)), &map, points),
        );
    })*};
}

pub(crate) fn fused(visitor: &mut impl Visitor) {
    fused! {
        visitor:
        "sobol" Sobol, "disc/concentric/q15" Concentric<Q15>, [Q15; 2], Concentric::new();
        "sobol-owen" SobolOwen, "disc/concentric/q15" Concentric<Q15>, [Q15; 2], Concentric::new();
        "sobol" Sobol, "disc/concentric/fast-f32" Concentric<FastF32>, [f32; 2], Concentric::new();
    }
}

macro_rules! turned {
    ($visitor:ident: $($path:literal $map:ty, $value:expr;)*) => {$(
        fill!(
            $visitor, concat!("turned/", $path), About<$map, f32>,
            [f32; 3], $value.about(Frame::new([0.6, 0.0, 0.8])?)
        );
    )*};
}

/// Lobes about the third axis of a frame, from stored coordinates.
pub(crate) fn turned(visitor: &mut impl Visitor) -> Result<(), Error> {
    turned! {
        visitor:
        "power/concentric/fast-f32" Power<FastF32>, Power::<FastF32>::new(black_box(50.0))?;
        "cosine/concentric/fast-f32" Cosine<FastF32>, Cosine::<FastF32>::new();
    }
    Ok(())
}

macro_rules! components {
    ($visitor:ident: $($path:literal $map:ty, $component:ty, $value:expr;)*) => {$({
        #[unsafe(export_name = concat!("components/", $path))]
        #[inline(never)]
        fn fill(
            map: &$map, coordinates: &[[u32; 2]], x: &mut [$component], y: &mut [$component]
        ) -> usize {
            let Ok(stored) = Stored::new(coordinates) else { return 0 };
            Points::new(stored, *map).fill_components([x, y])
        }
        let map = black_box($value);
        $visitor.points(
            concat!("components/", $path),
            |coordinates, points: &mut [[$component; 2]]| {
                let (x, y) = points.as_flattened_mut().split_at_mut(COUNT);
                fill(&map, coordinates, x, y)
            },
        );
    })*};
}

/// Fills of a buffer for each component, from stored coordinates.
pub(crate) fn components(visitor: &mut impl Visitor) {
    components! {
        visitor:
        "disc/concentric/q15" Concentric<Q15>, Q15, Concentric::new();
        "disc/concentric/fast-f32" Concentric<FastF32>, f32, Concentric::new();
    }
}
