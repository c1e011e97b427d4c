//! Every effect: one sample with its density, in the arithmetics of `f32`, which is what a hit is
//! given in.

use crate::calls::Calls;
use benches::EXPONENT;
use benches::failure::Failure;
use hemidisc::arithmetic::{Arithmetic, Root};
use hemidisc::catalogue::EFFECTS;
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, ThinLens};
use hemidisc::{Concentric, FastF32, Frame, LibmF32};

/// What becomes of a direction below the surface.
const BELOW: [(&str, BelowHorizon); 3] =
    [("reject", BelowHorizon::Reject), ("flip", BelowHorizon::Flip), ("zero", BelowHorizon::Zero)];

pub(crate) fn every(calls: &mut Calls<'_>) -> Result<(), Failure> {
    of::<FastF32>(calls)?;
    of::<LibmF32>(calls)
}

fn of<A>(calls: &mut Calls<'_>) -> Result<(), Failure>
where
    A: Root + Arithmetic<Real = f32, Parameter = f32>,
{
    for effect in EFFECTS {
        match *effect {
            "lens" => lens::<A>(calls)?,
            "light" => light::<A>(calls)?,
            "occlusion" => occlusion::<A>(calls)?,
            "glossy" => {
                BELOW.iter().try_for_each(|(name, below)| glossy::<A>(calls, name, *below))?;
            }
            other => return Err(format!("no row has the effect {other}").into()),
        }
    }
    Ok(())
}

/// A ray from a lens.
fn lens<A: Arithmetic<Real = f32>>(calls: &mut Calls<'_>) -> Result<(), Failure> {
    let lens = ThinLens::new(Concentric::<A>::new(), 0.05, 4.0)?;
    let path = format!("effect/lens/{}", A::NAME);
    // Any two numbers are a place of the image.
    calls.call(&path, move |given| {
        let [x, y, _] = given.normal();
        lens.ray([x, y], given.pair())
    });
    Ok(())
}

/// A point of a light, as seen from the unit sphere below it.
fn light<A: Root + Arithmetic<Real = f32>>(calls: &mut Calls<'_>) -> Result<(), Failure> {
    let light = DiscLight::<A>::new([0.0, 3.0, 0.0], Frame::new([0.0, -1.0, 0.0])?, 0.5)?;
    let path = format!("effect/light/{}", A::NAME);
    calls.call(&path, move |given| light.sample(given.normal(), given.pair()));
    Ok(())
}

/// A direction to the sky, with the frame of the normal that was hit.
fn occlusion<A: Arithmetic<Real = f32>>(calls: &mut Calls<'_>) -> Result<(), Failure> {
    let occlusion = AmbientOcclusion::<A>::new(0.5)?;
    let path = format!("effect/occlusion/{}", A::NAME);
    calls.call(&path, move |given| occlusion.sample(&given.unit_normal().into(), given.pair()));
    Ok(())
}

/// A direction about the mirror direction.
fn glossy<A: Arithmetic<Real = f32, Parameter = f32>>(
    calls: &mut Calls<'_>,
    name: &str,
    below: BelowHorizon,
) -> Result<(), Failure> {
    let gloss = Glossy::<A>::new(EXPONENT, below)?;
    let path = format!("effect/glossy-{name}/{}", A::NAME);
    calls.call(&path, move |given| {
        gloss.sample(given.arriving(), given.unit_normal(), given.pair())
    });
    Ok(())
}
