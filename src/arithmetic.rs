//! Arithmetics: the number type of the points and the kernels of every map on it.
//!
//! This is the only entry to real numbers. An arithmetic is a type, not a feature that swaps the
//! number type, so a binary may hold and compare several. To bring an f32 or f64 maths library of
//! your own, implement [`Float`]: seven functions give every map.
//!
//! | arithmetic | feature | component | functions |
//! | --- | --- | --- | --- |
//! | `LibmF32` | `libm` | `f32` | `libm`, correctly rounded or within 1 ulp, on any core |
//! | `LibmF64` | `libm` | `f64` | the same in double precision |
//! | [`FastF32`] | always | `f32` | its own polynomials, which become vector code |
//! | `Q15` | `fixed-point` | `Q15` | integers: tables and 16-bit products, for small cores |
//! | `Q15Div` | `fixed-point` | `Q15` | the same, with a division in the concentric map |
//! | `Q31` | `fixed-point` | `Q31` | integers: tables and short series |
//! | `MicromathF32` | `micromath` | `f32` | three digits: `micromath`'s sine and cosine, the rest refined |
//!
//! The plot shows what each costs and how accurate its points are. In each panel the line is the
//! Pareto frontier: no arithmetic beats its marks in both. `docs/accuracy.md` has the figures, and
//! says which arithmetic to use.
//!
#![doc = include_str!("../docs/accuracy/pareto.svg")]

use crate::block::{Block, Lanes};
use crate::error::Error;
use core::fmt::{Debug, Display};
use core::str::FromStr;

#[cfg(feature = "fixed-point")]
mod fixed;
mod float;

macro_rules! modules {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {$(
        #[$cfg]
        mod $file;
        #[$cfg]
        pub use $file::$arithmetic;
    )*};
}
for_each_arithmetic!(modules);

#[cfg(feature = "fixed-point")]
pub use fixed::FixedExponent;
pub use float::{DiscPoint, Float, Real, Root};
pub(crate) use float::{FloatBack, RealKernel, length, vector};

