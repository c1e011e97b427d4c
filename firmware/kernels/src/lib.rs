//! A fill of a buffer by every map, every sequence and every peer: what a board counts, and what a
//! linker sizes.
//!
//! Each is a function of its own under its path as a symbol, such as `map/disc/concentric/q15`: the
//! programs call it, and an image linked with that symbol as its entry holds it and nothing else.
//!
//! | path | fill |
//! | --- | --- |
//! | `map/MAP/DISC/ARITHMETIC` | points of stored coordinates |
//! | `fused/SEQUENCE/MAP/DISC/ARITHMETIC` | points of a sequence |
//! | `turned/MAP/DISC/ARITHMETIC` | directions about a frame, of stored coordinates |
//! | `components/MAP/DISC/ARITHMETIC` | points of stored coordinates, a buffer for each component |
//! | `sequence/NAME` | coordinates of a sequence, or of as many domains |
//! | `effect/EFFECT/ARITHMETIC` | samples of an effect, of stored coordinates |
//! | `render/SCENE/ARITHMETIC` | pixels of a scene |
//! | `exponent/ARITHMETIC` | no fill: what prepares an exponent, once, before a power lobe is filled |
//! | `peer/MAP/DISC/PEER` | the same points by other formulas and crates, of stored coordinates |
//! | `loop/empty`, `loop/copy` | the loop alone; the loop with its loads and stores |
#![no_std]

mod effects;
mod loops;
mod maps;
mod peers;
mod render;
mod sequences;

use bytemuck::Pod;

/// Points of a fill.
pub const COUNT: usize = 256;
/// Coordinates that a fill may draw on: rejection keeps 256 of these.
pub const CANDIDATES: usize = 384;

/// Sees every fill in turn, by its path.
pub trait Visitor {
    /// A fill of points from coordinates; says how many.
    fn points<P: Pod>(&mut self, path: &'static str, fill: impl Fn(&[[u32; 2]], &mut [P]) -> usize);
}

/// Visits the fills of loops, sequences, maps and peers.
pub fn fills(visitor: &mut impl Visitor) {
    loops::every(visitor);
    sequences::every(visitor);
    maps::every(visitor);
    maps::fused(visitor);
    maps::components(visitor);
    // An error leaves fills out, which the report tells.
    let _ = maps::turned(visitor);
    peers::every(visitor);
}

/// Visits the fills of effects and scenes.
pub fn effects(visitor: &mut impl Visitor) {
    effects::every(visitor);
    render::every(visitor);
}
