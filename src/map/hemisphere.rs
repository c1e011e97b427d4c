//! Maps onto the unit hemisphere z > 0: a disc map lifted by a lobe.
//!
//! A disc map gives a point and its exact 1 - r^2; a lobe turns both into a direction. Over the polar
//! map the power lobe is the textbook's phi = 2 pi u, theta = acos((1 - v)^(1 / (e + 1))).

mod cosine;
mod power;
mod uniform;

pub use cosine::CosineLobe;
pub use power::PowerLobe;
pub use uniform::UniformLobe;

use super::Map;
use super::disc::{Concentric, DiscMap, Polar};
use crate::arithmetic::{Arithmetic, point_by_point};
use crate::error::Error;
use crate::frame::{About, Frame};
use crate::sequence::{BLOCK, Block};
use core::marker::PhantomData;

/// What lifts a point of the disc to a direction.
pub trait Lobe: Copy {
    /// The arithmetic it computes in.
    type Arithmetic: Arithmetic;

    /// The direction above a point of the disc.
    fn lift(&self, disc: <Self::Arithmetic as Arithmetic>::Disc) -> Direction<Self::Arithmetic>;

    /// The directions above a block of points of a disc map; the same bits.
    #[inline(always)]
    fn lift_block<D: DiscMap<Arithmetic = Self::Arithmetic>>(
        &self,
        disc: &D,
        u: &Block,
        v: &Block,
        out: &mut [Direction<Self::Arithmetic>; BLOCK],
    ) {
        point_by_point!(u, v, out, uv => self.lift(disc.disc::<true>(uv)));
    }

    /// The point of the disc below a direction, x and y up to a common factor.
    fn lower(
        &self,
        direction: Direction<Self::Arithmetic>,
    ) -> <Self::Arithmetic as Arithmetic>::Disc;

    /// The density of directions, per steradian; 0 below the horizon.
    fn density(&self, direction: Direction<Self::Arithmetic>) -> Slot<Self::Arithmetic>;
}

type Slot<A> = <A as Arithmetic>::Real;
type Direction<A> = [Slot<A>; 3];

/// A lobe over a disc map: directions (x, y, z) with z > 0 about the z axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
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
/// ```
/// use hemidisc::{LibmF32, Map, Power};
/// let lobe = Power::<LibmF32>::new(50.0)?;
/// let [x, y, z] = lobe.sample([1 << 31, 1 << 30]);
/// assert!((x * x + y * y + z * z - 1.0).abs() < 1e-6);
/// assert!(Power::<LibmF32>::new(-1.0).is_err());
/// # Ok::<(), hemidisc::Error>(())
/// ```
pub type Power<A, D = Concentric<A>> = Hemisphere<PowerLobe<A>, D>;

impl<L, D> Hemisphere<L, D> {
    /// The lobe.
    pub const fn lobe(&self) -> &L {
        &self.lobe
    }

    /// The same directions in world space, about the third axis of a frame.
    pub const fn about<R>(self, frame: Frame<R>) -> About<Self, R>
    where
        Self: Copy,
    {
        About::new(self, frame)
    }
}

/// Constructors over both disc maps for the lobes without a parameter.
macro_rules! without_parameter {
    ($lobe:ident) => {
        impl<A: Arithmetic> Hemisphere<$lobe<A>, Concentric<A>> {
            /// The lobe over the concentric map.
            pub const fn new() -> Self {
                Self { lobe: $lobe(PhantomData), disc: Concentric::new() }
            }
        }

        impl<A: Arithmetic> Hemisphere<$lobe<A>, Polar<A>> {
            /// The lobe over the polar map.
            pub const fn polar() -> Self {
                Self { lobe: $lobe(PhantomData), disc: Polar::new() }
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
        Ok(Self { lobe: PowerLobe::new(exponent)?, disc: Concentric::new() })
    }
}

impl<A: Arithmetic> Hemisphere<PowerLobe<A>, Polar<A>> {
    /// The lobe of exponent e > -1 over the polar map: the textbook's formula.
    ///
    /// # Errors
    /// [`Error::Exponent`] for a value that is not a finite number above -1.
    pub fn polar(exponent: A::Parameter) -> Result<Self, Error> {
        Ok(Self { lobe: PowerLobe::new(exponent)?, disc: Polar::new() })
    }
}

impl<L: Lobe, D: DiscMap<Arithmetic = L::Arithmetic>> Map for Hemisphere<L, D> {
    type Arithmetic = L::Arithmetic;
    type Point = Direction<L::Arithmetic>;

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> Self::Point {
        self.lobe.lift(self.disc.disc::<true>(uv))
    }

    #[inline(always)]
    fn sample_block(&self, u: &Block, v: &Block, out: &mut [Self::Point; BLOCK]) {
        self.lobe.lift_block(&self.disc, u, v, out);
    }

    #[inline]
    fn density(&self, direction: Self::Point) -> Slot<L::Arithmetic> {
        self.lobe.density(direction)
    }

    #[inline]
    fn invert(&self, direction: Self::Point) -> [u32; 2] {
        self.disc.invert_disc(self.lobe.lower(direction))
    }
}

#[cfg(feature = "rand")]
impl<L: Lobe, D: DiscMap<Arithmetic = L::Arithmetic>>
    rand::distr::Distribution<Direction<L::Arithmetic>> for Hemisphere<L, D>
{
    /// Draws two words, u first.
    #[inline]
    fn sample<R: rand::Rng + ?Sized>(&self, rng: &mut R) -> Direction<L::Arithmetic> {
        crate::map::draw(self, rng)
    }
}

/// A lobe whose kernels are the arithmetic's functions of the same names.
macro_rules! lobe {
    ($lobe:ident, $lift:ident, $block:ident, $lower:ident, $density:ident $(, $parameter:tt)?) => {
        impl<A: Arithmetic> Lobe for $lobe<A> {
            type Arithmetic = A;

            #[inline(always)]
            fn lift(&self, disc: A::Disc) -> [A::Real; 3] {
                A::$lift($(self.$parameter,)? disc)
            }

            #[inline(always)]
            fn lift_block<D: crate::map::DiscMap<Arithmetic = A>>(
                &self,
                disc: &D,
                u: &crate::sequence::Block,
                v: &crate::sequence::Block,
                out: &mut [[A::Real; 3]; crate::sequence::BLOCK],
            ) {
                A::$block($(self.$parameter,)? disc, u, v, out)
            }

            #[inline]
            fn lower(&self, direction: [A::Real; 3]) -> A::Disc {
                A::$lower($(self.$parameter,)? direction)
            }

            #[inline]
            fn density(&self, direction: [A::Real; 3]) -> A::Real {
                A::$density($(self.$parameter,)? direction)
            }
        }
    };
}
use lobe;
