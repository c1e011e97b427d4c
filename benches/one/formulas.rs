//! The peers that take coordinates: the textbooks' formulas on std's f32 functions.

use crate::calls::Calls;
use crate::words::Word;
use benches::EXPONENT;
use benches::functions::Std;
use std::hint::black_box;
use testkit::textbook::{
    pbrt_concentric, pbrt_cosine, pbrt_polar, pbrt_uniform, shirley_cosine, suffern_glossy,
    suffern_power, suffern_power_with_density, suffern_power_with_density_divided, unit,
};

pub(crate) fn every(calls: &mut Calls<'_>) {
    formula(calls, "square/-/unit", |uv| uv);
    formula(calls, "disc/concentric/pbrt", pbrt_concentric::<Std>);
    formula(calls, "disc/polar/pbrt", pbrt_polar::<Std>);
    formula(calls, "uniform/polar/pbrt", pbrt_uniform::<Std>);
    formula(calls, "cosine/concentric/pbrt", pbrt_cosine::<Std>);
    formula(calls, "cosine/polar/shirley", shirley_cosine::<Std>);
    // A material's exponent is in memory, too.
    let e = black_box(EXPONENT);
    formula(calls, "power/polar/suffern", move |uv| suffern_power::<Std>(e, uv));
    with_density(calls, "suffern", move |uv| suffern_power_with_density::<Std>(e, uv));
    with_density(calls, "suffern-divided", move |uv| {
        suffern_power_with_density_divided::<Std>(e, uv)
    });
}

/// A map's formula.
fn formula<P: Word>(
    calls: &mut Calls<'_>,
    name: &str,
    formula: impl Fn([f32; 2]) -> P + Copy + 'static,
) {
    calls.call(&format!("peer/{name}"), move |given| formula(given.pair().map(unit)));
}

/// The power lobe with its density, and the glossy reflection that is made of it.
fn with_density(
    calls: &mut Calls<'_>,
    name: &str,
    lobe: impl Fn([f32; 2]) -> ([f32; 3], f32) + Copy + 'static,
) {
    calls.call(&format!("peer/density/power/{name}"), move |given| lobe(given.pair().map(unit)));
    calls.call(&format!("peer/glossy/{name}"), move |given| {
        let sample = lobe(given.pair().map(unit));
        suffern_glossy(given.arriving().get(), given.unit_normal().get(), sample)
    });
}
