//! The errors of every map x arithmetic.
//!
//! The reference is the textbook's formula in f64, at random and at hard coordinates. It is not
//! accurate enough for `libm-f64`, whose reference is mpmath at the hard cases of
//! `testkit/vectors/maps.csv`.

use crate::evenness::deviation;
use hemidisc::Invert;
use hemidisc::Map;
use hemidisc::invariant::Exact;
use hemidisc::sequence::Random;
use serde::Serialize;
use std::collections::BTreeMap;
use testkit::arithmetics::{EachArithmetic, Exponent, Tested, every_arithmetic};
use testkit::contract::{Contract, contract};
use testkit::errors::{EachMap, Errors, Reference, each_map, each_power_map, hard_coordinates};
use testkit::reference::reference;
use testkit::vectors::{self, Table};

/// Exponents of the power lobe; its errors are those of both.
const EXPONENTS: [f64; 2] = [10.0, 100.0];
/// Random coordinates of each map.
const COUNT: u32 = 200_000;

/// A maximum and a root mean square, in units.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Error {
    pub max: f64,
    pub rms: f64,
}

/// The accuracy and the cost of a map in an arithmetic.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub map: &'static str,
    pub disc: &'static str,
    pub arithmetic: &'static str,
    /// Of the errors: half an ulp of 1 or an LSB; 2^-20 for `micromath-f32`.
    pub unit: f64,
    /// Of a component of the point.
    pub position: Error,
    /// Of the norm from 1; on the disc from r.
    pub norm: Error,
    /// Of the angle from the pole, relative in floats; none on the disc.
    pub theta: Option<Error>,
    /// Largest change by rounding in the share of a set within a radius or a polar angle.
    pub evenness: f64,
    /// Time of a point on this machine, as a ratio to `libm-f32` on the same map.
    pub host: f64,
    pub boards: BTreeMap<String, Board>,
}

/// What a fill costs on a board.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Board {
    pub instructions_per_point: f64,
    pub flash_bytes: u64,
    pub stack_bytes: u64,
}

/// Every map x arithmetic.
pub fn rows() -> Vec<Row> {
    let mut rows = Rows { table: vectors::table(32), rows: Vec::new() };
    every_arithmetic(&mut rows);
    rows.rows
}

struct Rows {
    table: Table,
    rows: Vec<Row>,
}

impl EachArithmetic for Rows {
    fn each<A: Tested>(&mut self) {
        let mut maps = Maps { exponent: None, table: &self.table, rows: &mut self.rows };
        each_map::<A>(&mut maps);
        for exponent in EXPONENTS {
            maps.exponent = Some(exponent);
            let parameter = A::Parameter::exactly(exponent).expect("an exponent of every type");
            each_power_map::<A>(parameter, &mut maps);
        }
    }
}

/// Every map of an arithmetic.
struct Maps<'a> {
    exponent: Option<f64>,
    table: &'a Table,
    rows: &'a mut Vec<Row>,
}

impl<A: Tested> EachMap<A> for Maps<'_> {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let contract = contract(A::NAME, kind).expect("every map has a contract");
        let e = self.exponent.unwrap_or_default();
        let exact = |uv| reference::<A>(kind, disc, e, uv);
        let errors = if contract.unit < 0.5_f64.powi(40) {
            let bits = self.exponent.map_or(String::new(), |e| format!("{:016x}", e.to_bits()));
            let cases = &self.table[&(kind.to_owned(), disc.to_owned(), bits)];
            collected(cases.iter().map(|case| errors(&map, case.uv, case.exact, &contract)), &[])
        } else {
            let random = Random::new(2007);
            let random = (0..COUNT).map(|i| random.at(i));
            let hard = hard_coordinates();
            // Each of them against one of the others.
            let hard = hard.iter().zip(hard.iter().cycle().skip(hard.len() / 3));
            let hard: Vec<_> =
                hard.map(|(u, v)| errors(&map, [*u, *v], exact([*u, *v]), &contract)).collect();
            collected(random.map(|uv| errors(&map, uv, exact(uv), &contract)), &hard)
        };
        let [position, norm, theta] = errors;
        let row = Row {
            map: kind,
            disc,
            arithmetic: A::NAME,
            unit: contract.unit,
            position,
            norm,
            theta: (kind != "disc").then_some(theta),
            evenness: deviation(&map, kind, e, exact),
            host: f64::NAN,
            boards: BTreeMap::new(),
        };
        let same = |known: &&mut Row| {
            (known.map, known.disc, known.arithmetic) == (row.map, row.disc, row.arithmetic)
        };
        match self.rows.iter_mut().find(same) {
            Some(known) => known.include(&row),
            None => self.rows.push(row),
        }
    }
}

impl Row {
    /// The larger errors of two exponents.
    fn include(&mut self, other: &Self) {
        let larger = |a: &mut Error, b: Error| {
            *a = Error { max: a.max.max(b.max), rms: a.rms.max(b.rms) };
        };
        larger(&mut self.position, other.position);
        larger(&mut self.norm, other.norm);
        if let (Some(theta), Some(other)) = (&mut self.theta, other.theta) {
            larger(theta, other);
        }
        self.evenness = self.evenness.max(other.evenness);
    }
}

fn errors<const D: usize, M: Map<Point = [R; D]>, R: Exact>(
    map: &M,
    uv: [u32; 2],
    exact: Reference,
    contract: &Contract,
) -> [f64; 3] {
    let point = map.sample(uv).map(Exact::exact);
    let Errors { position, norm, theta, .. } = Errors::of(point, exact, contract);
    [position, norm, theta]
}

/// The root mean squares of the first, and the maxima of both.
fn collected(of: impl Iterator<Item = [f64; 3]>, hard: &[[f64; 3]]) -> [Error; 3] {
    let (mut count, mut squares, mut largest) = (0.0, [0.0; 3], [0.0_f64; 3]);
    let mut include = |errors: [f64; 3]| {
        for (largest, error) in largest.iter_mut().zip(errors) {
            assert!(!error.is_nan(), "an error is not a number");
            *largest = largest.max(error);
        }
    };
    for errors in of {
        count += 1.0;
        include(errors);
        for (square, error) in squares.iter_mut().zip(errors) {
            *square += error * error;
        }
    }
    hard.iter().copied().for_each(include);
    [0, 1, 2].map(|i| Error { max: largest[i], rms: (squares[i] / count).sqrt() })
}
