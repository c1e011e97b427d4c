//! The rows: coordinates through a map, printed as they come.

use crate::arguments::Arguments;
use crate::coordinates::{coordinates, joint};
use crate::field::{Writer, writer};
use crate::{Failure, tell};
use examples::maps::SQUARE;
use hemidisc::Invert;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::disc::Rejection;
use hemidisc::map::Component;
use std::io::{self, BufWriter, Write};

/// A map as the command line sees it: one that may refuse coordinates.
pub(crate) trait Target {
    /// A component of a point.
    type Real;
    /// An array of two or three components.
    type Point: Copy + AsRef<[Self::Real]>;
    /// Whether refusals are expected, and so counted.
    const REJECTS: bool;

    fn sample(&self, uv: [u32; 2]) -> Option<Self::Point>;
    fn density(&self, point: Self::Point) -> Self::Real;
    fn invert(&self, point: Self::Point) -> [u32; 2];
}

/// A one-to-one map.
pub(crate) struct Mapped<M>(pub(crate) M);

impl<M: Invert<Point: AsRef<[Component<M>]>>> Target for Mapped<M> {
    type Real = Component<M>;
    type Point = M::Point;
    const REJECTS: bool = false;

    fn sample(&self, uv: [u32; 2]) -> Option<M::Point> {
        Some(self.0.sample(uv))
    }

    fn density(&self, point: M::Point) -> Component<M> {
        self.0.density(point)
    }

    fn invert(&self, point: M::Point) -> [u32; 2] {
        self.0.invert(point)
    }
}

/// Rejection from the square about the disc, a candidate at a time.
pub(crate) struct Rejected<A>(std::marker::PhantomData<A>);

impl<A> Rejected<A> {
    pub(crate) const fn new() -> Self {
        Self(std::marker::PhantomData)
    }
}

impl<A: Arithmetic> Target for Rejected<A> {
    type Real = A::Real;
    type Point = [A::Real; 2];
    const REJECTS: bool = true;

    fn sample(&self, uv: [u32; 2]) -> Option<[A::Real; 2]> {
        Rejection::<A>::sample(uv)
    }

    fn density(&self, point: [A::Real; 2]) -> A::Real {
        Rejection::<A>::density(point)
    }

    fn invert(&self, point: [A::Real; 2]) -> [u32; 2] {
        Rejection::<A>::invert(point)
    }
}

/// What is printed of each point, and how.
pub(crate) struct Table<'a, R> {
    arguments: &'a Arguments,
    write: Writer<R>,
}

impl<'a, R: 'static> Table<'a, R> {
    pub(crate) fn new(arguments: &'a Arguments) -> Result<Self, Failure> {
        let write = writer(arguments.raw).ok_or_else(|| {
            let name = &arguments.arithmetic;
            Failure::Usage(format!("--arithmetic: the numbers of {name} cannot be printed yet"))
        })?;
        Ok(Self { arguments, write })
    }

    /// Prints the header, the rows and, on standard error, notes and the counts of rejection.
    pub(crate) fn print<T: Target<Real = R>>(&self, target: &T) -> Result<(), Failure> {
        coordinates(self.arguments, &mut |pairs| {
            // Not before here: an error is to be the only line.
            self.arguments.notes().iter().for_each(|note| tell(note));
            let mut out = BufWriter::new(io::stdout().lock());
            let counts = self.rows(target, pairs, &mut out).map_err(Failure::Output)?;
            out.flush().map_err(Failure::Output)?;
            if T::REJECTS {
                tell(&format!("drawn {}, kept {}", counts.drawn, counts.kept));
            }
            Ok(())
        })
    }

    fn rows<T: Target<Real = R>>(
        &self,
        target: &T,
        pairs: &mut dyn Iterator<Item = [u32; 2]>,
        out: &mut dyn Write,
    ) -> io::Result<Counts> {
        let Arguments { density, invert, .. } = *self.arguments;
        let square = self.arguments.map == SQUARE;
        let components = size_of::<T::Point>() / size_of::<R>();
        let columns = match components {
            _ if invert || square => "u,v",
            2 => "x,y",
            _ => "x,y,z",
        };
        writeln!(out, "{columns}{}", if density { ",density" } else { "" })?;

        let mut counts = Counts::default();
        for uv in pairs {
            counts.drawn += 1;
            let Some(point) = target.sample(uv) else { continue };
            counts.kept += 1;
            if invert {
                cells(target.invert(point), out)?;
            } else if square {
                // The coordinates themselves, before the arithmetic rounds them.
                cells(uv, out)?;
            } else {
                self.fields(point.as_ref(), out)?;
            }
            if density {
                out.write_all(b",")?;
                (self.write)(&target.density(point), out)?;
            }
            out.write_all(b"\n")?;
        }
        Ok(counts)
    }

    fn fields(&self, components: &[R], out: &mut dyn Write) -> io::Result<()> {
        for (column, component) in components.iter().enumerate() {
            if column > 0 {
                out.write_all(b",")?;
            }
            (self.write)(component, out)?;
        }
        Ok(())
    }
}

/// Prints rows of four coordinates.
pub(crate) fn print_joint(arguments: &Arguments) -> Result<(), Failure> {
    let points = joint(arguments)?;
    arguments.notes().iter().for_each(|note| tell(note));
    let mut out = BufWriter::new(io::stdout().lock());
    let print = || {
        writeln!(out, "u,v,w,x")?;
        for [first, second] in points {
            cells(first, &mut out)?;
            out.write_all(b",")?;
            cells(second, &mut out)?;
            out.write_all(b"\n")?;
        }
        out.flush()
    };
    print().map_err(Failure::Output)
}

/// Candidates drawn and points kept.
#[derive(Default)]
struct Counts {
    drawn: u64,
    kept: u64,
}

fn cells([u, v]: [u32; 2], out: &mut dyn Write) -> io::Result<()> {
    write!(out, "0x{u:08x},0x{v:08x}")
}
