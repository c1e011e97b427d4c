//! Tables of points that the compiler computes, for a `static` in flash.

use crate::disc::{Concentric, Polar};
use crate::hemisphere::{CosineLobe, Hemisphere, PowerLobe, UniformLobe};

/// An array of the first points of a sequence through a map, computed at compile time.
///
/// The points are those of [`Points`](crate::Points), byte for byte.
///
/// - The **map** is a type, such as `Concentric<Q15>` or `Cosine<FastF32, Polar<FastF32>>`, or a
///   power lobe, `Power::<FastF32>::const_new(50.0)?`, or a constant of a map in braces. Its
///   arithmetic has kernels that are `const`: [`FastF32`](crate::FastF32), and with the feature
///   `fixed-point` `Q31`, `Q15` and `Q15Div`.
/// - The **sequence** is a call of its constructor, with a `?` where that can fail, or any other
///   constant expression. For a set of exactly so many points, such as
///   [`Hammersley`](crate::sequence::Hammersley), the name alone will do. A sequence of your own has
///   `const fn at(self, u32) -> [u32; 2]` and `const fn size(&self) -> Option<u32>`.
/// - The **length** is a `usize`: a number, a constant or a parameter of a function.
///
/// # Errors
/// The build fails if a constructor refuses its parameters, and if the set has fewer points than
/// the table.
///
/// # Cost
/// The compiler takes 0.1 to 2 ms a point: 1 s for 4,096 points of Hammersley's set and 9 s of
/// `Correlated`, on one core of a desktop. The macro allows the lint `long_running_const_eval`, at
/// which the compiler would stop.
///
/// ```
/// use hemidisc::sequence::{Hammersley, MultiJittered, Sobol};
/// use hemidisc::{Concentric, Cosine, FastF32, Points, table};
///
/// static LENS: [[f32; 2]; 64] = table!(Concentric<FastF32>, MultiJittered::new(8, 8, 7)?, 64);
/// static SKY: [[f32; 3]; 16] = table!(Cosine<FastF32>, Sobol::new(0), 16);
/// static PROBE: [[f32; 2]; 10] = table!(Concentric<FastF32>, Hammersley, 10);
///
/// let lens = Points::new(MultiJittered::new(8, 8, 7)?, Concentric::<FastF32>::new());
/// assert!(lens.iter().eq(LENS));
/// # Ok::<(), hemidisc::Error>(())
/// ```
///
/// ```compile_fail
/// # // The grid is empty.
/// use hemidisc::{Concentric, FastF32, sequence::Jittered, table};
/// static EMPTY: [[f32; 2]; 64] = table!(Concentric<FastF32>, Jittered::new(0, 8, 7)?, 64);
/// ```
///
/// ```compile_fail
/// # // The set has 16 points.
/// use hemidisc::{Concentric, FastF32, sequence::MultiJittered, table};
/// static LONG: [[f32; 2]; 64] = table!(Concentric<FastF32>, MultiJittered::new(4, 4, 7)?, 64);
/// ```
#[macro_export]
macro_rules! table {
    // The crate's maps go by their names.
    (Concentric<$arithmetic:ty>, $($set:tt)*) => {
        $crate::table!(@sequence <$crate::Concentric<$arithmetic>>::VALUE, $($set)*)
    };
    (Polar<$arithmetic:ty>, $($set:tt)*) => {
        $crate::table!(@sequence <$crate::Polar<$arithmetic>>::VALUE, $($set)*)
    };
    (Uniform<$arithmetic:ty>, $($set:tt)*) => {
        $crate::table!(@sequence <$crate::Uniform<$arithmetic>>::VALUE, $($set)*)
    };
    (Cosine<$arithmetic:ty>, $($set:tt)*) => {
        $crate::table!(@sequence <$crate::Cosine<$arithmetic>>::VALUE, $($set)*)
    };
    ({ $map:expr }, $($set:tt)*) => {
        $crate::table!(@sequence $map, $($set)*)
    };
    ($($path:ident)::+ ::<$($parameter:ty),+>::$new:ident($($argument:expr),* $(,)?)?, $($set:tt)*) => {
        $crate::table!(@sequence
            $crate::table!(@accepted $($path)::+::<$($parameter),+>::$new($($argument),*), "map"),
            $($set)*)
    };
    (@sequence $map:expr, $sequence:ident, $count:expr) => {
        $crate::table!(@sequence $map, $sequence::new($count as ::core::primitive::u32)?, $count)
    };
    (@sequence $map:expr, $($path:ident)::+ ($($argument:expr),* $(,)?)?, $count:expr) => {
        $crate::table!(@points $map,
            $crate::table!(@accepted $($path)::+($($argument),*), "sequence"), $count)
    };
    (@sequence $map:expr, $sequence:expr, $count:expr) => {
        $crate::table!(@points $map, $sequence, $count)
    };
    (@accepted $made:expr, $what:literal) => {
        match $made {
            ::core::result::Result::Ok(made) => made,
            ::core::result::Result::Err(_) => {
                ::core::panic!(::core::concat!("the ", $what, " refuses its parameters"))
            }
        }
    };
    (@points $map:expr, $sequence:expr, $count:expr) => {{
        // In a constant even where the table is not one.
        #[allow(long_running_const_eval, reason = "a table takes a known time")]
        let table = const {
            let (map, sequence) = ($map, $sequence);
            if let ::core::option::Option::Some(size) = sequence.size() {
                ::core::assert!($count <= size as ::core::primitive::usize,
                    "the set has fewer points than the table");
            }
            let mut points = [map.const_sample([0, 0]); $count];
            let mut index = 0;
            while index < points.len() {
                points[index] = map.const_sample(sequence.at(index as ::core::primitive::u32));
                index += 1;
            }
            points
        };
        table
    }};
    ($map:ty, $($set:tt)*) => {
        $crate::table!(@sequence <$map>::VALUE, $($set)*)
    };
}

