//! Maps onto the unit hemisphere z > 0: a disc map lifted by a lobe.
//!
//! A disc map gives a point and its exact 1 - r^2; a lobe turns both into a direction. Over the
//! polar map the power lobe is the textbook's phi = 2 pi u, theta = acos((1 - v)^(1 / (e + 1))).

macro_rules! modules {
    ($($file:ident $lobe:ident $over:ident $name:literal $parameters:tt;)*) => {$(
        mod $file;
        pub use $file::$lobe;
    )*};
}
for_each_lobe!(modules);

use super::disc::{Concentric, DiscMap, LoweredOf};
use super::{Density, Invert, Map, sealed::Sealed};
use crate::arithmetic::{Arithmetic, Back, FloatBack, KernelOf, Root, assert_rounds};
use crate::block::{Block, Lanes};
use crate::error::Error;
use crate::frame::{About, Frame};
use core::marker::PhantomData;

/// What lifts a point of the disc to a direction. Sealed: see [`DiscMap`] for a lobe of your own.
pub trait Lobe: Copy + Sealed {
    /// The arithmetic it computes in.
    type Arithmetic: Arithmetic;

    /// The direction above a point of the disc.
    #[doc(hidden)]
    fn lift(&self, disc: <Self::Arithmetic as Arithmetic>::Disc) -> Direction<Self::Arithmetic>;

    /// The directions above a block of points of a disc map.
    #[doc(hidden)]
    fn lift_block<D: KernelOf<Self::Arithmetic>, const N: usize>(
        &self,
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<Slot<Self::Arithmetic>, N>; 3],
    );

    /// The point of the disc below a direction.
    #[doc(hidden)]
    fn lower(&self, direction: Direction<Self::Arithmetic>) -> LoweredOf<Self::Arithmetic>;

    /// The density of directions, per steradian; 0 below the horizon.
    #[doc(hidden)]
    fn density(&self, direction: Direction<Self::Arithmetic>) -> Slot<Self::Arithmetic>;

    /// The direction above a point of the disc, and its density.
    #[doc(hidden)]
    #[inline(always)]
    fn lift_with_density(
        &self,
        disc: <Self::Arithmetic as Arithmetic>::Disc,
    ) -> (Direction<Self::Arithmetic>, Slot<Self::Arithmetic>) {
        let direction = self.lift(disc);
        (direction, self.density(direction))
    }
}

type Slot<A> = <A as Arithmetic>::Real;
type Direction<A> = [Slot<A>; 3];

/// A lobe over a disc map: directions (x, y, z) with z > 0 about the z axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub struct Hemisphere<L, D> {
    lobe: L,
    disc: D,
}

/// Uniform directions: density 1 / (2 pi) per steradian. `D` is the disc map below.
pub type Uniform<A, D = Concentric<A>> = Hemisphere<UniformLobe<A>, D>;

/// Cosine-weighted directions: density z / pi per steradian. `D` is the disc map below.
pub type Cosine<A, D = Concentric<A>> = Hemisphere<CosineLobe<A>, D>;

/// Cosine-power directions: density (e + 1) z^e / (2 pi) per steradian. `D` is the disc map below.
///
/// [`sample_with_density`](Density::sample_with_density) forms the density of a sample in floats as
/// (e + 1) / (2 pi) (1 - r^2) / z, from the 1 - r^2 of the coordinates: one division, and a few eps
/// and the error of z from the exact density of the coordinates. [`density`](Density::density) of
/// the same direction takes a logarithm and an exponential, and what the direction has lost by
/// rounding counts sqrt(e) times: with e = 50 up to 83 eps. In fixed point the two are one.
///
/// ```
/// use hemidisc::{FastF32, LibmF32, Polar, Power};
/// let lobe = Power::<LibmF32>::new(50.0)?;
/// let [x, y, z] = lobe.sample([1 << 31, 1 << 30]);
/// assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6);
/// assert!(Power::<LibmF32>::new(-1.0).is_err());
/// // Over the polar map it is the textbook's formula.
/// let textbook = Power::over(50.0, Polar::<LibmF32>::new())?;
/// // In flash, for FastF32 and fixed point.
/// static LOBE: Power<FastF32> = match Power::<FastF32>::const_new(50.0) {
///     Ok(lobe) => lobe,
///     Err(_) => panic!("not an exponent"),
/// };
/// # Ok::<(), hemidisc::Error>(())
/// ```
pub type Power<A, D = Concentric<A>> = Hemisphere<PowerLobe<A>, D>;

