//! The public view of a point of the disc, for lobes of one's own.

use super::disc::sorted;
use super::real::Real;

/// A point of the disc as a lobe lifts it: its direction, r^2 and 1 - r^2.
///
/// r^2 and 1 - r^2 are formed from the coordinates, each without cancellation, and both are above
/// 0. Made by [`DiscMap::disc_point`](crate::disc::DiscMap::disc_point).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiscPoint<R> {
    pub(in crate::arithmetic) direction: [R; 2],
    pub(in crate::arithmetic) r2: R,
    pub(in crate::arithmetic) one_minus_r2: R,
}

impl<R: Real> DiscPoint<R> {
    /// (cos phi, sin phi), within the arithmetic's error of a length of 1.
    #[inline]
    pub const fn direction(&self) -> [R; 2] {
        self.direction
    }

    /// r^2, in (0, 1].
    #[inline]
    pub const fn r2(&self) -> R {
        self.r2
    }

    /// 1 - r^2, in (0, 1].
    #[inline]
    pub const fn one_minus_r2(&self) -> R {
        self.one_minus_r2
    }

    /// x and y in this direction at a distance in [0, 1] from the axis: sin theta for a direction
    /// of the sphere. Rounded inward, so that x^2 + y^2 <= 1 in exact arithmetic.
    #[inline]
    pub fn at(&self, distance: R) -> [R; 2] {
        let [x, y] = self.direction.map(|component| component * distance);
        let (mut a, mut b) = sorted(x.magnitude(), y.magnitude());
        let square = a * a + b * b;
        let slack = R::EPSILON * R::FOUR;
        if square <= R::ONE - slack {
            return [x, y];
        }
        if square > R::ONE + slack {
            // A coarse sine and cosine may be off by more than rounding.
            (a, b) = (a / square, b / square);
        }
        while R::outside(a, b) {
            a = a.below();
        }
        let [a, b] = if y.magnitude() > x.magnitude() { [b, a] } else { [a, b] };
        [a.with_sign(x), b.with_sign(y)]
    }
}
