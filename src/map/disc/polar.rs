//! Polar map: u is the angle, v the squared radius.

use super::disc_map;
use core::marker::PhantomData;

/// r = sqrt v, phi = 2 pi u: the textbook's map, which keeps area ratios but not neighbours.
///
/// The edges u = 0 and u = 1 meet in a seam along the positive x axis, and v = 0 shrinks to the
/// centre. u -> !u negates y, bit for bit. With r = v instead of sqrt v the points crowd at the
/// centre.
///
/// ```
/// use hemidisc::{LibmF32, Map, Polar};
/// let [x, y] = Polar::<LibmF32>::new().sample([1 << 30, 1 << 30]);
/// assert!(x.abs() < 1e-9 && (y - 0.5).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Polar<A>(PhantomData<A>);

disc_map!(Polar, polar, polar_point, invert_polar);
