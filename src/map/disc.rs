//! Maps onto the unit disc: density 1 / pi per unit of area.

mod rejection;

pub use crate::arithmetic::DiscPoint;
pub use rejection::Rejection;

use super::{Invert, sealed::Sealed};
use crate::arithmetic::{Arithmetic, Back, KernelOf, Root};
use core::marker::PhantomData;

/// A one-to-one map onto the disc, which a lobe can lift to the hemisphere. Sealed.
///
/// A lobe of your own is a [`Map`](crate::Map) over any disc map: it takes r^2 and 1 - r^2 from
/// [`disc_point`](Self::disc_point), forms the angle to the axis, and places x and y with
/// [`DiscPoint::at`]. `examples/lobe` of the repository has Beckmann's distribution.
pub trait DiscMap:
    Invert<Point = [<Self::Arithmetic as Arithmetic>::Real; 2]> + KernelOf<Self::Arithmetic> + Sealed
{
    /// The arithmetic it computes in.
    type Arithmetic: Arithmetic;

    /// The point of a pair of coordinates, before it is rounded.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, disc::DiscMap};
    /// let point = Concentric::<LibmF32>::new().disc_point([1 << 31, 0]);
    /// // At the rim the coordinates know 1 - r^2 where r has rounded to 1.
    /// assert_eq!(point.r2(), 1.0);
    /// assert!(point.one_minus_r2() > 4e-10);
    /// ```
    #[must_use]
    #[inline(always)]
    fn disc_point(&self, uv: [u32; 2]) -> DiscPoint<<Self::Arithmetic as Arithmetic>::Real>
    where
        Self::Arithmetic: Root,
    {
        Self::Arithmetic::disc_point(Self::disc(uv))
    }

    /// The coordinates of a point given by its direction and r^2.
    #[doc(hidden)]
    fn invert_lowered(lowered: LoweredOf<Self::Arithmetic>) -> [u32; 2];
}

/// The input of an arithmetic's inverses.
#[doc(hidden)]
pub type LoweredOf<A> = <<A as Arithmetic>::Back as Back>::Lowered;

/// r = sqrt v, phi = 2 pi u: the textbook's map, which keeps area ratios but not neighbours.
///
/// The edges u = 0 and u = 1 meet in a seam along the positive x axis, and v = 0 shrinks to the
/// centre. u -> !u negates y, bit for bit. With r = v instead of sqrt v the points crowd at the
/// centre.
///
/// ```
/// use hemidisc::{LibmF32, Polar};
/// let [x, y] = Polar::<LibmF32>::new().sample([1 << 30, 1 << 30]);
/// assert!(x.abs() < 1e-9 && (y - 0.5).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Polar<A>(PhantomData<A>);

/// The concentric map (P. Shirley and K. Chiu, "A Low Distortion Map between Disk and Square",
/// 1997): squares about the centre of the unit square to circles about the centre of the disc.
///
/// With a = 2u - 1, b = 2v - 1 and |a| >= |b|: r = |a|, phi = pi/4 b/a; else x and y swap. Area
/// ratios are kept and neighbours stay neighbours. u -> !u and v -> !v each negate one component,
/// bit for bit.
///
/// ```
/// use hemidisc::{Concentric, LibmF32};
/// let [x, y] = Concentric::<LibmF32>::new().sample([u32::MAX, 1 << 31]);
/// assert!(x > 0.999 && y > 0.0 && y < 1e-9);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Concentric<A>(PhantomData<A>);

/// A disc map whose kernels are the arithmetic's functions of the same names.
macro_rules! disc_map {
    ($map:ident, $kernel:ident, $lane:ident, $point:ident, $invert:ident) => {
        impl<A> $map<A> {
            /// The map; it has no parameters.
            #[must_use]
            pub const fn new() -> Self {
                Self(core::marker::PhantomData)
            }
        }

        const _: () = {
            use $crate::arithmetic::{Arithmetic, Back, DiscKernel, assert_rounds};
            use $crate::block::{Block, Lanes};
            use $crate::map::disc::{DiscMap, LoweredOf};
            use $crate::map::{Density, Invert, Map, sealed::Sealed};

            impl<A: Arithmetic> Map for $map<A> {
                type Point = [A::Real; 2];

                const POINTWISE: bool = A::POINTWISE;

                #[inline(always)]
                fn sample(&self, uv: [u32; 2]) -> [A::Real; 2] {
                    assert_rounds::<A>();
                    A::$point(uv)
                }

                #[inline(always)]
                fn sample_block<const N: usize>(
                    &self,
                    u: &Block<N>,
                    v: &Block<N>,
                    out: &mut [Lanes<A::Real, N>; 2],
                ) {
                    assert_rounds::<A>();
                    A::disc_block::<Self, N>(u, v, out);
                }
            }

            impl<A: Arithmetic> Density for $map<A> {
                #[inline]
                fn density(&self, point: [A::Real; 2]) -> A::Real {
                    assert_rounds::<A>();
                    A::Back::disc_density(point)
                }
            }

            impl<A: Arithmetic> Invert for $map<A> {
                #[inline]
                fn invert(&self, point: [A::Real; 2]) -> [u32; 2] {
                    assert_rounds::<A>();
                    A::Back::$invert(A::Back::lower_disc(point))
                }
            }

            impl<A: Arithmetic> DiscKernel for $map<A> {
                type Real = A::Real;
                type Disc = A::Disc;

                #[inline(always)]
                fn disc(uv: [u32; 2]) -> A::Disc {
                    assert_rounds::<A>();
                    A::$kernel(uv)
                }

                #[inline(always)]
                fn lane(uv: [u32; 2]) -> A::Disc {
                    assert_rounds::<A>();
                    A::$lane(uv)
                }

                #[inline(always)]
                fn point(uv: [u32; 2]) -> [A::Real; 2] {
                    assert_rounds::<A>();
                    A::$point(uv)
                }
            }

            impl<A: Arithmetic> Sealed for $map<A> {}

            impl<A: Arithmetic> DiscMap for $map<A> {
                type Arithmetic = A;

                #[inline]
                fn invert_lowered(lowered: LoweredOf<A>) -> [u32; 2] {
                    assert_rounds::<A>();
                    A::Back::$invert(lowered)
                }
            }

    $crate::map::sampled!([A: Arithmetic] $map<A>, [A::Real; 2]);
        };
    };
}
disc_map!(Polar, polar, polar_lane, polar_point, invert_polar);
disc_map!(Concentric, concentric, concentric_lane, concentric_point, invert_concentric);
