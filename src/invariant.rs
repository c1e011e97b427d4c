//! The promises as functions: tests, fuzz targets and users share them.
//!
//! Each returns `Ok(())` or a [`Violation`] that names the promise and the inputs. They compute in
//! exact arithmetic, allocate nothing, and are slower than the maps they check.
//!
//! ```
//! use hemidisc::{Cosine, LibmF32, invariant};
//! invariant::hemisphere(&Cosine::<LibmF32>::new(), [0, u32::MAX])?;
//! # Ok::<(), invariant::Violation>(())
//! ```
//!
//! # In a fuzz target of your own
//!
//! With the feature `arbitrary`, sequences, domains, maps, points, frames and effects implement
//! `arbitrary::Arbitrary`: any bytes give valid values. So a target takes them as its input and
//! checks its own results. These functions tell whether a fault is the target's or this crate's:
//!
//! ```
//! # // The macro of `libfuzzer_sys`, for this example to be compiled and run without it.
//! # macro_rules! fuzz_target {
//! #     (|$input:ident: $type:ty| $body:block) => { fn target($input: $type) $body };
//! # }
//! // #![no_main]
//! // use libfuzzer_sys::fuzz_target;
//! use hemidisc::effect::DiscLight;
//! use hemidisc::sequence::SobolOwen;
//! use hemidisc::{FastF32, Points, Power, invariant};
//!
//! type Input = (DiscLight<FastF32>, Points<SobolOwen, Power<FastF32>>, [f32; 3], u32);
//!
//! fuzz_target!(|input: Input| {
//!     let (lamp, lobe, receiver, index) = input;
//!     let uv = lobe.sequence().at(index);
//!     assert_eq!(invariant::consistent(lobe.sequence(), index), Ok(()));
//!     assert_eq!(invariant::hemisphere(lobe.map(), uv), Ok(()));
//!     // Here comes the renderer, in the place of these two lines.
//!     let sample = lamp.sample(receiver, uv);
//!     assert!(sample.weight >= 0.0 && sample.weight.is_finite());
//! });
//! # use arbitrary::Unstructured;
//! # for byte in 0..=255 {
//! #     target(Unstructured::new(&[byte; 64]).arbitrary()?);
//! # }
//! # Ok::<(), arbitrary::Error>(())
//! ```
//!
//! The checks of this crate's own targets, in every arithmetic, are in `testkit/src/checks` of its
//! repository.

use crate::block::{BLOCK, SHORT_BLOCK};

/// Where the last short block of a block begins.
const LAST_SHORT: u32 = (BLOCK - SHORT_BLOCK) as u32;
use crate::map::{Component, Density, Invert, Map};
use crate::sequence::Sequence;
use core::fmt;

mod exact;
mod strata;

pub use exact::{Exact, in_unit_disc};
pub use strata::{cells, net, rooks};

/// A broken promise.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Violation {
    /// A component or a density that is not a finite number.
    NotFinite {
        /// The coordinates of the sample.
        uv: [u32; 2],
    },
    /// x^2 + y^2 > 1 in exact arithmetic.
    OutsideDisc {
        /// The coordinates of the sample.
        uv: [u32; 2],
    },
    /// A direction that is not above the horizon.
    BelowHorizon {
        /// The coordinates of the sample.
        uv: [u32; 2],
    },
    /// A density that is not positive at a sampled point.
    NoDensity {
        /// The coordinates of the sample.
        uv: [u32; 2],
    },
    /// A mirrored coordinate whose point is not the mirrored point.
    NotMirrored {
        /// The coordinates of the sample.
        uv: [u32; 2],
    },
    /// Coordinates that `invert` did not give back.
    NotInverted {
        /// The coordinates of the sample.
        uv: [u32; 2],
        /// What came back.
        got: [u32; 2],
    },
    /// A cell, a row, a column or an elementary interval that does not hold exactly one point.
    Stratum {
        /// Columns and rows of the grid of strata.
        grid: [u32; 2],
        /// The index of the point that came second to a stratum, or left it.
        index: u32,
    },
    /// More strata than the caller's memory can mark.
    NoRoom {
        /// Words of `u32` that are needed.
        needed: u64,
    },
    /// A point that random access, iteration and blocks do not agree on.
    Inconsistent {
        /// Its index.
        index: u32,
    },
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { uv } => write!(f, "the sample of {uv:#x?} is not finite"),
            Self::OutsideDisc { uv } => write!(f, "the sample of {uv:#x?} is outside the disc"),
            Self::BelowHorizon { uv } => write!(f, "the sample of {uv:#x?} has z <= 0"),
            Self::NoDensity { uv } => write!(f, "the sample of {uv:#x?} has no density"),
            Self::NotMirrored { uv } => write!(f, "the sample of {uv:#x?} is not mirrored"),
            Self::NotInverted { uv, got } => write!(f, "{uv:#x?} came back as {got:#x?}"),
            Self::Stratum { grid: [columns, rows], index } => {
                write!(f, "point {index} shares a stratum of {columns} x {rows}")
            }
            Self::Inconsistent { index } => {
                write!(f, "point {index} depends on how it is asked for")
            }
            Self::NoRoom { needed } => write!(f, "marking the strata takes {needed} words"),
        }
    }
}