impl<L, D> Hemisphere<L, D> {
    pub(crate) const fn lobe(&self) -> &L {
        &self.lobe
    }

    /// The disc map below the lobe.
    #[must_use]
    pub const fn disc(&self) -> &D {
        &self.disc
    }

    /// Whether all of its directions are one: never, for a lobe of finite exponent has a density.
    /// For [the heuristics](crate::effect::power_heuristic).
    #[must_use]
    #[inline]
    pub const fn is_delta(&self) -> bool {
        false
    }

    /// The same directions in world space, about the third axis of a frame.
    #[must_use]
    pub const fn about<R>(self, frame: Frame<R>) -> About<Self, R>
    where
        Self: Copy,
    {
        About::new(self, frame)
    }
}

/// Constructors for the lobes without a parameter.
macro_rules! without_parameter {
    ($lobe:ident) => {
        impl<A: Arithmetic> Hemisphere<$lobe<A>, Concentric<A>> {
            /// The lobe over the concentric map.
            #[must_use]
            pub const fn new() -> Self {
                Self::over(Concentric::new())
            }
        }

        impl<A: Arithmetic, D: DiscMap<Arithmetic = A>> Hemisphere<$lobe<A>, D> {
            /// The lobe over a disc map.
            #[must_use]
            pub const fn over(disc: D) -> Self {
                Self { lobe: $lobe(PhantomData), disc }
            }
        }
    };
}
without_parameter!(UniformLobe);
without_parameter!(CosineLobe);

impl<A: Arithmetic> Hemisphere<PowerLobe<A>, Concentric<A>> {
    /// The lobe of exponent e > -1 over the concentric map.
    ///
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub fn new(exponent: A::Parameter) -> Result<Self, Error> {
        Self::over(exponent, Concentric::new())
    }
}

impl<A: Arithmetic, D: DiscMap<Arithmetic = A>> Hemisphere<PowerLobe<A>, D> {
    /// The lobe of exponent e > -1 over a disc map.
    ///
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub fn over(exponent: A::Parameter, disc: D) -> Result<Self, Error> {
        Ok(Self { lobe: PowerLobe::new(exponent)?, disc })
    }
}

