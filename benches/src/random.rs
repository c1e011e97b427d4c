//! Random words: what coordinates and keys are drawn from, and the generator of the peers.

use rand_xoshiro::Xoshiro128PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;

/// The seed of sequences and generators.
pub const SEED: u32 = 7;

/// Different words for each size of buffer: with the same ones the second buffer would find a
/// trained branch predictor.
pub fn generator(points: usize) -> Xoshiro128PlusPlus {
    Xoshiro128PlusPlus::seed_from_u64(u64::from(SEED) + points as u64)
}
