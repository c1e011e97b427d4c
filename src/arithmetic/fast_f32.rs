//! Fast f32: its own polynomials, no library, and no branches, so that fills are vectorised.
//!
//! **Octant.** Both disc maps fold to 0 <= phi <= pi/4, phi = pi/4 t. With q = t^2, x = r - r P(q)
//! and y = r t - r t R(q), P = 1 - cos phi and R = 1 - sin phi / t: no angle and no sign logic.
//! Both are below 0.3, so their own roundings count little. The concentric map has r t = n, the
//! minor magnitude, without the error of the division t = n/m. Only a swap and two sign bits place
//! the octant, so mirror images are equal bit for bit.
//!
//! **Coordinates.** A magnitude m < 2^31 is (m + 1/2) / 2^31, by a conversion from *signed*
//! integers, which vector units have and round correctly. 1 - r is as accurate, from 2^31 - 1 - m,
//! and 1 - r^2 = d (2 - d), d = 1 - r.
//!
//! **Inward.** Within 2 eps of the circle both components move one ulp toward zero. The test takes
//! four operations and the step two, for every point. Shrinking all points by as much would be as
//! cheap, but all would lose accuracy.
//!
//! **Forms.** A kernel is written for a lane of a block, for a point alone on a processor of 64-bit
//! words, and for a small core. That has no vectors, and a branch costs it less than the swap or test
//! that it avoids: both sides of the diagonal have code of their own, and only points near the rim
//! are tested. The bits are the same.
//!
//! **Lobes.** sin theta is the root of r^2 (1 + (1 - r^2)) for the uniform lobe; the power lobe
//! takes one logarithm and one power of 2, from which z and 1 - z both come without cancellation. A
//! direction of the octant, which is at hand earlier, is multiplied by sin theta.
//!
//! **Roots** are correctly rounded, by an instruction or without (`root.rs`).
//!
//! There is no fused multiply-add and no reordered sum: the bits are the same on SSE2, AVX-512, Arm
//! and RISC-V. Everything up to the exponent is `const`.

mod back;
mod disc;
mod functions;
mod lobes;
mod passes;
mod root;
#[cfg(test)]
mod tests;

use super::{Arithmetic, DiscPoint, KernelOf, Root, sealed::Sealed};
use crate::block::{Block, Lanes};
use crate::error::Error;
use crate::target::form::{LANE, ONE};
use crate::target::{ROUNDS_FLOATS, where_floats_round};
use back::Functions;
use disc::FastDisc;
use lobes::FastExponent;
use root::{now, root};

/// `f32` with its own polynomials: the fastest on a core with an FPU, above all in vectors.
///
/// Always available: it needs no feature. The bytes are the same on every target and never change
/// within a major version of this crate. Its errors are a little above those of `libm` on f32:
/// docs/accuracy.md has the bounds.
///
/// ```
/// use hemidisc::{Concentric, FastF32};
/// // At compile time as well.
/// const POINT: [f32; 2] = FastF32::concentric([u32::MAX, 1 << 31]);
/// assert_eq!(Concentric::<FastF32>::new().sample([u32::MAX, 1 << 31]), POINT);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FastF32;

where_floats_round! {
    impl FastF32 {
        /// The concentric map: what [`Concentric`](crate::Concentric) gives, as a `const fn`.
        #[must_use]
        #[inline(always)]
        pub const fn concentric(uv: [u32; 2]) -> [f32; 2] {
            disc::concentric::<ONE>(uv).point
        }

        /// The polar map: what [`Polar`](crate::Polar) gives, as a `const fn`.
        #[must_use]
        #[inline(always)]
        pub const fn polar(uv: [u32; 2]) -> [f32; 2] {
            Self::disc_polar(uv).point
        }

        /// Square root of x in [0, MAX], which `core` does not have.
        #[must_use]
        #[inline]
        pub const fn sqrt(x: f32) -> f32 {
            functions::sqrt(x)
        }
    }
}

/// The kernels, as `const` functions: with roots that constants can have.
impl FastF32 {
    #[inline(always)]
    pub(crate) const fn disc_concentric(uv: [u32; 2]) -> FastDisc {
        disc::concentric::<ONE>(uv)
    }

    #[inline(always)]
    pub(crate) const fn disc_polar(uv: [u32; 2]) -> FastDisc {
        let squares = disc::squares::<ONE>(uv);
        disc::polar::<ONE>(uv, squares, root(squares[0]))
    }

    #[inline(always)]
    pub(crate) const fn lift_uniform(disc: FastDisc) -> [f32; 3] {
        disc.uniform_at(root(disc.uniform_square()))
    }

