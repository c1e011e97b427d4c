//! Arithmetics: the number type of the points and the kernels of every map on it.
//!
//! This is the only entry to real numbers. An arithmetic is a zero-sized type, so a binary may hold
//! and compare several. To bring an f32 or f64 maths library of your own, implement [`Float`]: seven
//! functions give every map. To bring a number type of your own, implement [`Arithmetic`].
//!
//! | arithmetic | feature | slot | functions |
//! | --- | --- | --- | --- |
//! | `LibmF32` | `libm` | `f32` | `libm`, correctly rounded or within 1 ulp, on any core |
//! | `LibmF64` | `libm` | `f64` | the same in double precision |
//! | [`FastF32`] | always | `f32` | its own polynomials, which become vector code |
//! | `Q15` | `fixed-point` | `Q15` | integers alone: tables and 16-bit products, for small cores |
//! | `Q15Div` | `fixed-point` | `Q15` | the same, with a division and no table in the concentric map |
//! | `Q31` | `fixed-point` | `Q31` | integers alone: tables and short series, the same bytes on any core |
//! | `MicromathF32` | `micromath` | `f32` | three digits: `micromath`'s sine and cosine, the rest refined |
//!
//! What each costs, and what its points are good to: of a panel's marks, those on the line are not beaten by another
//! in both. `docs/accuracy.md` has the figures, and says which to use.
//!
#![doc = include_str!("../docs/accuracy/pareto.svg")]

use crate::error::Error;
use crate::map::DiscMap;
use crate::sequence::{BLOCK, Block};
use core::fmt::{Debug, Display};
use core::str::FromStr;

mod fast_f32;
#[cfg(feature = "fixed-point")]
mod fixed;
pub(crate) mod float;
#[cfg(feature = "libm")]
mod libm_f32;
#[cfg(feature = "libm")]
mod libm_f64;
#[cfg(feature = "micromath")]
mod micromath_f32;
#[cfg(feature = "fixed-point")]
mod q15;
#[cfg(feature = "fixed-point")]
mod q15_div;
#[cfg(feature = "fixed-point")]
mod q31;

pub use fast_f32::{FastDisc, FastExponent, FastF32};
#[cfg(feature = "fixed-point")]
pub use fixed::{FixedExponent, Q15, Q31};
pub use float::{Float, FloatDisc, PowerExponent, Real, Root};
#[cfg(feature = "libm")]
pub use libm_f32::LibmF32;
#[cfg(feature = "libm")]
pub use libm_f64::LibmF64;
#[cfg(feature = "micromath")]
pub use micromath_f32::MicromathF32;
#[cfg(feature = "fixed-point")]
pub use q15::{Q15Disc, Q15Exponent};
#[cfg(feature = "fixed-point")]
pub use q15_div::Q15Div;
#[cfg(feature = "fixed-point")]
pub use q31::{Q31Disc, Q31Exponent};

/// Fills a block a point at a time. A component is stored at a time, which LLVM likes better than an array; and
/// this is a macro, for a closure would hide a long kernel from the inliner.
macro_rules! point_by_point {
    ($u:ident, $v:ident, $out:ident, $uv:ident => $point:expr) => {
        for (slot, (u, v)) in $out.iter_mut().zip($u.iter().zip($v)) {
            let $uv = [*u, *v];
            for (component, value) in slot.iter_mut().zip($point) {
                *component = value;
            }
        }
    };
}
pub(crate) use point_by_point;

