//! Exact strata of an axis: the unit interval cut into any number of equal parts.
//!
//! Stratum c of n holds the cells k with floor(k n / 2^32) = c, that is from ceil(c 2^32 / n) up to
//! the next edge. Rounding edges down instead would put a point into the stratum below whenever n
//! is not a power of two.
//!
//! With 2^32 / n = w + r / n and f = floor(2^32 r / n), an edge is c w + ceil(c r / n), and for
//! n <= 2^16 the latter is ceil(c f / 2^32): c f / 2^32 is smaller than c r / n by less than
//! c / 2^32 < 1 / n, and c r / n is an integer or at least 1 / n above one.

use crate::target::HALVES;

/// `count` equal strata of one axis, `count` >= 1, with a prepared reciprocal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Strata {
    count: u32,
    /// The cells that every stratum has: floor(2^32 / count), one fewer for `count` = 1.
    whole: u32,
    /// Its halves, for a core that multiplies by them.
    halves: [u16; 2],
    /// 2^32 mod count, and the same as a fraction of count in 0.32 fixed point.
    rest: u32,
    fraction: u32,
}

impl Strata {
    /// The largest count for which `fraction` alone gives the edges.
    const SHORT: u32 = 1 << 16;

    /// `count` is at least 1: the constructors of sets have checked it.
    pub(crate) const fn new(count: u32) -> Self {
        let count = if count == 0 { 1 } else { count };
        let divisor = count as u64;
        let whole = if count == 1 { u32::MAX } else { ((1 << 32) / divisor) as u32 };
        let rest = ((1 << 32) % divisor) as u32;
        let fraction = (((rest as u64) << 32) / divisor) as u32;
        Self { count, whole, halves: [(whole >> 16) as u16, whole as u16], rest, fraction }
    }

    pub(crate) const fn count(self) -> u32 {
        self.count
    }

    /// The first cell of a stratum: ceil(c 2^32 / count); `stratum` < count.
    #[inline(always)]
    pub(crate) const fn first(self, stratum: u32) -> u32 {
        let up = if self.count > Self::SHORT {
            self.up_long(stratum)
        } else if HALVES {
            up_by_halves(stratum, self.fraction)
        } else {
            ((stratum as u64 * self.fraction as u64 + u32::MAX as u64) >> 32) as u32
        };
        stratum.wrapping_mul(self.whole).wrapping_add(up)
    }

    /// ceil(c rest / count) for any count: the quotient from the reciprocal is at most one too
    /// small, which its remainder shows.
    // Apart: few sets are as large, and the call costs the others nothing.
    #[inline(never)]
    const fn up_long(self, stratum: u32) -> u32 {
        let quotient = (stratum as u64 * self.fraction as u64) >> 32;
        let remainder = stratum as u64 * self.rest as u64 - quotient * self.count as u64;
        quotient as u32 + (remainder > 0) as u32 + (remainder > self.count as u64) as u32
    }

    /// The first cell of the stratum after the one that begins at `first`, if there is one.
    ///
    /// first count is c 2^32 + s with a slack s < count; `whole` more cells take `rest` from the
    /// slack, and where that is too much it takes one cell more.
    #[inline(always)]
    pub(crate) const fn after(self, first: u32) -> u32 {
        let slack = first.wrapping_mul(self.count);
        first.wrapping_add(self.whole).wrapping_add((slack < self.rest) as u32)
    }

    /// A cell of the stratum that begins at `first`, at a fraction of 2^-16 of it.
    #[inline(always)]
    pub(crate) const fn jittered(self, first: u32, fraction: u32) -> u32 {
        first.wrapping_add(if HALVES {
            let [upper, lower] = self.halves;
            fraction * upper as u32 + ((fraction * lower as u32) >> 16)
        } else {
            ((fraction as u64 * self.whole as u64) >> 16) as u32
        })
    }
}

/// ceil(c f / 2^32) for c < 2^16: both products and both sums are below 2^32.
#[inline(always)]
const fn up_by_halves(c: u32, f: u32) -> u32 {
    let low = (c * (f & 0xffff) + 0xffff) >> 16;
    (c * (f >> 16) + low + 0xffff) >> 16
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(stratum: u32, count: u32) -> u64 {
        ((u128::from(stratum) << 32).div_ceil(u128::from(count))) as u64
    }

    /// Counts about the largest for which the short form does, and the largest of all.
    const LARGE: [u32; 10] = [
        65_535,
        65_536,
        65_537,
        65_539,
        1 << 31,
        (1 << 31) + 1,
        u32::MAX - 1,
        u32::MAX,
        3_486_784_401,
        99_991,
    ];

    #[test]
    fn edges_are_exact() {
        for count in (1..=1500).chain(LARGE) {
            let strata = Strata::new(count);
            let step = (count / 1000).max(1);
            for stratum in (0..1000).map(|i| (i * step).min(count - 1)).chain([count - 1]) {
                let (first, edge) = (strata.first(stratum), exact(stratum, count));
                assert_eq!(u64::from(first), edge, "{stratum} of {count}");
                if count <= Strata::SHORT {
                    let up = up_by_halves(stratum, strata.fraction);
                    assert_eq!(up, strata.up_long(stratum), "{stratum} of {count}");
                }
                if stratum < count - 1 {
                    let after = u64::from(strata.after(first));
                    assert_eq!(after, exact(stratum + 1, count), "after {stratum} of {count}");
                }
            }
        }
    }

    /// All edges of the short form's counts whose fractions are closest to failing.
    #[test]
    fn the_longest_short_form_is_exact() {
        for count in (65_500..=Strata::SHORT).chain([46_341, 32_768, 32_769, 54_321]) {
            let strata = Strata::new(count);
            for stratum in 0..count {
                let up = up_by_halves(stratum, strata.fraction);
                let first = stratum.wrapping_mul(strata.whole).wrapping_add(up);
                assert_eq!(u64::from(first), exact(stratum, count), "{stratum} of {count}");
                assert_eq!(strata.first(stratum), first, "{stratum} of {count}");
            }
        }
    }

    #[test]
    fn jitter_stays_in_its_stratum() {
        for count in [1, 2, 3, 7, 10, 300, 65_537, u32::MAX] {
            let strata = Strata::new(count);
            for stratum in [0, count / 2, count - 1] {
                for fraction in [0, 1, 1 << 15, 0xffff] {
                    let k = strata.jittered(strata.first(stratum), fraction);
                    let hit = (u64::from(k) * u64::from(count)) >> 32;
                    assert_eq!(hit, u64::from(stratum), "{stratum} of {count}, {fraction:#x}");
                    let [upper, lower] = strata.halves.map(u32::from);
                    let by_halves = fraction * upper + ((fraction * lower) >> 16);
                    assert_eq!(k, strata.first(stratum) + by_halves);
                }
            }
        }
    }

    /// One stratum is the whole axis, in 2^16 places.
    #[test]
    fn jitter_of_one_stratum_is_its_fraction() {
        for fraction in [0, 1, 2, 0x8000, 0xffff] {
            let expected = (fraction << 16) - u32::from(fraction > 0);
            assert_eq!(Strata::new(1).jittered(0, fraction), expected);
        }
    }
}
