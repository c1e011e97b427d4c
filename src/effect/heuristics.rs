//! Multiple importance sampling: the weight of a sample that another strategy could have drawn
//! (E. Veach and L. Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering",
//! SIGGRAPH 1995).
//!
//! A sample of density p, where the other strategy has density q for the same direction, counts
//! p / (p + q) by the balance heuristic and p^2 / (p^2 + q^2) by the power heuristic. Both are
//! formed from the ratio of the smaller to the larger density, so no square overflows.
//!
//! A strategy that no other can take the place of, such as a light of radius 0, is a delta
//! distribution: its samples count 1. Its density here is the largest number, and says nothing.

use crate::arithmetic::Real;

/// The balance heuristic, p / (p + q), in [0, 1]: the share of a sample of density `density`, where
/// the other strategy has density `other` for the same direction.
///
/// It is 1 for a sample of a delta distribution, which the effects' `is_delta` tells, and 0 for a
/// density that is not above 0. A density above MAX counts as MAX, and an `other` that is not above
/// 0 as 0, so the result is never NaN. Where a strategy draws several samples, its density is
/// multiplied by their number.
///
/// ```
/// use hemidisc::{Frame, LibmF32, Unit, effect::*};
/// let lamp = DiscLight::<LibmF32>::new([0.0, 2.0, 0.0], Frame::new([0.0, -1.0, 0.0])?, 0.5)?;
/// let gloss = Glossy::<LibmF32>::new(50.0, BelowHorizon::Zero)?;
/// let (down, up) = (Unit::new([0.6, -0.8, 0.0])?, Unit::new([0.0, 1.0, 0.0])?);
/// // Of the light's sample, and of the lobe's.
/// let light = lamp.sample([0.0; 3], [1 << 30, 1 << 31]);
/// let lobe = gloss.density(down, up, light.direction);
/// let share = balance_heuristic(light.density, lamp.is_delta(), lobe);
/// let others = balance_heuristic(lobe, gloss.is_delta(), light.density);
/// assert!((share + others - 1.0).abs() < 1e-6);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[must_use]
#[inline]
pub fn balance_heuristic<R: Real>(density: R, is_delta: bool, other: R) -> R {
    share(density, is_delta, other, |ratio| ratio)
}

/// The power heuristic, p^2 / (p^2 + q^2), in [0, 1]: as [`balance_heuristic`], and with less
/// variance where one of the strategies is much the better.
#[must_use]
#[inline]
pub fn power_heuristic<R: Real>(density: R, is_delta: bool, other: R) -> R {
    share(density, is_delta, other, |ratio| ratio * ratio)
}

/// f(p) / (f(p) + f(q)) for an f with f(p) / f(q) = f(p / q), of ratios in [0, 1].
#[inline]
fn share<R: Real>(density: R, is_delta: bool, other: R, f: impl Fn(R) -> R) -> R {
    let at_most_max = |x: R| if x < R::MAX { x } else { R::MAX };
    if is_delta {
        R::ONE
    } else if density > R::ZERO {
        if other > R::ZERO {
            let (p, q) = (at_most_max(density), at_most_max(other));
            if q < p {
                R::ONE / (R::ONE + f(q / p))
            } else {
                let ratio = f(p / q);
                ratio / (R::ONE + ratio)
            }
        } else {
            R::ONE
        }
    } else {
        R::ZERO
    }
}
