//! A component of a point as little-endian bytes: a float as its bits, fixed point as an integer of
//! LSBs.

use std::any::Any;

/// A number that can be a component.
trait Number {
    /// As the types of arrays are called elsewhere.
    const NAME: &str;

    fn put(&self, bytes: &mut Vec<u8>);
}

macro_rules! numbers {
    ($($type:ty, $name:literal, $bits:expr;)*) => {$(
        impl Number for $type {
            const NAME: &str = $name;

            fn put(&self, bytes: &mut Vec<u8>) {
                let bits = $bits(*self);
                bytes.extend_from_slice(&bits.to_le_bytes());
            }
        }
    )*};
}
numbers! {
    f32, "f32", f32::to_bits;
    f64, "f64", f64::to_bits;
}
numbers! {
    hemidisc::Q31, "i32", hemidisc::Q31::to_bits;
    hemidisc::Q15, "i16", hemidisc::Q15::to_bits;
}

/// The name of a type of numbers, and what appends the bytes of one.
pub(crate) type Encoding<R> = (&'static str, fn(&R, &mut Vec<u8>));

/// The encoding of an arithmetic's numbers, if they have one.
///
/// The catalogue hands out arithmetics without a bound on their numbers, so the type is looked up
/// in the list of all; a new type is one line there.
pub(crate) fn encoding<R: 'static>() -> Option<Encoding<R>> {
    fn of<N: Number>() -> Encoding<N> {
        (N::NAME, N::put)
    }
    let encodings: &[&dyn Any] =
        &[&of::<f32>(), &of::<f64>(), &of::<hemidisc::Q31>(), &of::<hemidisc::Q15>()];
    encodings.iter().find_map(|encoding| encoding.downcast_ref()).copied()
}