/// The maps of an arithmetic whose kernels are `const`, in constants.
macro_rules! const_maps {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $($facts:tt)*);)*) => {
        $(const_maps! { $form $kind #[$cfg] $arithmetic })*
    };
    (const float #[$cfg:meta] $arithmetic:ident) => {
        crate::target::where_floats_round! { const_maps! { const fixed #[$cfg] $arithmetic } }
    };
    (const fixed #[$cfg:meta] $arithmetic:ident) => {
        #[$cfg]
        const _: () = {
            use crate::arithmetic::$arithmetic;
            type Real = <$arithmetic as crate::arithmetic::Arithmetic>::Real;
            const_maps!($arithmetic, Concentric, concentric, disc_concentric);
            const_maps!($arithmetic, Polar, polar, disc_polar);
        };
    };
    (runtime $kind:ident #[$cfg:meta] $arithmetic:ident) => {};
    ($arithmetic:ident, $disc:ident, $point:ident, $kernel:ident) => {
        impl $disc<$arithmetic> {
            /// The map, for [`table!`](crate::table).
            #[doc(hidden)]
            pub const VALUE: Self = Self::new();

            /// [`sample`](crate::Map::sample) for [`table!`](crate::table).
            #[doc(hidden)]
            #[must_use]
            pub const fn const_sample(&self, uv: [u32; 2]) -> [Real; 2] {
                <$arithmetic>::$point(uv)
            }
        }

        const_maps!($arithmetic, $disc, $kernel, UniformLobe over lift_uniform);
        const_maps!($arithmetic, $disc, $kernel, CosineLobe over lift_cosine);

        impl Hemisphere<PowerLobe<$arithmetic>, $disc<$arithmetic>> {
            /// [`sample`](crate::Map::sample) for [`table!`](crate::table).
            #[doc(hidden)]
            #[must_use]
            pub const fn const_sample(&self, uv: [u32; 2]) -> [Real; 3] {
                <$arithmetic>::lift_power(self.lobe().prepared(), <$arithmetic>::$kernel(uv))
            }
        }
    };
    ($arithmetic:ident, $disc:ident, $kernel:ident, $lobe:ident over $lift:ident) => {
        impl Hemisphere<$lobe<$arithmetic>, $disc<$arithmetic>> {
            /// The map, for [`table!`](crate::table).
            #[doc(hidden)]
            pub const VALUE: Self = Self::over($disc::new());

            /// [`sample`](crate::Map::sample) for [`table!`](crate::table).
            #[doc(hidden)]
            #[must_use]
            pub const fn const_sample(&self, uv: [u32; 2]) -> [Real; 3] {
                <$arithmetic>::$lift(<$arithmetic>::$kernel(uv))
            }
        }
    };
}
for_each_arithmetic!(const_maps);
