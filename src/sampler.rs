#![doc = include_str!("../docs/renderer.md")]

mod weight;

pub use weight::Weight;

use crate::domain::{Domain, choice};
use crate::map::Map;
use crate::sequence::{InDomain, Sequence, SobolOwen};
use core::fmt;
use core::hash::{Hash, Hasher};

/// The numbers of one sample: a `Copy` value of at most 16 bytes.
///
/// Draws do not change it: whoever wants another number takes a [`child`](Self::child). All samples
/// of a pixel share the pixel's domain and differ in their index, so what they draw for one child
/// is spread evenly over its square. (A domain for each sample, `pixel.child(i)` with index 0, is
/// as noisy as random numbers.)
///
/// ```
/// use hemidisc::{Cosine, Domain, FastF32, Frame, Sampler};
/// # use hemidisc::Error;
/// const LENS: u32 = 0;
/// const BOUNCE: u32 = 1;
/// const SURVIVES: u32 = 2;
/// # fn main() -> Result<(), Error> {
/// let lobe = Cosine::<FastF32>::new();
/// let pixel = Domain::new(7).pixel(120, 64);
/// for i in 0..16 {
///     let mut path = Sampler::new(pixel, i);
///     let lens = path.child(LENS).pair();
///     for _ in 0..4 {
///         path = path.child(BOUNCE);
///         let normal = Frame::new([0.0, 1.0, 0.0])?;
///         let leaving = path.sample(&lobe.about(normal));
///         if !path.child(SURVIVES).chance(0.8) {
///             break;
///         }
///     }
/// }
/// # Ok(())
/// # }
/// ```
///
/// A sampler draws from [`SobolOwen`] unless another family is named: `Sampler::<R2>::of(..)`.
pub struct Sampler<S: InDomain = SobolOwen> {
    domain: Domain,
    index: u32,
    size: S::Size,
}

// A derive would want these traits of the family, which is no part of the value.
impl<S: InDomain> Copy for Sampler<S> {}

impl<S: InDomain> Clone for Sampler<S> {
    #[inline]
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: InDomain> PartialEq for Sampler<S> {
    fn eq(&self, other: &Self) -> bool {
        (self.domain, self.index, self.size) == (other.domain, other.index, other.size)
    }
}

impl<S: InDomain> Eq for Sampler<S> {}

impl<S: InDomain> Hash for Sampler<S> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.domain, self.index, self.size).hash(state);
    }
}

impl<S: InDomain> fmt::Debug for Sampler<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { domain, index, size } = self;
        f.debug_struct("Sampler")
            .field("domain", domain)
            .field("index", index)
            .field("size", size)
            .finish()
    }
}

impl Sampler {
    /// The sample of an index in the domain of a pixel.
    #[must_use]
    #[inline]
    pub const fn new(domain: Domain, index: u32) -> Self {
        Self { domain, index, size: () }
    }
}

impl<S: InDomain> Sampler<S> {
    /// The sample of an index in a domain, drawn from a family's members of a size.
    #[must_use]
    #[inline]
    pub const fn of(domain: Domain, size: S::Size, index: u32) -> Self {
        Self { domain, index, size }
    }

    /// What it draws for.
    #[must_use]
    pub const fn domain(&self) -> Domain {
        self.domain
    }

    /// Which sample it is.
    #[must_use]
    pub const fn index(&self) -> u32 {
        self.index
    }

    /// What its sequences take besides the domain.
    #[must_use]
    pub const fn size(&self) -> S::Size {
        self.size
    }

    /// The same sample in the domain of `key` under its own: for an effect or a bounce. It costs
    /// one multiplication.
    #[must_use]
    #[inline]
    pub const fn child(self, key: u32) -> Self {
        Self { domain: self.domain.child(key), ..self }
    }

    /// The samples that this one branches into, `ways` of them, in the domain of `key`: the
    /// branches of all samples together are as even as one sequence.
    ///
    /// ```
    /// use hemidisc::{Domain, Sampler};
    /// let path = Sampler::new(Domain::new(7).pixel(3, 4), 5);
    /// for light in path.split(1, 4) {
    ///     let [u, v] = light.pair();
    /// }
    /// ```
    #[inline]
    pub fn split(self, key: u32, ways: u32) -> impl Iterator<Item = Self> + Clone {
        let (domain, size) = (self.domain.child(key), self.size);
        let first = u64::from(self.index) * u64::from(ways);
        (first..first + u64::from(ways)).map(move |branch| {
            let domain = domain.tile(branch >> 32);
            Self { domain, index: branch as u32, size }
        })
    }

    /// A pair of coordinates.
    #[must_use]
    #[inline]
    pub fn pair(self) -> [u32; 2] {
        S::in_domain(self.domain, self.size).at(self.index)
    }

    /// A point of a map.
    #[must_use]
    #[inline]
    pub fn sample<M: Map>(self, map: &M) -> M::Point {
        map.sample(self.pair())
    }

    /// Two pairs for an effect of four dimensions, such as a point of the pixel and one of the
    /// lens. The first is [`pair`](Self::pair).
    ///
    /// From [`SobolOwen`] all four are even together, which two pairs of different domains are not:
    /// on the edges of blurred objects that costs 1.1 to 1.4 times the error.
    #[must_use]
    #[inline]
    pub fn joint(self) -> [[u32; 2]; 2] {
        S::joint(self.domain, self.size, self.index)
    }

    /// One number, a `u32` cell as a coordinate is: the time in a shutter. It is independent of
    /// the pair of the same domain.
    #[must_use]
    #[inline]
    pub fn cell(self) -> u32 {
        S::cell(self.domain, self.size, self.index)
    }

    /// One number in [0, 1), a multiple of 2^-24, never rounded up to 1.
    #[must_use]
    #[inline]
    pub fn unit_f32(self) -> f32 {
        (self.cell() >> 8) as f32 * (1.0 / 16_777_216.0)
    }

    /// One number in [0, 1), a multiple of 2^-32.
    #[must_use]
    #[inline]
    pub fn unit_f64(self) -> f64 {
        f64::from(self.cell()) * (1.0 / 4_294_967_296.0)
    }

    /// One of `ways` equally likely choices; 0 for `ways` = 0.
    #[must_use]
    #[inline]
    pub fn choose(self, ways: u32) -> u32 {
        choice(self.cell(), ways)
    }

    /// True with a probability, which is rounded down to a multiple of 2^-32: always from 1 on,
    /// never up to 0 and for NaN.
    #[must_use]
    #[inline]
    pub fn chance(self, probability: f32) -> bool {
        u64::from(self.cell()) < (probability * 4_294_967_296.0) as u64
    }

    /// One of several choices by their weights, and what is left of the number: where it is within
    /// the choice, as a cell. `None` if there is no choice, or none has a weight.
    ///
    /// The weights are given as their sums so far, the last of which is the total. They must not
    /// decrease. A choice of weight 0 is never made. The search takes log2 of the number of choices
    /// steps.
    ///
    /// ```
    /// use hemidisc::{Domain, Sampler};
    /// let path = Sampler::new(Domain::new(7).pixel(3, 4), 5);
    /// // Lamps of powers 1, 0 and 3.
    /// let (lamp, rest) = path.pick(&[1.0_f32, 1.0, 4.0]).unwrap();
    /// assert!(lamp == 0 || lamp == 2);
    /// ```
    #[must_use]
    #[inline]
    pub fn pick<W: Weight>(self, sums: &[W]) -> Option<(usize, u32)> {
        W::pick(sums, self.cell())
    }
}
