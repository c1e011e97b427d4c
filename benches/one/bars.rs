//! What a row must reach: its speed relative to a peer, on the baseline build and on one for the
//! machine's own vectors. Bars are for the throughput, where calls overlap.

use crate::calls::THROUGHPUT;

/// One of them.
pub(crate) struct Bar {
    pub(crate) path: &'static str,
    pub(crate) peer: &'static str,
    /// Baseline, native.
    pub(crate) at_least: [f64; 2],
}

/// To take at most 2.5 times as long is to be at least 0.4 times as fast.
#[rustfmt::skip]
pub(crate) const BARS: &[Bar] = &[
    Bar { path: "map/disc/concentric/fast-f32",    peer: "peer/disc/concentric/pbrt",             at_least: [1.5, 2.0] },
    Bar { path: "map/cosine/concentric/fast-f32",  peer: "peer/cosine/concentric/pbrt",           at_least: [1.5, 2.0] },
    Bar { path: "map/disc/polar/fast-f32",         peer: "peer/disc/polar/pbrt",                  at_least: [1.0, 1.0] },
    Bar { path: "map/uniform/polar/fast-f32",      peer: "peer/uniform/polar/pbrt",               at_least: [1.0, 1.0] },
    Bar { path: "map/cosine/polar/fast-f32",       peer: "peer/cosine/polar/shirley",             at_least: [1.0, 1.0] },
    Bar { path: "map/power/concentric/fast-f32",   peer: "peer/power/polar/suffern",              at_least: [1.0, 1.0] },
    Bar { path: "map/power/polar/fast-f32",        peer: "peer/power/polar/suffern",              at_least: [1.0, 1.0] },
    Bar { path: "pair/child",                      peer: "peer/pair/sobol_burley",                at_least: [2.0, 2.0] },
    Bar { path: "pair/screen",                     peer: "peer/pair/sobol_burley",                at_least: [3.0, 3.0] },
    Bar { path: "bounce/cosine",                   peer: "peer/bounce/small-rng-pbrt-duff",       at_least: [0.75, 0.9] },
    Bar { path: "effect/glossy-reject/fast-f32",   peer: "peer/glossy/suffern",                   at_least: [0.8, 0.9] },
    Bar { path: "effect/glossy-flip/fast-f32",     peer: "peer/glossy/suffern",                   at_least: [0.8, 0.9] },
    Bar { path: "effect/glossy-zero/fast-f32",     peer: "peer/glossy/suffern",                   at_least: [0.8, 0.9] },
    Bar { path: "fill/16/disc/concentric/fast-f32",   peer: "fill/4096/disc/concentric/fast-f32",   at_least: [0.4, 0.4] },
    Bar { path: "fill/16/cosine/concentric/fast-f32", peer: "fill/4096/cosine/concentric/fast-f32", at_least: [0.4, 0.4] },
    Bar { path: "row/64/cosine/concentric/fast-f32", peer: "screen/cosine",                         at_least: [4.0, 8.0] },
];

impl Bar {
    /// The names of its row in the report: of the row itself, and of the one that it is against.
    pub(crate) fn names(&self) -> [String; 2] {
        [self.path, self.peer].map(|path| format!("{path}/{THROUGHPUT}"))
    }
}
