//! Errors of points against reference values, for the accuracy tests.
//!
//! A reference is a pair of doubles hi + lo; the squares of a point are formed without rounding by
//! fused multiply-add, so errors of a few units of 2^-53 are measured to a small fraction of one.
//! Errors of fixed point are absolute, and are simple differences of doubles.

use crate::arithmetics::peak;
use crate::contract::Contract;
use hemidisc::Invert;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{MapVisitor, maps, power_maps};
use hemidisc::invariant::Exact;
use std::fmt::Display;

/// A real number as an unevaluated sum.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pair {
    pub hi: f64,
    pub lo: f64,
}

impl Pair {
    pub fn sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_part = hi - a;
        Self { hi, lo: (a - (hi - b_part)) + (b - b_part) }
    }

    pub fn product(a: f64, b: f64) -> Self {
        let hi = a * b;
        Self { hi, lo: a.mul_add(b, -hi) }
    }

    pub fn plus(self, other: Self) -> Self {
        let sum = Self::sum(self.hi, other.hi);
        Self::sum(sum.hi, sum.lo + self.lo + other.lo)
    }

    /// self - other, rounded once.
    pub fn minus(self, other: Self) -> f64 {
        let difference = self.plus(Self { hi: -other.hi, lo: -other.lo });
        difference.hi + difference.lo
    }
}

/// The exact image of a coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    pub x: Pair,
    pub y: Pair,
    /// x^2 + y^2.
    pub s2: Pair,
    /// None on the disc.
    pub z: Option<Pair>,
    pub density: Pair,
}

impl Reference {
    /// With the smallest normal number for a z that floats do not hold: below e = 0 the true one
    /// leaves their range.
    pub fn with_z_from(self, smallest: f64) -> Self {
        let z = self.z.map(|z| if z.hi < smallest { Pair { hi: smallest, lo: 0.0 } } else { z });
        Self { z, ..self }
    }
}

/// Errors of points in units of a contract, the largest of each kind.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    pub position: f64,
    pub norm: f64,
    pub theta: f64,
    /// (|dz / z| / unit - first) / |ln z|, for the contract's first; and |dz / z| / unit itself.
    pub z_slope: f64,
    pub z: f64,
    /// For exponents up to 1, or for any where the bound does not grow with the exponent.
    pub density: f64,
    /// (error - first) / sqrt e, for the contract's first.
    pub density_slope: f64,
    /// Of the density that comes with the sample; and (error - first) / |ln z|.
    pub sampled: f64,
    pub sampled_slope: f64,
    pub round_trip: f64,
}

/// The error of a density that an error of z within its contract makes in fixed point where 0 < e <
/// 1: at the horizon z^e is then infinitely steep.
fn explained(contract: &Contract, e: f64, z: f64) -> f64 {
    if e <= 0.0 || e >= 1.0 {
        return 0.0;
    }
    let error = contract.position * contract.unit;
    (z + error).powf(e) - (z - error).max(0.0).powf(e)
}

impl Errors {
    pub fn of<const D: usize>(point: [f64; D], exact: Reference, contract: &Contract) -> Self {
        let unit = contract.unit;
        if !contract.relative {
            return Self::absolute(point, exact, unit);
        }
        let against = |value: f64, exact: Pair| (value - exact.hi) - exact.lo;
        let (x, y) = (point[0], point[1]);
        let mut position = against(x, exact.x).abs().max(against(y, exact.y).abs());
        let square = Pair::product(x, x).plus(Pair::product(y, y));
        // ds / s, by the difference of the squares.
        let ds = square.minus(exact.s2) / (2.0 * exact.s2.hi);
        let s = exact.s2.hi.sqrt();
        let Some(z) = exact.z else {
            return Self {
                position: position / unit,
                norm: (ds * s).abs() / unit,
                ..Self::default()
            };
        };
        let dz = against(point[2], z);
        position = position.max(dz.abs());
        let dz = dz / z.hi;
        let norm = square.plus(Pair::product(point[2], point[2])).minus(Pair::sum(1.0, 0.0)) / 2.0;
        // d theta = s z (ds / s - dz / z), for theta = atan2(s, z) of a unit vector.
        let theta = s * z.hi * (ds - dz) / s.atan2(z.hi);
        let log = z.hi.ln().abs();
        let over = (dz.abs() / unit - contract.z[0]).max(0.0);
        Self {
            position: position / unit,
            norm: norm.abs() / unit,
            theta: theta.abs() / unit,
            z_slope: if over > 0.0 { over / log } else { 0.0 },
            z: dz.abs() / unit,
            ..Self::default()
        }
    }

