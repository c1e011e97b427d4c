//! A sampler for each pixel of a screen, whose error is blue noise.
//!
//! Where pixels have independent domains, their errors are white noise. Here all pixels draw from
//! one sequence: a pixel takes the 2^k indices from place x 2^k on, its place being that in
//! Morton's order, and the sequence shuffles them by Owen's scrambling. So each block of 2^m x 2^m
//! pixels is a net as well as each pixel is, and errors of neighbours cancel (A. Ahmed and P.
//! Wonka, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via Hierarchical
//! Ordering of Pixels", ACM TOG 39(6), 2020). No table, and no key for a pixel.

mod row;

pub use row::Row;

use crate::domain::Domain;
use crate::error::Error;
use crate::sampler::Sampler;

/// The samplers of a screen's pixels.
///
/// The error of each pixel is as large as with `Sampler::new(domain.pixel(x, y), i)`. After the
/// blur of an eye or a filter it is smaller: with a Gaussian of 2 pixels at 1 / 4 / 16 samples some
/// 0.6 / 0.65 / 0.7 of it. That holds when all samples of all pixels are drawn.
///
/// ```
/// use hemidisc::{Domain, Screen};
/// const LENS: u32 = 0;
/// let screen = Screen::new(Domain::new(7), [1920, 1080], 16)?;
/// let pixel = screen.pixel(120, 64)?;
/// for i in 0..16 {
///     let lens = pixel.sampler(i).child(LENS).pair();
/// }
/// # Ok::<(), hemidisc::Error>(())
/// ```
///
/// [`row`](Self::row) has the same sample of neighbouring pixels as a sequence, for fills.
///
/// The first 2^k samples of a pixel are a net for each k, so a pixel may stop early or refine step
/// by step. Samples from the stated number on begin another set of all pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Screen {
    domain: Domain,
    size: [u32; 2],
    samples: u32,
    /// log2 of the indices that a pixel has: at least as many as it has samples.
    log2: u32,
}

impl Screen {
    /// A screen of width and height in pixels, for a number of samples in each pixel.
    ///
    /// Width, height and samples may be any: where they are more than 2^32 together the screen has
    /// tiles with a domain each, and within a tile errors are blue noise.
    ///
    /// # Errors
    /// [`Error::EmptyGrid`] if width or height is 0; [`Error::EmptySet`] if `samples` is.
    pub const fn new(domain: Domain, size: [u32; 2], samples: u32) -> Result<Self, Error> {
        let [width, height] = size;
        if width == 0 || height == 0 {
            return Err(Error::EmptyGrid { columns: width, rows: height });
        }
        if samples == 0 {
            return Err(Error::EmptySet);
        }
        Ok(Self { domain, size, samples, log2: 32 - (samples - 1).leading_zeros() })
    }

    /// The domain of all pixels.
    #[must_use]
    pub const fn domain(&self) -> Domain {
        self.domain
    }

    /// Width and height in pixels.
    #[must_use]
    pub const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// How many samples a pixel takes.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    /// A pixel.
    ///
    /// # Errors
    /// [`Error::Pixel`] if it is outside.
    #[inline]
    pub const fn pixel(&self, x: u32, y: u32) -> Result<Pixel, Error> {
        let [width, height] = self.size;
        if x >= width || y >= height {
            return Err(Error::Pixel { pixel: [x, y], screen: self.size });
        }
        let place = spread(x) | spread(y) << 1;
        // The number of its first sample is place 2^log2, of up to 96 bits.
        let domain = self.domain.tile(place >> (32 - self.log2));
        let start = match self.log2 {
            32 => 0,
            log2 => (place << log2) as u32,
        };
        Ok(Pixel { domain, start, log2: self.log2 })
    }
}

/// A pixel of a [`Screen`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Pixel {
    domain: Domain,
    start: u32,
    log2: u32,
}

impl Pixel {
    /// The sampler of a sample.
    #[must_use]
    #[inline]
    pub const fn sampler(&self, sample: u32) -> Sampler {
        let set = (sample as u64) >> self.log2;
        let within = sample & ((1_u64 << self.log2) - 1) as u32;
        let domain = match set {
            0 => self.domain,
            set => self.domain.aside(*b"next set").tile(set),
        };
        Sampler::new(domain, self.start | within)
    }
}

/// The bits of a number, each followed by a 0 above it.
#[inline(always)]
const fn spread(x: u32) -> u64 {
    let mut x = x as u64;
    x = (x | x << 16) & 0x0000_ffff_0000_ffff;
    x = (x | x << 8) & 0x00ff_00ff_00ff_00ff;
    x = (x | x << 4) & 0x0f0f_0f0f_0f0f_0f0f;
    x = (x | x << 2) & 0x3333_3333_3333_3333;
    (x | x << 1) & 0x5555_5555_5555_5555
}
