//! Strata of a coordinate.

/// The stratum of a cell: floor(cell count / 2^32), of 0 .. `count`.
pub fn stratum(cell: u32, count: u32) -> u32 {
    ((u64::from(cell) * u64::from(count)) >> 32) as u32
}