/// A number type and the kernels of all maps on it. Sealed: [`Float`] is the way to bring another
/// library.
///
/// Coordinates are read at the centres of their cells. Every kernel is total: all 2^64 pairs of
/// coordinates give a valid point. For all of them a stored point has x^2 + y^2 <= 1 in exact
/// arithmetic, and a direction has z > 0.
pub trait Arithmetic:
    sealed::Sealed + Copy + Default + Debug + PartialEq + Send + Sync + 'static
{
    /// Its name on command lines and in tables.
    const NAME: &'static str;

    /// Whether densities are per unit of area or of solid angle.
    ///
    /// A number type whose range is too small for that gives them relative to the peak. The peak is
    /// 1 on the square, 1 / pi on the disc, and 1 / (2 pi), 1 / pi and (e + 1) / (2 pi) for the
    /// lobes.
    const ABSOLUTE_DENSITY: bool;

    /// Whether its kernels become no vector code. To store their blocks a component after another
    /// and interleave them takes up to 10 % longer.
    #[doc(hidden)]
    const POINTWISE: bool;

    /// Whether its operations round to its numbers on this target. If not, the build fails where it
    /// is used.
    #[doc(hidden)]
    const ROUNDS: bool = true;

    /// A component of a point, as stored.
    type Real: Copy + Debug + Default + PartialEq + Send + Sync + 'static;

    /// An exponent as the user gives it.
    type Parameter: Copy + Debug + PartialEq + FromStr<Err: Display>;

    /// A point of the disc before it is rounded, with r^2 and 1 - r^2 formed from the coordinates
    /// without cancellation, which the lobes need.
    #[doc(hidden)]
    type Disc: Copy + Debug;

    /// A checked exponent, with precomputed values for its kernels.
    #[doc(hidden)]
    type Exponent: Copy + Debug + PartialEq + Send + Sync + 'static + Into<BackExponent<Self>>;

    /// Inverses and densities, which may be another arithmetic's: they are not for the inner loop.
    #[doc(hidden)]
    type Back: Back<Real = Self::Real>;

    /// The unit square itself, each component in [0, 1), rounded toward zero.
    #[doc(hidden)]
    fn square(uv: [u32; 2]) -> [Self::Real; 2];

    /// The square [-1, 1]^2 that rejection draws from, x = 2u - 1, y = 2v - 1, for coordinates
    /// inside the disc.
    #[doc(hidden)]
    fn centred(uv: [u32; 2]) -> [Self::Real; 2];

    /// The concentric map.
    #[doc(hidden)]
    fn concentric(uv: [u32; 2]) -> Self::Disc;

    /// The polar map: u is the angle, v is r^2.
    #[doc(hidden)]
    fn polar(uv: [u32; 2]) -> Self::Disc;

    /// [`concentric`](Self::concentric) as a lane of a block: in the form that becomes vector code.
    #[must_use]
    #[doc(hidden)]
    #[inline(always)]
    fn concentric_lane(uv: [u32; 2]) -> Self::Disc {
        Self::concentric(uv)
    }

    /// [`polar`](Self::polar) as a lane of a block.
    #[must_use]
    #[doc(hidden)]
    #[inline(always)]
    fn polar_lane(uv: [u32; 2]) -> Self::Disc {
        Self::polar(uv)
    }

    /// Rounds a point of the disc to the stored type, inward where it would leave the disc.
    #[doc(hidden)]
    fn store(disc: Self::Disc) -> [Self::Real; 2];

    /// The concentric map's point, stored. Separate from [`concentric`](Self::concentric), because
    /// the compiler does not always remove an unused r^2.
    #[must_use]
    #[doc(hidden)]
    #[inline(always)]
    fn concentric_point(uv: [u32; 2]) -> [Self::Real; 2] {
        Self::store(Self::concentric(uv))
    }

    /// The polar map's point, stored.
    #[must_use]
    #[doc(hidden)]
    #[inline(always)]
    fn polar_point(uv: [u32; 2]) -> [Self::Real; 2] {
        Self::store(Self::polar(uv))
    }

    /// Lifts to the uniform hemisphere: z = 1 - r^2.
    #[doc(hidden)]
    fn uniform(disc: Self::Disc) -> [Self::Real; 3];

    /// Lifts to the cosine hemisphere: z = sqrt(1 - r^2).
    #[doc(hidden)]
    fn cosine(disc: Self::Disc) -> [Self::Real; 3];

    /// Checks and prepares an exponent.
    ///
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1. In fixed point every
    /// value of the type is valid.
    #[doc(hidden)]
    fn exponent(parameter: Self::Parameter) -> Result<Self::Exponent, Error>;

    /// The exponent as the user gave it.
    #[doc(hidden)]
    fn given(exponent: Self::Exponent) -> Self::Parameter;

    /// Lifts to the cosine-power hemisphere: z = (1 - r^2)^(1 / (e + 1)).
    #[doc(hidden)]
    fn power(exponent: Self::Exponent, disc: Self::Disc) -> [Self::Real; 3];

    /// [`power`](Self::power), and the density of the direction: where both 1 - r^2 and z are at
    /// hand, z^e = (1 - r^2) / z needs no second power.
    #[doc(hidden)]
    #[inline]
    fn power_with_density(
        exponent: Self::Exponent,
        disc: Self::Disc,
    ) -> ([Self::Real; 3], Self::Real) {
        let direction = Self::power(exponent, disc);
        (direction, Self::Back::power_density(exponent.into(), direction))
    }

    /// The points of a disc map over a block.
    #[doc(hidden)]
    #[inline(always)]
    fn disc_block<D: KernelOf<Self>, const N: usize>(
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<Self::Real, N>; 2],
    ) {
        point_by_point!(u, v, out, uv => D::point(uv));
    }

    /// [`uniform`](Self::uniform) over a block of points of a disc map.
    #[doc(hidden)]
    #[inline(always)]
    fn uniform_block<D: KernelOf<Self>, const N: usize>(
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<Self::Real, N>; 3],
    ) {
        point_by_point!(u, v, out, uv => Self::uniform(D::disc(uv)));
    }

    /// [`cosine`](Self::cosine) over a block of points of a disc map.
    #[doc(hidden)]
    #[inline(always)]
    fn cosine_block<D: KernelOf<Self>, const N: usize>(
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<Self::Real, N>; 3],
    ) {
        point_by_point!(u, v, out, uv => Self::cosine(D::disc(uv)));
    }

    /// [`power`](Self::power) over a block of points of a disc map.
    #[doc(hidden)]
    #[inline(always)]
    fn power_block<D: KernelOf<Self>, const N: usize>(
        exponent: Self::Exponent,
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<Self::Real, N>; 3],
    ) {
        point_by_point!(u, v, out, uv => Self::power(exponent, D::disc(uv)));
    }
}

