//! Hard cases against mpmath (tests/derive/maps.py): corners, axes, diagonals, both outer rings and
//! the last coordinates, for exponents from -0.9 to 3e38, in every arithmetic.

use crate::errors::{EachMap, Errors, Pair, Reference, each_map, each_power_map};
use hemidisc::arithmetic::{
    Arithmetic,
    contract::{CONTRACTS, contract},
};
use hemidisc::invariant::{self, Exact};
use hemidisc::{FastF32, LibmF32, LibmF64, Map};
use std::collections::{BTreeSet, HashMap};

/// One line of the table.
#[derive(Clone, Copy)]
struct Case {
    uv: [u32; 2],
    exact: Reference,
}

/// The cases of each (map, disc map, bits of the exponent).
type Table = HashMap<(String, String, String), Vec<Case>>;

fn double(bits: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(bits, 16).unwrap())
}

fn table() -> Table {
    let mut table = Table::new();
    for line in include_str!("../vectors/maps.csv").lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let pair = |i: usize| Pair { hi: double(fields[i]), lo: double(fields[i + 1]) };
        let word = |i: usize| u32::from_str_radix(fields[i], 16).unwrap();
        let case = Case {
            uv: [word(3), word(4)],
            exact: Reference {
                x: pair(5),
                y: pair(7),
                z: (!fields[9].is_empty()).then(|| pair(9)),
                s2: pair(11),
                density: pair(13),
            },
        };
        let key = (fields[0].to_string(), fields[1].to_string(), fields[2].to_string());
        table.entry(key).or_default().push(case);
    }
    table
}

/// Runs the cases of each map, with the exponent that the maps were made with.
struct Check<'a> {
    table: &'a Table,
    /// As the table writes it; empty for a map without one.
    exponent: &'a str,
    cases: usize,
    /// The largest errors within the promised range, by arithmetic and map.
    found: HashMap<(&'static str, &'static str), Errors>,
}

impl<A: Arithmetic<Real: Exact>> EachMap<A> for Check<'_> {
    fn each<const D: usize, M: Map<Arithmetic = A, Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let contract = contract(A::NAME, kind).unwrap();
        let e = if self.exponent.is_empty() { 0.0 } else { double(self.exponent) };
        let promised = (0.0..=1e8).contains(&e);
        let smallest =
            if A::NAME == "libm-f64" { f64::MIN_POSITIVE } else { f32::MIN_POSITIVE.into() };
        for case in &self.table[&(kind.to_string(), disc.to_string(), self.exponent.to_string())] {
            let label = format!("{} {kind}/{disc} e = {e:e} at {:08x?}", A::NAME, case.uv);
            let mut expected = case.exact;
            if let Some(z) = &mut expected.z
                && z.hi < smallest
            {
                // Below e = 0 the true z leaves the type's range: the smallest normal stands in.
                assert!(e < 0.0, "{label}: z = {:e}", z.hi);
                *z = Pair::sum(smallest, 0.0);
            }
            let errors = Errors::at(&map, case.uv, expected, &contract);
            errors.assert_within(&contract, promised, e >= 0.0, &label);
            if promised {
                self.found.entry((A::NAME, kind)).or_default().include(errors);
            } else if e > 0.0 {
                // Far above the exponents of the contract theta and density are still as accurate.
                assert!(errors.theta <= 2.0 * contract.theta, "{label}: {errors:?}");
                assert!(errors.density <= contract.density[0], "{label}: {errors:?}");
            }
            let density = map.density(map.sample(case.uv)).exact();
            assert!(density > 0.0 && density.is_finite(), "{label}: density {density}");
            if A::NAME == "libm-f64" && promised {
                invariant::inverted(&map, case.uv).unwrap_or_else(|v| panic!("{label}: {v}"));
            }
            self.cases += 1;
        }
    }
}

#[test]
fn every_hard_case_is_within_its_contract() {
    let table = table();
    let mut check = Check { table: &table, exponent: "", cases: 0, found: HashMap::new() };
    each_map::<LibmF64>(&mut check);
    each_map::<LibmF32>(&mut check);
    each_map::<FastF32>(&mut check);
    let exponents: BTreeSet<&str> =
        table.keys().map(|key| key.2.as_str()).filter(|bits| !bits.is_empty()).collect();
    assert_eq!(exponents.len(), 21);
    let mut only_f64 = 0;
    for bits in exponents {
        let exponent = double(bits);
        check.exponent = bits;
        each_power_map::<LibmF64>(exponent, &mut check);
        if f64::from(exponent as f32) == exponent {
            each_power_map::<LibmF32>(exponent as f32, &mut check);
            each_power_map::<FastF32>(exponent as f32, &mut check);
        } else {
            only_f64 +=
                table.iter().filter(|(key, _)| key.2 == bits).map(|(_, c)| c.len()).sum::<usize>();
        }
    }
    let lines: usize = table.values().map(Vec::len).sum();
    assert_eq!(check.cases, 3 * lines - 2 * only_f64, "a line was not tested in every arithmetic");
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
