//! Concentric map (P. Shirley and K. Chiu, "A Low Distortion Map between Disk and Square", 1997).

use super::disc_map;
use core::marker::PhantomData;

/// Squares about the centre of the unit square to circles about the centre of the disc.
///
/// With a = 2u - 1, b = 2v - 1 and |a| >= |b|: r = |a|, phi = pi/4 b/a; else x and y swap. Area
/// ratios are kept and neighbours stay neighbours. u -> !u and v -> !v each negate one component,
/// bit for bit.
///
/// ```
/// use hemidisc::{Concentric, LibmF32, Map};
/// let [x, y] = Concentric::<LibmF32>::new().sample([u32::MAX, 1 << 31]);
/// assert!(x > 0.999 && y > 0.0 && y < 1e-9);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Concentric<A>(PhantomData<A>);

disc_map!(Concentric, concentric, concentric_point, invert_concentric);
