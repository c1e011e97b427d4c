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
//! sample has its density, and the weight to multiply with the value that the sample sees. The mean
//! of weight times value estimates the effect's integral. [`balance_heuristic`] and
//! [`power_heuristic`] combine two strategies, such as a light's samples and a lobe's.
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

/// 1 / x for x >= 0, as a normal number, since a density is positive.
#[inline]
fn reciprocal<R: Real>(x: R) -> R {
    let reciprocal = capped(R::ONE / x);
    if reciprocal > R::MIN_POSITIVE { reciprocal } else { R::MIN_POSITIVE }
}

/// a + k b.
#[inline]
fn along<R: Real>(a: [R; 3], k: R, b: [R; 3]) -> [R; 3] {
    core::array::from_fn(|i| a[i] + k * b[i])
}
