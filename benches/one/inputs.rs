//! What calls take, from memory: coordinates, an index, keys, and what a ray hit.

use benches::failure::Failure;
use benches::random::generator;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Domain, Unit};
use rand_distr::{Distribution, UnitSphere};
use rand_xoshiro::rand_core::Rng;

/// Calls between two readings of the clock. What they take stays in the first cache.
pub(crate) const WINDOW: usize = 512;
/// Each round has other values than the one before. The branch predictor would learn those of one
/// window, and would then predict branches that it cannot predict in a renderer.
const WINDOWS: usize = 16;
/// Samples of a pixel; `sobol_burley` has no more.
const SAMPLES: u32 = 1 << 16;

/// What is there for one call.
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
/// `last` is 0, and the compiler does not know that. So every word that is taken waits, and none of
/// them changes.
#[derive(Clone, Copy)]
pub(crate) struct Given {
    input: Input,
    last: u32,
}

/// Where a path goes on: the domain of its last bounce, the key of the next one, the sample's index
/// and the normal.
///
/// Generators take the same, and leave most of it, so that no call is given less to read than
/// another.
#[derive(Clone, Copy)]
pub(crate) struct Bounce {
    pub(crate) domain: Domain,
    pub(crate) key: u32,
    pub(crate) index: u32,
    pub(crate) normal: [f32; 3],
    /// 0, of which a draw that takes nothing else is made to wait.
    pub(crate) last: u32,
}

impl Given {
    pub(crate) fn after(input: &Input, last: u32) -> Self {
        Self { input: *input, last }
    }

    /// Coordinates.
    pub(crate) fn pair(self) -> [u32; 2] {
        self.input.pair.map(|word| word ^ self.last)
    }

    /// The index of a sample.
    pub(crate) fn index(self) -> u32 {
        self.input.index ^ self.last
    }

    /// A key, and the index of a sample.
    pub(crate) fn key(self) -> (u32, u32) {
        (self.input.key ^ self.last, self.index())
    }

    /// A domain, the key of a child and the index of a sample.
    pub(crate) fn child(self) -> (Domain, u32, u32) {
        let (key, index) = self.key();
        (Domain::from_words(self.pair()), key, index)
    }

    /// The sequence of a domain, ready, and the index of a sample.
    pub(crate) fn ready(self) -> (SobolOwen, u32) {
        (self.input.sequence, self.index())
    }

    /// Where a path goes on.
    pub(crate) fn bounce(self) -> Bounce {
        let (domain, key, index) = self.child();
        Bounce { domain, key, index, normal: self.position(), last: self.last }
    }

    /// Where a path goes on, about a normal that was checked before.
    pub(crate) fn checked_bounce(self) -> (Bounce, Unit<f32>) {
        (self.bounce(), self.input.normal)
    }

    /// A point of the unit sphere.
    pub(crate) fn position(self) -> [f32; 3] {
        self.input.normal.get().map(|x| f32::from_bits(x.to_bits() ^ self.last))
    }

    /// A position, and coordinates.
    pub(crate) fn seen(self) -> ([f32; 3], [u32; 2]) {
        (self.position(), self.pair())
    }

    /// A normal, and coordinates.
    pub(crate) fn normal(self) -> (Unit<f32>, [u32; 2]) {
        (self.input.normal, self.pair())
    }

    /// The direction of arrival, a normal, and coordinates.
    pub(crate) fn hit(self) -> (Unit<f32>, Unit<f32>, [u32; 2]) {
        (self.input.arriving, self.input.normal, self.pair())
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
