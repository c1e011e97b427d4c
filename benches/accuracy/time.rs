//! Time of a point on this machine: every map x arithmetic once in each of many rounds, and the
//! minimum of each.

use crate::measure::Row;
use hemidisc::sequence::{SobolOwen, Stored};
use hemidisc::{Invert, Points};
use std::collections::HashMap;
use std::hint::black_box;
use std::time::{Duration, Instant};
use testkit::arithmetics::{EachArithmetic, Exponent, Tested, every_arithmetic};
use testkit::errors::{EachMap, each_map, each_power_map};

/// Points of a fill: they and their coordinates stay in the first cache.
const COUNT: usize = 1024;
/// Each round has new coordinates, because the branch predictor learns those it has seen.
const WINDOWS: usize = 16;
const ROUNDS: usize = 300;

type Smallest = HashMap<[&'static str; 3], Duration>;

/// Sets each row's time, as a ratio to `libm-f32` on the same map.
pub fn measure(rows: &mut [Row]) {
    let sequence = SobolOwen::new(7);
    let coordinates: Vec<_> = (0..).map(|i| sequence.at(i)).take(COUNT * WINDOWS).collect();
    let windows = coordinates.chunks_exact(COUNT).cycle();
    let mut round = Round { coordinates: &[], smallest: Smallest::new() };
    for window in windows.take(ROUNDS) {
        round.coordinates = window;
        every_arithmetic(&mut round);
    }
    for row in rows {
        let time = |arithmetic| round.smallest[&[row.map, row.disc, arithmetic]].as_secs_f64();
        row.host = time(row.arithmetic) / time("libm-f32");
    }
}

struct Round<'a> {
    coordinates: &'a [[u32; 2]],
    smallest: Smallest,
}

impl EachArithmetic for Round<'_> {
    fn each<A: Tested>(&mut self) {
        each_map::<A>(self);
        let parameter = A::Parameter::exactly(50.0).expect("an exponent of every type");
        each_power_map::<A>(parameter, self);
    }
}

impl<A: Tested> EachMap<A> for Round<'_> {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let stored = Stored::new(black_box(self.coordinates)).expect("coordinates");
        let points = Points::new(stored, black_box(map));
        let mut buffer = [[A::Real::default(); D]; COUNT];
        let start = Instant::now();
        points.fill(black_box(&mut buffer));
        let time = start.elapsed();
        black_box(&buffer);
        let smallest = self.smallest.entry([kind, disc, A::NAME]).or_insert(Duration::MAX);
        *smallest = time.min(*smallest);
    }
}
