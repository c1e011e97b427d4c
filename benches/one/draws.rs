//! What a path draws: the pair of a domain's child, a point of the lens, and the direction of the
//! next bounce.

use crate::calls::Calls;
use crate::inputs::{Bounce, Given};
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Cosine, Domain, FastF32, Frame, Map, Unit};

/// What is drawn at a bounce, as the key of a domain.
const DIRECTION: u32 = 3;

pub(crate) fn every(calls: &mut Calls<'_>) {
    calls.call("pair/child", Given::child, |(domain, key, index)| child(domain, key, index));
    calls.call("pair/ready", Given::ready, |(sequence, index)| sequence.at(index));
    // Later: `pair/screen`, a child and its pair of the sampler over the screen.
    calls.call("lens/concentric", Given::child, |(domain, key, index)| lens(domain, key, index));
    calls.call("bounce/cosine", Given::bounce, bounce);
    calls.call("bounce/cosine-checked", Given::checked_bounce, |(at, normal)| checked(at, normal));
}

/// A child and its pair.
fn child(domain: Domain, key: u32, index: u32) -> [u32; 2] {
    SobolOwen::in_domain(domain.child(key)).at(index)
}

/// A point of the disc for a child.
fn lens(domain: Domain, key: u32, index: u32) -> [f32; 2] {
    Concentric::<FastF32>::new().sample(child(domain, key, index))
}

/// A whole bounce: two children, a pair, and a direction about the normal that a ray hit.
fn bounce(at: Bounce) -> Option<[f32; 3]> {
    let frame = Frame::new(at.normal).ok()?;
    let uv = child(at.domain.child(at.key), DIRECTION, at.index);
    Some(Cosine::<FastF32>::new().about(frame).sample(uv))
}

/// The same about a normal that was checked before.
fn checked(at: Bounce, normal: Unit<f32>) -> [f32; 3] {
    let uv = child(at.domain.child(at.key), DIRECTION, at.index);
    Cosine::<FastF32>::new().about(Frame::from(normal)).sample(uv)
}
