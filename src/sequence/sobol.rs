//! Sobol sequence, the first two dimensions: a (0, 2)-sequence in base 2 (I. Sobol, 1967).
//!
//! Dimension 0 is the radical inverse in base 2. The matrix of dimension 1 is Pascal's triangle
//! modulo 2, the Kronecker power of [1 1; 0 1], so it acts on the reversed index in five xor-shift
//! steps. Indices are in natural order, not Gray code.

use super::Sequence;
use super::walk::{Walk, walks};
#[cfg(any(feature = "serde", feature = "defmt"))]
use crate::bits::hash::unmix;
use crate::bits::hash::{mix, shift};
use crate::bits::sobol::higher_dimensions;
use crate::block::{BLOCK, Block, SHORT_BLOCK};

/// The Sobol (0, 2)-sequence, with an optional digital (xor) shift.
///
/// Promise: each block of 2^k points that starts at a multiple of 2^k is a (0, k, 2)-net: every
/// elementary interval of area 2^-k holds exactly one. A point costs about 20 integer operations.
///
/// ```
/// use hemidisc::sequence::Sobol;
/// assert_eq!(Sobol::new(0).at(3), [0xc000_0000, 0x4000_0000]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sobol {
    shift: [u32; 2],
}

impl Sobol {
    /// Seed 0 is the textbook sequence; any other shifts both axes by a hash of the seed.
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { shift: shift(seed) }
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn seed(&self) -> u32 {
        unmix(self.shift[0])
    }

    /// How many points there are: `None`, for it is endless.
    #[must_use]
    pub const fn size(&self) -> Option<u32> {
        None
    }

    /// The point of any index.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> [u32; 2] {
        let [u, v] = textbook(index);
        [u ^ self.shift[0], v ^ self.shift[1]]
    }

    /// The first four dimensions at an index, as two pairs, the first that of [`at`](Self::at).
    ///
    /// Those of S. Joe and F. Kuo, "Constructing Sobol Sequences with Better Two-Dimensional
    /// Projections", 2008, whose file new-joe-kuo-6 scipy takes, too.
    ///
    /// ```
    /// use hemidisc::sequence::Sobol;
    /// assert_eq!(Sobol::new(0).joint(2)[1], [0xc000_0000, 0xc000_0000]);
    /// ```
    #[must_use]
    #[inline]
    pub const fn joint(self, index: u32) -> [[u32; 2]; 2] {
        let [w, x] = higher_dimensions(index);
        let [_, second] = self.shift;
        let third = mix(second.rotate_left(13));
        let fourth = mix(third.rotate_left(13));
        [self.at(index), [w.reverse_bits() ^ third, x.reverse_bits() ^ fourth]]
    }
}

/// The unshifted point.
#[inline(always)]
const fn textbook(index: u32) -> [u32; 2] {
    let u = index.reverse_bits();
    [u, pascal(u)]
}

/// Pascal's triangle modulo 2 applied to the bits of `x`, the highest first: bit pairs, then pairs
/// of pairs, and so on take the lower half into the upper.
const fn pascal(mut x: u32) -> u32 {
    x ^= x << 1 & 0xaaaa_aaaa;
    x ^= x << 2 & 0xcccc_cccc;
    x ^= x << 4 & 0xf0f0_f0f0;
    x ^= x << 8 & 0xff00_ff00;
    x ^ (x << 16)
}

/// The first 64 points: xor with the first point of a block gives the rest of it.
const OFFSETS: [Block; 2] = {
    let mut offsets = [[0; BLOCK]; 2];
    let mut index = 0;
    while index < BLOCK {
        [offsets[0][index], offsets[1][index]] = textbook(index as u32);
        index += 1;
    }
    offsets
};

/// The points of a block, from its first.
#[inline(always)]
fn beside<const N: usize>(first: [u32; 2], u: &mut Block<N>, v: &mut Block<N>) {
    for (axis, out) in [u, v].into_iter().enumerate() {
        for (slot, offset) in out.iter_mut().zip(&OFFSETS[axis]) {
            *slot = first[axis] ^ offset;
        }
    }
}

const FEW: usize = 16;

/// The first few points.
const FIRST: [[u32; 2]; FEW] = {
    let mut first = [[0; 2]; FEW];
    let mut index = 0;
    while index < FEW {
        first[index] = textbook(index as u32);
        index += 1;
    }
    first
};

impl Sequence for Sobol {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    walks!();

    /// Both matrices are linear over xor, so a block is its first point xor a table.
    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        beside(self.at(start), u, v);
    }

    #[inline(always)]
    fn short_block(&self, start: u32, u: &mut Block<SHORT_BLOCK>, v: &mut Block<SHORT_BLOCK>) {
        beside(self.at(start), u, v);
    }
}

/// Like a block, but small enough for a small image.
impl Walk for Sobol {
    /// The point that the few begin with, and the place among them.
    type State = ([u32; 2], u32);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let offset = index % FEW as u32;
        ((self.at(index - offset), offset), FEW as u32 - offset)
    }

    #[inline(always)]
    fn step(&self, ([u, v], offset): &mut Self::State) -> [u32; 2] {
        let [du, dv] = FIRST[*offset as usize % FEW];
        *offset += 1;
        [*u ^ du, *v ^ dv]
    }
}
