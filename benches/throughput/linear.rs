//! That cost grows linearly: the time of a point at four sizes of buffer, side by side.
//!
//! A point must cost the same in cache and in memory, apart from memory bandwidth, which
//! `slice::fill` shows.

use crate::buffers::{Coordinates, LARGE, SMALL};
use crate::rounds;
use benches::failure::Failure;
use benches::rounds::Measurement;

/// Points of a buffer.
pub(crate) const SIZES: [usize; 4] = [1 << 8, SMALL, 1 << 16, LARGE];

/// Every sequence through one map, one sequence through every map, and the fills without either.
fn wanted(path: &str) -> bool {
    match path.split('/').collect::<Vec<_>>()[..] {
        ["fused", sequence, map, disc, "fast-f32"] => {
            sequence == "sobol" || (map, disc) == ("disc", "concentric")
        }
        ["peer", .., peer] => peer == "slice-fill" || peer == "rand_distr",
        _ => false,
    }
}

/// All sizes of one fill, then of the next: the buffers together would take gigabytes.
pub(crate) fn run(coordinates: &Coordinates, rounds: usize) -> Result<Vec<Measurement>, Failure> {
    let mut measured = Vec::new();
    for path in rounds::paths(coordinates)?.iter().filter(|path| wanted(path)) {
        measured.extend(rounds::at_sizes(coordinates, &SIZES, rounds, |found| found == path)?);
    }
    Ok(measured)
}
