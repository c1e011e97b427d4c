//! That what is drawn is where it should be and of the right colour, on panels of any size, and
//! that a target's error comes through.

mod discs;
mod picture;
mod srgb;
mod target;

use target::Target;

/// Sizes of panels that there are, and some that there are not.
const SIZES: [[u32; 2]; 9] =
    [[160, 128], [240, 240], [320, 170], [96, 64], [101, 53], [16, 200], [9, 7], [1, 1], [0, 0]];
