//! What a path draws: the pair of a domain's child, a point of the lens, and the direction of the
//! next bounce.

use crate::calls::Calls;
use crate::inputs::Given;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Frame, Screen};

/// What is drawn at a bounce, as the key of a domain.
const DIRECTION: u32 = 3;

pub(crate) fn every(calls: &mut Calls<'_>) {
    calls.call("pair/child", child);
    calls.call("pair/ready", ready);
    calls.call("pair/screen", screen);
    calls.call("pair/joint", joint);
    calls.call("pair/chance", chance);
    calls.call("lens/concentric", lens);
    calls.call("screen/cosine", direction);
    calls.call("bounce/cosine", bounce);
    calls.call("bounce/cosine-checked", checked);
}

/// A child and its pair.
fn child(given: Given) -> [u32; 2] {
    given.sampler().child(given.key()).pair()
}

/// A child and its pair of a pixel of a screen, whose place is found for each call.
fn screen(given: Given) -> Option<[u32; 2]> {
    const SIZE: [u32; 2] = [4096; 2];
    let screen = Screen::new(Domain::new(7), SIZE, 16).ok()?;
    let [x, y] = given.pixel();
    Some(screen.pixel(x, y).ok()?.sampler(given.index() & 15).child(given.key()).pair())
}

/// A direction for such a pixel, about the z axis.
fn direction(given: Given) -> Option<[f32; 3]> {
    Some(Cosine::<FastF32>::new().sample(screen(given)?))
}

/// A child and its four joint numbers.
fn joint(given: Given) -> [u32; 4] {
    let [[u, v], [w, x]] = given.sampler().child(given.key()).joint();
    [u, v, w, x]
}

/// A child and a decision.
fn chance(given: Given) -> u32 {
    given.sampler().child(given.key()).chance(0.7).into()
}

/// The pair of a sequence that was made before.
fn ready(given: Given) -> [u32; 2] {
    given.sequence().at(given.index())
}

/// A child, its pair, and a point of the disc.
fn lens(given: Given) -> [f32; 2] {
    Concentric::<FastF32>::new().sample(child(given))
}

/// A whole bounce: two children, a pair, and a direction about the normal that a ray hit.
fn bounce(given: Given) -> [f32; 3] {
    let frame = Frame::from_normal(given.normal());
    Cosine::<FastF32>::new().about(frame).sample(grandchild(given))
}

/// The same about a normal that was checked before.
fn checked(given: Given) -> [f32; 3] {
    Cosine::<FastF32>::new().about(Frame::from(given.unit_normal())).sample(grandchild(given))
}

/// The pair of a child's child: of what is drawn, at a bounce.
fn grandchild(given: Given) -> [u32; 2] {
    given.sampler().child(given.key()).child(DIRECTION).pair()
}
