//! The invariants can fail: each is given a map or a sequence with one fault and must name it.
#![cfg(feature = "libm")]

use hemidisc::invariant::{self, Violation, in_unit_disc};
use hemidisc::map::{Component, Density, Invert, Map, Point};
use hemidisc::sequence::{Block, Hammersley, NRooks, Regular, Sequence, Sobol};
use hemidisc::{Concentric, Cosine, LibmF32, Polar};

/// A map with a fault in its points, its density or its inverse.
#[derive(Clone, Copy)]
struct Faulty<M: Map> {
    map: M,
    sample: fn(M::Point) -> M::Point,
    density: fn(f32) -> f32,
    invert: fn([u32; 2]) -> [u32; 2],
}

impl<M: Map> Faulty<M> {
    fn sample(map: M, sample: fn(M::Point) -> M::Point) -> Self {
        Self { map, sample, density: |d| d, invert: |uv| uv }
    }
}

impl<M: Map> Map for Faulty<M> {
    type Point = M::Point;

    fn sample(&self, uv: [u32; 2]) -> M::Point {
        (self.sample)(self.map.sample(uv))
    }
}

impl<M: Density<Point: Point<Component = f32>>> Density for Faulty<M> {
    fn density(&self, point: M::Point) -> Component<Self> {
        (self.density)(self.map.density(point))
    }
}

impl<M: Invert<Point: Point<Component = f32>>> Invert for Faulty<M> {
    fn invert(&self, point: M::Point) -> [u32; 2] {
        (self.invert)(self.map.invert(point))
    }
}

const UV: [u32; 2] = [u32::MAX, 1 << 31];

#[test]
fn maps_with_a_fault_are_found_out() {
    let disc = Concentric::<LibmF32>::new();
    assert_eq!(invariant::disc(&disc, UV), Ok(()));
    let one_ulp_out = Faulty::sample(disc, |[x, y]| [f32::from_bits(x.to_bits() + 1), y]);
    assert_eq!(invariant::disc(&one_ulp_out, UV), Err(Violation::OutsideDisc { uv: UV }));
    let nan = Faulty::sample(disc, |[x, _]| [x, f32::NAN]);
    assert_eq!(invariant::disc(&nan, UV), Err(Violation::NotFinite { uv: UV }));
    let wrong_sign = Faulty::sample(disc, |[x, y]| [x.abs(), y]);
    let mirror = invariant::mirrored_concentric(&wrong_sign, UV);
    assert_eq!(mirror, Err(Violation::NotMirrored { uv: UV }));
    let biased = Faulty::sample(disc, |[x, y]| [x - 1e-7, y]);
    assert!(invariant::mirrored_concentric(&biased, [1, 2]).is_err());
    let polar = Faulty::sample(Polar::<LibmF32>::new(), |[x, y]| [x, y + 1e-7]);
    assert!(invariant::mirrored_polar(&polar, [1 << 30, 1 << 30]).is_err());
    for (density, violation) in [
        ((|_| 0.0) as fn(f32) -> f32, Violation::NoDensity { uv: UV }),
        (|_| f32::INFINITY, Violation::NotFinite { uv: UV }),
        (|_| f32::NAN, Violation::NotFinite { uv: UV }),
    ] {
        let faulty = Faulty { density, ..Faulty::sample(disc, |p| p) };
        assert_eq!(invariant::disc(&faulty, UV), Err(violation));
    }
    let off_by_one = Faulty { invert: |[u, v]| [u, v ^ 1], ..Faulty::sample(disc, |p| p) };
    assert!(matches!(invariant::inverted(&off_by_one, UV), Err(Violation::NotInverted { .. })));
}

#[test]
fn lobes_with_a_fault_are_found_out() {
    let cosine = Cosine::<LibmF32>::new();
    assert_eq!(invariant::hemisphere(&cosine, UV), Ok(()));
    for (height, violation) in [
        ((|[x, y, _]| [x, y, 0.0]) as fn([f32; 3]) -> _, Violation::BelowHorizon { uv: UV }),
        (|[x, y, z]| [x, y, -z], Violation::BelowHorizon { uv: UV }),
        (|[x, y, _]| [x, y, f32::NAN], Violation::NotFinite { uv: UV }),
        (|[x, y, _]| [x, y, f32::INFINITY], Violation::NotFinite { uv: UV }),
    ] {
        assert_eq!(invariant::hemisphere(&Faulty::sample(cosine, height), UV), Err(violation));
    }
    let out = Faulty::sample(cosine, |[x, _, z]| [x, 0.01, z]);
    assert_eq!(invariant::hemisphere(&out, UV), Err(Violation::OutsideDisc { uv: UV }));
}

