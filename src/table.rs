//! Tables of points that the compiler computes, for a `static` in flash.

/// An array of the first points of a sequence through a disc map, computed at compile time.
///
/// The map is `Concentric` or `Polar` over an arithmetic whose kernels are `const`:
/// [`FastF32`](crate::FastF32), and with the feature `fixed-point` `Q31`, `Q15` and `Q15Div`. The
/// sequence is a call of its constructor, with a `?` where that can fail. For a set of exactly so
/// many points, such as [`Hammersley`](crate::sequence::Hammersley), the name alone will do. What
/// the constructor refuses fails the build. The points are those of [`Points`](crate::Points), byte
/// for byte.
///
/// ```
/// use hemidisc::sequence::{Hammersley, MultiJittered, Sobol};
/// use hemidisc::{Concentric, FastF32, Points, table};
///
/// static LENS: [[f32; 2]; 64] = table!(Concentric<FastF32>, MultiJittered::new(8, 8, 7)?, 64);
/// static LIGHT: [[f32; 2]; 16] = table!(Concentric<FastF32>, Sobol::new(0), 16);
/// static PROBE: [[f32; 2]; 10] = table!(Concentric<FastF32>, Hammersley, 10);
///
/// let lens = Points::new(MultiJittered::new(8, 8, 7)?, Concentric::<FastF32>::new());
/// assert!(lens.iter().eq(LENS));
/// # Ok::<(), hemidisc::Error>(())
/// ```
///
/// ```compile_fail
/// use hemidisc::{FastF32, sequence::Jittered, table};
/// static EMPTY: [[f32; 2]; 64] = table!(Concentric<FastF32>, Jittered::new(0, 8, 7)?, 64);
/// ```
#[macro_export]
macro_rules! table {
    (Concentric<$arithmetic:ty>, $($set:tt)*) => {
        $crate::table!(@sequence $arithmetic, concentric, $($set)*)
    };
    (Polar<$arithmetic:ty>, $($set:tt)*) => {
        $crate::table!(@sequence $arithmetic, polar, $($set)*)
    };
    (@sequence $arithmetic:ty, $kernel:ident, $sequence:ident, $count:expr) => {
        $crate::table!(@sequence $arithmetic, $kernel, $sequence::new($count)?, $count)
    };
    (@sequence $arithmetic:ty, $kernel:ident,
        $sequence:ident::new($($argument:expr),* $(,)?)?, $count:expr) => {
        $crate::table!(@points $arithmetic, $kernel, match $sequence::new($($argument),*) {
            Ok(sequence) => sequence,
            Err(_) => ::core::panic!("the sequence refuses its parameters"),
        }, $count)
    };
    (@sequence $arithmetic:ty, $kernel:ident,
        $sequence:ident::new($($argument:expr),* $(,)?), $count:expr) => {
        $crate::table!(@points $arithmetic, $kernel, $sequence::new($($argument),*), $count)
    };
    (@points $arithmetic:ty, $kernel:ident, $sequence:expr, $count:expr) => {{
        // In a constant even where the table is not one.
        const TABLE: [[<$arithmetic as $crate::arithmetic::Arithmetic>::Real; 2]; $count] = {
            let sequence = $sequence;
            let mut points = [<$arithmetic>::$kernel([0, 0]); $count];
            let mut index = 0;
            while index < points.len() {
                points[index] = <$arithmetic>::$kernel(sequence.at(index as u32));
                index += 1;
            }
            points
        };
        TABLE
    }};
}
