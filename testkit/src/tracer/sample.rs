//! One sample of a pixel: where each effect's points come from, and how many were drawn.

use core::fmt;
use core::ops::AddAssign;
use hemidisc::Domain;
use hemidisc::sequence::SobolOwen;

/// What a sequence is to the renderer.
pub trait Points {
    /// The point of a number in a domain.
    fn point(&self, domain: Domain, index: u32) -> [u32; 2];
}

/// The Owen-scrambled Sobol sequence: well spread however many samples there are.
#[derive(Clone, Copy, Debug)]
pub struct Owen;

impl Points for Owen {
    #[inline]
    fn point(&self, domain: Domain, index: u32) -> [u32; 2] {
        SobolOwen::in_domain(domain).at(index)
    }
}

/// The keys of the domains under a pixel's, one for each use of points.
pub(super) const FILTER: u32 = 0;
pub(super) const LENS: u32 = 1;
pub(super) const LIGHT: u32 = 2;
pub(super) const OCCLUSION: u32 = 3;
pub(super) const GLOSSY: u32 = 4;
/// Under it are the domains of the effects where a reflected ray ends.
pub(super) const BOUNCE: u32 = 5;

/// A sample's number, and the domain of its pixel or of a bounce there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    domain: Domain,
    index: u32,
}

impl Sample {
    /// The sample of a number in the domain of a pixel.
    pub(super) const fn new(pixel: Domain, index: u32) -> Self {
        Self { domain: pixel, index }
    }

    /// The point of an effect.
    #[inline]
    pub(super) fn point(self, effect: u32, points: &impl Points) -> [u32; 2] {
        points.point(self.domain.child(effect), self.index)
    }

    /// The sample where a reflected ray ends.
    pub(super) const fn bounced(self) -> Self {
        Self { domain: self.domain.child(BOUNCE), index: self.index }
    }
}

/// Points drawn and rays sent.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Pairs of coordinates.
    pub points: u64,
    /// Rays that were looked along.
    pub rays: u64,
}

impl Tally {
    #[inline]
    pub(super) const fn draw(&mut self) {
        self.points += 1;
    }

    #[inline]
    pub(super) const fn send(&mut self) {
        self.rays += 1;
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.points, self.rays)
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.points += other.points;
        self.rays += other.rays;
    }
}

/// What each effect took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// The pixel filter's points, and the rays of what stands in for an absent effect.
    pub base: Tally,
    /// Depth of field.
    pub lens: Tally,
    /// Soft shadows.
    pub light: Tally,
    /// Ambient occlusion.
    pub occlusion: Tally,
    /// Glossy reflection.
    pub glossy: Tally,
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.base += other.base;
        self.lens += other.lens;
        self.light += other.light;
        self.occlusion += other.occlusion;
        self.glossy += other.glossy;
    }
}
