//! What a path draws: the pair of a domain's child, a point of the lens, and the direction of the
//! next bounce.

use crate::calls::Calls;
use crate::inputs::Given;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Cosine, FastF32, Frame};

/// What is drawn at a bounce, as the key of a domain.
const DIRECTION: u32 = 3;

pub(crate) fn every(calls: &mut Calls<'_>) {
    calls.call("pair/child", child);
    calls.call("pair/ready", ready);
    // Later: `pair/screen`, a child and its pair of the sampler over the screen.
    calls.call("lens/concentric", lens);
    calls.call("bounce/cosine", bounce);
    calls.call("bounce/cosine-checked", checked);
}

/// A child and its pair.
fn child(given: Given) -> [u32; 2] {
    SobolOwen::in_domain(given.domain().child(given.key())).at(given.index())
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
fn bounce(given: Given) -> Option<[f32; 3]> {
    let frame = Frame::new(given.normal()).ok()?;
    Some(Cosine::<FastF32>::new().about(frame).sample(grandchild(given)))
}

/// The same about a normal that was checked before.
fn checked(given: Given) -> [f32; 3] {
    Cosine::<FastF32>::new().about(Frame::from(given.unit_normal())).sample(grandchild(given))
}

/// The pair of a child's child: of what is drawn, at a bounce.
fn grandchild(given: Given) -> [u32; 2] {
    let bounce = given.domain().child(given.key());
    SobolOwen::in_domain(bounce.child(DIRECTION)).at(given.index())
}
