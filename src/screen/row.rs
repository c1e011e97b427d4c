//! A row of pixels at a time: the same sample of each, as a sequence.
//!
//! All pixels of a screen's tile draw from one sequence, and differ by their index. So a row of them
//! has one domain, whose keys are mixed once, and the points of a block of pixels are vector code.

use super::{Screen, spread};
use crate::block::{Block, SHORT_BLOCK};
use crate::domain::Domain;
use crate::error::Error;
use crate::sampler::Sampler;
use crate::sequence::walk::{is_inside, repeat};
use crate::sequence::{Sequence, SobolOwen, looked_up};

/// Neighbouring pixels of a row of a [`Screen`], at one of their samples: a set of as many points as
/// there are pixels, a point each.
///
/// [`Points::fill`](crate::Points::fill) makes a lens point or a direction for each pixel in a
/// quarter of the time, or less, that they take one at a time. The points are those of
/// [`Pixel::sampler`](super::Pixel::sampler), bit for bit.
///
/// ```
/// use hemidisc::{Cosine, Domain, FastF32, Points, Screen};
/// const SKY: u32 = 1;
/// let screen = Screen::new(Domain::new(7), [640, 480], 16)?;
/// let sky = Cosine::<FastF32>::new();
/// let mut directions = [[0.0; 3]; 640];
/// let (y, sample, mut x) = (7, 3, 0);
/// // A row may end with a tile of the screen, so the next one takes the rest.
/// while let Ok(row) = screen.row(x, y, sample) {
///     x += Points::new(row.child(SKY), sky).fill(&mut directions[x as usize..]) as u32;
/// }
/// let one = screen.pixel(77, 7)?.sampler(3).child(SKY).sample(&sky);
/// assert_eq!(directions[77], one);
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Row {
    domain: Domain,
    /// The first pixel's x in its tile.
    x: u32,
    pixels: u32,
    /// The index of the sample without the bits of x.
    base: u32,
    /// log2 of the indices that a pixel has.
    log2: u32,
}

impl Screen {
    /// The pixels of row `y` from `x` on, up to the end of the row or of the screen's tile, at one of
    /// their samples. At 2^k samples a tile is 2^((33 - k) / 2) pixels wide, the exponent rounded
    /// down: 8192 at 64.
    ///
    /// # Errors
    /// [`Error::Pixel`] if the first is outside.
    #[inline]
    pub const fn row(&self, x: u32, y: u32, sample: u32) -> Result<Row, Error> {
        let sampler = match self.pixel(x, y) {
            Ok(pixel) => pixel.sampler(sample),
            Err(error) => return Err(error),
        };
        // Of the 32 - log2 bits of a place, x has every other one, the lowest first.
        let tile = 1 << ((33 - self.log2) / 2);
        let (x, right) = (x & (tile - 1), self.size[0] - x);
        let pixels = if right < tile - x { right } else { tile - x };
        let base = sampler.index() & !bits_of_x(tile - 1, self.log2);
        Ok(Row { domain: sampler.domain(), x, pixels, base, log2: self.log2 })
    }
}

/// x of up to 16 bits, spread, as bits of an index.
#[inline(always)]
const fn bits_of_x(x: u32, log2: u32) -> u32 {
    // At 2^32 indices a pixel there is no bit of x, nor a shift by 32.
    (spread(x) as u32) << (log2 & 31)
}

impl Row {
    /// How many pixels there are.
    #[must_use]
    pub const fn pixels(&self) -> u32 {
        self.pixels
    }

    /// The same pixels in a child of their domain, as [`Sampler::child`].
    #[must_use]
    #[inline]
    pub const fn child(self, key: u32) -> Self {
        Self { domain: self.domain.child(key), ..self }
    }

    /// The sampler of the pixel that is so many after the first; the first again after the last.
    #[must_use]
    #[inline]
    pub const fn sampler(&self, index: u32) -> Sampler {
        let index = repeat(index, self.pixels);
        Sampler::new(self.domain, self.base | bits_of_x(self.x + index, self.log2))
    }

    /// The pixels' points, by keys that are mixed once.
    #[inline(always)]
    const fn keyed(self) -> Keyed {
        Keyed { row: self, sequence: SobolOwen::in_domain(self.domain) }
    }
}

impl Sequence for Row {
    #[inline]
    fn size(&self) -> Option<u32> {
        Some(self.pixels)
    }

    #[inline]
    fn at(&self, index: u32) -> [u32; 2] {
        self.sampler(index).pair()
    }

    #[inline(always)]
    fn iter(&self, start: u32) -> impl Iterator<Item = [u32; 2]> {
        looked_up(self.keyed(), start)
    }

    #[inline(always)]
    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        self.keyed().points(start, u, v);
    }

    #[inline(always)]
    fn short_block(&self, start: u32, u: &mut Block<SHORT_BLOCK>, v: &mut Block<SHORT_BLOCK>) {
        self.keyed().points(start, u, v);
    }
}

#[derive(Clone, Copy)]
struct Keyed {
    row: Row,
    sequence: SobolOwen,
}

impl Keyed {
    /// The points from an index on.
    #[inline(always)]
    fn points<const N: usize>(&self, start: u32, u: &mut Block<N>, v: &mut Block<N>) {
        let Row { x, pixels, base, log2, .. } = self.row;
        if is_inside::<N>(start, pixels) {
            for (index, lane) in u.iter_mut().zip(0..) {
                *index = base | bits_of_x(x + start + lane, log2);
            }
        } else {
            for (index, lane) in u.iter_mut().zip(0..) {
                *index = self.row.sampler(start.wrapping_add(lane)).index();
            }
        }
        self.sequence.points(u, v);
    }
}

impl Sequence for Keyed {
    fn size(&self) -> Option<u32> {
        Some(self.row.pixels)
    }

    #[inline(always)]
    fn at(&self, index: u32) -> [u32; 2] {
        self.sequence.at(self.row.sampler(index).index())
    }
}
