//! The renderer's core: no heap, no operating system, no panic; the boards run it too.
//!
//! A pixel is the mean, over its samples, of what a ray from the camera sees: emission, direct
//! light of one lamp, ambient light, and one reflection whose own hit is lit but reflects no
//! further.
//!
//! Each of the four effects is a type parameter of [`Renderer`]: the effect itself, or the type
//! that stands in for it and draws no points ([`Pinhole`], [`PointLight`], [`Unoccluded`],
//! [`Mirror`]). Points come from a domain of the pixel and the effect alone, so no effect changes
//! the noise of another.
//!
//! [`Renderer::row`] adds samples to the caller's sums, so a frame may be split by rows, by parts
//! of rows and by ranges of samples. Sums are the same bits for any split in which a pixel's
//! samples are added in order.
//!
//! Its numbers are those of any `arithmetic::Root`. It takes their constants and tests from
//! `arithmetic::Real`, whose items are hidden, for they are the crate's own: a renderer of yours in
//! `f32` alone has no need of them.

mod camera;
mod effects;
mod geometry;
mod renderer;
mod sample;
mod vector;

pub use camera::{Camera, Ray};
pub use effects::{
    Ambient, Draw, Lens, Light, Mirror, Pinhole, PointLight, Reflection, Unoccluded,
};
pub use geometry::{Checker, Finish, Hit, Material, Plane, Sphere};
pub use renderer::{Renderer, Sky};
pub use sample::{Counts, Source, Tally};
pub use vector::Vector;