/// A sequence with one point replaced, and perhaps blocks that do not know.
#[derive(Clone, Copy)]
struct Replaced<S> {
    sequence: S,
    index: u32,
    point: [u32; 2],
    in_blocks: bool,
}

impl<S: Sequence> Sequence for Replaced<S> {
    fn size(&self) -> Option<u32> {
        self.sequence.size()
    }

    fn at(&self, index: u32) -> [u32; 2] {
        if index == self.index { self.point } else { self.sequence.at(index) }
    }

    fn block(&self, start: u32, u: &mut Block, v: &mut Block) {
        self.sequence.block(start, u, v);
        if self.in_blocks {
            let offset = self.index.wrapping_sub(start) as usize;
            if let (Some(u), Some(v)) = (u.get_mut(offset), v.get_mut(offset)) {
                [*u, *v] = self.point;
            }
        }
    }
}

#[test]
fn sequences_with_a_fault_are_found_out() {
    let marks = &mut [0; 64];
    let sobol = Sobol::new(5);
    assert_eq!(invariant::net(&sobol, 1024, 8, marks), Ok(()));
    // Not a multiple of 2^8: no net is promised there, and none is found.
    assert!(invariant::net(&sobol, 1025, 8, marks).is_err());
    // Rooks alone pass the two extreme shapes and fail one between.
    let only_rooks = NRooks::new(256, 1).unwrap();
    assert_eq!(invariant::rooks(&only_rooks, 0, 256, marks), Ok(()));
    let found = invariant::net(&only_rooks, 0, 8, marks);
    assert!(matches!(found, Err(Violation::Stratum { grid: [2..=128, 2..=128], .. })), "{found:?}");
    assert!(matches!(invariant::net(&sobol, 0, 32, marks), Err(Violation::NoRoom { .. })));
    // One coordinate moved by a 2^-8 of the axis.
    let [u, v] = sobol.at(1030);
    let moved = Replaced { sequence: sobol, index: 1030, point: [u, v ^ 1 << 24], in_blocks: true };
    assert!(matches!(invariant::net(&moved, 1024, 8, marks), Err(Violation::Stratum { .. })));

    let rooks = NRooks::new(100, 1).unwrap();
    assert_eq!(invariant::rooks(&rooks, 0, 100, marks), Ok(()));
    let twice = Replaced { sequence: rooks, index: 7, point: rooks.at(8), in_blocks: true };
    let found = invariant::rooks(&twice, 0, 100, marks);
    assert_eq!(found, Err(Violation::Stratum { grid: [100, 1], index: 8 }));

    let grid = Regular::new(10, 10).unwrap();
    assert_eq!(invariant::cells(&grid, 0, [10, 10], marks), Ok(()));
    assert!(invariant::cells(&grid, 0, [10, 11], marks).is_err());
    assert_eq!(
        invariant::cells(&grid, 0, [100, 100], marks),
        Err(Violation::NoRoom { needed: 313 })
    );

    let hammersley = Hammersley::new(1000).unwrap();
    assert_eq!(invariant::consistent(&hammersley, 64), Ok(()));
    let forgetful = Replaced { sequence: hammersley, index: 70, point: [0; 2], in_blocks: false };
    assert!(invariant::consistent(&forgetful, 64).is_err());
    assert!(invariant::consistent(&forgetful, 128).is_ok());
}

#[test]
fn the_exact_test_is_exact() {
    // The f32 on either side of sqrt(1/2): 2 x^2 is below and above 1 by less than an eps.
    let below = f64::from(std::f32::consts::FRAC_1_SQRT_2);
    let above = f64::from(f32::from_bits(std::f32::consts::FRAC_1_SQRT_2.to_bits() + 1));
    assert!(in_unit_disc([below, below]) == (below * below * 2.0 <= 1.0));
    assert!(!in_unit_disc([above, above]));
    // 1 - 2^-53 and 2^-26: x^2 + y^2 = 1 - 2^-52 + 2^-106 + 2^-52 > 1 by 2^-106, which f64 cannot
    // see.
    let x = 1.0 - f64::EPSILON / 2.0;
    assert_eq!(x * x + 0.5_f64.powi(52), 1.0);
    assert!(!in_unit_disc([x, 0.5_f64.powi(26)]));
    assert!(in_unit_disc([x, f64::from_bits(0.5_f64.powi(26).to_bits() - 1)]));
}
