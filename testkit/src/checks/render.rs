//! Tiny scenes through the reference renderer. No NaN or negative number reaches the buffer. A
//! split changes no bit. An absent effect draws no point, and radius 0 equals absence.

mod scene;

use super::roots::{EachRoot, every_root, wide};
use crate::arithmetics::Tested;
use crate::digest::Digest;
use crate::tracer::{Counts, Light, PointLight, Renderer, Source, Tally};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::DiscLight;
use hemidisc::sequence::{InDomain, Random, Sequence, SobolOwen};
use hemidisc::{Domain, Error, Sampler, Screen};
use scene::{AnyLens, Scene};

#[derive(Arbitrary, Debug)]
struct Input {
    scene: Scene,
    /// Bit 0: random numbers; bit 1: those of a screen.
    kind: u8,
    /// Of the row and of the samples.
    cuts: [u8; 2],
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let mut input: Input = Unstructured::new(data).arbitrary()?;
    every_root(&mut input);
    Ok(())
}

impl EachRoot for Input {
    fn each<A: Root<Real: Real> + Tested>(&mut self) {
        match picture::<A>(self) {
            Ok(()) => {}
            Err(error) => assert_eq!(error, Error::NoDirection, "{:?}", self),
        }
    }
}

/// Pixels of a row at most, and samples.
const WIDTH: u32 = 4;
const SAMPLES: u32 = 4;

type Row<A> = [[<A as hemidisc::arithmetic::Arithmetic>::Real; 3]; WIDTH as usize];

fn picture<A: Root<Real: Real> + Tested>(input: &Input) -> Result<(), Error> {
    let scene = &input.scene;
    let lens = scene.lens::<A>();
    let (position, frame) = scene.lamp::<A>()?;
    let point = PointLight { position, normal: frame.unit(), two_sided: scene.lamp.two_sided };
    let row = match scene.lamp.radius {
        None => checked_row::<A, _>(input, lens, point)?,
        Some(radius) => {
            let disc = DiscLight::<A>::new(position, frame, scene.radius::<A>(radius))?;
            let disc = if scene.lamp.two_sided { disc.two_sided() } else { disc };
            let row = checked_row(input, lens, disc)?;
            if radius == 0 {
                assert_eq!(row, checked_row::<A, _>(input, lens, point)?, "{} {input:?}", A::NAME);
            }
            row
        }
    };
    if scene.is_sharp() && scene.has_lens() && scene.lamp.radius.is_none() {
        let sharp = checked_row::<A, _>(input, AnyLens::Pinhole, point)?;
        assert_eq!(row, sharp, "{} {input:?}", A::NAME);
    }
    Ok(())
}

/// A row of the scene, whole and in four parts.
fn checked_row<A: Root<Real: Real> + Tested, S: Light<A>>(
    input: &Input,
    lens: AnyLens<A>,
    light: S,
) -> Result<Row<A>, Error> {
    let scene = &input.scene;
    let size = scene.size.map(|pixels| u32::from(pixels) % WIDTH + 1);
    let renderer = Renderer {
        camera: scene.camera::<A>(size)?,
        lens,
        light,
        intensity: scene.intensity::<A>(),
        ambient: scene.ambient::<A>(),
        occlusion: scene.occlusion::<A>(),
        sky: scene.sky::<A>(),
        spheres: &scene.spheres::<A>(),
        planes: &scene.planes::<A>(),
        source: Drawn { domain: Domain::new(scene.seed), size, kind: input.kind },
    };
    let what = || format!("{} {input:?}", A::NAME);
    let samples = u32::from(scene.samples) % SAMPLES + 1;
    let (width, y) = (size[0] as usize, scene.seed % size[1]);
    let mut whole = [[A::Real::ZERO; 3]; WIDTH as usize];
    let counts = renderer.row([0, y], 0..samples, &mut whole[..width]);
    for component in whole.into_iter().flat_map(wide) {
        assert!(component >= 0.0 && component.is_finite(), "{}: {whole:?}", what());
    }
    called_for(counts, scene, (width as u32 * samples).into(), &what);

    let mut parts = [[A::Real::ZERO; 3]; WIDTH as usize];
    let [at, before] = [usize::from(input.cuts[0]) % width, usize::from(input.cuts[1])];
    let before = before as u32 % samples;
    let (left, right) = parts[..width].split_at_mut(at);
    let mut sum = Counts::default();
    for range in [0..before, before..samples] {
        sum += renderer.row([at as u32, y], range.clone(), right);
        sum += renderer.row([0, y], range, left);
    }
    let digest = |row: Row<A>| {
        let mut digest = Digest::new();
        row.into_iter().for_each(|pixel| digest.value_of(pixel));
        digest.value()
    };
    assert_eq!((digest(parts), sum), (digest(whole), counts), "{}", what());
    Ok(whole)
}

/// The numbers of a kind, under a domain and for a size in pixels.
struct Drawn {
    domain: Domain,
    size: [u32; 2],
    kind: u8,
}

/// Members of either family.
struct Either;

impl InDomain for Either {
    /// Whether they are random.
    type Size = bool;
    type Sequence = EitherOf;

    fn in_domain(domain: Domain, random: bool) -> EitherOf {
        if random {
            EitherOf::Random(Random::in_domain(domain))
        } else {
            EitherOf::Owen(SobolOwen::in_domain(domain))
        }
    }
}

#[derive(Clone, Copy)]
enum EitherOf {
    Random(Random),
    Owen(SobolOwen),
}

impl Sequence for EitherOf {
    fn size(&self) -> Option<u32> {
        None
    }

    fn at(&self, index: u32) -> [u32; 2] {
        match self {
            Self::Random(random) => random.at(index),
            Self::Owen(owen) => owen.at(index),
        }
    }
}

impl Source for Drawn {
    type Family = Either;

    fn sampler(&self, pixel: [u32; 2], sample: u32) -> Sampler<Either> {
        let apart = self.domain.sampler(pixel, sample);
        let sampler = match (self.kind & 3, Screen::new(self.domain, self.size, SAMPLES)) {
            (2 | 3, Ok(screen)) => screen.sampler(pixel, sample),
            _ => apart,
        };
        Sampler::of(sampler.domain(), self.kind & 1 == 1, sampler.index())
    }
}

/// Points are drawn for what the scene calls for, and for nothing else.
fn called_for(counts: Counts, scene: &Scene, samples: u64, what: &impl Fn() -> String) {
    let none = Tally::default();
    assert_eq!(counts.base.points, samples, "{}", what());
    if counts.lens != none {
        assert_eq!(counts.lens, Tally { points: samples, rays: samples }, "{}", what());
        assert!(scene.has_lens(), "{}", what());
    }
    assert!(counts.glossy == none || scene.has_glossy(), "{}", what());
    assert!(counts.occlusion == none || scene.has_occlusion(), "{}", what());
    assert!(counts.light == none || scene.lamp.radius.is_some(), "{}", what());
}
