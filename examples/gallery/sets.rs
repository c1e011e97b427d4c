//! The points: every sequence of the catalogue through every disc map and lobe.
//!
//! A visitor sees each sequence as its own type, fills the caller's buffer by `Points::fill`, which
//! is what is timed, and keeps the points; all else in the gallery works on those.

use crate::statistics::Measured;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{self, MapVisitor, SequenceVisitor};
use hemidisc::disc::Rejection;
use hemidisc::sequence::Sequence;
use hemidisc::{Coordinates, Error, Invert, LibmF32, Map, Points};
use std::hint::black_box;
use std::time::Instant;

/// The sizes of the lecture's pictures.
pub(crate) const COUNTS: [u32; 2] = [64, 256];
/// The exponents of the lobes.
pub(crate) const EXPONENTS: [f32; 4] = [0.0, 1.0, 10.0, 100.0];
/// The sequences' seed.
const SEED: u32 = 0;
/// Points in a caller's buffer; a smaller set fills the start of it.
const BUFFER: usize = 256;

/// One sequence's points of one size.
pub(crate) struct Set {
    pub(crate) sequence: &'static str,
    pub(crate) count: u32,
    pub(crate) coordinates: Vec<[u32; 2]>,
    pub(crate) discs: Vec<OnDisc>,
    pub(crate) lobes: Vec<OnHemisphere>,
}

/// A set on the disc.
pub(crate) struct OnDisc {
    pub(crate) map: &'static str,
    pub(crate) points: Vec<[f64; 2]>,
    /// Candidates that a map which is not one-to-one threw away.
    pub(crate) rejected: Vec<[f64; 2]>,
    pub(crate) measured: Measured,
    pub(crate) nanoseconds: f64,
}

/// A set on the hemisphere: a cosine-power lobe over a disc map.
pub(crate) struct OnHemisphere {
    pub(crate) disc: &'static str,
    pub(crate) exponent: f32,
    pub(crate) directions: Vec<[f64; 3]>,
    pub(crate) nanoseconds: f64,
}

impl Set {
    pub(crate) fn on_disc(&self, map: &str) -> Option<&OnDisc> {
        self.discs.iter().find(|disc| disc.map == map)
    }

    pub(crate) fn on_hemisphere(&self, disc: &str, exponent: f32) -> Option<&OnHemisphere> {
        self.lobes.iter().find(|lobe| lobe.disc == disc && lobe.exponent == exponent)
    }
}

/// Collects the sets of every sequence at one size; `seen` is called after each.
pub(crate) fn collect(count: u32, seen: &mut dyn FnMut(&str)) -> Result<Vec<Set>, Error> {
    let mut collector = Collector { count, sets: Ok(Vec::new()), seen };
    catalogue::sequences(count, SEED, &mut collector)?;
    collector.sets
}

struct Collector<'a> {
    count: u32,
    sets: Result<Vec<Set>, Error>,
    seen: &'a mut dyn FnMut(&str),
}

impl SequenceVisitor for Collector<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        match (set(name, sequence, self.count), &mut self.sets) {
            (Ok(set), Ok(sets)) => sets.push(set),
            (Err(error), Ok(_)) => self.sets = Err(error),
            (_, Err(_)) => {}
        }
        (self.seen)(name);
    }
}

fn set<S: Sequence>(name: &'static str, sequence: S, count: u32) -> Result<Set, Error> {
    let coordinates = (0..count).map(|index| sequence.at(index)).collect();
    let mut maps = Maps {
        sequence,
        count,
        discs: vec![rejection(sequence, count)],
        lobes: vec![],
        exponent: None,
    };
    catalogue::maps(&mut maps);
    for exponent in EXPONENTS {
        maps.exponent = Some(exponent);
        catalogue::power_maps::<LibmF32>(exponent, &mut maps)?;
    }
    Ok(Set { sequence: name, count, coordinates, discs: maps.discs, lobes: maps.lobes })
}

