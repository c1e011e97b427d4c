//! Domains: independent streams of points for one (pixel, effect, bounce).
//!
//! A domain is a 64-bit state. A child takes one multiplication, and a draw hashes the state
//! (`bits/state.rs`): a path derives many domains and draws from few (after OpenQMC's domains). Its
//! keys scramble each axis and shuffle the index: two Sobol pairs that share an order leave 12 of
//! the 16 cells of a 4 x 4 grid of (u of one, u of the other) empty (B. Burley 2020, section 5).

#[cfg(any(feature = "serde", feature = "defmt"))]
use crate::bits::state::unfinish;
use crate::bits::{
    owen::scramble,
    state::{finish, of_words, step, to_words},
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
    /// The lower word first.
    state: [u32; 2],
}

impl Domain {
    /// The root domain of a frame, scene or test.
    #[must_use]
    pub const fn new(seed: u32) -> Self {
        Self { state: [0x6469_7363, 0x6865_6d69] }.child(seed)
    }

    /// The domain of `key` under this one: an effect, a bounce, a frame number. Different keys
    /// always give different domains, and so do different pairs of keys, for a child of a child.
    #[must_use]
    #[inline]
    pub const fn child(self, key: u32) -> Self {
        self.stepped(key as u64)
    }

    /// The domain of a pixel under this one. Different pixels always have different domains, and no
    /// child has the same domain as a pixel with y < 2^31.
    #[must_use]
    #[inline]
    pub const fn pixel(self, x: u32, y: u32) -> Self {
        self.stepped(of_words([x, y]).wrapping_add(PIXELS))
    }

    #[inline(always)]
    const fn stepped(self, key: u64) -> Self {
        Self { state: to_words(step(of_words(self.state), key)) }
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
    ///
    /// It has half the bits of a domain: among 2^16 domains two may have the same. Sequences
    /// [in a domain](crate::sequence::InDomain) take all of it.
    #[must_use]
    #[inline]
    pub const fn seed(self) -> u32 {
        self.words(*b"the seed")[0]
    }

    /// A one-dimensional stream of this domain, independent of the points drawn in it: the choice
    /// of a light, the time in a shutter.
    #[must_use]
    #[inline]
    pub const fn stream(self) -> Stream {
        let [key, order] = self.words(*b"a stream");
        Stream { order, key }
    }

    /// Three keys, for the order and for each axis, independent of those of other domains and any
    /// two of each other.
    #[inline]
    pub(crate) const fn keys(self) -> [u32; 3] {
        let [u, order] = to_words(finish(of_words(self.state)));
        [order, u, (order ^ u.rotate_left(16)).wrapping_mul(0x9e37_79b9)]
    }

    /// The domain of which these are the first two [`keys`](Self::keys).
    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn of_keys([order, u]: [u32; 2]) -> Self {
        Self { state: to_words(unfinish(of_words([u, order]))) }
    }

    /// Another domain of the same use: of the numbers that no longer fit in an index. The first
    /// 2^32 are this one's.
    #[inline]
    pub(crate) const fn tile(self, tile: u64) -> Self {
        if tile == 0 { self } else { self.stepped(tile.wrapping_add(TILES)) }
    }

    /// Another domain for a purpose, which is no child, pixel or tile.
    #[inline]
    pub(crate) const fn aside(self, purpose: [u8; 8]) -> Self {
        Self { state: to_words(of_words(self.state) ^ u64::from_be_bytes(purpose)) }
    }

    /// Two independent words for a purpose.
    #[inline(always)]
    const fn words(self, purpose: [u8; 8]) -> [u32; 2] {
        to_words(finish(of_words(self.aside(purpose).state)))
    }
}

/// Added to the key of a pixel, so that none with y < 2^31 is a child's.
const PIXELS: u64 = 0x7069_7865 << 32;

/// Added to the number of a tile: far from the keys of children and of pixels of any picture.
const TILES: u64 = 0xd1b5_4a32_d192_ed03;

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
        let keys = of_words([self.key, self.order]);
        Domain { state: to_words(unfinish(keys)) }.aside(*b"a stream")
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
        choice(self.at(index), ways)
    }
}

