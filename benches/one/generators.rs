//! The peers that draw: `sobol_burley`, and generators with the formulas that renderers put on
//! them.
//!
//! `SmallRng` of rand is what a renderer in Rust takes; on 64 bits it is xoshiro256++. Xoshiro128++
//! makes words of 32 bits in 32-bit arithmetic.

use crate::calls::Calls;
use crate::inputs::Given;
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
    calls.call("peer/pair/sobol_burley", |given| {
        let (index, seed) = (given.index(), given.key());
        [0, 1].map(|axis| sobol_burley::sample(index, axis, seed))
    });
    calls.call("peer/pair/sobol_burley-4d", |given| {
        let [u, v, ..] = sobol_burley::sample_4d(given.index(), 0, given.key());
        [u, v]
    });
}

/// A generator: words, and the points and directions that are made of them.
fn of<G: Rng + Clone + 'static>(calls: &mut Calls<'_>, name: &str, rng: G) {
    let mut own = rng.clone();
    calls.call(&format!("peer/pair/{name}"), move |given| {
        [(); 2].map(|()| given.waiting(own.next_u32()))
    });
    let mut own = rng.clone();
    calls.call(&format!("peer/lens/{name}-shirley"), move |given| {
        shirley_disc(|| draw(&mut own, given))
    });
    let mut own = rng.clone();
    calls.call(&format!("peer/bounce/{name}-pbrt-duff"), move |given| {
        let uv = [(); 2].map(|()| draw(&mut own, given));
        duff_about(given.normal(), pbrt_cosine::<Std>(uv))
    });
    let mut own = rng.clone();
    calls.call(&format!("peer/bounce/{name}-shirley"), move |given| {
        shirley_cosine_about::<Std>(given.normal(), || draw(&mut own, given))
    });
    let mut own = rng;
    calls.call(&format!("peer/bounce/{name}-shirley-uniform"), move |given| {
        shirley_uniform_about::<Std>(given.normal(), || draw(&mut own, given))
    });
}

/// A number in [0, 1), made to wait for the last result like all that a call takes.
#[inline(always)]
fn draw(rng: &mut impl Rng, given: Given) -> f32 {
    unit(given.waiting(rng.next_u32()))
}
