//! What an absent effect costs and changes: nothing. And that pictures do not depend on how they are split.

mod closed_forms;
mod command;
mod domains;
mod noise;
mod pictures;
mod subsets;

use crate::assembly::ARITHMETICS;
use crate::description::Scene;
use crate::effects::{Effect, Effects};
use crate::file;
use crate::frame::{Frame, Settings};
use crate::sequence::Sequence;

const SMALL: Settings =
    Settings { size: [24, 16], samples: 4, sequence: Sequence::SobolOwen, seed: 5 };

fn scene(name: &str) -> Scene {
    let found = file::scene(name);
    found.unwrap_or_else(|_| panic!("no scene {name}")).1
}

fn subsets() -> impl Iterator<Item = Effects> {
    let bit = |n: usize, effect: Effect| n >> effect as usize & 1 == 1;
    (0..16).map(move |n| Effect::ALL.into_iter().filter(|effect| bit(n, *effect)).collect())
}

fn rendered(arithmetic: &str, scene: &Scene, effects: Effects, settings: &Settings) -> Frame {
    let render = crate::assembly::renderer_of(arithmetic).unwrap();
    render(scene, effects, settings, &mut || {}).unwrap()
}

fn each_arithmetic() -> impl Iterator<Item = &'static str> {
    ARITHMETICS.iter().map(|(name, _)| *name)
}

/// The bits of a picture, where -0 is not 0 and NaN is itself.
fn bits(frame: &Frame) -> Vec<u64> {
    frame.pixels.iter().flatten().map(|component| component.to_bits()).collect()
}
