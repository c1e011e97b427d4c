//! The peers that draw: `sobol_burley`, and generators with the formulas that renderers put on
//! them.
//!
//! `SmallRng` of rand is what a renderer in Rust takes; on 64 bits it is xoshiro256++. Xoshiro128++
//! makes words of 32 bits in 32-bit arithmetic.

use crate::calls::Calls;
use crate::inputs::{Bounce, Given};
use benches::functions::Std;
use benches::random::{SEED, generator};
use rand::rngs::SmallRng;
use rand::{Rng, SeedableRng};
use testkit::textbook::{
    duff_about, pbrt_cosine, shirley_cosine_about, shirley_disc, shirley_uniform_about, unit,
};

pub(crate) fn every(calls: &mut Calls<'_>) {
    burley(calls);
    of(calls, "small-rng", SmallRng::seed_from_u64(u64::from(SEED)));
    of(calls, "xoshiro128++", generator(0));
}

/// Two dimensions of a set of four. It makes one at a time, or all four.
fn burley(calls: &mut Calls<'_>) {
    calls.call("peer/pair/sobol_burley", Given::key, |(key, index)| {
        [0, 1].map(|axis| sobol_burley::sample(index, axis, key))
    });
    calls.call("peer/pair/sobol_burley-4d", Given::key, |(key, index)| {
        let [u, v, ..] = sobol_burley::sample_4d(index, 0, key);
        [u, v]
    });
}

/// A generator: words, and the directions and points that are made of them.
fn of<G: Rng + Clone + 'static>(calls: &mut Calls<'_>, name: &str, rng: G) {
    let mut own = rng.clone();
    calls.call(&format!("peer/pair/{name}"), Given::key, move |(key, _)| {
        [own.next_u32() ^ key, own.next_u32()]
    });
    let mut own = rng.clone();
    calls.call(&format!("peer/bounce/{name}-pbrt-duff"), Given::bounce, move |at: Bounce| {
        let uv = [(); 2].map(|()| draw(&mut own, at));
        duff_about(at.normal, pbrt_cosine::<Std>(uv))
    });
    let mut own = rng.clone();
    calls.call(&format!("peer/bounce/{name}-shirley"), Given::bounce, move |at: Bounce| {
        shirley_cosine_about::<Std>(at.normal, || draw(&mut own, at))
    });
    let mut own = rng.clone();
    calls.call(&format!("peer/bounce/{name}-shirley-uniform"), Given::bounce, move |at: Bounce| {
        shirley_uniform_about::<Std>(at.normal, || draw(&mut own, at))
    });
    let mut own = rng;
    calls.call(&format!("peer/lens/{name}-shirley"), Given::bounce, move |at: Bounce| {
        shirley_disc(|| draw(&mut own, at))
    });
}

/// A number in [0, 1), made to wait for the last result like all that a call takes.
#[inline(always)]
fn draw(rng: &mut impl Rng, at: Bounce) -> f32 {
    unit(rng.next_u32() ^ at.last)
}
