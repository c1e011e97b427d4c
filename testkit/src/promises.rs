//! The promises of every map in every arithmetic at one sample, and at arbitrary points.

use crate::arithmetics::{EachArithmetic, Exponent, Number, Tested};
use crate::contract::contract;
use crate::errors::{EachMap, Errors, each_map, each_power_map};
use crate::reference::reference;
use hemidisc::Invert;
use hemidisc::Map;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{MapVisitor, maps, power_maps};
use hemidisc::invariant::{self, Exact};
use hemidisc::map::Point;

/// Exponents that the contracts of theta, density and inverse are for.
pub fn is_promised(e: f64) -> bool {
    (0.0..=1e8).contains(&e)
}

/// What must hold for each map at one sample.
struct Promises {
    uv: [u32; 2],
    exponent: f64,
}

impl Promises {
    fn label<A: Arithmetic>(&self) -> String {
        format!("{} e = {:e} at {:08x?}", A::NAME, self.exponent, self.uv)
    }

    fn mirrored<A, const D: usize, M>(&self, disc: &str, map: &M)
    where
        A: Arithmetic<Real: Exact>,
        M: Map<Point = [A::Real; D]>,
    {
        match disc {
            "polar" => invariant::mirrored_polar(map, self.uv),
            "concentric" => invariant::mirrored_concentric(map, self.uv),
            _ => panic!("no symmetry is known of {disc}"),
        }
        .unwrap_or_else(|v| panic!("{}: {v}", self.label::<A>()));
    }

    /// libm f64 gives back the coordinates; every arithmetic comes back to the same place within
    /// its contract.
    fn inverted<A, const D: usize, M>(&self, kind: &str, map: &M)
    where
        A: Arithmetic<Real: Exact>,
        M: Invert<Point = [A::Real; D]>,
    {
        let name = A::NAME;
        let point = map.sample(self.uv);
        let inverse = map.invert(point);
        if is_promised(self.exponent) {
            if name == "libm-f64" {
                invariant::inverted(map, self.uv)
                    .unwrap_or_else(|v| panic!("{}: {v}", self.label::<A>()));
            }
            let contract = contract(name, kind).unwrap();
            let [here, there] = [point, map.sample(inverse)].map(|p| p.map(Exact::exact));
            let moved = here.iter().zip(there).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
            let moved = moved / contract.unit;
            let label = || self.label::<A>();
            assert!(moved <= contract.round_trip, "{}: {kind} moved by {moved}", label());
        }
    }
}

impl<A: Tested> MapVisitor<A> for Promises {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        invariant::disc(&map, self.uv).unwrap_or_else(|v| panic!("{}: {v}", A::NAME));
        self.mirrored::<A, _, _>(name, &map);
        self.inverted::<A, _, _>("disc", &map);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        lobe: &'static str,
        disc: &'static str,
        map: M,
    ) {
        invariant::hemisphere(&map, self.uv)
            .unwrap_or_else(|v| panic!("{lobe} {}: {v}", self.label::<A>()));
        self.mirrored::<A, _, _>(disc, &map);
        self.inverted::<A, _, _>(lobe, &map);
    }
}

/// The contract of each map, against the textbook's formula in f64, which is not accurate enough to
/// judge f64.
impl<A: Tested> EachMap<A> for Promises {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let contract = contract(A::NAME, kind).unwrap();
        if contract.unit < 0.5_f64.powi(40) {
            return;
        }
        let e = self.exponent;
        let mut exact = reference::<A>(kind, disc, e, self.uv);
        if e < 0.0 {
            exact = exact.with_z_from(A::Real::SMALLEST);
        }
        let (point, with_sample) = map.sample_with_density(self.uv);
        // A z that is not the coordinates' has a density of its own.
        if e < 0.0 && point[D - 1].exact() == A::Real::SMALLEST {
            assert_eq!(with_sample.exact(), map.density(point).exact(), "{} {kind} {e:e}", A::NAME);
        }
        let errors = Errors::at::<A, _>(&map, self.uv, e, exact, &contract);
        let name = A::NAME;
        let label = format_args!("{name} {kind}/{disc} e = {e:e} at {:08x?}", self.uv);
        errors.assert_within(&contract, is_promised(e), e >= 0.0, &label);
    }
}

/// The promises at one sample: of every map without an exponent, and of lobes of the exponent
/// given, where the arithmetic has it, and of one of its own, of random bits.
pub struct AtSample {
    pub uv: [u32; 2],
    pub exponent: f32,
    pub bits: u64,
}

impl EachArithmetic for AtSample {
    fn each<A: Tested>(&mut self) {
        let mut promises = Promises { uv: self.uv, exponent: 0.0 };
        maps::<A>(&mut promises);
        each_map::<A>(&mut promises);
        let given = A::Parameter::exactly(self.exponent.into());
        for parameter in given.into_iter().chain(A::Parameter::any(self.bits)) {
            promises.exponent = parameter.value();
            power_maps::<A>(parameter, &mut promises).unwrap();
            each_power_map::<A>(parameter, &mut promises);
        }
    }
}

/// Arbitrary points and directions: inverses are in the square and densities are numbers.
pub struct Total {
    pub numbers: [f64; 3],
    pub exponent: f64,
}

impl EachArithmetic for Total {
    fn each<A: Tested>(&mut self) {
        let mut lobes = Given { numbers: self.numbers };
        maps::<A>(&mut lobes);
        if let Some(parameter) = A::Parameter::exactly(self.exponent) {
            power_maps::<A>(parameter, &mut lobes).unwrap();
        }
    }
}

struct Given {
    numbers: [f64; 3],
}

impl Given {
    fn point<A: Tested>(&self) -> [A::Real; 3] {
        let number = |x: f64| if A::Real::FIXED && x.is_nan() { 0.0 } else { x };
        self.numbers.map(|x| A::Real::nearest(number(x)))
    }

    fn check<A: Tested, M: Invert>(&self, map: &M, point: M::Point)
    where
        M::Point: Point<Component = A::Real>,
    {
        let _ = map.invert(point);
        let density = map.density(point).exact();
        assert!(density >= 0.0 && density.is_finite(), "{} {:?}: {density}", A::NAME, self.numbers);
    }
}

impl<A: Tested> MapVisitor<A> for Given {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, _: &'static str, map: M) {
        let [x, y, _] = self.point::<A>();
        self.check::<A, M>(&map, [x, y]);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        _: &'static str,
        _: &'static str,
        map: M,
    ) {
        let [x, y, z] = self.point::<A>();
        // A cosine lobe has a density at a z that is no direction's, and an infinite one at
        // infinity.
        let z = if z.exact() > 1.0 { A::Real::nearest(1.0) } else { z };
        self.check::<A, M>(&map, [x, y, z]);
        if z.exact() <= 0.0 {
            assert_eq!(map.density([x, y, z]).exact(), 0.0, "{}", A::NAME);
        }
    }
}
