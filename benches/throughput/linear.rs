//! That cost grows linearly: the time of a point at four sizes of buffer, side by side.
//!
//! From the caches to memory a point must cost the same, but for what the memory itself takes:
//! `slice::fill` shows it.

use crate::buffers::{Coordinates, LARGE, SMALL};
use crate::failure::Failure;
use crate::rounds::{self, Measurement};

/// Points of a buffer.
pub(crate) const SIZES: [usize; 4] = [1 << 8, SMALL, 1 << 16, LARGE];

/// Every sequence through one map, one sequence through every map, and what there is without
/// either.
fn wanted(path: &str) -> bool {
    match path.split('/').collect::<Vec<_>>()[..] {
        ["fused", sequence, map, disc, "fast-f32"] => {
            sequence == "sobol" || (map, disc) == ("disc", "concentric")
        }
        ["peer", .., peer] => peer == "slice-fill" || peer == "rand_distr",
        _ => false,
    }
}

/// The sizes of one fill, then of the next: the buffers of all together would be gigabytes.
pub(crate) fn run(coordinates: &Coordinates, rounds: usize) -> Result<Vec<Measurement>, Failure> {
    let mut measured = Vec::new();
    for path in rounds::paths(coordinates)?.iter().filter(|path| wanted(path)) {
        measured.extend(rounds::at_sizes(coordinates, &SIZES, rounds, |found| found == path)?);
    }
    Ok(measured)
}