    #[inline(always)]
    pub(crate) const fn lift_cosine(disc: FastDisc) -> [f32; 3] {
        let [x, y] = disc.point;
        [x, y, root(disc.one_minus_r2)]
    }

    pub(crate) const fn prepared(e: f32) -> Result<FastExponent, Error> {
        FastExponent::new(e)
    }

    #[inline(always)]
    pub(crate) const fn lift_power(exponent: FastExponent, disc: FastDisc) -> [f32; 3] {
        let [square, z] = lobes::power(exponent, disc);
        lobes::powered(exponent, disc, root(square), z)
    }
}

impl Sealed for FastF32 {}

impl Root for FastF32 {
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        if x >= functions::FAR_FROM_0 { now(x) } else { functions::sqrt(x) }
    }

    #[inline(always)]
    fn disc_point(disc: FastDisc) -> DiscPoint<f32> {
        let direction = disc.place_at::<ONE>(1.0, 1.0);
        DiscPoint { direction, r2: disc.r2, one_minus_r2: disc.one_minus_r2 }
    }
}

impl Arithmetic for FastF32 {
    const NAME: &'static str = "fast-f32";
    const ABSOLUTE_DENSITY: bool = true;
    const POINTWISE: bool = false;
    const ROUNDS: bool = ROUNDS_FLOATS;

    type Real = f32;
    type Disc = FastDisc;
    type Parameter = f32;
    type Exponent = FastExponent;
    type Back = Functions;

    #[inline(always)]
    fn square(uv: [u32; 2]) -> [f32; 2] {
        uv.map(disc::centre_down)
    }

    #[inline(always)]
    fn centred(uv: [u32; 2]) -> [f32; 2] {
        disc::centred(uv)
    }

    #[inline(always)]
    fn concentric(uv: [u32; 2]) -> FastDisc {
        Self::disc_concentric(uv)
    }

    #[inline(always)]
    fn concentric_lane(uv: [u32; 2]) -> FastDisc {
        disc::concentric::<LANE>(uv)
    }

    #[inline(always)]
    fn polar(uv: [u32; 2]) -> FastDisc {
        let squares = disc::squares::<ONE>(uv);
        disc::polar::<ONE>(uv, squares, now(squares[0]))
    }

    #[inline(always)]
    fn polar_lane(uv: [u32; 2]) -> FastDisc {
        let squares = disc::squares::<LANE>(uv);
        disc::polar::<LANE>(uv, squares, now(squares[0]))
    }

    #[inline(always)]
    fn store(disc: FastDisc) -> [f32; 2] {
        disc.point
    }

    #[inline(always)]
    fn disc_block<D: KernelOf<Self>, const N: usize>(
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<f32, N>; 2],
    ) {
        passes::disc::<D, N>(u, v, out);
    }

    #[inline(always)]
    fn uniform(disc: FastDisc) -> [f32; 3] {
        disc.uniform_at(now(disc.uniform_square()))
    }

    #[inline(always)]
    fn uniform_block<D: KernelOf<Self>, const N: usize>(
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<f32, N>; 3],
    ) {
        passes::uniform::<D, N>(u, v, out);
    }

    #[inline(always)]
    fn cosine(disc: FastDisc) -> [f32; 3] {
        let [x, y] = disc.point;
        [x, y, now(disc.one_minus_r2)]
    }

    #[inline(always)]
    fn cosine_block<D: KernelOf<Self>, const N: usize>(
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<f32, N>; 3],
    ) {
        passes::cosine::<D, N>(u, v, out);
    }

    fn exponent(e: f32) -> Result<FastExponent, Error> {
        Self::prepared(e)
    }

    fn given(exponent: FastExponent) -> f32 {
        exponent.value()
    }

    #[inline(always)]
    fn power(exponent: FastExponent, disc: FastDisc) -> [f32; 3] {
        let [square, z] = lobes::power(exponent, disc);
        lobes::powered(exponent, disc, now(square), z)
    }

    #[inline(always)]
    fn power_with_density(exponent: FastExponent, disc: FastDisc) -> ([f32; 3], f32) {
        let direction = Self::power(exponent, disc);
        (direction, exponent.density_of_sample(disc.one_minus_r2, direction))
    }

    #[inline(always)]
    fn power_block<D: KernelOf<Self>, const N: usize>(
        exponent: FastExponent,
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<f32, N>; 3],
    ) {
        passes::power::<D, N>(exponent, u, v, out);
    }
}