/// A number type and the kernels of all maps on it.
///
/// Coordinates are read at the centres of their cells. Every kernel is total: all 2^64 pairs of
/// coordinates give a valid point. `RIM` asks a disc kernel for r^2 and 1 - r^2, which only the lobes
/// use; an unused one is not always removed by the compiler.
///
/// Promises of an implementation, for all inputs: a stored point has x^2 + y^2 <= 1 in exact
/// arithmetic; a direction has z > 0; a density is positive at every sampled point, and finite.
pub trait Arithmetic: Copy + Default + Debug + PartialEq + Send + Sync + 'static {
    /// Its name on command lines and in tables.
    const NAME: &'static str;

    /// Whether densities are per unit of area or of solid angle. Where a number type has no room for
    /// that they are parts of the peak: 1 on the square, 1 / pi on the disc, 1 / (2 pi), 1 / pi and
    /// (e + 1) / (2 pi) for the lobes.
    const ABSOLUTE_DENSITY: bool;

    /// Whether filling a buffer by blocks of 64 points is faster than one by one. The bits are the
    /// same either way.
    const BLOCKED: bool;

    /// A component of a point, as stored.
    type Real: Copy + Debug + Default + PartialEq + Send + Sync + 'static;
    /// A point of the disc before it is rounded to its slot, with what the lobes need of it: r^2 and
    /// 1 - r^2 formed from the coordinates, without cancellation.
    type Disc: Copy + Debug;
    /// An exponent as the user gives it.
    type Parameter: Copy + Debug + FromStr<Err: Display>;
    /// A checked exponent with what its kernels need prepared.
    type Exponent: Copy + Debug + PartialEq + Send + Sync + 'static;

    /// The unit square itself, each component in [0, 1), rounded toward zero.
    fn square(uv: [u32; 2]) -> [Self::Real; 2];
    /// The square [-1, 1]^2 that rejection draws from, x = 2u - 1, y = 2v - 1, for coordinates inside
    /// the disc.
    fn centred(uv: [u32; 2]) -> [Self::Real; 2];
    /// The concentric map.
    fn concentric<const RIM: bool>(uv: [u32; 2]) -> Self::Disc;
    /// The polar map: u is the angle, v is r^2.
    fn polar<const RIM: bool>(uv: [u32; 2]) -> Self::Disc;
    /// Rounds a point of the disc to its slot, inward where it would leave the disc.
    fn store(disc: Self::Disc) -> [Self::Real; 2];

    /// Lifts to the uniform hemisphere: z = 1 - r^2.
    fn uniform(disc: Self::Disc) -> [Self::Real; 3];
    /// Lifts to the cosine hemisphere: z = sqrt(1 - r^2).
    fn cosine(disc: Self::Disc) -> [Self::Real; 3];
    /// Checks and prepares an exponent.
    ///
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1. In fixed point every value of
    /// the type is valid.
    fn exponent(parameter: Self::Parameter) -> Result<Self::Exponent, Error>;
    /// Lifts to the cosine-power hemisphere: z = (1 - r^2)^(1 / (e + 1)).
    fn power(exponent: Self::Exponent, disc: Self::Disc) -> [Self::Real; 3];

    /// [`store`](Self::store) over a block of points of a disc map; the same bits.
    #[inline(always)]
    fn disc_block<D: DiscMap<Arithmetic = Self>>(
        disc: &D,
        u: &Block,
        v: &Block,
        out: &mut [[Self::Real; 2]; BLOCK],
    ) {
        point_by_point!(u, v, out, uv => Self::store(disc.disc::<false>(uv)));
    }

    /// [`uniform`](Self::uniform) over a block of points of a disc map; the same bits.
    #[inline(always)]
    fn uniform_block<D: DiscMap<Arithmetic = Self>>(
        disc: &D,
        u: &Block,
        v: &Block,
        out: &mut [[Self::Real; 3]; BLOCK],
    ) {
        point_by_point!(u, v, out, uv => Self::uniform(disc.disc::<true>(uv)));
    }

    /// [`cosine`](Self::cosine) over a block of points of a disc map; the same bits.
    #[inline(always)]
    fn cosine_block<D: DiscMap<Arithmetic = Self>>(
        disc: &D,
        u: &Block,
        v: &Block,
        out: &mut [[Self::Real; 3]; BLOCK],
    ) {
        point_by_point!(u, v, out, uv => Self::cosine(disc.disc::<true>(uv)));
    }

    /// [`power`](Self::power) over a block of points of a disc map; the same bits.
    #[inline(always)]
    fn power_block<D: DiscMap<Arithmetic = Self>>(
        exponent: Self::Exponent,
        disc: &D,
        u: &Block,
        v: &Block,
        out: &mut [[Self::Real; 3]; BLOCK],
    ) {
        point_by_point!(u, v, out, uv => Self::power(exponent, disc.disc::<true>(uv)));
    }

    /// A stored point of the disc, for its inverse.
    fn load(point: [Self::Real; 2]) -> Self::Disc;
    /// The disc point of a direction of the uniform hemisphere, for its inverse.
    fn lower_uniform(direction: [Self::Real; 3]) -> Self::Disc;
    /// The disc point of a direction of the cosine hemisphere, for its inverse.
    fn lower_cosine(direction: [Self::Real; 3]) -> Self::Disc;
    /// The disc point of a direction of the power hemisphere, for its inverse.
    fn lower_power(exponent: Self::Exponent, direction: [Self::Real; 3]) -> Self::Disc;
    /// The cells of a point of the unit square.
    fn invert_square(point: [Self::Real; 2]) -> [u32; 2];
    /// The cells of a point of [-1, 1]^2.
    fn invert_centred(point: [Self::Real; 2]) -> [u32; 2];
    /// The cells that the concentric map sends to a disc point.
    fn invert_concentric(disc: Self::Disc) -> [u32; 2];
    /// The cells that the polar map sends to a disc point.
    fn invert_polar(disc: Self::Disc) -> [u32; 2];

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
}
