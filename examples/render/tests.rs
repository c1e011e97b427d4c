//! An absent effect costs and changes nothing, and pictures do not depend on how they are split.

mod closed_forms;
mod command;
mod domains;
mod noise;
mod pictures;
mod subsets;
mod sums;

use examples::render::assembly::{renderers, with_rows};
use examples::render::description::Scene;
use examples::render::effects::{Effect, Effects};
use examples::render::file;
use examples::render::frame::{Frame, Row, Settings};
use examples::render::sequence::{Pixels, Sequence};
use examples::render::sums::means;
use hemidisc::arithmetic::{Real, Root};
use testkit::arithmetics::{EachRoot, Tested, every_root};

const SMALL: Settings = Settings {
    size: [24, 16],
    samples: 4,
    sequence: Sequence::SobolOwen,
    pixels: Pixels::Screen,
    seed: 5,
};

fn scene(name: &str) -> Scene {
    let found = file::text(name).and_then(|(path, text)| file::scene(&path, &text));
    found.unwrap_or_else(|_| panic!("no scene {name}"))
}

fn subsets() -> impl Iterator<Item = Effects> {
    let bit = |n: usize, effect: Effect| n >> effect as usize & 1 == 1;
    let of = move |n| Effect::ALL.iter().copied().filter(|effect| bit(n, *effect)).collect();
    (0..1 << Effect::ALL.len()).map(of)
}

fn rendered(arithmetic: &str, scene: &Scene, effects: Effects, settings: &Settings) -> Frame {
    let render = examples::render::assembly::renderer_of(arithmetic).unwrap();
    render(scene, effects, settings, &settings.whole(), &mut || {}).unwrap()
}

/// The bits of the arithmetic's own sums, which are finer than what a frame keeps of them: -0 is
/// not 0.
fn bits(arithmetic: &str, scene: &Scene, effects: Effects) -> Vec<u64> {
    struct Bits<'a>(&'a str, &'a Scene, Effects, Option<Vec<u64>>);
    impl EachRoot for Bits<'_> {
        fn each<A: Root<Real: Real> + Tested>(&mut self) {
            if A::NAME == self.0 {
                self.3 = Some(bits_in::<A>(self.1, self.2));
            }
        }
    }
    let mut bits = Bits(arithmetic, scene, effects, None);
    every_root(&mut bits);
    bits.3.unwrap_or_else(|| panic!("{arithmetic} is not of floats"))
}

fn bits_in<A: Root>(scene: &Scene, effects: Effects) -> Vec<u64> {
    let mut bits = Vec::new();
    let Settings { size: [width, height], samples, .. } = SMALL;
    let mut run = |row: &Row<'_, A::Real>| {
        for y in 0..height {
            let mut sums = vec![[A::Real::ZERO; 3]; width as usize];
            row([0, y], 0..samples.into(), &mut sums);
            bits.extend(sums.into_iter().flatten().map(|sum| Into::<f64>::into(sum).to_bits()));
        }
    };
    with_rows::<A>(scene, effects, &SMALL, &mut run).unwrap();
    bits
}

/// Mean radiance.
fn pixels(frame: &Frame, settings: &Settings) -> Vec<[f64; 3]> {
    means(&frame.sums, settings.samples.into())
}

fn each_arithmetic() -> impl Iterator<Item = &'static str> {
    renderers().map(|(name, _)| name)
}
