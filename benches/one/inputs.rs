//! What calls take, from memory: coordinates, an index, keys, and what a ray hit.

use benches::failure::Failure;
use benches::random::generator;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Domain, Sampler, Unit};
use rand_distr::{Distribution, UnitSphere};
use rand_xoshiro::rand_core::Rng;

/// Calls between two readings of the clock. What they take stays in the first cache.
pub(crate) const WINDOW: usize = 512;
/// Each round has other inputs than the one before. The branch predictor learns those of one window,
/// and would then predict branches that it cannot predict in a renderer.
const WINDOWS: usize = 16;
/// Samples of a pixel; `sobol_burley` has no more.
const SAMPLES: u32 = 1 << 16;

/// What there is for one call.
#[derive(Clone, Copy)]
pub(crate) struct Input {
    pair: [u32; 2],
    index: u32,
    key: u32,
    sequence: SobolOwen,
    normal: Unit<f32>,
    arriving: Unit<f32>,
}

/// An input that waits for the result of the call before.
///
/// The word of that result is masked to 0, which neither the compiler nor the processor knows ahead.
/// So every word that is taken waits, and none of them changes. Unit vectors that were checked
/// before do not wait.
#[derive(Clone, Copy)]
pub(crate) struct Given {
    input: Input,
    last: u32,
}

impl Given {
    #[inline(always)]
    pub(crate) fn after(input: &Input, last: u32) -> Self {
        Self { input: *input, last }
    }

    /// Coordinates.
    #[inline(always)]
    pub(crate) fn pair(self) -> [u32; 2] {
        self.input.pair.map(|word| self.waiting(word))
    }

    /// The index of a sample.
    #[inline(always)]
    pub(crate) fn index(self) -> u32 {
        self.waiting(self.input.index)
    }

    /// The key of a child, or a seed.
    #[inline(always)]
    pub(crate) fn key(self) -> u32 {
        self.waiting(self.input.key)
    }

    /// A domain: any two words are one.
    #[inline(always)]
    pub(crate) fn domain(self) -> Domain {
        Domain::from_words(self.pair())
    }

    /// A path at a sample of that domain.
    #[inline(always)]
    pub(crate) fn sampler(self) -> Sampler {
        Sampler::new(self.domain(), self.index())
    }

    /// A pixel of a screen of 4096 x 4096.
    #[inline(always)]
    pub(crate) fn pixel(self) -> [u32; 2] {
        self.pair().map(|word| word >> 20)
    }

    /// The sequence of a domain, made before.
    #[inline(always)]
    pub(crate) fn sequence(self) -> SobolOwen {
        self.input.sequence
    }

    /// A normal as a ray finds it, or a point of the unit sphere.
    #[inline(always)]
    pub(crate) fn normal(self) -> [f32; 3] {
        self.input.normal.get().map(|x| f32::from_bits(self.waiting(x.to_bits())))
    }

    /// The same, checked before.
    #[inline(always)]
    pub(crate) fn unit_normal(self) -> Unit<f32> {
        self.input.normal
    }

    /// The direction in which light arrives, on either side of the surface; checked before.
    #[inline(always)]
    pub(crate) fn arriving(self) -> Unit<f32> {
        self.input.arriving
    }

    /// A word that waits: for what takes none of the above, such as a generator.
    #[inline(always)]
    pub(crate) fn waiting(self, word: u32) -> u32 {
        word ^ self.last
    }
}

/// Windows of inputs.
pub(crate) struct Inputs(Vec<Input>);

impl Inputs {
    pub(crate) fn new() -> Result<Self, Failure> {
        let mut rng = generator(WINDOW);
        let mut input = || {
            let mut unit = || Unit::normalized(UnitSphere.sample(&mut rng));
            let (normal, arriving) = (unit()?, unit()?);
            let pair = [rng.next_u32(), rng.next_u32()];
            let (index, key) = (rng.next_u32() % SAMPLES, rng.next_u32());
            let sequence = SobolOwen::new(rng.next_u32());
            Ok(Input { pair, index, key, sequence, normal, arriving })
        };
        (0..WINDOW * WINDOWS).map(|_| input()).collect::<Result<_, _>>().map(Self)
    }

    /// One after another, without end.
    pub(crate) fn windows(&self) -> impl Iterator<Item = &[Input]> {
        self.0.chunks_exact(WINDOW).cycle()
    }
}