/// Fills a block point by point, each component into its lanes. A macro, because a closure would
/// hide a long kernel from the inliner.
macro_rules! point_by_point {
    ($u:ident, $v:ident, $out:ident, $uv:ident => $point:expr) => {
        for (lane, (u, v)) in $u.iter().zip($v).enumerate() {
            let $uv = [*u, *v];
            for (lanes, value) in $out.iter_mut().zip($point) {
                lanes[lane] = value;
            }
        }
    };
}
use point_by_point;

/// The exponent as the inverses and densities of an arithmetic take it.
#[doc(hidden)]
pub type BackExponent<A> = <<A as Arithmetic>::Back as Back>::Exponent;

/// The way back on a number type: inverses and densities of all maps.
#[doc(hidden)]
pub trait Back {
    /// A component of a point, as stored.
    type Real: Copy;
    /// The input of the inverses: an unnormalised direction, and r^2.
    type Lowered: Copy;
    /// A checked exponent.
    type Exponent: Copy;

    /// A stored point of the disc.
    fn lower_disc(point: [Self::Real; 2]) -> Self::Lowered;
    /// The disc point of a direction of the uniform hemisphere.
    fn lower_uniform(direction: [Self::Real; 3]) -> Self::Lowered;
    /// The disc point of a direction of the cosine hemisphere.
    fn lower_cosine(direction: [Self::Real; 3]) -> Self::Lowered;
    /// The disc point of a direction of the power hemisphere.
    fn lower_power(exponent: Self::Exponent, direction: [Self::Real; 3]) -> Self::Lowered;

    /// The cells of a point of the unit square.
    fn invert_square(point: [Self::Real; 2]) -> [u32; 2];
    /// The cells of a point of [-1, 1]^2.
    fn invert_centred(point: [Self::Real; 2]) -> [u32; 2];
    /// The cells that the concentric map sends to a disc point.
    fn invert_concentric(lowered: Self::Lowered) -> [u32; 2];
    /// The cells that the polar map sends to a disc point.
    fn invert_polar(lowered: Self::Lowered) -> [u32; 2];

    /// Density over the unit square, per unit of area.
    fn square_density(point: [Self::Real; 2]) -> Self::Real;
    /// Density over the disc, per unit of area: 1 / pi, and 0 outside.
    fn disc_density(point: [Self::Real; 2]) -> Self::Real;
    /// Density over directions, per steradian: 1 / (2 pi), and 0 below the horizon.
    fn uniform_density(direction: [Self::Real; 3]) -> Self::Real;
    /// Density over directions, per steradian: z / pi, and 0 below the horizon.
    fn cosine_density(direction: [Self::Real; 3]) -> Self::Real;
    /// Density over directions, per steradian: (e + 1) z^e / (2 pi), and 0 below the horizon.
    fn power_density(exponent: Self::Exponent, direction: [Self::Real; 3]) -> Self::Real;

    /// [`power_density`](Self::power_density) of a direction at a height z, to be added to that of
    /// another one, whose x^2 + y^2 is less by `growth`: 0 where that is known to be less than a
    /// rounding error of the sum.
    #[inline]
    fn power_density_beside(
        exponent: Self::Exponent,
        _growth_and_z: [Self::Real; 2],
        direction: impl FnOnce() -> [Self::Real; 3],
    ) -> Self::Real {
        Self::power_density(exponent, direction())
    }
}

/// The kernel of a disc map, without a value: a disc map has no parameter.
#[doc(hidden)]
pub trait DiscKernel {
    /// A component of a point, as stored.
    type Real;
    /// A point before it is rounded.
    type Disc;

    /// The point before rounding.
    fn disc(uv: [u32; 2]) -> Self::Disc;

    /// The same as a lane of a block.
    fn lane(uv: [u32; 2]) -> Self::Disc;

    /// The point as it is stored.
    fn point(uv: [u32; 2]) -> [Self::Real; 2];
}

/// A disc kernel of an arithmetic.
#[doc(hidden)]
pub trait KernelOf<A: Arithmetic>: DiscKernel<Real = A::Real, Disc = A::Disc> {}
impl<A: Arithmetic, D: DiscKernel<Real = A::Real, Disc = A::Disc>> KernelOf<A> for D {}

/// Fails the build where an arithmetic would give other bits on this target than elsewhere.
#[inline(always)]
pub(crate) const fn assert_rounds<A: Arithmetic>() {
    const {
        assert!(
            A::ROUNDS,
            "x86 without SSE2 computes floats in registers of 80 bits, so points would differ from \
             those of other machines: build with `-C target-feature=+sse2`, or take Q15 or Q31"
        );
    }
}

mod sealed {
    /// What seals [`Arithmetic`](super::Arithmetic).
    pub trait Sealed {}
}
