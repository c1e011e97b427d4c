//! The list of what is tested: the catalogue's maps, and power lobes, in each arithmetic, as
//! functions of f64.

use hemidisc::catalogue::{
    AVAILABLE_ARITHMETICS, DISC_MAPS, LOBES, MapVisitor, POWER_LOBES, maps, power_maps,
};
use hemidisc::{Invert, arithmetic::Arithmetic};
use testkit::arithmetics::{EachArithmetic, Exponent, Number, Tested, every_arithmetic, peak};
use testkit::contract::{Contract, contract};
use testkit::reference::is_polar;

/// Exponents of the power lobes; 0 is uniform and 1 cosine.
const EXPONENTS: [f64; 5] = [0.0, 0.5, 1.0, 10.0, 1000.0];

/// A map under test. A point of the disc has z = 0.
pub(crate) struct Case<'a> {
    pub(crate) name: String,
    /// The exponent e of a lobe, whose directions have density (e + 1) z^e / (2 pi).
    pub(crate) lobe: Option<f64>,
    /// Whether u is the angle and v the squared radius, so that cells of both are strata.
    pub(crate) polar: bool,
    /// The error of the density at a given point, relative; in fixed point in parts of the peak,
    /// and 1 LSB.
    pub(crate) density_error: f64,
    /// Whether numbers are counts of LSBs, so that small ones are coarse.
    pub(crate) fixed: bool,
    contract: Contract,
    pub(crate) sample: &'a dyn Fn([u32; 2]) -> [f64; 3],
    /// The point as the arithmetic stores it.
    pub(crate) store: &'a dyn Fn([f64; 3]) -> [f64; 3],
    /// The density at the stored point.
    pub(crate) density: &'a dyn Fn([f64; 3]) -> f64,
}

impl Case<'_> {
    /// The error that a component of a point may have.
    pub(crate) fn position(&self) -> f64 {
        self.contract.position * self.contract.unit
    }

    /// How far a point may be off in widths of a lobe of exponent `e`, whose width is about
    /// 1 / sqrt(e + 1); an error that is relative to theta is so to the width. On the disc, in
    /// radii.
    pub(crate) fn shift(&self, e: f64) -> f64 {
        let Contract { relative, position, norm, theta, unit, .. } = self.contract;
        let error = if self.lobe.is_some() { theta } else { norm.max(position) };
        error * unit * if relative { 1.0 } else { (e + 1.0).sqrt() }
    }

    /// The error of a density at a given point, in parts of the peak of a lobe of exponent `e`:
    /// fixed point has also rounded the point.
    pub(crate) fn density_error(&self, e: f64) -> f64 {
        self.density_error + if self.fixed { self.shift(e) } else { 0.0 }
    }
}

struct Cases<'a> {
    run: &'a mut dyn FnMut(&Case),
    exponent: f64,
}

/// Per unit of area or of solid angle, also for an arithmetic with relative densities.
fn scale<A: Arithmetic>(kind: &str, e: f64) -> f64 {
    if A::ABSOLUTE_DENSITY { 1.0 } else { peak(kind, e) }
}

impl<A: Tested> MapVisitor<A> for Cases<'_> {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        let scale = scale::<A>("disc", 0.0);
        let stored = |x: f64| A::Real::nearest(x);
        (self.run)(&Case {
            name: format!("{} disc, {}", name, A::NAME),
            lobe: None,
            polar: is_polar(name),
            density_error: A::DENSITY_ERROR,
            fixed: A::Real::FIXED,
            contract: contract(A::NAME, "disc").unwrap(),
            sample: &|uv| {
                let [x, y] = map.sample(uv);
                [x.into(), y.into(), 0.0]
            },
            store: &|point| point.map(|x| stored(x).into()),
            density: &|[x, y, _]| map.density([x, y].map(stored)).into() * scale,
        });
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let exponent = match name {
            "uniform" => 0.0,
            "cosine" => 1.0,
            "power" => self.exponent,
            _ => panic!("no exponent is known of {name}"),
        };
        let scale = scale::<A>(name, exponent);
        let stored = |x: f64| A::Real::nearest(x);
        (self.run)(&Case {
            name: format!("{name} lobe of {exponent} over {disc}, {}", A::NAME),
            lobe: Some(exponent),
            polar: is_polar(disc),
            density_error: A::DENSITY_ERROR,
            fixed: A::Real::FIXED,
            contract: contract(A::NAME, name).unwrap(),
            sample: &|uv| map.sample(uv).map(Into::into),
            store: &|point| point.map(|x| stored(x).into()),
            density: &|direction| map.density(direction.map(stored)).into() * scale,
        });
    }
}

/// Every case of each arithmetic.
struct Each<'a>(&'a mut dyn FnMut(&Case));

impl EachArithmetic for Each<'_> {
    fn each<A: Tested>(&mut self) {
        maps::<A>(&mut Cases { run: self.0, exponent: f64::NAN });
        for exponent in EXPONENTS {
            let parameter = A::Parameter::exactly(exponent).unwrap();
            power_maps::<A>(parameter, &mut Cases { run: self.0, exponent }).unwrap();
        }
    }
}

/// Runs a test on every case.
pub(crate) fn every_case(mut run: impl FnMut(&Case)) {
    let mut count = 0;
    every_arithmetic(&mut Each(&mut |case| {
        count += 1;
        run(case);
    }));
    let powers = POWER_LOBES.len();
    let over_a_disc = 1 + LOBES.len() - powers + powers * EXPONENTS.len();
    assert_eq!(count, AVAILABLE_ARITHMETICS.len() * DISC_MAPS.len() * over_a_disc, "cases");
}

/// Runs a test on every lobe.
pub(crate) fn every_lobe(mut run: impl FnMut(&Case, f64)) {
    every_case(|case| {
        if let Some(exponent) = case.lobe {
            run(case, exponent);
        }
    });
}
