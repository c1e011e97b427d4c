//! Targets of the fast arithmetic: its speed relative to a peer, on the baseline build and on one
//! for the machine's own vectors.

use crate::buffers::{Coordinates, LARGE};
use crate::rounds;
use benches::failure::Failure;
use benches::rounds::Measurement;

/// One of them.
pub(crate) struct Target {
    pub(crate) path: &'static str,
    pub(crate) peer: &'static str,
    /// Baseline, native.
    pub(crate) at_least: [f64; 2],
    pub(crate) wanted: [f64; 2],
}

/// `wanted` is the same where no more is. To be at most twice as slow is to be 0.5 times as fast.
#[rustfmt::skip]
pub(crate) const TARGETS: &[Target] = &[
    Target { path: "map/disc/concentric/fast-f32",         peer: "peer/disc/concentric/pbrt",          at_least: [6.0, 12.0], wanted: [8.0, 16.0] },
    Target { path: "map/cosine/concentric/fast-f32",       peer: "peer/cosine/concentric/pbrt",        at_least: [4.0, 8.0],  wanted: [5.0, 9.0] },
    Target { path: "map/power/concentric/fast-f32",        peer: "peer/power/polar/suffern-libm-powf", at_least: [8.0, 14.0], wanted: [8.0, 14.0] },
    Target { path: "fused/sobol/disc/concentric/fast-f32", peer: "peer/disc/-/rand_distr",             at_least: [4.5, 8.5],  wanted: [4.5, 8.5] },
    Target { path: "fused/sobol-owen/square/-/fast-f32",   peer: "peer/square/-/sobol_burley",         at_least: [9.0, 28.0], wanted: [9.0, 28.0] },
    Target { path: "fused/sobol/square/-/fast-f32",        peer: "peer/square/-/slice-fill",           at_least: [0.5, 0.4],  wanted: [0.5, 0.4] },
    Target { path: "turned/uniform/concentric/fast-f32",   peer: "map/uniform/concentric/fast-f32",    at_least: [0.85, 0.85], wanted: [0.9, 0.9] },
    Target { path: "turned/cosine/concentric/fast-f32",    peer: "map/cosine/concentric/fast-f32",     at_least: [0.85, 0.85], wanted: [0.9, 0.9] },
    Target { path: "turned/power/concentric/fast-f32",     peer: "map/power/concentric/fast-f32",      at_least: [0.85, 0.85], wanted: [0.9, 0.9] },
    Target { path: "apart/disc/concentric/fast-f32",       peer: "map/disc/concentric/fast-f32",       at_least: [1.0, 1.0],  wanted: [1.1, 1.1] },
    Target { path: "apart/uniform/concentric/fast-f32",    peer: "map/uniform/concentric/fast-f32",    at_least: [1.0, 1.0],  wanted: [1.1, 1.1] },
    Target { path: "apart/cosine/concentric/fast-f32",     peer: "map/cosine/concentric/fast-f32",     at_least: [1.0, 1.0],  wanted: [1.1, 1.1] },
    Target { path: "apart/power/concentric/fast-f32",      peer: "map/power/concentric/fast-f32",      at_least: [1.0, 1.0],  wanted: [1.1, 1.1] },
];

/// Each fill and its peer in buffers that no cache holds.
pub(crate) fn run(coordinates: &Coordinates, rounds: usize) -> Result<Vec<Measurement>, Failure> {
    let mut measured = Vec::new();
    for Target { path, peer, .. } in TARGETS {
        let both = |found: &str| found == *path || found == *peer;
        measured.extend(rounds::at_sizes(coordinates, &[LARGE], rounds, both)?);
    }
    Ok(measured)
}
