//! Every fill of a buffer that is timed, by its path.
//!
//! | path | fill |
//! | --- | --- |
//! | `sequence/SEQUENCE` | coordinates, a block of 64 after another |
//! | `map/MAP/DISC/ARITHMETIC` | points of stored random coordinates |
//! | `apart/MAP/DISC/fast-f32` | the same, each component into a buffer of its own |
//! | `turned/MAP/DISC/fast-f32` | the same about a frame |
//! | `fused/SEQUENCE/MAP/DISC/ARITHMETIC` | points of a sequence |
//! | `peer/MAP/DISC/PEER` | the same by other crates and formulas |
//!
//! All but the peers come from the catalogue's lists.

use crate::buffers::{Coordinates, Visitor};
use crate::{fused, maps, peers, sequences, shapes};
use benches::failure::Failure;

/// Visits every fill of that many points, a multiple of 64.
pub(crate) fn every<'a>(
    coordinates: &'a Coordinates,
    points: usize,
    visitor: &mut impl Visitor<'a>,
) -> Result<(), Failure> {
    sequences::every(points, visitor)?;
    maps::every(coordinates, points, visitor)?;
    shapes::every(coordinates, points, visitor)?;
    fused::every(points, visitor)?;
    peers::every(coordinates, points, visitor);
    Ok(())
}
