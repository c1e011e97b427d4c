//! The families' lists: every sequence, map and arithmetic by name.
//!
//! Tests, benches, digests and command lines are driven by these lists, so that a new member is one
//! file and one line here. A member has a type of its own, so a list is walked by a visitor.
//!
//! ```
//! use hemidisc::catalogue::{SequenceVisitor, sequences};
//! use hemidisc::sequence::Sequence;
//!
//! struct FirstPoints;
//! impl SequenceVisitor for FirstPoints {
//!     fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
//!         println!("{name}: {:x?}", sequence.at(0));
//!     }
//! }
//! sequences(64, 0, &mut FirstPoints)?;
//! # Ok::<(), hemidisc::Error>(())
//! ```

use crate::arithmetic::Arithmetic;
use crate::error::Error;
use crate::map::{Concentric, Cosine, Invert, Polar, Power, Uniform};
use crate::sequence::{
    Correlated, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Random, Regular, Sequence,
    Sobol, SobolOwen,
};

/// Sees every sequence in turn.
pub trait SequenceVisitor {
    /// Called once for each sequence.
    fn visit<S: Sequence + 'static>(&mut self, name: &'static str, sequence: S);
}

/// Sees every one-to-one map of an arithmetic in turn.
pub trait MapVisitor<A: Arithmetic> {
    /// Called once for each map onto the disc.
    fn disc<M: Invert<Point = [A::Real; 2]> + 'static>(&mut self, name: &'static str, map: M);
    /// Called once for each map onto the hemisphere: its lobe, and the disc map below it.
    fn hemisphere<M: Invert<Point = [A::Real; 3]> + 'static>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    );
}

/// Sees every arithmetic in turn.
pub trait ArithmeticVisitor {
    /// Called once for each arithmetic whose feature is on.
    fn visit<A: Arithmetic>(&mut self);
}

/// Columns and rows of the grid that holds `count` points: floor(sqrt count) columns.
#[must_use]
pub const fn grid(count: u32) -> [u32; 2] {
    let columns = count.isqrt();
    [columns, if columns == 0 { 0 } else { count.div_ceil(columns) }]
}

/// The names of all sequences, in the order in which they are visited.
pub const SEQUENCES: &[&str] = &[
    "regular",
    "random",
    "jittered",
    "nrooks",
    "multi-jittered",
    "correlated",
    "hammersley",
    "halton",
    "sobol",
    "sobol-owen",
    "r2",
];

/// Visits every sequence: the sets with `count` points (grids of [`grid`]`(count)`), the endless
/// ones as they are.
///
/// # Errors
/// [`Error::EmptyGrid`] for a `count` of 0.
pub fn sequences(count: u32, seed: u32, visitor: &mut impl SequenceVisitor) -> Result<(), Error> {
    let [columns, rows] = grid(count);
    visitor.visit("regular", Regular::new(columns, rows)?);
    visitor.visit("random", Random::new(seed));
    visitor.visit("jittered", Jittered::new(columns, rows, seed)?);
    visitor.visit("nrooks", NRooks::new(count, seed)?);
    visitor.visit("multi-jittered", MultiJittered::new(columns, rows, seed)?);
    visitor.visit("correlated", Correlated::new(columns, rows, seed)?);
    visitor.visit("hammersley", Hammersley::new(count)?);
    visitor.visit("halton", Halton::new());
    visitor.visit("sobol", Sobol::new(seed));
    visitor.visit("sobol-owen", SobolOwen::new(seed));
    visitor.visit("r2", R2::new(seed));
    Ok(())
}

/// Visits every map without a parameter.
pub fn maps<A: Arithmetic>(visitor: &mut impl MapVisitor<A>) {
    visitor.disc("polar", Polar::<A>::new());
    visitor.disc("concentric", Concentric::<A>::new());
    visitor.hemisphere("uniform", "polar", Uniform::over(Polar::<A>::new()));
    visitor.hemisphere("uniform", "concentric", Uniform::<A>::new());
    visitor.hemisphere("cosine", "polar", Cosine::over(Polar::<A>::new()));
    visitor.hemisphere("cosine", "concentric", Cosine::<A>::new());
}

/// Visits the cosine-power lobe of one exponent over every disc map.
///
/// # Errors
/// [`Error::Exponent`] for a value that is not a finite number above -1.
pub fn power_maps<A: Arithmetic>(
    exponent: A::Parameter,
    visitor: &mut impl MapVisitor<A>,
) -> Result<(), Error> {
    visitor.hemisphere("power", "polar", Power::over(exponent, Polar::<A>::new())?);
    visitor.hemisphere("power", "concentric", Power::<A>::new(exponent)?);
    Ok(())
}

/// The names of all arithmetics that a build with every feature has, in the order of visits.
pub const ARITHMETICS: &[&str] =
    &["libm-f64", "libm-f32", "fast-f32", "micromath-f32", "q31", "q15", "q15-div"];

/// The names of the arithmetics that this build has, in the order of visits.
pub const AVAILABLE_ARITHMETICS: &[&str] = &[
    #[cfg(feature = "libm")]
    "libm-f64",
    #[cfg(feature = "libm")]
    "libm-f32",
    "fast-f32",
    #[cfg(feature = "micromath")]
    "micromath-f32",
    #[cfg(feature = "fixed-point")]
    "q31",
    #[cfg(feature = "fixed-point")]
    "q15",
    #[cfg(feature = "fixed-point")]
    "q15-div",
];

/// Visits every arithmetic whose feature is on.
pub fn arithmetics(visitor: &mut impl ArithmeticVisitor) {
    #[cfg(feature = "libm")]
    {
        visitor.visit::<crate::LibmF64>();
        visitor.visit::<crate::LibmF32>();
    }
    visitor.visit::<crate::FastF32>();
    #[cfg(feature = "micromath")]
    visitor.visit::<crate::MicromathF32>();
    #[cfg(feature = "fixed-point")]
    {
        visitor.visit::<crate::Q31>();
        visitor.visit::<crate::Q15>();
        visitor.visit::<crate::Q15Div>();
    }
}
