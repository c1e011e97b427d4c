//! The samples of a pixel: where their numbers come from, and how many were drawn.

use core::fmt;
use core::ops::AddAssign;
use hemidisc::sequence::{InDomain, SobolOwen};
use hemidisc::{Domain, Sampler, Screen};

/// Where the numbers of a sample come from.
pub trait Source {
    /// The sequences that they are drawn from.
    type Family: InDomain;

    /// The sampler of a pixel's sample.
    fn sampler(&self, pixel: [u32; 2], sample: u32) -> Sampler<Self::Family>;
}

/// Each pixel has a domain of its own.
impl Source for Domain {
    type Family = SobolOwen;

    #[inline]
    fn sampler(&self, [x, y]: [u32; 2], sample: u32) -> Sampler {
        Sampler::new(self.pixel(x, y), sample)
    }
}

/// All pixels share one, and their errors are blue noise.
impl Source for Screen {
    type Family = SobolOwen;

    /// A pixel outside has a domain of its own.
    #[inline]
    fn sampler(&self, [x, y]: [u32; 2], sample: u32) -> Sampler {
        match self.pixel(x, y) {
            Ok(pixel) => pixel.sampler(sample),
            Err(_) => self.domain().sampler([x, y], sample),
        }
    }
}

/// The keys of the domains under a pixel's, one for each use of numbers. The point of the pixel and
/// that of the lens are drawn together.
pub(super) const CAMERA: u32 = 0;
pub(super) const LIGHT: u32 = 2;
pub(super) const OCCLUSION: u32 = 3;
pub(super) const GLOSSY: u32 = 4;
/// Under it are the domains of the effects where a reflected ray ends.
pub(super) const BOUNCE: u32 = 5;

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
