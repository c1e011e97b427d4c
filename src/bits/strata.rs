//! Exact strata of an axis: the unit interval cut into any number of equal parts.
//!
//! Stratum c of n holds the cells k with floor(k n / 2^32) = c, that is from ceil(c 2^32 / n) up to
//! the next edge. Rounding edges down instead would put a point into the stratum below whenever n is
//! not a power of two.

/// `count` equal strata of one axis, `count` >= 1, with a prepared reciprocal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Strata {
    count: u32,
    /// floor(2^32 / count), and 2^32 mod count as a fraction of count in 0.32 fixed point.
    whole: u64,
    rest: u32,
    fraction: u32,
}

impl Strata {
    /// `count` is at least 1: the constructors of sets have checked it.
    pub(crate) const fn new(count: u32) -> Self {
        let count = if count == 0 { 1 } else { count };
        let divisor = count as u64;
        let whole = (1 << 32) / divisor;
        let rest = ((1 << 32) % divisor) as u32;
        let fraction = (((rest as u64) << 32) / divisor) as u32;
        Self { count, whole, rest, fraction }
    }

    pub(crate) const fn count(self) -> u32 {
        self.count
    }

    /// ceil(c 2^32 / count) for c <= count, without a division: the quotient from the reciprocal
    /// is at most one too small, which its remainder shows.
    #[inline(always)]
    pub(crate) const fn edge(self, stratum: u32) -> u64 {
        let quotient = (stratum as u64 * self.fraction as u64) >> 32;
        let remainder = stratum as u64 * self.rest as u64 - quotient * self.count as u64;
        let up = (remainder > 0) as u64 + (remainder > self.count as u64) as u64;
        stratum as u64 * self.whole + quotient + up
    }

    /// The first cell of a stratum; `stratum` < count.
    #[inline(always)]
    pub(crate) const fn first(self, stratum: u32) -> u32 {
        self.edge(stratum) as u32
    }

    /// A cell of the stratum, picked by 32 uniform bits.
    #[inline(always)]
    pub(crate) const fn jittered(self, stratum: u32, bits: u32) -> u32 {
        let first = self.edge(stratum);
        // `count` < 2^32, so the sum does not wrap and no stratum is empty.
        let width = self.edge(stratum + 1) - first;
        (first + ((bits as u64 * width) >> 32)) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(stratum: u32, count: u32) -> u64 {
        ((u128::from(stratum) << 32).div_ceil(u128::from(count))) as u64
    }

    #[test]
    fn edges_are_exact() {
        let large = [65_535, 65_537, 1 << 31, (1 << 31) + 1, u32::MAX - 1, u32::MAX, 3_486_784_401];
        for count in (1..=1500).chain(large) {
            let strata = Strata::new(count);
            let step = (count / 1000).max(1);
            for stratum in (0..=1000).map(|i| (i * step).min(count)).chain([count - 1, count]) {
                assert_eq!(strata.edge(stratum), exact(stratum, count), "{stratum} of {count}");
            }
        }
    }

    #[test]
    fn jitter_stays_in_its_stratum() {
        for count in [1, 2, 3, 7, 10, 300, 65_537, u32::MAX] {
            let strata = Strata::new(count);
            for stratum in [0, count / 2, count - 1] {
                for bits in [0, 1, 1 << 31, u32::MAX] {
                    let k = strata.jittered(stratum, bits);
                    let hit = (u64::from(k) * u64::from(count)) >> 32;
                    assert_eq!(hit, u64::from(stratum), "{stratum} of {count}, {bits:#x}");
                }
            }
        }
    }
}
