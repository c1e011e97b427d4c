//! A map of directions, turned to world space.

use super::Frame;
use crate::arithmetic::Real;
use crate::block::{Block, Lanes};
use crate::map::{Density, Invert, Map};

/// A map of directions, turned about the third axis of a frame: world-space sampling about a
/// normal. [`Hemisphere::about`](crate::hemisphere::Hemisphere::about) turns a lobe.
///
/// Rotation rounds: a direction at the horizon may end a few eps below the plane, where its density
/// is 0. The angle to the axis of a sharp lobe is off by an eps, so the density of a turned
/// direction is accurate to about sqrt(e) eps. [`sample_with_density`](Density::sample_with_density)
/// takes the density before the rotation: positive for every sample, and as accurate as the lobe's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct About<M, R> {
    map: M,
    frame: Frame<R>,
}

impl<M, R> About<M, R> {
    /// The directions of a map in world space: its z axis is the third axis of the frame.
    #[must_use]
    pub const fn new(map: M, frame: Frame<R>) -> Self {
        Self { map, frame }
    }

    /// The map, about its own z axis.
    #[must_use]
    pub const fn map(&self) -> &M {
        &self.map
    }

    /// The frame.
    #[must_use]
    pub const fn frame(&self) -> &Frame<R> {
        &self.frame
    }
}

impl<R: Real, M: Map<Point = [R; 3]>> Map for About<M, R> {
    type Point = [R; 3];

    #[inline(always)]
    fn sample(&self, uv: [u32; 2]) -> [R; 3] {
        self.frame.to_world(self.map.sample(uv))
    }

    /// The map's own block, turned.
    #[inline(always)]
    fn sample_block<const N: usize>(&self, u: &Block<N>, v: &Block<N>, out: &mut [Lanes<R, N>; 3]) {
        self.map.sample_block(u, v, out);
        let [x, y, z] = out;
        for lane in 0..N {
            [x[lane], y[lane], z[lane]] = self.frame.to_world([x[lane], y[lane], z[lane]]);
        }
    }
}

impl<R: Real, M: Density<Point = [R; 3]>> Density for About<M, R> {
    #[inline]
    fn density(&self, world: [R; 3]) -> R {
        self.map.density(self.frame.to_local(world))
    }

    #[inline]
    fn sample_with_density(&self, uv: [u32; 2]) -> ([R; 3], R) {
        let (local, density) = self.map.sample_with_density(uv);
        (self.frame.to_world(local), density)
    }
}

impl<R: Real, M: Invert<Point = [R; 3]>> Invert for About<M, R> {
    #[inline]
    fn invert(&self, world: [R; 3]) -> [u32; 2] {
        self.map.invert(self.frame.to_local(world))
    }
}

crate::map::sampled!([R: Real, M: Map<Point = [R; 3]>] About<M, R>, [R; 3]);