    /// The errors of fixed point: none is relative, and z is a component like the others.
    fn absolute<const D: usize>(point: [f64; D], exact: Reference, unit: f64) -> Self {
        let s = exact.s2.hi.sqrt();
        let found = point[0].hypot(point[1]);
        let position = (point[0] - exact.x.hi).abs().max((point[1] - exact.y.hi).abs());
        let Some(z) = exact.z.map(|z| z.hi) else {
            return Self {
                position: position / unit,
                norm: (found - s).abs() / unit,
                ..Self::default()
            };
        };
        Self {
            position: position.max((point[2] - z).abs()) / unit,
            norm: (found.hypot(point[2]) - 1.0).abs() / unit,
            theta: (found.atan2(point[2]) - s.atan2(z)).abs() / unit,
            ..Self::default()
        }
    }

    /// The errors at one sample of a map of exponent `e`, of its density and of its inverse too.
    pub fn at<A: Arithmetic<Real: Exact>, const D: usize>(
        map: &impl Invert<Point = [A::Real; D]>,
        uv: [u32; 2],
        e: f64,
        reference: Reference,
        contract: &Contract,
    ) -> Self {
        let (point, with_sample) = map.sample_with_density(uv);
        let bits = |point| exact::<A::Real, D>(point).map(f64::to_bits);
        assert_eq!(bits(point), bits(map.sample(uv)), "{uv:08x?}: two points");
        let [here, there] = [point, map.sample(map.invert(point))].map(exact);
        let apart = here.iter().zip(there).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
        let exactly = reference.density;
        let z = reference.z.map_or(1.0, |z| z.hi);
        let [density, sampled] = [map.density(point), with_sample].map(|found| {
            let found = found.exact();
            let error = if contract.relative {
                ((found - exactly.hi - exactly.lo) / exactly.hi).abs()
            } else {
                let error = (found - exactly.hi / peak(contract.map, e)).abs();
                let explained = explained(contract, e, z);
                // NaN propagates.
                if error <= explained { 0.0 } else { error - explained }
            };
            error / contract.unit
        });
        let over = |error: f64, first: f64, by: f64| {
            // NaN propagates.
            if error <= first { 0.0 } else { (error - first) / by }
        };
        let [first, slope] = contract.density;
        let sampled_by = if contract.relative { z.ln().abs() } else { e.sqrt() };
        // Only where the slope counts little is the error the first part's.
        let near = if contract.relative { 0.25 } else { 1.0 };
        let sampled_counts = contract.sampled[1] == 0.0 || sampled_by <= near;
        Self {
            density: if slope == 0.0 || e <= 1.0 { density } else { 0.0 },
            density_slope: over(density, first, e.sqrt()),
            sampled: if sampled_counts { sampled } else { 0.0 },
            sampled_slope: over(sampled, contract.sampled[0], sampled_by),
            round_trip: apart / contract.unit,
            ..Self::of(here, reference, contract)
        }
    }

