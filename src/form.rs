//! The form in which a value is written: the arguments of its constructor, by name.
//!
//! `serde` writes and reads the form. A value is read by its constructor, which refuses what it
//! always refuses, with the same message. What a constructor prepares is not written. `defmt` logs
//! the form. A value whose fields are its form has both derived where it is defined.
//!
//! [`Stored`](crate::sequence::Stored) has no form: it borrows its points, and the slice can be
//! written. [`Pixel`](crate::screen::Pixel) has none: its screen has.

use crate::Domain;
use crate::arithmetic::{Arithmetic, Real};
use crate::domain::Stream;
use crate::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use crate::frame::{About, Frame, Unit};
use crate::map::disc::DiscMap;
use crate::map::hemisphere::{CosineLobe, Hemisphere, PowerLobe, UniformLobe};
use crate::map::{Concentric, Map, Polar, UnitSquare};
use crate::points::Points;
use crate::sampler::Sampler;
use crate::screen::Screen;
use crate::sequence::{
    Correlated, GridSize, Halton, Hammersley, InDomain, Jittered, MultiJittered, NRooks, R2,
    Random, Regular, Sequence, Shifted, Shuffled, Sobol, SobolOwen,
};

/// `[generics] Name: Type, where [bounds to read] { field: its type = its getter } => constructor;`
///
/// A form has a type parameter for each field, so that no bound but those of the fields is needed.
macro_rules! forms {
    ($([$($generics:tt)*] $name:ident: $type:ty $(, where [$($bounds:tt)*])?
        {$($field:ident: $kind:ty = $get:expr),*} => $make:expr;)*) => {$(
        const _: () = {
            #[allow(non_camel_case_types, reason = "a type parameter has the name of its field")]
            mod form {
                #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
                #[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
                #[cfg_attr(feature = "defmt", derive(defmt::Format))]
                pub struct $name<$($field),*> {
                    $(pub $field: $field),*
                }
            }

            #[cfg(feature = "serde")]
            #[allow(trivial_bounds, reason = "a field of a type without parameters bounds none")]
            impl<$($generics)*> serde::Serialize for $type
            where
                $($kind: serde::Serialize),*
            {
                fn serialize<W: serde::Serializer>(&self, target: W) -> Result<W::Ok, W::Error> {
                    $(let $field: fn(&Self) -> $kind = $get;)*
                    form::$name { $($field: $field(self)),* }.serialize(target)
                }
            }

            #[cfg(feature = "serde")]
            impl<'de, $($generics)*> serde::Deserialize<'de> for $type
            where
                $($kind: serde::Deserialize<'de>,)*
                $($($bounds)*)?
            {
                fn deserialize<W: serde::Deserializer<'de>>(source: W) -> Result<Self, W::Error> {
                    let form::$name { $($field),* } =
                        form::$name::<$($kind),*>::deserialize(source)?;
                    let made: Result<Self, crate::error::Error> = $make;
                    made.map_err(serde::de::Error::custom)
                }
            }

            #[cfg(feature = "defmt")]
            #[allow(trivial_bounds, reason = "a field of a type without parameters bounds none")]
            impl<$($generics)*> defmt::Format for $type
            where
                $($kind: defmt::Format),*
            {
                fn format(&self, formatter: defmt::Formatter<'_>) {
                    $(let $field: fn(&Self) -> $kind = $get;)*
                    defmt::Format::format(&form::$name { $($field: $field(self)),* }, formatter);
                }
            }
        };
    )*};
}

forms! {
    [] Stream: Stream { domain: Domain = Self::domain } => Ok(domain.stream());
    [] Regular: Regular { columns: u32 = Self::columns, rows: u32 = Self::rows }
        => Self::new(columns, rows);
    [] Random: Random { domain: Domain = Self::domain } => Ok(Self::in_domain(domain));
    [] Jittered: Jittered
        { columns: u32 = Self::columns, rows: u32 = Self::rows, seed: u32 = Self::seed }
        => Self::new(columns, rows, seed);
    [] NRooks: NRooks { count: u32 = Self::count, seed: u32 = Self::seed }
        => Self::new(count, seed);
    [] MultiJittered: MultiJittered
        { columns: u32 = Self::columns, rows: u32 = Self::rows, seed: u32 = Self::seed }
        => Self::new(columns, rows, seed);
    [] Correlated: Correlated
        { columns: u32 = Self::columns, rows: u32 = Self::rows, seed: u32 = Self::seed }
        => Self::new(columns, rows, seed);
    [] Hammersley: Hammersley { count: u32 = Self::count } => Self::new(count);
    [] Halton: Halton {} => Ok(Self::new());
    [] Sobol: Sobol { seed: u32 = Self::seed } => Ok(Self::new(seed));
    [] SobolOwen: SobolOwen { domain: Domain = Self::domain } => Ok(Self::in_domain(domain));
    [] R2: R2 { seed: u32 = Self::seed } => Ok(Self::new(seed));
    [S: Sequence] Shuffled: Shuffled<S>
        { sequence: S = |set| *set.sequence(), domain: Domain = Self::domain }
        => Ok(Self::new(sequence, domain));
    [S: Sequence] Shifted: Shifted<S>
        { sequence: S = |set| *set.sequence(), domain: Domain = Self::domain }
        => Ok(Self::new(sequence, domain));
    [] GridSize: GridSize { columns: u32 = |size| size.columns(), rows: u32 = |size| size.rows() }
        => Self::new(columns, rows);
    [S: InDomain] Sampler: Sampler<S>
        { domain: Domain = Self::domain, size: S::Size = Self::size, index: u32 = Self::index }
        => Ok(Self::of(domain, size, index));
    [] Screen: Screen
        { domain: Domain = Self::domain, size: [u32; 2] = Self::size, samples: u32 = Self::samples }
        => Self::new(domain, size, samples);
}

