//! The lines of `effects.txt`: a digest of every effect in an arithmetic of floats.
//!
//! As `lines.rs`, compiled by the host and the firmware alike.

use crate::digest::{Digest, Digestible};
use core::fmt::Arguments;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{
    AmbientOcclusion, BelowHorizon, DirectionSample, DiscLight, Glossy, Polygon, ThinLens,
};
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Density, Error, Frame, Unit};

const COUNT: u32 = 300;

/// A digest of what an effect makes of the points.
fn digest_of(mut sample: impl FnMut(&mut Digest, [u32; 2])) -> u64 {
    let mut digest = Digest::new();
    for index in 0..COUNT {
        sample(&mut digest, SobolOwen::new(7).at(index));
    }
    digest.value()
}

fn take<R: Real + Digestible>(digest: &mut Digest, sample: DirectionSample<R>) {
    digest.value_of(sample.direction);
    digest.value_of([sample.density, sample.weight]);
}

fn lens<A: Root<Real: Digestible>>(
    aperture: impl Density<Point = [A::Real; 2]>,
) -> Result<u64, Error> {
    let (half, two) = (A::Real::HALF, A::Real::TWO);
    let lens = ThinLens::new(aperture, half, two)?;
    Ok(digest_of(|digest, uv| {
        let ray = lens.ray([half, -two], uv);
        digest.value_of(ray.origin);
        digest.value_of(ray.direction);
        digest.value_of([ray.density, ray.weight]);
    }))
}

/// From in front of the light, and from behind it.
fn light<A: Root<Real: Digestible>>(light: DiscLight<A>) -> u64 {
    let (zero, half, four) = (A::Real::ZERO, A::Real::HALF, A::Real::FOUR);
    digest_of(|digest, uv| {
        for receiver in [[half, zero, zero], [zero, half, four]] {
            let sample = light.sample(receiver, uv);
            digest.value_of(sample.point);
            digest.value_of(sample.direction);
            digest.value_of([sample.distance, sample.density]);
            digest.value_of([sample.weight, light.density(receiver, sample.direction)]);
        }
    })
}

/// Takes the name and the digest of a line.
type Line<'a> = &'a mut dyn FnMut(&str, u64);

fn thin_lens<A: Root<Real: Digestible>>(line: Line) -> Result<(), Error> {
    line("lens", lens::<A>(Concentric::<A>::new())?);
    line("lens of 5 blades", lens::<A>(Polygon::<A, 5>::new(1 << 29))?);
    Ok(())
}

fn disc_light<A: Root<Real: Digestible>>(line: Line) -> Result<(), Error> {
    let (zero, half, one) = (A::Real::ZERO, A::Real::HALF, A::Real::ONE);
    let down = Frame::new([zero, zero, -one])?;
    let lamp = DiscLight::<A>::new([zero, half, one], down, half)?;
    line("light", light(lamp));
    line("light to both sides", light(lamp.two_sided()));
    Ok(())
}

fn ambient_occlusion<A: Root<Real: Digestible>>(line: Line) -> Result<(), Error> {
    let (zero, one) = (A::Real::ZERO, A::Real::ONE);
    let up = Frame::new([zero, one, zero])?;
    let occlusion = AmbientOcclusion::<A>::new(one)?;
    line("occlusion", digest_of(|digest, uv| take(digest, occlusion.sample(&up, uv))));
    Ok(())
}

fn glossy<A: Root<Real: Digestible>>(line: Line) -> Result<(), Error> {
    let (zero, one) = (A::Real::ZERO, A::Real::ONE);
    let (along, up) = (Unit::new([one, zero, zero])?, Unit::new([zero, one, zero])?);
    for (name, below) in [
        ("glossy, reject", BelowHorizon::Reject),
        ("glossy, flip", BelowHorizon::Flip),
        ("glossy, zero", BelowHorizon::Zero),
    ] {
        let Ok(exponent) = "10".parse() else { continue };
        let glossy = Glossy::<A>::new(exponent, below)?;
        line(
            name,
            digest_of(|digest, uv| {
                // Along the surface, so that half of the lobe is below it.
                if let Some(sample) = glossy.sample(along, up, uv) {
                    take(digest, sample);
                }
            }),
        );
    }
    Ok(())
}

macro_rules! effects {
    ($($file:ident $effect:ident $name:literal;)*) => {
        /// The lines of one arithmetic: each effect's are those of the function that is called as
        /// its file is.
        pub fn effects<A>(lines: &mut dyn FnMut(Arguments)) -> Result<(), Error>
        where
            A: Root<Real: Digestible>,
        {
            let mut line = |effect: &str, digest: u64| {
                lines(format_args!("{} {effect} {digest:016x}", A::NAME));
            };
            $($file::<A>(&mut line)?;)*
            Ok(())
        }
    };
}
hemidisc::for_each_effect!(effects);

macro_rules! file {
    ($(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident $($facts:tt)*);
    )*) => {
        /// The lines of every arithmetic of floats, first of those of which boards have the most.
        pub fn file(lines: &mut dyn FnMut(Arguments)) -> Result<(), Error> {
            for boards in ["pictures", "fills", "digests"] {
                $(
                    #[$cfg]
                    file!(@ $kind $boards boards $arithmetic lines);
                )*
            }
            Ok(())
        }
    };
    (@ float $own:ident $boards:ident $arithmetic:ident $lines:ident) => {
        if stringify!($own) == $boards {
            effects::<hemidisc::$arithmetic>($lines)?;
        }
    };
    (@ fixed $own:ident $boards:ident $arithmetic:ident $lines:ident) => {};
}
hemidisc::for_each_arithmetic!(file);
