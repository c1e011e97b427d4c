//! Effects: a renderer's sampling tasks, independent of each other.
//!
//! | effect | points | sample |
//! | --- | --- | --- |
//! | [`ThinLens`] | on a round or polygonal aperture | a ray through the point in focus |
//! | [`DiscLight`] | on the light | the direction to it, its density per steradian |
//! | [`AmbientOcclusion`] | directions about a normal | one to be looked along up to a reach |
//! | [`Glossy`] | directions about the mirror's | one above the surface, by one of three policies |
//!
//! An effect that a renderer does not use costs nothing: no point drawn, no code, no table. Every
//! sample has its density and a weight. The mean over the samples of a weight times what it is for
//! estimates the effect's integral:
//!
//! | effect | weight | times | mean |
//! | --- | --- | --- | --- |
//! | [`ThinLens`] | `weight`, 1 | the radiance along the ray | the pixel's |
//! | [`DiscLight`] | `weight`, cos t / d^2 | the intensity along the axis, cos s | irradiance |
//! | | `radiance_weight`, area cos t / d^2 | the radiance, cos s | irradiance |
//! | [`AmbientOcclusion`] | `weight`, 1 | openness | openness, weighted by cos s / pi |
//! | [`Glossy`] | `weight`, 0 or 1 | the radiance along the direction | that of the reflection |
//!
//! t is the angle at the light, s the angle at the receiver, which the renderer knows; a light of
//! which nothing is visible has weights of 0. [`balance_heuristic`] and [`power_heuristic`] combine
//! two strategies, such as a light's samples and a lobe's.
//!
//! Results are finite for finite input, unless slopes or sums of coordinates exceed MAX. The weight
//! is 0 where nothing is visible: a receiver on the light, in its plane or behind it. Normals and
//! arriving directions are a [`Unit`](crate::Unit) or a [`Frame`](crate::Frame), which are checked
//! where they are made. The density that a sample has is that of its direction, within rounding.

//! In a `static` an effect is made by its `const_new`, where the arithmetic is `FastF32`, whose
//! kernels are `const`; a lens's is for any aperture of floats. The bits are those of `new`.
//!
//! ```
//! use hemidisc::effect::{BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
//! use hemidisc::{Error, FastF32, Frame};
//!
//! struct Effects {
//!     lens: ThinLens<Polygon<FastF32, 6>, f32>,
//!     lamp: DiscLight<FastF32>,
//!     gloss: Glossy<FastF32>,
//! }
//!
//! /// What a constructor accepts, or an error of the compiler.
//! macro_rules! accepted {
//!     ($made:expr) => {
//!         match $made {
//!             Ok(made) => made,
//!             Err(_) => panic!("refused"),
//!         }
//!     };
//! }
//!
//! static EFFECTS: Effects = Effects {
//!     lens: accepted!(ThinLens::<_, f32>::const_new(Polygon::const_new(1 << 30), 0.1, 4.9)),
//!     lamp: {
//!         let down = accepted!(Frame::<f32>::const_new([0.0, -1.0, 0.0]));
//!         accepted!(DiscLight::<FastF32>::const_new([0.0, 3.0, 0.0], down, 0.5))
//!     },
//!     gloss: accepted!(Glossy::<FastF32>::const_new(50.0, BelowHorizon::Flip)),
//! };
//! assert_eq!(EFFECTS.lens, ThinLens::new(Polygon::new(1 << 30), 0.1, 4.9)?);
//! # Ok::<(), Error>(())
//! ```

mod heuristics;
mod polygon;

macro_rules! modules {
    ($($file:ident $effect:ident $name:literal;)*) => {$(
        mod $file;
        pub use $file::*;
    )*};
}
for_each_effect!(modules);

pub use heuristics::{balance_heuristic, power_heuristic};
pub use polygon::Polygon;

use crate::arithmetic::Real;

/// A direction with its density and weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct DirectionSample<R> {
    /// Of unit length, in world space.
    pub direction: [R; 3],
    /// Per steradian; at most MAX.
    pub density: R,
    /// The factor of the value seen along the direction.
    pub weight: R,
}

/// A number that is not negative, at most MAX.
#[inline]
fn capped<R: Real>(x: R) -> R {
    if x.finite() { x } else { R::MAX }
}

/// A number that is not negative as a normal number, since a density is positive.
#[inline]
fn positive<R: Real>(x: R) -> R {
    let x = capped(x);
    if x > R::MIN_POSITIVE { x } else { R::MIN_POSITIVE }
}

/// 1 / x for x >= 0, as a normal number.
#[inline]
fn reciprocal<R: Real>(x: R) -> R {
    positive(R::ONE / x)
}

/// a + k b.
#[inline]
fn along<R: Real>(a: [R; 3], k: R, b: [R; 3]) -> [R; 3] {
    core::array::from_fn(|i| a[i] + k * b[i])
}
