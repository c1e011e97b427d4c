//! A component of a point as text: the shortest decimal that reads back exactly, or its raw bits.
//! Fixed point is its exact decimal value, or a signed decimal count of LSBs.

use std::any::Any;
use std::io::{self, Write};

/// A number that can be a field of a row.
trait Field {
    /// The shortest decimal that reads back exactly; the exact value where that is the custom.
    fn decimal(&self, out: &mut dyn Write) -> io::Result<()>;
    /// The bits, for a comparison without a parser of floats.
    fn raw(&self, out: &mut dyn Write) -> io::Result<()>;
}

impl Field for f32 {
    fn decimal(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{self:?}")
    }

    fn raw(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "0x{:08x}", self.to_bits())
    }
}

impl Field for f64 {
    fn decimal(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "{self:?}")
    }

    fn raw(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(out, "0x{:016x}", self.to_bits())
    }
}

macro_rules! fixed {
    ($($number:ident),*) => {$(
        impl Field for hemidisc::$number {
            fn decimal(&self, out: &mut dyn Write) -> io::Result<()> {
                write!(out, "{self}")
            }

            fn raw(&self, out: &mut dyn Write) -> io::Result<()> {
                write!(out, "{}", self.to_bits())
            }
        }
    )*};
}
fixed!(Q15, Q31);

/// Writes a number as a field.
pub(crate) type Writer<R> = fn(&R, &mut dyn Write) -> io::Result<()>;

/// The writer for an arithmetic's numbers, if its type has one.
///
/// The catalogue hands out arithmetics without a bound on their numbers, so the type is looked up
/// in the list of all fields; a new type is one line there.
pub(crate) fn writer<R: 'static>(raw: bool) -> Option<Writer<R>> {
    fn of<F: Field>(raw: bool) -> Writer<F> {
        if raw { F::raw } else { F::decimal }
    }
    let fields: &[&dyn Any] =
        &[&of::<f32>(raw), &of::<f64>(raw), &of::<hemidisc::Q15>(raw), &of::<hemidisc::Q31>(raw)];
    fields.iter().find_map(|writer| writer.downcast_ref()).copied()
}
