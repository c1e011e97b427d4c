//! Hard cases against mpmath (tests/derive/maps.py): corners, axes, diagonals, both outer rings and
//! the last coordinates, for exponents from -0.9 to 3e38, in every arithmetic.

use crate::errors::{EachMap, Errors, Pair, Reference, each_map, each_power_map, exact};
use hemidisc::arithmetic::{
    Arithmetic,
    contract::{CONTRACTS, contract},
};
use hemidisc::invariant::{self, Exact};
use hemidisc::{LibmF32, LibmF64, Map};
use std::collections::HashMap;

/// One line of the table.
#[derive(Clone, Copy)]
struct Case {
    uv: [u32; 2],
    exact: Reference,
    density: f64,
}

/// The cases of each (map, disc map, bits of the exponent).
type Table = HashMap<(String, String, String), Vec<Case>>;

fn table() -> Table {
    let mut table = Table::new();
    for line in include_str!("../vectors/maps.csv").lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let double = |i: usize| f64::from_bits(u64::from_str_radix(fields[i], 16).unwrap());
        let pair = |i: usize| Pair { hi: double(i), lo: double(i + 1) };
        let word = |i: usize| u32::from_str_radix(fields[i], 16).unwrap();
        let case = Case {
            uv: [word(3), word(4)],
            exact: Reference {
                x: pair(5),
                y: pair(7),
                z: (!fields[9].is_empty()).then(|| pair(9)),
                s2: pair(11),
            },
            density: double(13),
        };
        let key = (fields[0].to_string(), fields[1].to_string(), fields[2].to_string());
        table.entry(key).or_default().push(case);
    }
    table
}

/// Runs the cases of each map, with the exponent that the maps were made with.
struct Check<'a> {
    table: &'a Table,
    exponent: Option<f32>,
    cases: usize,
    /// The largest errors within the promised range, by arithmetic and map.
    found: HashMap<(&'static str, &'static str), Errors>,
}

impl<A: Arithmetic> EachMap<A> for Check<'_>
where
    A::Real: Exact,
{
    fn each<const D: usize, M: Map<Arithmetic = A, Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let bits = self.exponent.map_or(String::new(), |e| format!("{:08x}", e.to_bits()));
        let contract = contract(A::NAME, kind).unwrap();
        let e = self.exponent.unwrap_or(0.0);
        let smallest =
            if A::NAME == "libm-f64" { f64::MIN_POSITIVE } else { f32::MIN_POSITIVE.into() };
        for case in &self.table[&(kind.to_string(), disc.to_string(), bits)] {
            let label = format!("{} {kind}/{disc} e = {e:e} at {:08x?}", A::NAME, case.uv);
            let point = map.sample(case.uv);
            let density = map.density(point).exact();
            let coordinates = exact(point);

            let mut expected = case.exact;
            if let Some(z) = &mut expected.z
                && z.hi < smallest
            {
                // Below e = 0 the true z leaves the type's range: the smallest normal stands in.
                assert!(e < 0.0, "{label}: z = {:e}", z.hi);
                *z = Pair::sum(smallest, 0.0);
            }
            let errors = Errors::of(coordinates, expected, &contract);
            errors.assert_within(&contract, (0.0..=1e8).contains(&e), e >= 0.0, &label);
            if (0.0..=1e8).contains(&e) {
                self.found.entry((A::NAME, kind)).or_default().include(errors);
            }
            // theta stays accurate far above the exponents of the contract: see below.
            if kind == "power" && e > 1e8 {
                assert!(errors.theta <= 2.0 * contract.theta, "{label}: theta {}", errors.theta);
            }

            assert!(density > 0.0 && density.is_finite(), "{label}: density {density}");
            if e >= 0.0 {
                // Rounding of the point moves ln z by a few units, and e ln z is at least -23.
                let relative = (density / case.density - 1.0).abs() / contract.unit;
                assert!(relative <= 256.0, "{label}: density off by {relative} units");
            }
            if A::NAME == "libm-f64" && (0.0..=1e8).contains(&e) {
                invariant::inverted(&map, case.uv).unwrap_or_else(|v| panic!("{label}: {v}"));
            }
            self.cases += 1;
        }
    }
}

const EXPONENTS: [f32; 14] = [
    -0.9,
    0.0,
    f32::from_bits(1),
    f32::from_bits(0x3380_0000),
    0.5,
    1.0,
    3.3,
    10.0,
    1e2,
    1e3,
    1e4,
    1e8,
    f32::from_bits(0x7180_0000),
    3e38,
];

#[test]
fn every_hard_case_is_within_its_contract() {
    let table = table();
    let mut check = Check { table: &table, exponent: None, cases: 0, found: HashMap::new() };
    each_map::<LibmF64>(&mut check);
    each_map::<LibmF32>(&mut check);
    for exponent in EXPONENTS {
        check.exponent = Some(exponent);
        each_power_map::<LibmF64>(exponent.into(), &mut check);
        each_power_map::<LibmF32>(exponent, &mut check);
    }
    let lines: usize = table.values().map(Vec::len).sum();
    assert_eq!(check.cases, 2 * lines, "a line of the table was not tested in both arithmetics");
    for contract in CONTRACTS.iter().filter(|row| row.arithmetic == "libm-f64") {
        let found = check.found[&(contract.arithmetic, contract.map)];
        println!("libm-f64 {}: {found:.3?}", contract.map);
        found.assert_not_stale(contract, &format!("libm-f64 {}", contract.map));
    }
}

#[test]
fn exponents_are_checked() {
    use hemidisc::{Error, Power};
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, -1.5, f32::MIN] {
        assert!(matches!(Power::<LibmF32>::new(bad), Err(Error::Exponent { .. })), "{bad}");
        assert!(matches!(Power::<LibmF64>::new(bad.into()), Err(Error::Exponent { .. })), "{bad}");
    }
    let nearest = -1.0 + f32::EPSILON / 2.0;
    for good in [nearest, -0.5, -0.0, f32::MAX] {
        assert!(Power::<LibmF32>::new(good).is_ok(), "{good}");
    }
    let error = Power::<LibmF32>::new(-1.5).unwrap_err();
    assert_eq!(error.to_string(), "exponent is -1.5; accepted: a finite number above -1");
}
