//! Rings of the square: the coordinates of one distance from the centre, for walks of the disc's rim.

use crate::arithmetics::{Number, Tested};

/// Magnitudes about the centre as coordinates: 2m + 1 in units of 2^-32.
pub fn outward(magnitude: u32) -> u32 {
    0x8000_0000 + magnitude
}

/// Every m in 0..2^31 that the arithmetic tells from the m before, and each `stride`-th of them:
/// floats those whose 2m + 1 is another f32, fixed point those whose leading bits differ.
pub fn distinct<A: Tested>(stride: usize) -> impl Iterator<Item = u32> {
    // An f32 tells every m below 2^23, and above that one in 2^(bit - 23).
    let read = A::BITS.min(24);
    let exact = (0..1_u32 << 23).step_by(1 << (32 - A::BITS));
    let rounded = (23..31_u32).flat_map(move |bit| {
        let step = if A::Real::FIXED { 32 - read } else { bit - 23 };
        (1 << bit..1 << (bit + 1)).step_by(1 << step)
    });
    exact.chain(rounded).step_by(stride)
}
