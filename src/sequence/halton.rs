//! Halton sequence in bases 2 and 3 (J. Halton, "On the Efficiency of Certain Quasi-random
//! Sequences of Points in Evaluating Multi-dimensional Integrals", 1960).
//!
//! The radical inverse mirrors the digits of the index at the radix point. A coordinate is
//! ceil(2^32 x) of the exact rational x, so that it lies in the stratum of every base that x does.

use super::Sequence;
use super::walk::Reversed;
use super::walk::{Walk, block_in_order, walks};
use crate::bits::wide::high;
use crate::block::Block;
use crate::target::HALVES;

/// The Halton sequence: radical inverses of the index in base 2 (u) and base 3 (v).
///
/// Promise: any 2^a 3^b consecutive points hit each of the 2^a x 3^b elementary intervals once, for
/// b <= 19. (3^20 intervals are as narrow as a cell, and rounding up to a cell may cross an edge.)
/// Takes no seed. A point by its index costs up to 20 divisions by 3, the next one a few additions.
///
/// ```
/// use hemidisc::sequence::Halton;
/// // 1 / 2 and ceil(2^32 / 3)
/// assert_eq!(Halton::new().at(1), [0x8000_0000, 0x5555_5556]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Halton;

impl Halton {
    /// The sequence; it has no parameters.
    #[must_use]
    pub const fn new() -> Self {
        Self
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
        [index.reverse_bits(), radical_inverse_3(index)]
    }
}

/// The ternary digits that a coordinate can distinguish, and 3 to their power.
const DIGITS: u32 = 20;
const SCALE: u32 = 3_u32.pow(DIGITS);

/// ceil(2^32 x) for the radical inverse x of `index` in base 3.
///
/// A `u32` has at most 21 ternary digits. The lowest 20, mirrored, make an integer below
/// 3^20 < 2^32; the last one, 0 or 1, has weight 3^-21.
const fn radical_inverse_3(index: u32) -> u32 {
    let (mut rest, mut digits, mut mirrored, mut weight) = (index, 0, 0, SCALE / 3);
    while rest > 0 && digits < DIGITS {
        let third = third(rest);
        mirrored += (rest - 3 * third) * weight;
        rest = third;
        // A third of a multiple of 3, unused after the last digit: 3 0xaaaa_aaab = 1 mod 2^32.
        weight = weight.wrapping_mul(0xaaaa_aaab);
        digits += 1;
    }
    let cell = scaled(mirrored);
    // The cell is (mirrored 2^32 + slack) / 3^20; a digit more is a third of 2^32, less than 3^20.
    let slack = cell.wrapping_mul(SCALE);
    cell + (rest > 0 && slack <= u32::MAX / 3) as u32
}

/// floor(n / 3), by products for a core without a divider.
#[inline(always)]
const fn third(n: u32) -> u32 {
    if !HALVES {
        n / 3
    } else if n < 1 << 16 {
        // 3 0xaaab = 2^17 + 1, and n / (3 2^17) < 1 / 3.
        (n * 0xaaab) >> 17
    } else {
        high(n, 0xaaaa_aaab) >> 1
    }
}

/// ceil(2^32 m / 3^20) for m < 3^20.
///
/// That is m + y with y = m (2^32 - 3^20) / 3^20, and 4y is above `quarters` by less than
/// 1 + m / 2^32 < 1.82. So `near` is above m + y by at most 1/4 or below it by less than 0.96, and
/// the product with 3^20, which is the difference times 3^20 modulo 2^32, tells which: 3^20 / 4 is
/// below 2^32 - 0.96 3^20.
const fn scaled(m: u32) -> u32 {
    const FRACTION: u32 = ((((1 << 32) - SCALE as u64) << 34) / SCALE as u64) as u32;
    let quarters = high(m, FRACTION);
    // At most m / 4 + 1.
    let near = m + ((quarters + 1) >> 2);
    near + (near.wrapping_mul(SCALE) > SCALE / 4) as u32
}

/// 4 / 3^(j + 1) of the axis modulo 1: the step from an index that ends in j digits 2 to the next.
/// In cells, rounded down, and the remainder in 3^-20 cells.
const STEPS: [[u32; 2]; DIGITS as usize] = {
    let mut steps = [[0; 2]; DIGITS as usize];
    let (mut digit, mut weight) = (0, SCALE as u64 / 3);
    while digit < DIGITS as usize {
        let step = (4 * weight % SCALE as u64) << 32;
        steps[digit] = [(step / SCALE as u64) as u32, (step % SCALE as u64) as u32];
        (digit, weight) = (digit + 1, weight / 3);
    }
    steps
};

/// The cell of the index after one below 3^20 - 1.
#[inline(always)]
fn after(cell: u32) -> u32 {
    // j digits 2 lead those of x from 1 - 3^-j on, that is where fewer than 2^32 / 3^j cells
    // follow.
    let mut step = STEPS[0];
    if !cell < step[0] {
        for next in &STEPS[1..] {
            step = *next;
            if !cell >= step[0] / 4 {
                break;
            }
        }
    }
    let slack = cell.wrapping_mul(SCALE);
    cell.wrapping_add(step[0]).wrapping_add((slack < step[1]) as u32)
}

impl Sequence for Halton {
    fn size(&self) -> Option<u32> {
        Self::size(self)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        Self::at(*self, index)
    }

    walks!();

    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        block_in_order(self.iter(start), u, v);
    }
}

impl Walk for Halton {
    type State = (Reversed, u32);

    #[inline(always)]
    fn enter(&self, index: u32) -> (Self::State, u32) {
        let state = (Reversed::new(index), radical_inverse_3(index));
        // From 3^20 on a cell does not determine the digits.
        (state, SCALE.saturating_sub(index).max(1))
    }

    #[inline(always)]
    fn step(&self, (index, v): &mut Self::State) -> [u32; 2] {
        let point = [index.bits(), *v];
        (*index, *v) = (index.after(), after(*v));
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::hash::mix;

    #[test]
    fn scaling_is_exact() {
        let ends = (0..100_000).flat_map(|i| [i, SCALE - 1 - i]);
        for m in ends.chain((0..100_000).map(|i| mix(i) % SCALE)) {
            let exact = (u64::from(m) << 32).div_ceil(u64::from(SCALE));
            assert_eq!(u64::from(scaled(m)), exact, "{m}");
        }
    }

    /// At every carry, including the longest.
    #[test]
    fn a_step_is_the_next_point() {
        let powers = (0..DIGITS).flat_map(|digit| [1, 2, 3].map(|n| n * 3_u32.pow(digit)));
        let about = powers.flat_map(|power| (power.max(9) - 9)..power.saturating_add(9));
        for index in about.chain((0..100_000).map(mix)).filter(|&i| i < SCALE - 1) {
            let v = radical_inverse_3(index);
            assert_eq!(after(v), radical_inverse_3(index + 1), "{index}");
        }
    }
}