/// Rejection of `count` candidates: the one map that `Points` cannot be, for it keeps only some.
fn rejection<S: Sequence>(sequence: S, count: u32) -> OnDisc {
    let mut buffer = [[0.0_f32; 2]; BUFFER];
    let fill = |buffer: &mut [[f32; 2]]| {
        let kept = Rejection::<LibmF32, _>::new((0..count).map(|index| sequence.at(index)));
        buffer.iter_mut().zip(kept).map(|(slot, point)| *slot = point).count()
    };
    let kept = fill(&mut buffer);
    let nanoseconds = nanoseconds_a_point(kept, || fill(black_box(&mut buffer)));
    let candidates = (0..count).map(|index| sequence.at(index));
    let rejected = candidates
        .filter(|uv| !Rejection::<LibmF32, ()>::inside(*uv))
        .map(|uv| Coordinates(uv).to_f64().map(|k| 2.0 * k - 1.0))
        .collect();
    let points = widened(&buffer, kept);
    let measured = Measured::of(&points, count);
    OnDisc { map: "rejection", points, rejected, measured, nanoseconds }
}

/// The maps of one sequence; the lobes of the list without a parameter are seen while `exponent` is
/// not set, and left out, for e = 0 and e = 1 are the same lobes.
struct Maps<S> {
    sequence: S,
    count: u32,
    discs: Vec<OnDisc>,
    lobes: Vec<OnHemisphere>,
    exponent: Option<f32>,
}

impl<S: Sequence> Maps<S> {
    /// Fills a buffer as a caller would, and times it; with the points that it holds then.
    fn fill<M: Map<Point = [f32; D]>, const D: usize>(&self, map: M) -> (Vec<[f64; D]>, f64)
    where
        [f32; D]: Default,
    {
        let mut buffer = [[0.0; D]; BUFFER];
        // Every set of the catalogue has at least the points asked for, but it need not.
        let points = Points::new(self.sequence, map);
        let points = points.take(self.count).unwrap_or(points);
        let filled = points.fill(&mut buffer);
        let nanoseconds = nanoseconds_a_point(filled, || points.fill(black_box(&mut buffer)));
        (widened(&buffer, filled), nanoseconds)
    }
}

type Slot = <LibmF32 as Arithmetic>::Real;

impl<S: Sequence> MapVisitor<LibmF32> for Maps<S> {
    fn disc<M: Invert<Point = [Slot; 2]>>(&mut self, name: &'static str, map: M) {
        let (points, nanoseconds) = self.fill(map);
        let measured = Measured::of(&points, self.count);
        self.discs.push(OnDisc { map: name, points, rejected: Vec::new(), measured, nanoseconds });
    }

    fn hemisphere<M: Invert<Point = [Slot; 3]>>(
        &mut self,
        _: &'static str,
        disc: &'static str,
        map: M,
    ) {
        if let Some(exponent) = self.exponent {
            let (directions, nanoseconds) = self.fill(map);
            self.lobes.push(OnHemisphere { disc, exponent, directions, nanoseconds });
        }
    }
}

/// The first `count` points of a buffer, exactly.
fn widened<const D: usize>(buffer: &[[f32; D]], count: usize) -> Vec<[f64; D]> {
    buffer.iter().take(count).map(|point| point.map(f64::from)).collect()
}

/// The shortest of repeated fills, for each of their `points`.
fn nanoseconds_a_point(points: usize, mut fill: impl FnMut() -> usize) -> f64 {
    const RUNS: usize = 16;
    // A run of 4096 points or so takes long enough for the clock's own cost not to show.
    let fills = 4096 / points.max(1);
    let run = |_| {
        let start = Instant::now();
        for _ in 0..fills {
            black_box(fill());
        }
        start.elapsed().as_secs_f64() * 1e9 / (fills * points) as f64
    };
    (0..RUNS).map(run).fold(f64::INFINITY, f64::min)
}
