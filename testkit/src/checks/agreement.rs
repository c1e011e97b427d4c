//! Every arithmetic against every other, within the sum of their contracts: Q15 against Q31 against
//! f32 against f64.
//!
//! An arithmetic that reads 16 bits of a coordinate reads the centre of a cell of 2^-16, which is a
//! corner that four cells of 2^-32 share. Against one that reads 32 bits its point is that of the
//! corner, to the distance between the four.

use crate::arithmetics::{EachArithmetic, Exponent, Tested, every_arithmetic};
use crate::contract::contract;
use crate::errors::{EachMap, each_map, each_power_map};
use crate::promises::is_promised;
use hemidisc::invariant::Exact;
use hemidisc::{Invert, LibmF64};

/// The samples of one arithmetic at one pair of coordinates, in the order of the maps.
struct Samples {
    arithmetic: &'static str,
    bits: u32,
    maps: Vec<Sample>,
}

struct Sample {
    kind: &'static str,
    disc: &'static str,
    point: Vec<f64>,
    density: f64,
}

struct Take {
    uv: [u32; 2],
    maps: Vec<Sample>,
}

impl<A: Tested> EachMap<A> for Take {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let point = map.sample(self.uv);
        let density = map.density(point).exact();
        self.maps.push(Sample { kind, disc, point: point.map(Exact::exact).to_vec(), density });
    }
}

fn samples<A: Tested>(uv: [u32; 2], exponent: f64) -> Vec<Sample> {
    let mut take = Take { uv, maps: Vec::new() };
    each_map::<A>(&mut take);
    if let Some(parameter) = A::Parameter::exactly(exponent) {
        each_power_map::<A>(parameter, &mut take);
    }
    take.maps
}

struct Every {
    uv: [u32; 2],
    exponent: f64,
    taken: Vec<Samples>,
}

impl EachArithmetic for Every {
    fn each<A: Tested>(&mut self) {
        let maps = samples::<A>(self.uv, self.exponent);
        self.taken.push(Samples { arithmetic: A::NAME, bits: A::BITS, maps });
    }
}

/// The samples of all arithmetics; of the power lobe for an exponent that they hold exactly.
fn every(uv: [u32; 2], exponent: f64) -> Vec<Samples> {
    let mut every = Every { uv, exponent, taken: Vec::new() };
    every_arithmetic(&mut every);
    every.taken
}

/// The largest difference of a component.
fn apart(a: &Sample, b: &Sample) -> f64 {
    a.point.iter().zip(&b.point).map(|(a, b)| (a - b).abs()).fold(0.0, |largest, difference| {
        if difference > largest || difference.is_nan() { difference } else { largest }
    })
}

/// Two arithmetics at the same coordinates; `slack` is what the reading of each map's may differ
/// by.
fn assert_agree(a: &Samples, b: &Samples, slack: impl Fn(usize) -> f64, label: &str) {
    for (n, (at, bt)) in a.maps.iter().zip(&b.maps).enumerate() {
        let names = [a.arithmetic, "and", b.arithmetic, at.kind, at.disc, label];
        let [ca, cb] = [a, b].map(|x| contract(x.arithmetic, at.kind).unwrap());
        let room = ca.position * ca.unit + cb.position * cb.unit + slack(n);
        let found = apart(at, bt);
        assert!(found <= room, "{names:?}: {found:e} apart, not {room:e}");
        // Relative both, so they add up; a few units more for the larger of the two densities.
        if ca.relative && cb.relative && a.bits == b.bits {
            let room = ca.density[0] * ca.unit + cb.density[0] * cb.unit;
            let found = (at.density - bt.density).abs();
            let room = room * at.density.max(bt.density) * (1.0 + room);
            assert!(found <= room, "{names:?}: densities {found:e} apart, not {room:e}");
        }
    }
}

/// All pairs of arithmetics at a sample, and at the coarse cell's centre nearest to it.
pub fn check(uv: [u32; 2], exponent: f32) {
    // The accepted ones that the contracts are for, or none: there is a lobe of exponent 0 then.
    let exponent = if is_promised(exponent.into()) { exponent.into() } else { 0.0 };
    let label = format!("e = {exponent:e} at {uv:08x?}");
    let fine: Vec<_> = every(uv, exponent).into_iter().filter(|x| x.bits == 32).collect();
    for (n, a) in fine.iter().enumerate() {
        for b in &fine[n + 1..] {
            assert_agree(a, b, |_| 0.0, &label);
        }
    }
    let corner = uv.map(|k| k & 0xffff_0000 | 0x8000);
    let coarse = every(corner, exponent);
    let around = [[0, 0], [0, 1], [1, 0], [1, 1]]
        .map(|[a, b]| samples::<LibmF64>([corner[0] - a, corner[1] - b], exponent));
    let slack = |map: usize| {
        around.iter().map(|near| apart(&near[map], &around[0][map])).fold(0.0, f64::max)
    };
    let label = format!("e = {exponent:e} about {corner:08x?}");
    for (n, a) in coarse.iter().enumerate().filter(|(_, a)| a.bits < 32) {
        for (m, b) in coarse.iter().enumerate() {
            if m != n {
                assert_agree(a, b, slack, &label);
            }
        }
    }
}
