//! A choice by weights: sums of integers or of floats.

use crate::target::where_floats_round;

/// A sum of weights: `u32`, `f32` or `f64`. Sealed.
pub trait Weight: Copy + sealed::Sealed {
    /// The choice that a cell makes, and where it is within the choice.
    #[doc(hidden)]
    fn pick(sums: &[Self], cell: u32) -> Option<(usize, u32)>;
}

impl sealed::Sealed for u32 {}

impl Weight for u32 {
    /// Exact: a choice has the cells whose product with the total begins within it.
    #[inline]
    fn pick(sums: &[Self], cell: u32) -> Option<(usize, u32)> {
        let total = *sums.last()?;
        let product = u64::from(cell) * u64::from(total);
        let chosen = sums.partition_point(|sum| u64::from(*sum) << 32 <= product);
        let end = *sums.get(chosen)?;
        let start = chosen.checked_sub(1).map_or(0, |before| sums[before]);
        // 0 if the sums decrease here, which they must not.
        let weight = u64::from(end.saturating_sub(start));
        let rest = product.saturating_sub(u64::from(start) << 32).checked_div(weight)?;
        Some((chosen, rest as u32))
    }
}

macro_rules! floats {
    ($($float:ident)*) => {$(
        impl sealed::Sealed for $float {}

        impl Weight for $float {
            /// In `f64`, which holds a cell with 21 bits to spare: a share is off by less than
            /// 2^-32 of the total.
            #[inline]
            fn pick(sums: &[Self], cell: u32) -> Option<(usize, u32)> {
                let total = f64::from(*sums.last()?);
                if !(total > 0.0 && total < f64::INFINITY) {
                    return None;
                }
                let at = f64::from(cell) * (1.0 / 4_294_967_296.0) * total;
                let chosen = sums.partition_point(|sum| f64::from(*sum) <= at);
                let end = f64::from(*sums.get(chosen)?);
                let start = chosen.checked_sub(1).map_or(0.0, |before| f64::from(sums[before]));
                // A cast of more than the greatest cell gives that, and of NaN 0.
                let rest = (at - start) / (end - start) * 4_294_967_296.0;
                Some((chosen, rest as u32))
            }
        }
    )*};
}

where_floats_round! {
    floats! { f32 f64 }
}

mod sealed {
    pub trait Sealed {}
}

#[cfg(test)]
mod tests {
    use super::Weight;

    #[test]
    fn integer_weights_are_exact() {
        let sums = [3, 3, 4, 9];
        let mut counts = [0_u64; 4];
        for cell in (0..1 << 20).map(|i: u32| i << 12) {
            let (chosen, rest) = u32::pick(&sums, cell).unwrap();
            counts[chosen] += 1;
            let (start, weight) = ([0, 3, 3, 4][chosen], [3, 0, 1, 5][chosen]);
            // The place within the choice leads back to the cell.
            let place = (u64::from(rest) * weight + (start << 32)) / 9;
            assert!(place.abs_diff(u64::from(cell)) <= 1, "{cell:#x}: {chosen}, {rest:#x}");
        }
        for (count, weight) in counts.into_iter().zip([3, 0, 1, 5]) {
            assert!(count.abs_diff((weight << 20) / 9) <= 1, "{counts:?}");
        }
    }

    #[test]
    fn no_sums_panic() {
        let hard = [0.0, 1.0, -1.0, 0.5, f32::NAN, f32::INFINITY, f32::MAX, f32::MIN_POSITIVE];
        let cells = [0, 1, 1 << 31, u32::MAX];
        for (a, b) in hard.into_iter().flat_map(|a| hard.map(|b| (a, b))) {
            for (c, cell) in hard.into_iter().flat_map(|c| cells.map(|cell| (c, cell))) {
                if let Some((chosen, _)) = f32::pick(&[a, b, c], cell) {
                    assert!(chosen < 3);
                }
                let [a, b, c] = [a, b, c].map(|sum| sum as u32);
                if let Some((chosen, _)) = u32::pick(&[a, b, c], cell) {
                    assert!(chosen < 3);
                }
            }
        }
        assert_eq!(f64::pick(&[], 5), None);
        assert_eq!(u32::pick(&[], 5), None);
        assert_eq!(u32::pick(&[0, 0], 5), None);
        assert_eq!(f32::pick(&[0.0], 5), None);
        assert_eq!(u32::pick(&[0, u32::MAX, u32::MAX], u32::MAX), Some((1, u32::MAX)));
    }
}
