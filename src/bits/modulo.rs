//! Indices modulo the size of a set.

use crate::target::HALVES;

/// `index` modulo `size`, without a division for an index inside the set. A set is never empty.
#[inline(always)]
pub(crate) const fn repeat(index: u32, size: u32) -> u32 {
    if index < size {
        index
    } else if HALVES {
        remainder(index, size)
    } else {
        match index.checked_rem(size) {
            Some(index) => index,
            None => 0,
        }
    }
}

/// `index` modulo `size` by doubling and subtracting. A core without a divider would link 800 bytes
/// of a routine that is seldom called.
#[cold]
#[inline(never)]
const fn remainder(index: u32, size: u32) -> u32 {
    let mut rest = index;
    while size > 0 && rest >= size {
        let mut multiple = size;
        while multiple <= rest / 2 {
            multiple *= 2;
        }
        rest -= multiple;
    }
    rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bits::grid::tests::lengths;
    use crate::bits::hash::mix;

    #[test]
    fn remainders_by_bits_are_remainders() {
        for size in lengths() {
            let ends = (0..100).flat_map(|i| [i, u32::MAX - i, size.wrapping_mul(i)]);
            for index in ends.chain((0..1000).map(mix)) {
                assert_eq!(remainder(index, size), index % size, "{index} mod {size}");
                assert_eq!(repeat(index, size), index % size, "{index} mod {size}");
            }
        }
    }
}
