//! Coordinates: a point of the unit square as two `u32` cells.
//!
//! A coordinate `k` is the cell [k, k+1) / 2^32 of one axis, read at its centre (2k + 1) / 2^33.
//! Every bit pattern is valid; 0, 1 and the centre 1/2 never occur, so no map meets 0/0 or the rim.

use crate::error::{Axis, Error};

/// A point of the unit square: two `u32` cells, read at their centres.
///
/// Sequences give `[u32; 2]` and maps take it; this newtype is the checked way in for coordinates
/// that start as floats, and the way out to floats.
///
/// ```
/// use hemidisc::Coordinates;
/// let cell = Coordinates::try_from([0.25_f32, 0.5])?;
/// assert_eq!(cell, Coordinates([0x4000_0000, 0x8000_0000]));
/// assert_eq!(cell.to_f32(), [0.25, 0.5]);
/// let error = Coordinates::try_from([0.25_f64, 1.0]).unwrap_err();
/// assert_eq!(error.to_string(), "coordinate v is 1; accepted: 0 <= v < 1");
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coordinates(pub [u32; 2]);

impl Coordinates {
    /// The centres of the two cells, each in (0, 1), rounded toward zero to 24 bits.
    #[must_use]
    #[inline]
    pub fn to_f32(self) -> [f32; 2] {
        self.0.map(centre_f32)
    }

    /// The centres of the two cells, each in (0, 1), exactly.
    #[must_use]
    #[inline]
    pub fn to_f64(self) -> [f64; 2] {
        self.0.map(centre_f64)
    }
}

/// (2k + 1) / 2^33 toward zero: the top 24 significant bits, and the half where it still fits.
#[inline]
pub(crate) fn centre_f32(k: u32) -> f32 {
    const SCALE: f32 = 1.0 / 4_294_967_296.0;
    let significant = k & (0xffff_ff00 >> k.leading_zeros().min(8));
    let half = if k < 1 << 23 { 0.5 } else { 0.0 };
    (significant as f32 + half) * SCALE
}

/// (2k + 1) / 2^33, which 53 bits hold exactly.
#[inline]
pub(crate) fn centre_f64(k: u32) -> f64 {
    const SCALE: f64 = 1.0 / 4_294_967_296.0;
    (f64::from(k) + 0.5) * SCALE
}

/// The magnitude m of a coordinate about the centre, 2u - 1 = +-(2m + 1) / 2^32, and its sign: 0,
/// or -1 where it is negative.
#[inline(always)]
pub(crate) const fn fold(k: u32) -> (u32, i32) {
    let j = (k ^ 0x8000_0000).cast_signed();
    let sign = j >> 31;
    ((j ^ sign).cast_unsigned(), sign)
}

/// The angle 2 pi u folded to an octant, each mask all ones or 0.
#[derive(Clone, Copy)]
pub(crate) struct Angle {
    /// Whether y is negative.
    pub(crate) below: u32,
    /// Whether x is negative.
    pub(crate) left: u32,
    /// Whether x and y swap places.
    pub(crate) steep: u32,
    /// The cell within the octant, of 29 bits.
    pub(crate) within: u32,
}

/// Folds an angle: u and !u are mirror images in the x axis, so they fold before anything is
/// rounded.
#[inline(always)]
pub(crate) const fn fold_angle(u: u32) -> Angle {
    let Quarter { below, left, quarter } = fold_to_quarter(u);
    let steep = ((quarter << 2).cast_signed() >> 31).cast_unsigned();
    Angle { below, left, steep, within: quarter ^ steep >> 2 }
}

/// The angle 2 pi u folded to a quarter turn, each mask all ones or 0.
#[derive(Clone, Copy)]
pub(crate) struct Quarter {
    /// Whether y is negative.
    pub(crate) below: u32,
    /// Whether x is negative.
    pub(crate) left: u32,
    /// The cell within the quarter, of 30 bits; the highest says which octant.
    pub(crate) quarter: u32,
}

/// Folds an angle, but not to an octant: for what branches there.
#[inline(always)]
pub(crate) const fn fold_to_quarter(u: u32) -> Quarter {
    let below = (u.cast_signed() >> 31).cast_unsigned();
    // 31 bits of a half turn: the quarter, the octant in it, 29 bits within.
    let half = u ^ below;
    let left = ((half << 1).cast_signed() >> 31).cast_unsigned();
    Quarter { below, left, quarter: half ^ left >> 1 }
}

/// The cell of `value`; the multiplication by a power of two is exact, the cast rounds down.
macro_rules! checked_cells {
    ($float:ty) => {
        impl TryFrom<[$float; 2]> for Coordinates {
            type Error = Error;

            /// The cells that hold the two values: floor(2^32 value).
            ///
            /// # Errors
            /// [`Error::Coordinate`] for a value that is NaN, infinite, below 0, or 1 and above.
            #[inline]
            fn try_from(values: [$float; 2]) -> Result<Self, Error> {
                let mut cells = [0; 2];
                for (axis, (cell, value)) in
                    [Axis::U, Axis::V].into_iter().zip(cells.iter_mut().zip(values))
                {
                    if !(0.0..1.0).contains(&value) {
                        return Err(Error::Coordinate { axis, value: value.into() });
                    }
                    *cell = (value * 4_294_967_296.0) as u32;
                }
                Ok(Self(cells))
            }
        }
    };
}
checked_cells!(f32);
checked_cells!(f64);

impl From<Coordinates> for [u32; 2] {
    #[inline]
    fn from(coordinates: Coordinates) -> Self {
        coordinates.0
    }
}

impl From<[u32; 2]> for Coordinates {
    #[inline]
    fn from(cells: [u32; 2]) -> Self {
        Self(cells)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn f32_rounds_toward_zero() {
        let edges = (0..32).flat_map(|b| {
            let p = 1_u32 << b;
            [p.wrapping_sub(2), p - 1, p, p + 1, p | p >> 24, p | p >> 25, p.wrapping_neg()]
        });
        for k in edges.chain([0, u32::MAX]) {
            let (exact, got) = (centre_f64(k), centre_f32(k));
            assert!(f64::from(got) <= exact, "{k:#x}: {got:e} above {exact:e}");
            let above = f32::from_bits(got.to_bits() + 1);
            assert!(f64::from(above) > exact, "{k:#x}: {got:e} is not the nearest below");
        }
        assert!(centre_f32(u32::MAX) < 1.0 && centre_f32(0) > 0.0);
    }

    #[test]
    fn conversions_are_checked() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1e-45, 1.0, 2.0] {
            for at in [0, 1] {
                let mut pair = [0.5, 0.5];
                pair[at] = bad;
                assert!(Coordinates::try_from(pair).is_err(), "{bad} accepted");
                assert!(Coordinates::try_from(pair.map(f64::from)).is_err(), "{bad} accepted");
            }
        }
        let top = 1.0 - f64::EPSILON / 2.0;
        assert_eq!(Coordinates::try_from([0.0, top]), Ok(Coordinates([0, u32::MAX])));
        assert_eq!(Coordinates::try_from([-0.0_f32, f32::MIN_POSITIVE]), Ok(Coordinates([0, 0])));
    }

    #[test]
    fn cells_survive_a_round_trip() {
        for k in [0, 1, 2, 0x7fff_ffff, 0x8000_0000, u32::MAX, 0x1234_5678] {
            assert_eq!(
                Coordinates::try_from(Coordinates([k, !k]).to_f64()),
                Ok(Coordinates([k, !k]))
            );
        }
    }
}