/// The constructors of power lobes, as `const fn`, in the arithmetics whose kernels are.
macro_rules! const_powers {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $($facts:tt)*);)*) => {
        $(const_powers! { $form $kind #[$cfg] $arithmetic })*
    };
    (runtime $kind:ident #[$cfg:meta] $arithmetic:ident) => {};
    (const float #[$cfg:meta] $arithmetic:ident) => {
        const_powers! { #[$cfg] $arithmetic, f32 }
    };
    (const fixed #[$cfg:meta] $arithmetic:ident) => {
        const_powers! { #[$cfg] $arithmetic, crate::arithmetic::FixedExponent }
    };
    (#[$cfg:meta] $arithmetic:ident, $parameter:ty) => {
        #[$cfg]
        const _: () = {
            use crate::arithmetic::$arithmetic;

            impl Hemisphere<PowerLobe<$arithmetic>, Concentric<$arithmetic>> {
                /// [`new`](Self::new), as a `const fn`: for a lobe in a `static`.
                ///
                /// # Errors
                /// Those of `new`.
                pub const fn const_new(exponent: $parameter) -> Result<Self, Error> {
                    Self::const_over(exponent, Concentric::new())
                }
            }

            impl<D: DiscMap<Arithmetic = $arithmetic>> Hemisphere<PowerLobe<$arithmetic>, D> {
                /// [`over`](Self::over), as a `const fn`.
                ///
                /// # Errors
                /// Those of `over`.
                pub const fn const_over(exponent: $parameter, disc: D) -> Result<Self, Error> {
                    match $arithmetic::prepared(exponent) {
                        Ok(exponent) => Ok(Self { lobe: PowerLobe::of(exponent), disc }),
                        Err(error) => Err(error),
                    }
                }
            }
        };
    };
}
for_each_arithmetic!(const_powers);

impl<A: Arithmetic, D> Hemisphere<PowerLobe<A>, D> {
    /// The exponent as it was given.
    #[must_use]
    pub fn exponent(&self) -> A::Parameter {
        self.lobe.exponent()
    }
}

impl<A: Arithmetic, D> Hemisphere<PowerLobe<A>, D> {
    /// The density of a direction at a height z, to be added to that of another, whose x^2 + y^2 is
    /// less by `growth`: 0 where the sum would not show it.
    #[inline]
    pub(crate) fn density_beside(
        &self,
        growth_and_z: [A::Real; 2],
        direction: impl FnOnce() -> Direction<A>,
    ) -> A::Real {
        A::Back::power_density_beside(self.lobe.prepared().into(), growth_and_z, direction)
    }
}

impl<A: Root, D> Hemisphere<PowerLobe<A>, D> {
    /// The share of its directions above a plane, from the sine and the square of the cosine of
    /// its axis's elevation.
    pub(crate) fn share_above(&self, sin: A::Real, cos2: A::Real) -> A::Real {
        A::Back::power_share(self.lobe.prepared().into(), sin, cos2)
    }
}

impl<L: Lobe, D: DiscMap<Arithmetic = L::Arithmetic>> Map for Hemisphere<L, D> {
    type Point = Direction<L::Arithmetic>;

    const POINTWISE: bool = L::Arithmetic::POINTWISE;

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> Self::Point {
        self.lobe.lift(D::disc(uv))
    }

    #[inline(always)]
    fn sample_block<const N: usize>(
        &self,
        u: &Block<N>,
        v: &Block<N>,
        out: &mut [Lanes<Slot<L::Arithmetic>, N>; 3],
    ) {
        self.lobe.lift_block::<D, N>(u, v, out);
    }
}

impl<L: Lobe, D: DiscMap<Arithmetic = L::Arithmetic>> Density for Hemisphere<L, D> {
    #[inline]
    fn density(&self, direction: Self::Point) -> Slot<L::Arithmetic> {
        assert_rounds::<L::Arithmetic>();
        self.lobe.density(direction)
    }

    #[inline(always)]
    fn sample_with_density(&self, uv: [u32; 2]) -> (Self::Point, Slot<L::Arithmetic>) {
        self.lobe.lift_with_density(D::disc(uv))
    }
}

impl<L: Lobe, D: DiscMap<Arithmetic = L::Arithmetic>> Invert for Hemisphere<L, D> {
    #[inline]
    fn invert(&self, direction: Self::Point) -> [u32; 2] {
        D::invert_lowered(self.lobe.lower(direction))
    }
}

super::sampled!(
    [L: Lobe, D: DiscMap<Arithmetic = L::Arithmetic>]
    Hemisphere<L, D>, Direction<L::Arithmetic>
);

/// A lobe whose kernels are the arithmetic's functions of the same names.
macro_rules! lobe {
    (
        $lobe:ident, $lift:ident, $block:ident, $lower:ident, $density:ident
        $(, $parameter:tt, $with_density:ident)?
    ) => {
        const _: () = {
            use $crate::arithmetic::{Arithmetic, Back, KernelOf};
            use $crate::block::{Block, Lanes};
            use $crate::map::{disc::LoweredOf, hemisphere::Lobe, sealed::Sealed};

            impl<A: Arithmetic> Sealed for $lobe<A> {}

            impl<A: Arithmetic> Lobe for $lobe<A> {
                type Arithmetic = A;

                #[inline(always)]
                fn lift(&self, disc: A::Disc) -> [A::Real; 3] {
                    A::$lift($(self.$parameter,)? disc)
                }

                #[inline(always)]
                fn lift_block<D: KernelOf<A>, const N: usize>(
                    &self,
                    u: &Block<N>,
                    v: &Block<N>,
                    out: &mut [Lanes<A::Real, N>; 3],
                ) {
                    A::$block::<D, N>($(self.$parameter,)? u, v, out);
                }

                #[inline]
                fn lower(&self, direction: [A::Real; 3]) -> LoweredOf<A> {
                    A::Back::$lower($(self.$parameter.into(),)? direction)
                }

                #[inline]
                fn density(&self, direction: [A::Real; 3]) -> A::Real {
                    A::Back::$density($(self.$parameter.into(),)? direction)
                }

                $(
                    #[inline(always)]
                    fn lift_with_density(&self, disc: A::Disc) -> ([A::Real; 3], A::Real) {
                        A::$with_density(self.$parameter, disc)
                    }
                )?
            }
        };
    };
}
use lobe;
