//! The families' lists: every sequence, map and arithmetic by name.
//!
//! Tests, benches, digests and command lines walk these lists. A member has a type of its own, so a
//! list is walked by a visitor. `lists.rs` has a line for each member.
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
use crate::domain::Domain;
use crate::error::Error;
use crate::map::Invert;
use crate::sequence::Sequence;
use crate::{hemisphere, map, sequence};

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

/// What the constructors of sequences take.
#[derive(Clone, Copy, Debug)]
pub struct Parameters {
    /// Columns of a grid.
    pub columns: u32,
    /// Rows of a grid.
    pub rows: u32,
    /// Points of a set without a grid.
    pub count: u32,
    /// A seed.
    pub seed: u32,
    /// A domain.
    pub domain: Domain,
}

impl Parameters {
    /// For sets of `count` points, in grids of [`sequence::grid`]`(count)`.
    pub const fn new(count: u32, seed: u32) -> Self {
        let [columns, rows] = sequence::grid(count);
        Self { columns, rows, count, seed, domain: Domain::new(seed) }
    }
}

macro_rules! sequences {
    ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*) => {
        /// The names of all sequences, in the order in which they are visited.
        pub const SEQUENCES: &[&str] = &[$($name),*];

        /// Visits every sequence: the sets with `count` points, the endless ones as they are.
        ///
        /// # Errors
        /// [`Error::EmptyGrid`] for a `count` of 0.
        pub fn sequences(
            count: u32,
            seed: u32,
            visitor: &mut impl SequenceVisitor,
        ) -> Result<(), Error> {
            sequences_of(Parameters::new(count, seed), visitor)
        }

        /// Visits every sequence, each made of the parameters that it takes.
        ///
        /// # Errors
        /// [`Error::EmptyGrid`] and [`Error::SetTooLarge`] as the constructors.
        pub fn sequences_of(
            parameters: Parameters,
            visitor: &mut impl SequenceVisitor,
        ) -> Result<(), Error> {
            $(
                let made = sequence::$sequence::$new($(parameters.$part),*);
                visitor.visit($name, made_by!($kind made));
            )*
            Ok(())
        }
    };
}
for_each_sequence!(sequences);

/// One lobe over every disc map.
macro_rules! over_disc_maps {
    ($visitor:ident $over:ident $lobe:literal ()
        $($file:ident $map:ident $name:literal;)*) => {$(
        $visitor.hemisphere($lobe, $name, hemisphere::$over::over(map::disc::$map::<A>::new()));
    )*};
    ($visitor:ident $over:ident $lobe:literal ($parameter:ident)
        $($file:ident $map:ident $name:literal;)*) => {$(
        let made = hemisphere::$over::over($parameter, map::disc::$map::<A>::new());
        $visitor.hemisphere($lobe, $name, made?);
    )*};
}

/// The lobes of one parameter list over every disc map.
macro_rules! lobes {
    ($visitor:ident () $($file:ident $type:ident $over:ident $name:literal $taken:tt;)*) => {
        $(lobes!(@without $visitor $over $name $taken);)*
    };
    ($visitor:ident ($parameter:ident)
        $($file:ident $type:ident $over:ident $name:literal $taken:tt;)*) => {
        $(lobes!(@with $parameter $visitor $over $name $taken);)*
    };
    (@without $visitor:ident $over:ident $name:literal ()) => {
        for_each_disc_map!(over_disc_maps $visitor $over $name ())
    };
    (@with $parameter:ident $visitor:ident $over:ident $name:literal ($taken:ident)) => {
        for_each_disc_map!(over_disc_maps $visitor $over $name ($parameter))
    };
    (@without $visitor:ident $over:ident $name:literal $taken:tt) => {};
    (@with $parameter:ident $visitor:ident $over:ident $name:literal $taken:tt) => {};
}

macro_rules! discs {
    ($visitor:ident $($file:ident $map:ident $name:literal;)*) => {
        $($visitor.disc($name, map::disc::$map::<A>::new());)*
    };
}

/// Visits every map without a parameter.
pub fn maps<A: Arithmetic>(visitor: &mut impl MapVisitor<A>) {
    for_each_disc_map!(discs visitor);
    for_each_lobe!(lobes visitor ());
}

/// Visits the lobes of one exponent over every disc map.
///
/// # Errors
/// [`Error::Exponent`] for a value that is not a finite number above -1.
pub fn power_maps<A: Arithmetic>(
    exponent: A::Parameter,
    visitor: &mut impl MapVisitor<A>,
) -> Result<(), Error> {
    for_each_lobe!(lobes visitor (exponent));
    Ok(())
}

macro_rules! arithmetics {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        /// The names of all arithmetics that a build with every feature has, in the order of visits.
        pub const ARITHMETICS: &[&str] = &[$($name),*];

        /// The names of the arithmetics that this build has, in the order of visits.
        pub const AVAILABLE_ARITHMETICS: &[&str] = &[$(#[$cfg] $name),*];

        /// Visits every arithmetic whose feature is on.
        pub fn arithmetics(visitor: &mut impl ArithmeticVisitor) {
            $(
                #[$cfg]
                visitor.visit::<crate::arithmetic::$arithmetic>();
            )*
        }
    };
}
for_each_arithmetic!(arithmetics);

macro_rules! disc_maps {
    ($($file:ident $map:ident $name:literal;)*) => {
        /// The names of all disc maps.
        pub const DISC_MAPS: &[&str] = &[$($name),*];
    };
}
for_each_disc_map!(disc_maps);

macro_rules! lobe_names {
    ($($file:ident $type:ident $over:ident $name:literal ($($taken:ident)?);)*) => {
        /// The names of all lobes.
        pub const LOBES: &[&str] = &[$($name),*];

        /// The names of the lobes that take an exponent.
        pub const POWER_LOBES: &[&str] = &[$($(lobe_names!(@ $taken $name),)?)*];
    };
    (@ exponent $name:literal) => { $name };
}
for_each_lobe!(lobe_names);

macro_rules! effects {
    ($($file:ident $effect:ident $name:literal;)*) => {
        /// The names of all effects.
        pub const EFFECTS: &[&str] = &[$($name),*];
    };
}
for_each_effect!(effects);
