//! [`Arbitrary`] for what a renderer is configured with: any bytes make a valid value.
//!
//! A total function builds a value from parts that any bytes give. It first corrects what a
//! constructor would refuse, so that small changes of the bytes stay small changes of the value.
//! Only [`Stored`](crate::sequence::Stored) is left out: its points are the caller's.

use crate::arithmetic::{Arithmetic, Real, Root};
use crate::catalogue::Parameters;
use crate::domain::{Split, Stream};
use crate::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use crate::error::{Axis, Error};
use crate::frame::{About, Frame, Unit};
use crate::map::{Concentric, Cosine, Map, Polar, Power, Uniform, UnitSquare};
use crate::points::Points;
use crate::sampler::Sampler;
use crate::screen::Screen;
use crate::sequence::{GridSize, InDomain, Sequence, Shifted, Shuffled};
use crate::{Coordinates, Domain};
use arbitrary::{Arbitrary, Unstructured};

/// `[generics] Type: parts => function;`
macro_rules! made_of {
    ($([$($generics:tt)*] $type:ty: $parts:ty => $make:expr;)*) => {$(
        impl<'a, $($generics)*> Arbitrary<'a> for $type {
            fn arbitrary(u: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
                let make: fn($parts) -> Result<Self, Error> = $make;
                // None is refused, as `tests/arbitrary.rs` shows.
                make(u.arbitrary()?).map_err(|_| arbitrary::Error::IncorrectFormat)
            }

            fn size_hint(depth: usize) -> (usize, Option<usize>) {
                <$parts as Arbitrary>::size_hint(depth)
            }
        }
    )*};
}

made_of! {
    [] Coordinates: [u32; 2] => |cells| Ok(Self(cells));
    [] Axis: bool => |second| Ok(if second { Self::V } else { Self::U });
    [] Domain: [u32; 4] => |[seed, x, y, key]| Ok(Self::new(seed).pixel(x, y).child(key));
    [] Split: (Domain, [u32; 2]) => |(domain, [key, ways])| Ok(domain.split(key, ways));
    [] Stream: Domain => |domain| Ok(domain.stream());
    [] GridSize: [u16; 2] => |sides| {
        let [columns, rows] = sides.map(|side| side.max(1).into());
        Self::new(columns, rows)
    };
    [S: InDomain<Size: Arbitrary<'a>>] Sampler<S>: (Domain, S::Size, u32)
        => |(domain, size, index)| Ok(Self::of(domain, size, index));
    [] Screen: (Domain, [u32; 3]) => |(domain, sizes)| {
        let [width, height, samples] = sizes.map(|size| size.max(1));
        Self::new(domain, [width, height], samples)
    };
}

/// Any parameters as the constructors of sequences accept them.
fn accepted(parameters: Parameters) -> Parameters {
    let columns = parameters.columns.max(1);
    let rows = parameters.rows.clamp(1, u32::MAX / columns);
    Parameters { columns, rows, count: parameters.count.max(1), ..parameters }
}

fn hint_of<'a, T: Arbitrary<'a>>(_: T, depth: usize) -> (usize, Option<usize>) {
    T::size_hint(depth)
}

/// Every sequence, of as many parameters as its constructor takes, in their order.
macro_rules! sequences {
    ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*) => {$(
        impl<'a> Arbitrary<'a> for crate::sequence::$sequence {
            #[allow(unused, reason = "a constructor may take nothing")]
            fn arbitrary(u: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
                let mut parameters = Parameters::new(1, 0);
                $(parameters.$part = u.arbitrary()?;)*
                let parameters = accepted(parameters);
                let make = || -> Result<Self, Error> {
                    let made = made_by!($kind Self::$new($(parameters.$part),*));
                    Ok(made)
                };
                // None is refused, as `tests/arbitrary.rs` shows.
                make().map_err(|_| arbitrary::Error::IncorrectFormat)
            }

            #[allow(unused, reason = "a constructor may take nothing")]
            fn size_hint(depth: usize) -> (usize, Option<usize>) {
                let parameters = Parameters::new(1, 0);
                arbitrary::size_hint::and_all(&[$(hint_of(parameters.$part, depth)),*])
            }
        }
    )*};
}
for_each_sequence!(sequences);

