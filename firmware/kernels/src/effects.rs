//! A sample of each effect, with its density, for each of stored coordinates.

use crate::Visitor;
use core::hint::black_box;
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use hemidisc::{Concentric, Density, Error, FastF32, Frame, LibmF32, MicromathF32, Unit};

/// A function that fills by an effect, under its path.
macro_rules! fill {
    ($visitor:ident, $path:expr, $effect:ty, $value:expr, $sample:expr) => {{
        #[unsafe(export_name = $path)]
        #[inline(never)]
        fn fill(effect: &$effect, coordinates: &[[u32; 2]], points: &mut [[f32; 6]]) -> usize {
            let mut filled = 0;
            for (uv, point) in coordinates.iter().zip(points) {
                *point = $sample(effect, *uv);
                filled += 1;
            }
            filled
        }
        let effect = black_box($value);
        $visitor.points($path, |coordinates, points: &mut [[f32; 6]]| {
            fill(&effect, coordinates, points)
        });
    }};
}

/// The effects of an arithmetic of `f32`.
macro_rules! effects {
    ($visitor:ident: $($name:literal $arithmetic:ident;)*) => {$(
        fill!(
            $visitor, concat!("effect/lens/", $name), ThinLens<Concentric<$arithmetic>, f32>,
            ThinLens::new(Concentric::new(), 0.25, 2.0)?, through::<_>
        );
        fill!(
            $visitor, concat!("effect/lens-5-blades/", $name), ThinLens<Polygon<$arithmetic, 5>, f32>,
            ThinLens::new(Polygon::new(0), 0.25, 2.0)?, through::<_>
        );
        fill!(
            $visitor, concat!("effect/light/", $name), DiscLight<$arithmetic>,
            DiscLight::new([0.5, 1.0, 2.0], Frame::new([0.0, 0.0, -1.0])?, 0.5)?,
            |light: &DiscLight<$arithmetic>, uv| {
                let sample = light.sample([0.0; 3], uv);
                let [x, y, z] = sample.direction;
                [x, y, z, sample.distance, sample.density, sample.weight]
            }
        );
        fill!(
            $visitor, concat!("effect/occlusion/", $name),
            (AmbientOcclusion<$arithmetic>, Frame<f32>),
            (AmbientOcclusion::new(1.0)?, Frame::new([0.0, 1.0, 0.0])?),
            |(occlusion, ground): &(AmbientOcclusion<$arithmetic>, Frame<f32>), uv| {
                let sample = occlusion.sample(ground, uv);
                let [x, y, z] = sample.direction;
                [x, y, z, 0.0, sample.density, sample.weight]
            }
        );
        fill!(
            $visitor, concat!("effect/glossy/", $name), (Glossy<$arithmetic>, [Unit<f32>; 2]),
            (
                Glossy::new(50.0, BelowHorizon::Zero)?,
                [Unit::new([0.6, -0.8, 0.0])?, Unit::new([0.0, 1.0, 0.0])?],
            ),
            |(gloss, [arriving, normal]): &(Glossy<$arithmetic>, [Unit<f32>; 2]), uv| {
                let sample = gloss.sample(*arriving, *normal, uv);
                let sample = sample.unwrap_or_default();
                let [x, y, z] = sample.direction;
                [x, y, z, 0.0, sample.density, sample.weight]
            }
        );
    )*};
}

fn through<M>(lens: &ThinLens<M, f32>, uv: [u32; 2]) -> [f32; 6]
where
    M: Density<Point = [f32; 2]>,
{
    let ray = lens.ray([0.5, -0.25], uv);
    let [[x, y, _], [ahead_x, ahead_y, _]] = [ray.origin, ray.direction];
    [x, y, ahead_x, ahead_y, ray.density, ray.weight]
}

fn all(visitor: &mut impl Visitor) -> Result<(), Error> {
    effects! {
        visitor:
        "fast-f32" FastF32;
        "micromath-f32" MicromathF32;
        "libm-f32" LibmF32;
    }
    Ok(())
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    // An error leaves effects out, which the report detects.
    let _ = all(visitor);
}
