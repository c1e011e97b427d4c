//! A set of points as bytes: a sequence through a map.
//!
//! Sequences meet maps behind trait objects, a block of coordinates at a time, so the program holds
//! sequences + maps x arithmetics loops, not the product of all three.

use crate::job::{Job, Work};
use crate::number::{Encoding, encoding};
use crate::set::{EXPONENT, Set};
use examples::Failure;
use examples::maps::SQUARE;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{
    ArithmeticVisitor, MapVisitor, SequenceVisitor, arithmetics, maps, power_maps, sequences,
};
use hemidisc::map::Component;
use hemidisc::map::Point;
use hemidisc::sequence::{Sequence, Stored};
use hemidisc::{FastF32, Invert, Map, Points, UnitSquare};
use serde::{Deserialize, Serialize};
use std::io::{self, Write};

/// The bytes of a point.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Layout {
    components: u8,
    /// Of which type each component is.
    number: String,
    pub(crate) bytes: u8,
}

/// A map, and the encoding of its points' components.
struct Encoded<M: Map> {
    map: M,
    encoding: Encoding<Component<M>>,
}

/// An [`Encoded`] map of any type.
trait Encode {
    fn layout(&self) -> Layout;
    /// The points of some coordinates.
    fn encode(&self, coordinates: &[[u32; 2]], bytes: &mut Vec<u8>);
}

impl<M: Map<Point: AsRef<[Component<M>]>>> Encode for Encoded<M> {
    fn layout(&self) -> Layout {
        let [point, component] = [size_of::<M::Point>(), size_of::<Component<M>>()];
        let (number, _) = self.encoding;
        Layout {
            components: (point / component) as u8,
            number: number.to_owned(),
            bytes: point as u8,
        }
    }

    fn encode(&self, coordinates: &[[u32; 2]], bytes: &mut Vec<u8>) {
        // There are none.
        let Ok(stored) = Stored::new(coordinates) else { return };
        let mut points = vec![M::Point::zero(); coordinates.len()];
        Points::new(stored, self.map).fill(&mut points);
        let (_, put) = self.encoding;
        points.iter().flat_map(AsRef::as_ref).for_each(|component| put(component, bytes));
    }
}

/// The coordinates themselves.
struct Square;

impl Encode for Square {
    fn layout(&self) -> Layout {
        Layout { components: 2, number: "u32".to_owned(), bytes: 8 }
    }

    fn encode(&self, coordinates: &[[u32; 2]], bytes: &mut Vec<u8>) {
        coordinates.iter().flatten().for_each(|axis| bytes.extend_from_slice(&axis.to_le_bytes()));
    }
}

/// Calls a function with the map of a set.
fn with_map(set: &Set, run: &mut dyn FnMut(&dyn Encode)) -> Result<(), Failure> {
    let mut chosen = Chosen { set, run, result: Ok(()) };
    arithmetics(&mut chosen);
    chosen.result
}

struct Chosen<'a> {
    set: &'a Set,
    run: &'a mut dyn FnMut(&dyn Encode),
    result: Result<(), Failure>,
}

impl ArithmeticVisitor for Chosen<'_> {
    fn visit<A: Arithmetic>(&mut self) {
        if A::NAME == self.set.arithmetic {
            self.result = self.visit_maps::<A>();
        }
    }
}

impl Chosen<'_> {
    fn visit_maps<A: Arithmetic>(&mut self) -> Result<(), Failure> {
        let Set { map, exponent, .. } = self.set;
        if map == SQUARE {
            (self.run)(&Square);
            return Ok(());
        }
        let encoding = encoding::<A::Real>().ok_or_else(|| {
            Failure::Usage(format!("--arithmetic: the numbers of {} have no bytes yet", A::NAME))
        })?;
        let mut named = Named { set: self.set, encoding, run: self.run };
        let Some(exponent) = exponent else {
            maps::<A>(&mut named);
            return Ok(());
        };
        let parsed = exponent.parse().map_err(|error| {
            // A number that the type refuses, or none.
            Failure::Usage(if exponent.parse::<f64>().is_ok() {
                format!("--exponent: {error}")
            } else {
                format!("--exponent: {exponent:?} is not a number; accepted: {EXPONENT}")
            })
        })?;
        power_maps::<A>(parsed, &mut named)
            .map_err(|error| Failure::Usage(format!("--exponent: {error}")))
    }
}

/// Takes the map of a name.
struct Named<'a, R> {
    set: &'a Set,
    encoding: Encoding<R>,
    run: &'a mut dyn FnMut(&dyn Encode),
}

impl<A: Arithmetic> MapVisitor<A> for Named<'_, A::Real> {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        if self.set.map.strip_prefix("disc-") == Some(name) {
            (self.run)(&Encoded { map, encoding: self.encoding });
        }
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        if self.set.map.strip_prefix("hemisphere-") == Some(name) && self.set.disc() == disc {
            (self.run)(&Encoded { map, encoding: self.encoding });
        }
    }
}

/// Hands the coordinates of a shard on, a block at a time.
struct Blocks<'a> {
    set: &'a Set,
    shard: u16,
    of: u16,
    take: &'a mut dyn FnMut(&[[u32; 2]]) -> io::Result<()>,
    result: io::Result<()>,
}

impl SequenceVisitor for Blocks<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        if name == self.set.sequence {
            self.result = self.of(sequence);
        }
    }
}

impl Blocks<'_> {
    fn of<S: Sequence>(&mut self, sequence: S) -> io::Result<()> {
        /// Coordinates of a block: 32 KiB of them.
        const BLOCK: usize = 4096;
        // The coordinates are the same whatever the map.
        let square = UnitSquare::<FastF32>::new();
        let shard = Points::with_range(sequence, square, ..self.set.count.get())
            .and_then(|all| all.shard(self.shard.into(), self.of.into()))
            .map_err(io::Error::other)?;
        let mut coordinates = shard.iter_coordinates();
        let mut block = Vec::with_capacity(BLOCK);
        loop {
            block.extend(coordinates.by_ref().take(BLOCK));
            if block.is_empty() {
                return Ok(());
            }
            (self.take)(&block)?;
            block.clear();
        }
    }
}

/// A set that is known to be good.
pub(crate) struct PointSet {
    set: Set,
    job: Job,
}

impl PointSet {
    pub(crate) fn new(set: Set) -> Result<Self, Failure> {
        set.check()?;
        let mut layout = None;
        with_map(&set, &mut |map| layout = Some(map.layout()))?;
        let wrong = || Failure::Usage(format!("--map: {:?} is not in this build", set.map));
        let job = Job::Points { set: set.clone(), layout: layout.ok_or_else(wrong)? };
        Ok(Self { set, job })
    }
}

impl Work for PointSet {
    fn job(&self) -> &Job {
        &self.job
    }

    fn write(&self, shard: u16, of: u16, out: &mut dyn Write) -> io::Result<()> {
        let mut result = Ok(());
        let run = &mut |map: &dyn Encode| {
            let mut bytes = Vec::new();
            let take = &mut |coordinates: &[[u32; 2]]| {
                map.encode(coordinates, &mut bytes);
                out.write_all(&bytes)?;
                bytes.clear();
                Ok(())
            };
            let mut blocks = Blocks { set: &self.set, shard, of, take, result: Ok(()) };
            let known = sequences(self.set.count.get(), self.set.seed, &mut blocks);
            result = known.map_err(io::Error::other).and(blocks.result);
        };
        // A good set has its map, and `new` has found this one to be good.
        with_map(&self.set, run).map_err(|failure| io::Error::other(failure.told().1))?;
        result
    }
}