impl core::error::Error for Violation {}

/// A map onto the disc at one sample: finite, on the disc, with a density.
///
/// # Errors
/// The promise that is broken.
pub fn disc<R: Exact, M: Density<Point = [R; 2]>>(map: &M, uv: [u32; 2]) -> Result<(), Violation> {
    let point = map.sample(uv);
    on_disc(point, uv)?;
    has_density(map, point, uv)
}

/// A map onto the hemisphere at one sample: finite, x^2 + y^2 <= 1, z > 0, with a density.
///
/// # Errors
/// The promise that is broken.
pub fn hemisphere<R: Exact, M: Density<Point = [R; 3]>>(
    map: &M,
    uv: [u32; 2],
) -> Result<(), Violation> {
    let [x, y, z] = map.sample(uv);
    on_disc([x, y], uv)?;
    let height: f64 = z.exact();
    if !height.is_finite() {
        return Err(Violation::NotFinite { uv });
    }
    // NaN is excluded already, so the comparison is sound.
    if height <= 0.0 {
        return Err(Violation::BelowHorizon { uv });
    }
    has_density(map, [x, y, z], uv)
}

/// The concentric map's mirror symmetry at one sample: u -> !u negates x alone, v -> !v y alone.
///
/// # Errors
/// [`Violation::NotMirrored`].
pub fn mirrored_concentric<R: Exact, const D: usize, M: Map<Point = [R; D]>>(
    map: &M,
    [u, v]: [u32; 2],
) -> Result<(), Violation> {
    let point = map.sample([u, v]);
    mirrored(map.sample([!u, v]), point, &[0], [u, v])?;
    mirrored(map.sample([u, !v]), point, &[1], [u, v])
}

/// The polar map's mirror symmetry at one sample: u -> !u negates y alone.
///
/// # Errors
/// [`Violation::NotMirrored`].
pub fn mirrored_polar<R: Exact, const D: usize, M: Map<Point = [R; D]>>(
    map: &M,
    [u, v]: [u32; 2],
) -> Result<(), Violation> {
    mirrored(map.sample([!u, v]), map.sample([u, v]), &[1], [u, v])
}

fn mirrored<R: Exact, const D: usize>(
    image: [R; D],
    point: [R; D],
    negated: &[usize],
    uv: [u32; 2],
) -> Result<(), Violation> {
    for axis in 0..D {
        let same = if negated.contains(&axis) {
            image[axis].mirrors(point[axis])
        } else {
            image[axis].exact().to_bits() == point[axis].exact().to_bits()
        };
        if !same {
            return Err(Violation::NotMirrored { uv });
        }
    }
    Ok(())
}

/// That `invert` gives back the exact coordinates: promised by `LibmF64` on the disc and for e in
/// [0, 1e8].
///
/// # Errors
/// [`Violation::NotInverted`].
pub fn inverted<M: Invert>(map: &M, uv: [u32; 2]) -> Result<(), Violation> {
    let got = map.invert(map.sample(uv));
    if got == uv { Ok(()) } else { Err(Violation::NotInverted { uv, got }) }
}

fn on_disc<R: Exact>(point: [R; 2], uv: [u32; 2]) -> Result<(), Violation> {
    let [x, y] = point.map(Exact::exact);
    if !(x.is_finite() && y.is_finite()) {
        return Err(Violation::NotFinite { uv });
    }
    if in_unit_disc([x, y]) { Ok(()) } else { Err(Violation::OutsideDisc { uv }) }
}

fn has_density<M: Density>(map: &M, point: M::Point, uv: [u32; 2]) -> Result<(), Violation>
where
    Component<M>: Exact,
{
    let density = map.density(point).exact();
    if !density.is_finite() {
        return Err(Violation::NotFinite { uv });
    }
    if density > 0.0 { Ok(()) } else { Err(Violation::NoDensity { uv }) }
}

/// That random access, iteration and blocks of a sequence agree on the 64 points from a multiple
/// of 64 on.
///
/// # Errors
/// [`Violation::Inconsistent`].
pub fn consistent<S: Sequence>(sequence: &S, start: u32) -> Result<(), Violation> {
    let start = start - start % BLOCK as u32;
    let (mut u, mut v) = ([0; BLOCK], [0; BLOCK]);
    sequence.block(start, &mut u, &mut v);
    let block = u.into_iter().zip(v);
    for (offset, (block, iterated)) in (0..).zip(block.zip(sequence.iter(start))) {
        let index = start.wrapping_add(offset);
        let point = sequence.at(index);
        if point != iterated || point != [block.0, block.1] {
            return Err(Violation::Inconsistent { index });
        }
    }
    for start in (start..=start + LAST_SHORT).step_by(SHORT_BLOCK) {
        let (mut u, mut v) = ([0; SHORT_BLOCK], [0; SHORT_BLOCK]);
        sequence.short_block(start, &mut u, &mut v);
        for (index, (u, v)) in (start..=u32::MAX).zip(u.into_iter().zip(v)) {
            if sequence.at(index) != [u, v] {
                return Err(Violation::Inconsistent { index });
            }
        }
    }
    Ok(())
}