/// A cell as one of `ways` equally likely choices, 0 for `ways` = 0.
#[inline]
pub(crate) const fn choice(cell: u32, ways: u32) -> u32 {
    ((cell as u64 * ways as u64) >> 32) as u32
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

    /// How often each of the 96 bits of three keys differs between two domains.
    struct Flips([u32; 96]);

    impl Flips {
        fn add(&mut self, a: Domain, b: Domain) {
            for (word, (a, b)) in a.keys().into_iter().zip(b.keys()).enumerate() {
                for bit in 0..32 {
                    self.0[32 * word + bit] += (a ^ b) >> bit & 1;
                }
            }
        }
    }

    /// Domains whose paths differ in one bit: of a key, of a key further up, of a pixel. Every bit
    /// of every key is another in 45-55 % of 4,096 pairs.
    #[test]
    fn every_bit_of_a_path_flips_every_bit_of_the_keys() {
        type Path = fn(Domain, u32) -> Domain;
        let paths: [(&str, Path); 7] = [
            ("seed", |_, key| Domain::new(key)),
            ("child", |root, key| root.child(key)),
            ("parent", |root, key| root.child(key).child(3)),
            ("six up", |root, key| (0..6).fold(root.child(key), |domain, _| domain.child(1))),
            ("x", |root, x| root.pixel(x, 5)),
            ("y", |root, y| root.pixel(5, y).child(1)),
            ("a tile", |root, tile| root.tile(tile.into()).child(1)),
        ];
        for (what, path) in paths {
            for bit in 0..32 {
                let mut flips = Flips([0; 96]);
                for i in 0..4096 {
                    let root = Domain::new(i);
                    // Small keys, as renderers have, and others.
                    let small = i & 1 == 0 && what != "seed";
                    let key = if small { i >> 1 & 15 } else { i.wrapping_mul(0x9e37_79b9) };
                    flips.add(path(root, key), path(root, key ^ 1 << bit));
                }
                for (place, count) in flips.0.into_iter().enumerate() {
                    let even = (1843..2253).contains(&count);
                    assert!(even, "{what}, bit {bit} -> {place}: {count} of 4096");
                }
            }
        }
    }

    /// What steps a renderer takes: the keys before and after have nothing in common. Each bit is
    /// another in 49-51 % of 2^17 pairs.
    #[test]
    fn neighbours_have_nothing_in_common() {
        type Neighbours = fn(Domain, u32) -> [Domain; 2];
        let families: [(&str, Neighbours); 7] = [
            ("siblings", |root, i| [root.child(i), root.child(i + 1)]),
            ("parents and children", |root, i| [root.child(i), root.child(i).child(i & 7)]),
            ("parents and first children", |root, i| [root.child(i), root.child(i).child(0)]),
            ("in x", |root, i| [root.pixel(i & 511, i >> 9), root.pixel((i & 511) + 1, i >> 9)]),
            ("in y", |root, i| [root.pixel(i & 511, i >> 9), root.pixel(i & 511, (i >> 9) + 1)]),
            ("frames", |_, i| [Domain::new(i).pixel(3, 4), Domain::new(i + 1).pixel(3, 4)]),
            ("tiles", |root, i| [root.tile(i.into()), root.tile(i as u64 + 1)]),
        ];
        for (what, neighbours) in families {
            let mut flips = Flips([0; 96]);
            for i in 0..1 << 17 {
                let [a, b] = neighbours(Domain::new(7), i);
                flips.add(a, b);
            }
            for (place, count) in flips.0.into_iter().enumerate() {
                assert!((64_225..66_847).contains(&count), "{what}, bit {place}: {count} of 2^17");
            }
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
