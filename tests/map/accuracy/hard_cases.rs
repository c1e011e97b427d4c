//! Hard cases against mpmath (tests/derive/maps.py): corners, axes, diagonals, both outer rings and
//! the last coordinates, for exponents from -0.9 to 3e38, in every arithmetic. An arithmetic that
//! reads 16 bits of a coordinate has a table of its own.

use hemidisc::invariant::{self, Exact};
use hemidisc::{Invert, LibmF32, LibmF64};
use std::collections::{BTreeSet, HashMap};
use testkit::arithmetics::{Exponent, Number, Tested};
use testkit::contract::{CONTRACTS, contract};
use testkit::errors::{EachMap, Errors, each_map, each_power_map};
use testkit::vectors::{Table, UNREAD, double, table};

/// Runs the cases of each map, with the exponent that the maps were made with.
struct Check<'a> {
    table: &'a Table,
    /// As the table writes it; empty for a map without one.
    exponent: &'a str,
    cases: usize,
    /// The largest errors within the promised range, by map.
    found: HashMap<&'static str, Errors>,
}

impl<A: Tested> EachMap<A> for Check<'_> {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let contract = contract(A::NAME, kind).unwrap();
        let e = if self.exponent.is_empty() { 0.0 } else { double(self.exponent) };
        let promised = (0.0..=1e8).contains(&e);
        for case in &self.table[&(kind.to_string(), disc.to_string(), self.exponent.to_string())] {
            let label = format!("{} {kind}/{disc} e = {e:e} at {:08x?}", A::NAME, case.uv);
            if A::BITS < 32 {
                let read = case.uv.map(|k| k & !UNREAD);
                let same = map.sample(read).map(Exact::exact);
                assert_eq!(same, map.sample(case.uv).map(Exact::exact), "{label}: low bits");
            }
            let mut expected = case.exact;
            if !A::Real::FIXED && e < 0.0 {
                expected = expected.with_z_from(A::Real::SMALLEST);
            }
            let errors = Errors::at::<A, _>(&map, case.uv, e, expected, &contract);
            errors.assert_within(&contract, promised, e >= 0.0, &label);
            if promised {
                self.found.entry(kind).or_default().include(errors);
            } else if e > 0.0 {
                // Far above the exponents of the contract theta and density are still as accurate.
                assert!(errors.theta <= 2.0 * contract.theta, "{label}: {errors:?}");
                assert!(errors.density_slope <= contract.density[1], "{label}: {errors:?}");
                assert!(errors.sampled_slope <= contract.sampled[1], "{label}: {errors:?}");
            }
            let (point, with_sample) = map.sample_with_density(case.uv);
            let densities = [map.density(point), with_sample].map(Exact::exact);
            for density in densities {
                assert!(density > 0.0 && density.is_finite(), "{label}: density {density}");
            }
            // A z that is not the coordinates' has a density of its own.
            if e < 0.0 && point[D - 1].exact() == A::Real::SMALLEST {
                assert_eq!(densities[0], densities[1], "{label}");
            }
            if A::NAME == "libm-f64" && promised {
                invariant::inverted(&map, case.uv).unwrap_or_else(|v| panic!("{label}: {v}"));
            }
            self.cases += 1;
        }
    }
}

fn is_within_its_contract<A: Tested>() {
    let table = table(A::BITS);
    let mut check = Check { table: &table, exponent: "", cases: 0, found: HashMap::new() };
    each_map::<A>(&mut check);
    let exponents: BTreeSet<&str> =
        table.keys().map(|key| key.2.as_str()).filter(|bits| !bits.is_empty()).collect();
    let mut skipped = 0;
    for bits in &exponents {
        let Some(parameter) = A::Parameter::exactly(double(bits)) else {
            skipped +=
                table.iter().filter(|(key, _)| key.2 == *bits).map(|(_, c)| c.len()).sum::<usize>();
            continue;
        };
        check.exponent = bits;
        each_power_map::<A>(parameter, &mut check);
    }
    let lines: usize = table.values().map(Vec::len).sum();
    println!("{}: {} cases, {skipped} of other exponents", A::NAME, check.cases);
    assert_eq!(check.cases + skipped, lines, "a line was not tested");
    // These every arithmetic has.
    for e in [0.0, 1.0, 10.0, 1e4, 1e8_f64] {
        assert!(A::Parameter::exactly(e).is_some(), "{}: e = {e}", A::NAME);
        assert!(exponents.contains(format!("{:016x}", e.to_bits()).as_str()), "e = {e}");
    }
    // The other arithmetics find their largest errors over more points than these.
    let rows = CONTRACTS.iter().filter(|row| row.arithmetic == A::NAME);
    for contract in rows.filter(|row| row.unit < 0.5_f64.powi(40)) {
        let found = check.found[contract.map];
        println!("{} {}: {found:.3?}", A::NAME, contract.map);
        found.assert_not_stale(contract, &format!("{} {}", A::NAME, contract.map));
    }
}

testkit::test_each_arithmetic!(is_within_its_contract);

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
