//! Domains: independent streams of points for one (pixel, effect, bounce).
//!
//! A domain is a 64-bit state; a child hashes a key into it (`hash::absorb`). Its keys scramble
//! each axis and shuffle the index: two Sobol pairs that share an order leave 12 of the 16 cells of
//! a 4 x 4 grid of (u of one, u of the other) empty (B. Burley 2020, section 5; after OpenQMC's
//! domains).

#[cfg(any(feature = "serde", feature = "defmt"))]
use crate::bits::hash::release;
use crate::bits::{
    hash::{absorb, words},
    owen::scramble,
};
use crate::error::Error;
use core::ops::Range;

/// An independent stream of points: a `Copy` value of 8 bytes.
///
/// ```
/// use hemidisc::{Domain, sequence::SobolOwen};
/// const LENS: u32 = 0;
/// const LIGHT: u32 = 1;
/// let pixel = Domain::new(7).pixel(120, 64);
/// let lens = SobolOwen::in_domain(pixel.child(LENS));
/// let time = pixel.child(LENS).stream();
/// let bounce = pixel.child(2).child(LIGHT);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Domain {
    state: [u32; 2],
}

impl Domain {
    /// The root domain of a frame, scene or test.
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { state: [0x6865_6d69, 0x6469_7363] }.child(seed)
    }

    /// The domain of `key` under this one: an effect, a bounce, a frame number. Different keys
    /// always give different domains.
    #[must_use]
    pub const fn child(self, key: u32) -> Self {
        Self { state: absorb(self.state, key) }
    }

    /// The domain of a pixel under this one. No child has the same domain.
    #[must_use]
    pub const fn pixel(self, x: u32, y: u32) -> Self {
        let [a, b] = self.state;
        Self { state: absorb(absorb([b, a], x), y) }
    }

    /// The domain in which every sample of this one branches into `ways`: that of
    /// [`child(key)`](Self::child).
    ///
    /// The branches of all samples together are one stream, as even as an unsplit one.
    #[must_use]
    pub const fn split(self, key: u32, ways: u32) -> Split {
        Split { domain: self.child(key), ways }
    }

    /// The two words that are all of a domain: for a checkpoint, or another language.
    ///
    /// ```
    /// use hemidisc::Domain;
    /// let lens = Domain::new(7).pixel(120, 64).child(0);
    /// assert_eq!(Domain::from_words(lens.to_words()), lens);
    /// ```
    #[must_use]
    pub const fn to_words(self) -> [u32; 2] {
        self.state
    }

    /// The domain of two words that [`to_words`](Self::to_words) gave. Any other two are a domain
    /// as well.
    #[must_use]
    pub const fn from_words(words: [u32; 2]) -> Self {
        Self { state: words }
    }

    /// A well-mixed seed for a sequence that takes one.
    #[must_use]
    pub const fn seed(self) -> u32 {
        self.hashed(*b"seed")[0]
    }

    /// A one-dimensional stream of this domain, independent of the points drawn in it: the choice
    /// of a light, the time in a shutter.
    #[must_use]
    pub const fn stream(self) -> Stream {
        let [order, key, _] = self.hashed(*b"time");
        Stream { order, key }
    }

    /// Three independent keys: for the order and for each axis.
    pub(crate) const fn keys(self) -> [u32; 3] {
        self.hashed(*b"keys")
    }

    /// The domain of which these are the first two [`keys`](Self::keys).
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn of_keys(keys: [u32; 2]) -> Self {
        Self::unhashed(keys, *b"keys")
    }

    /// The domain of which these are the first two words hashed for a purpose.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    const fn unhashed(words: [u32; 2], purpose: [u8; 4]) -> Self {
        let [b, a] = release(words, u32::from_be_bytes(purpose));
        Self { state: [a, b] }
    }

    /// Hashes the state for a purpose; its words swap places, so that no purpose is a child's key.
    const fn hashed(self, purpose: [u8; 4]) -> [u32; 3] {
        let [a, b] = self.state;
        words([b, a], u32::from_be_bytes(purpose))
    }
}

/// The domain of a split, and which of its indices belong to a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Split {
    domain: Domain,
    ways: u32,
}

impl Split {
    /// The domain that the branches of all samples share.
    #[must_use]
    pub const fn domain(self) -> Domain {
        self.domain
    }

    /// The indices, in that domain, of the branches of one sample.
    ///
    /// # Errors
    /// [`Error::Range`] if they do not end below `u32::MAX`.
    pub const fn branches(self, sample: u32) -> Result<Range<u32>, Error> {
        if let Some(start) = sample.checked_mul(self.ways)
            && let Some(end) = start.checked_add(self.ways)
        {
            return Ok(start..end);
        }
        let (start, count) = (sample.saturating_mul(self.ways) as u64, self.ways as u64);
        Err(Error::Range { start, count, len: 1 << 32 })
    }
}

/// A one-dimensional stream: the Owen-scrambled van der Corput sequence in shuffled order.
///
/// Promise: each block of 2^k values that starts at a multiple of 2^k has one in each of 2^k
/// strata.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Stream {
    order: u32,
    key: u32,
}

impl Stream {
    /// The domain whose stream it is.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn domain(&self) -> Domain {
        Domain::unhashed([self.order, self.key], *b"time")
    }

    /// The value of any index, a `u32` cell like a coordinate.
    #[must_use]
    #[inline]
    pub const fn at(self, index: u32) -> u32 {
        scramble(scramble(index, self.order).reverse_bits(), self.key)
    }

    /// The value of any index as one of `ways` equally likely choices, 0 for `ways` = 0.
    #[must_use]
    #[inline]
    pub const fn choose(self, index: u32, ways: u32) -> u32 {
        ((self.at(index) as u64 * ways as u64) >> 32) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{collections::HashSet, vec::Vec};

    #[test]
    fn keys_never_collide_among_siblings_and_rarely_elsewhere() {
        let root = Domain::new(0);
        let mut seen = HashSet::new();
        for key in (0..20_000).chain([u32::MAX, 1 << 31]) {
            assert!(seen.insert(root.child(key)), "child {key}");
        }
        assert_ne!(root.pixel(1, 2), root.child(1).child(2));
        for (x, y) in (0..200).flat_map(|x| (0..200).map(move |y| (x, y))) {
            assert!(seen.insert(root.pixel(x, y)), "pixel {x} {y}");
        }
    }

    #[test]
    fn the_branches_of_all_samples_are_the_whole_stream() {
        let split = Domain::new(3).split(5, 4);
        assert_eq!(split.domain(), Domain::new(3).child(5));
        let indices: Vec<u32> = (0..9).flat_map(|sample| split.branches(sample).unwrap()).collect();
        assert!(indices.into_iter().eq(0..36));
        assert_eq!(Domain::new(0).split(1, 0).branches(7), Ok(0..0));
        let last = u32::MAX / 4;
        assert_eq!(split.branches(last - 1), Ok(u32::MAX - 7..u32::MAX - 3));
        let error = Error::Range { start: u32::MAX.into(), count: 4, len: 1 << 32 };
        assert_eq!(split.branches(last + 1), Err(error));
    }

    #[test]
    fn choices_are_even() {
        let stream = Domain::new(1).stream();
        let mut counts = [0; 5];
        for index in 0..1000 {
            counts[stream.choose(index, 5) as usize] += 1;
        }
        assert!(counts.iter().all(|count| (195..=205).contains(count)), "{counts:?}");
        assert_eq!(stream.choose(9, 0), 0);
    }
}