made_of! {
    [S: Sequence + Arbitrary<'a>]
    Shuffled<S>: (S, Domain) => |(sequence, domain)| Ok(Self::new(sequence, domain));
    [S: Sequence + Arbitrary<'a>]
    Shifted<S>: (S, Domain) => |(sequence, domain)| Ok(Self::new(sequence, domain));
}

made_of! {
    [A: Arithmetic] UnitSquare<A>: () => |()| Ok(Self::new());
    [A: Arithmetic] Concentric<A>: () => |()| Ok(Self::new());
    [A: Arithmetic] Polar<A>: () => |()| Ok(Self::new());
    [A: Arithmetic] Uniform<A>: () => |()| Ok(Self::new());
    [A: Arithmetic] Uniform<A, Polar<A>>: () => |()| Ok(Self::over(Polar::new()));
    [A: Arithmetic] Cosine<A>: () => |()| Ok(Self::new());
    [A: Arithmetic] Cosine<A, Polar<A>>: () => |()| Ok(Self::over(Polar::new()));
    [A: Arithmetic<Parameter: Arbitrary<'a>>]
    Power<A>: Accepted<A> => |exponent| Self::new(exponent.0);
    [A: Arithmetic<Parameter: Arbitrary<'a>>]
    Power<A, Polar<A>>: Accepted<A> => |exponent| Self::over(exponent.0, Polar::new());
    [M: Map + Arbitrary<'a>, R: Real + Arbitrary<'a>]
    About<M, R>: (M, Frame<R>) => |(map, frame)| Ok(Self::new(map, frame));
    [S: Sequence + Arbitrary<'a>, M: Map + Arbitrary<'a>]
    Points<S, M>: (S, M, [u32; 2]) => |(sequence, map, [start, count])| {
        let len = sequence.size().map_or(1 << 32, u64::from);
        let start = (u64::from(start) % len) as u32;
        let points = Self::with_range(sequence, map, start..)?;
        points.take(count.min(points.len()))
    };
}

#[cfg(feature = "fixed-point")]
made_of! {
    [] crate::Q15: i16 => |bits| Ok(Self::from_bits(bits));
    [] crate::Q31: i32 => |bits| Ok(Self::from_bits(bits));
    [] crate::arithmetic::FixedExponent: u64 => |bits| Ok(Self::from_bits(bits));
}

/// An exponent that the arithmetic accepts: the next one of the input.
struct Accepted<A: Arithmetic>(A::Parameter);

impl<'a, A: Arithmetic<Parameter: Arbitrary<'a>>> Arbitrary<'a> for Accepted<A> {
    fn arbitrary(u: &mut Unstructured<'a>) -> arbitrary::Result<Self> {
        loop {
            let ended = u.is_empty();
            let parameter = u.arbitrary()?;
            if A::exponent(parameter).is_ok() {
                return Ok(Self(parameter));
            }
            // After the end come zeros, which the arithmetics here accept.
            if ended {
                return Err(arbitrary::Error::NotEnoughData);
            }
        }
    }
}

/// A number, at least 0, of a finite area.
fn radius<R: Real>(number: R) -> R {
    let size = number.magnitude();
    if (size * size / R::FRAC_1_PI).finite() {
        size
    } else if number.finite() {
        R::ONE / size
    } else {
        R::ONE
    }
}

/// A number above 0, infinity included.
fn distance<R: Real>(number: R) -> R {
    let number = number.magnitude();
    if number > R::ZERO { number } else { R::ONE }
}

/// A unit vector from its stereographic projection, within the square [-1, 1]^2; rational, so it
/// needs no root.
fn unit_vector<R: Real>((projected, flipped): ([R; 2], bool)) -> [R; 3] {
    let [s, t] = projected.map(|x| {
        let size = x.magnitude();
        let outside = if size > R::ONE { R::ONE / x } else { R::ZERO };
        if size <= R::ONE { x } else { outside }
    });
    let q = s * s + t * t;
    let z = (R::ONE - q) / (R::ONE + q);
    let [x, y] = [s, t].map(|x| R::TWO * x / (R::ONE + q));
    [x, y, if flipped { -z } else { z }]
}

made_of! {
    [R: Real + Arbitrary<'a>]
    Unit<R>: ([R; 2], bool) => |parts| Self::new(unit_vector(parts));
    [R: Real + Arbitrary<'a>]
    Frame<R>: ([R; 2], bool) => |parts| Self::new(unit_vector(parts));
    [A: Root<Real: Arbitrary<'a>>]
    DiscLight<A>: ([A::Real; 3], Frame<A::Real>, A::Real, bool) => |(centre, frame, size, both)| {
        let centre = centre.map(|x| if x.finite() { x } else { A::Real::ZERO });
        // If its rim would overflow, its radius is 1.
        let new = |radius| Self::new(centre, frame, radius);
        let light = new(radius(size)).or_else(|_| new(A::Real::ONE))?;
        Ok(if both { light.two_sided() } else { light })
    };
    [A: Arithmetic<Real: Real + Arbitrary<'a>>]
    AmbientOcclusion<A>: A::Real => |reach| Self::new(distance(reach));
    [A: Arithmetic<Real: Real, Parameter: Arbitrary<'a>>]
    Glossy<A>: (Accepted<A>, BelowHorizon) => |(exponent, below)| Self::new(exponent.0, below);
    [] BelowHorizon: u8 => |policy| {
        Ok(match policy % 3 {
            0 => Self::Reject,
            1 => Self::Flip,
            _ => Self::Zero,
        })
    };
    [A: Arithmetic<Real: Real>, const N: usize]
    Polygon<A, N>: u32 => |rotation| Ok(Self::new(rotation));
    [M: Map<Point = [R; 2]> + Arbitrary<'a>, R: Real + Arbitrary<'a>]
    ThinLens<M, R>: (M, [R; 2]) => |(aperture, [size, focus])| {
        // A focus too near for its radius becomes a focus at infinity.
        let new = |focus| Self::new(aperture, radius(size), focus);
        new(distance(focus)).or_else(|_| new(R::ONE / R::ZERO))
    };
}