    /// The larger of each. A NaN propagates, so that a comparison with a bound fails.
    pub fn include(&mut self, other: Self) {
        let larger = |a: &mut f64, b: f64| {
            if b.is_nan() || b > *a {
                *a = b;
            }
        };
        larger(&mut self.position, other.position);
        larger(&mut self.norm, other.norm);
        larger(&mut self.theta, other.theta);
        larger(&mut self.z_slope, other.z_slope);
        larger(&mut self.z, other.z);
        larger(&mut self.density, other.density);
        larger(&mut self.density_slope, other.density_slope);
        larger(&mut self.sampled, other.sampled);
        larger(&mut self.sampled_slope, other.sampled_slope);
        larger(&mut self.round_trip, other.round_trip);
    }

    /// Asserts the bounds of a contract; those of theta, density and inverse, and that of z, only
    /// where they are promised.
    pub fn assert_within(&self, contract: &Contract, theta: bool, z: bool, label: &impl Display) {
        let c = contract;
        let check = |name: &str, error: f64, bound: f64| {
            assert!(error <= bound, "{label}: {name} error {error} exceeds {bound}");
        };
        check("position", self.position, c.position);
        check("norm", self.norm, c.norm);
        if theta {
            check("theta", self.theta, c.theta);
            check("slope of density", self.density_slope, c.density[1]);
            check("slope of the sample's density", self.sampled_slope, c.sampled[1]);
            check("round trip", self.round_trip, c.round_trip);
        }
        if z {
            check("slope of z", self.z_slope, c.z[1]);
        }
    }

    /// Asserts that no bound is twice what was found or more: a stale one.
    ///
    /// A bound of 1 LSB is as low as one of fixed point can be.
    pub fn assert_not_stale(&self, contract: &Contract, label: &impl Display) {
        let check = |name: &str, error: f64, bound: f64| {
            assert!(
                bound == 0.0 || bound < 2.0 * error || !contract.relative && bound == 1.0,
                "{label}: {name} bound {bound} is stale: the largest error is {error}"
            );
        };
        check("position", self.position, contract.position);
        check("norm", self.norm, contract.norm);
        check("theta", self.theta, contract.theta);
        check("z", self.z, contract.z[0]);
        check("slope of z", self.z_slope, contract.z[1]);
        check("density", self.density, contract.density[0]);
        check("slope of density", self.density_slope, contract.density[1]);
        check("sample's density", self.sampled, contract.sampled[0]);
        check("slope of the sample's density", self.sampled_slope, contract.sampled[1]);
        check("round trip", self.round_trip, contract.round_trip);
    }
}

/// A visitor of each map of an arithmetic, of either dimension.
pub trait EachMap<A: Arithmetic> {
    /// `kind` is `disc` or the lobe; `disc` the disc map.
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    );
}

struct Visit<'a, V>(&'a mut V);

impl<A: Arithmetic, V: EachMap<A>> MapVisitor<A> for Visit<'_, V> {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        self.0.each("disc", name, map);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.0.each(name, disc, map);
    }
}

/// Every map without an exponent.
pub fn each_map<A: Arithmetic>(visitor: &mut impl EachMap<A>) {
    maps::<A>(&mut Visit(visitor));
}

/// The power lobe of an exponent over every disc map.
pub fn each_power_map<A: Arithmetic>(exponent: A::Parameter, visitor: &mut impl EachMap<A>) {
    power_maps::<A>(exponent, &mut Visit(visitor)).unwrap();
}

/// A point's components as doubles.
fn exact<R: Exact, const D: usize>(point: [R; D]) -> [f64; D] {
    point.map(Exact::exact)
}

/// Hard coordinates: powers of two, the centre, the edges, each with neighbours.
pub fn hard_coordinates() -> Vec<u32> {
    let mut hard = Vec::new();
    for bit in 0..32 {
        let step = 1_i64 << bit;
        for base in [step, (1 << 31) + step, (1 << 31) - step, (1 << 32) - step] {
            hard.extend((base - 2..=base + 2).filter_map(|k| u32::try_from(k).ok()));
        }
    }
    hard.push(0);
    hard.sort_unstable();
    hard.dedup();
    hard
}