forms! {
    [A: Arithmetic] UnitSquare: UnitSquare<A> {} => Ok(Self::new());
    [A: Arithmetic] Concentric: Concentric<A> {} => Ok(Self::new());
    [A: Arithmetic] Polar: Polar<A> {} => Ok(Self::new());
    [A: Arithmetic, D: DiscMap<Arithmetic = A>] Uniform: Hemisphere<UniformLobe<A>, D>
        { disc: D = |map| *map.disc() }
        => Ok(Self::over(disc));
    [A: Arithmetic, D: DiscMap<Arithmetic = A>] Cosine: Hemisphere<CosineLobe<A>, D>
        { disc: D = |map| *map.disc() }
        => Ok(Self::over(disc));
    [A: Arithmetic, D: DiscMap<Arithmetic = A>] Power: Hemisphere<PowerLobe<A>, D>
        { exponent: A::Parameter = Self::exponent, disc: D = |map| *map.disc() }
        => Self::over(exponent, disc);
    [R: Real] Unit: Unit<R> { vector: [R; 3] = |unit| unit.get() } => Self::new(vector);
    [R: Real] Frame: Frame<R>
        { z: [R; 3] = |frame| frame.unit().get(), tangent: Option<[R; 3]> = Self::tangent }
        => match tangent {
            None => Self::new(z),
            Some(tangent) => Unit::new(z).and_then(|z| Self::with_tangent(z, tangent)),
        };
    [M: Copy, R: Copy] About: About<M, R>
        { map: M = |about| *about.map(), frame: Frame<R> = |about| *about.frame() }
        => Ok(Self::new(map, frame));
    [S: Sequence, M: Map] Points: Points<S, M>
        {
            sequence: S = |points| *points.sequence(),
            map: M = |points| *points.map(),
            start: u32 = Self::start,
            len: u32 = Self::len
        }
        => points(sequence, map, start, len);
}

/// The `len` points from index `start` on, the last of which may be the last that a `u32` counts.
#[cfg(feature = "serde")]
fn points<S: Sequence, M: Map>(
    sequence: S,
    map: M,
    start: u32,
    len: u32,
) -> Result<Points<S, M>, crate::error::Error> {
    match (start.checked_add(len), len.checked_sub(1)) {
        (Some(end), _) => Points::with_range(sequence, map, start..end),
        (None, Some(more)) if start.checked_add(more) == Some(u32::MAX) => {
            Points::with_range(sequence, map, start..=u32::MAX)
        }
        _ => {
            let size = sequence.size().map_or(1 << 32, u64::from);
            Err(crate::error::Error::Range { start: start.into(), count: len.into(), len: size })
        }
    }
}

forms! {
    [M: Copy, R: Copy] ThinLens: ThinLens<M, R>, where [R: Real, M: Map<Point = [R; 2]>]
        {
            aperture: M = |lens| *lens.aperture(),
            radius: R = Self::radius,
            focal_distance: R = Self::focal_distance
        }
        => Self::new(aperture, radius, focal_distance);
    [A: Arithmetic] DiscLight: DiscLight<A>, where [A: crate::arithmetic::Root]
        {
            centre: [A::Real; 3] = Self::centre,
            frame: Frame<A::Real> = |light| *light.frame(),
            radius: A::Real = Self::radius,
            two_sided: bool = Self::is_two_sided
        }
        => Self::new(centre, frame, radius)
            .map(|light| if two_sided { light.two_sided() } else { light });
    [A: Arithmetic] AmbientOcclusion: AmbientOcclusion<A>, where [A: Arithmetic<Real: Real>]
        { reach: A::Real = Self::reach }
        => Self::new(reach);
    [A: Arithmetic] Glossy: Glossy<A>, where [A: Arithmetic<Real: Real>]
        {
            exponent: A::Parameter = Self::exponent,
            below_horizon: BelowHorizon = Self::below_horizon
        }
        => Self::new(exponent, below_horizon);
    [A: Arithmetic, const N: usize] Polygon: Polygon<A, N>, where [A: Arithmetic<Real: Real>]
        { rotation: u32 = Self::rotation }
        => Ok(Self::new(rotation));
}
