//! Contracts from both sides, over hard coordinates, random ones and short and long rings.
//!
//! The reference is the textbook's formula in f64 (`reference.rs`); for f64 it is the table of
//! mpmath values. A bound that is twice the largest error found is stale and fails.

use hemidisc::Invert;
use hemidisc::sequence::Random;
use std::collections::HashMap;
use testkit::arithmetics::{Exponent, Tested};
use testkit::contract::{CONTRACTS, contract};
use testkit::errors::{EachMap, Errors, each_map, each_power_map, hard_coordinates};
use testkit::reference::reference;

/// Collects the errors of every map by its kind.
struct Measure<'a> {
    points: &'a [[u32; 2]],
    exponent: f64,
    found: &'a mut HashMap<&'static str, Errors>,
}

impl<A: Tested> EachMap<A> for Measure<'_> {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let contract = contract(A::NAME, kind).unwrap();
        let total = self.found.entry(kind).or_default();
        for &uv in self.points {
            let e = self.exponent;
            let errors =
                Errors::at::<A, _>(&map, uv, e, reference::<A>(kind, disc, e, uv), &contract);
            // A text for each of millions of points would take most of the time.
            let label = format_args!("{} {kind}/{disc} e = {e} at {uv:08x?}", A::NAME);
            errors.assert_within(&contract, true, true, &label);
            total.include(errors);
        }
    }
}

fn points() -> Vec<[u32; 2]> {
    let hard = hard_coordinates();
    let sparse: Vec<u32> = hard.iter().step_by(3).copied().collect();
    let mut points: Vec<_> =
        sparse.iter().flat_map(|&u| sparse.iter().map(move |&v| [u, v])).collect();
    let random = Random::new(2007);
    points.extend((0..400_000).map(|i| random.at(i)));
    // Near one axis, one edge or the centre, at every scale.
    points.extend((400_000..600_000).map(|i| {
        let [u, v] = random.at(i);
        let small = u >> (1 + i % 30);
        match i % 4 {
            0 => [small, v],
            1 => [!small, v],
            2 => [0x8000_0000 ^ small, v],
            _ => [v, 0x8000_0000 ^ small],
        }
    }));
    points
}

/// The worst densities and inverses: an exponent and coordinates near the rim. The first two have
/// the worst densities of 70 million samples for fast f32 and 100 million for libm f32, each then
/// climbed to a local maximum. The third has the worst density of `micromath`. Its direction there
/// is the longest, by 1.0e-3, and the log of the density is the largest multiple of that. It is as
/// near to the rim as s^2 just below 1/2 allows, from which on the density is by z. The fourth has
/// its worst inverse, of 60 million.
const WITNESSES: [(f32, [u32; 2]); 4] = [
    (116.567_49, [0x067b_e2f2, 0xffff_ffff]),
    (105.683_73, [0x38a2_1c26, 0xffff_fff9]),
    (65.5, [0x1ffb_25b1, u32::MAX]),
    (56.713_493, [0x6164_12ea, 0xffff_fff6]),
];

/// For all but f64, which the formulas in f64 are not accurate enough to judge.
fn holds_its_contract<A: Tested>() {
    let rows = || CONTRACTS.iter().filter(|row| row.arithmetic == A::NAME);
    assert_eq!(rows().count(), 4, "{}: contracts", A::NAME);
    if rows().any(|row| row.unit < 0.5_f64.powi(40)) {
        return;
    }
    let points = points();
    let mut found = HashMap::new();
    each_map::<A>(&mut Measure { points: &points, exponent: 0.0, found: &mut found });
    // Exponents for which e + 1 rounds as badly as it can come first; then the usual; then any.
    let random = Random::new(9);
    let any = (0..60).map(|i| {
        let [bits, scale] = random.at(i);
        (bits >> 8) as f32 * 0.5_f32.powi(24 + (scale % 30) as i32 - 4)
    });
    let mut run = |exponent: f32, points: &[[u32; 2]]| {
        // Fixed point has multiples of 2^-32.
        let exponent = f64::from(exponent);
        let nearest = || (exponent * 4_294_967_296.0).round() / 4_294_967_296.0;
        let parameter = A::Parameter::exactly(exponent);
        let parameter = parameter.or_else(|| A::Parameter::exactly(nearest())).unwrap();
        let mut measure = Measure { points, exponent: parameter.value(), found: &mut found };
        each_power_map::<A>(parameter, &mut measure);
    };
    for (exponent, uv) in WITNESSES {
        run(exponent, &[uv]);
    }
    let hard = [1.788_139_3e-7, 1.794_718_7e-4, 1e-3, 0.03, 0.1, 3.3, 1.0 / 3.0];
    let usual = [0.0, 0.5, 1.0, 10.0, 100.0, 1e4, 1e8];
    for (n, exponent) in hard.into_iter().chain(usual).chain(any).enumerate() {
        // A third of the points for those chosen, a twentieth for those that are not.
        let size = points.len() / if n < 14 { 3 } else { 20 };
        let from = n * 7919 % (points.len() - size);
        run(exponent, &points[from..from + size]);
    }
    for contract in rows() {
        let found = found[contract.map];
        println!("{} {}: {found:.3?}", A::NAME, contract.map);
        found.assert_not_stale(contract, &format!("{} {}", A::NAME, contract.map));
    }
}

testkit::test_each_arithmetic!(holds_its_contract);
