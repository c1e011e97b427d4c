//! The list of what is tested: the catalogue's maps, and power lobes, in each arithmetic, as
//! functions of f64.

use hemidisc::{
    LibmF32, LibmF64, Map,
    arithmetic::Arithmetic,
    catalogue::{MapVisitor, maps, power_maps},
};

/// Exponents of the power lobes; 0 is uniform and 1 cosine.
const EXPONENTS: [f64; 5] = [0.0, 0.5, 1.0, 10.0, 1000.0];

/// A component of a point, to and from f64.
pub(crate) trait Slot: Copy + Into<f64> {
    /// Half the distance from 1 to the next number.
    const EPSILON: f64;
    fn nearest(value: f64) -> Self;
}

impl Slot for f32 {
    const EPSILON: f64 = f32::EPSILON as f64 / 2.0;
    fn nearest(value: f64) -> Self {
        value as f32
    }
}

impl Slot for f64 {
    const EPSILON: f64 = f64::EPSILON / 2.0;
    fn nearest(value: f64) -> Self {
        value
    }
}

/// A map under test. A point of the disc has z = 0.
pub(crate) struct Case<'a> {
    pub(crate) name: String,
    /// The exponent e of a lobe, whose directions have density (e + 1) z^e / (2 pi).
    pub(crate) lobe: Option<f64>,
    /// Whether u is the angle and v the squared radius, so that cells of both are strata.
    pub(crate) polar: bool,
    pub(crate) epsilon: f64,
    pub(crate) sample: &'a dyn Fn([u32; 2]) -> [f64; 3],
    pub(crate) density: &'a dyn Fn([f64; 3]) -> f64,
}

struct Cases<'a> {
    run: &'a mut dyn FnMut(&Case),
    exponent: f64,
}

impl<A: Arithmetic<Real: Slot>> MapVisitor<A> for Cases<'_> {
    fn disc<M: Map<Arithmetic = A, Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        (self.run)(&Case {
            name: format!("{} disc, {}", name, A::NAME),
            lobe: None,
            polar: name == "polar",
            epsilon: A::Real::EPSILON,
            sample: &|uv| {
                let [x, y] = map.sample(uv);
                [x.into(), y.into(), 0.0]
            },
            density: &|[x, y, _]| map.density([x, y].map(A::Real::nearest)).into(),
        });
    }

    fn hemisphere<M: Map<Arithmetic = A, Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let exponent = match name {
            "uniform" => 0.0,
            "cosine" => 1.0,
            _ => self.exponent,
        };
        (self.run)(&Case {
            name: format!("{name} lobe of {exponent} over {disc}, {}", A::NAME),
            lobe: Some(exponent),
            polar: disc == "polar",
            epsilon: A::Real::EPSILON,
            sample: &|uv| map.sample(uv).map(Into::into),
            density: &|direction| map.density(direction.map(A::Real::nearest)).into(),
        });
    }
}

fn of_arithmetic<A: Arithmetic<Real: Slot, Parameter: Slot>>(run: &mut dyn FnMut(&Case)) {
    maps::<A>(&mut Cases { run, exponent: f64::NAN });
    for exponent in EXPONENTS {
        power_maps::<A>(A::Parameter::nearest(exponent), &mut Cases { run, exponent }).unwrap();
    }
}

/// Runs a test on every case.
pub(crate) fn every_case(mut run: impl FnMut(&Case)) {
    let mut count = 0;
    let mut counted = |case: &Case| {
        count += 1;
        run(case);
    };
    of_arithmetic::<LibmF64>(&mut counted);
    of_arithmetic::<LibmF32>(&mut counted);
    assert_eq!(count, 2 * (6 + 2 * EXPONENTS.len()), "cases");
}

/// Runs a test on every lobe.
pub(crate) fn every_lobe(mut run: impl FnMut(&Case, f64)) {
    every_case(|case| {
        if let Some(exponent) = case.lobe {
            run(case, exponent);
        }
    });
}
