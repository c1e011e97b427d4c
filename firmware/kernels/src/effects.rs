//! A sample of each effect, with its density, for each of stored coordinates.

use crate::Visitor;
use core::hint::black_box;
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use hemidisc::{Concentric, Density, Error, Frame, Unit};

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

// The fills of each effect, by the name of its file.

macro_rules! thin_lens {
    ($visitor:ident $name:literal $arithmetic:ident) => {
        fill!(
            $visitor,
            concat!("effect/lens/", $name),
            ThinLens<Concentric<$arithmetic>, f32>,
            ThinLens::new(Concentric::new(), 0.25, 2.0)?,
            through::<_>
        );
        fill!(
            $visitor,
            concat!("effect/lens-5-blades/", $name),
            ThinLens<Polygon<$arithmetic, 5>, f32>,
            ThinLens::new(Polygon::new(0), 0.25, 2.0)?,
            through::<_>
        );
    };
}

macro_rules! disc_light {
    ($visitor:ident $name:literal $arithmetic:ident) => {
        fill!(
            $visitor,
            concat!("effect/light/", $name),
            DiscLight<$arithmetic>,
            DiscLight::new([0.5, 1.0, 2.0], Frame::new([0.0, 0.0, -1.0])?, 0.5)?,
            |light: &DiscLight<$arithmetic>, uv| {
                let sample = light.sample([0.0; 3], uv);
                let [x, y, z] = sample.direction;
                [x, y, z, sample.distance, sample.density, sample.weight]
            }
        );
    };
}

macro_rules! ambient_occlusion {
    ($visitor:ident $name:literal $arithmetic:ident) => {
        fill!(
            $visitor,
            concat!("effect/occlusion/", $name),
            (AmbientOcclusion<$arithmetic>, Frame<f32>),
            (AmbientOcclusion::new(1.0)?, Frame::new([0.0, 1.0, 0.0])?),
            |(occlusion, ground): &(AmbientOcclusion<$arithmetic>, Frame<f32>), uv| {
                let sample = occlusion.sample(ground, uv);
                let [x, y, z] = sample.direction;
                [x, y, z, 0.0, sample.density, sample.weight]
            }
        );
    };
}

macro_rules! glossy {
    ($visitor:ident $name:literal $arithmetic:ident) => {
        fill!(
            $visitor,
            concat!("effect/glossy/", $name),
            (Glossy<$arithmetic>, [Unit<f32>; 2]),
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
    };
}

fn through<M>(lens: &ThinLens<M, f32>, uv: [u32; 2]) -> [f32; 6]
where
    M: Density<Point = [f32; 2]>,
{
    let ray = lens.ray([0.5, -0.25], uv);
    let [[x, y, _], [ahead_x, ahead_y, _]] = [ray.origin, ray.direction];
    [x, y, ahead_x, ahead_y, ray.density, ray.weight]
}

/// The effects of an arithmetic.
macro_rules! effects {
    ($visitor:ident $name:literal $arithmetic:ident
        $($file:ident $effect:ident $effect_name:literal;)*) => {
        $($file!($visitor $name $arithmetic);)*
    };
}

/// The arithmetics of which boards have fills; first those of which they have pictures too.
macro_rules! arithmetics {
    ($visitor:ident $(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident $($facts:tt)*);
    )*) => {
        $(arithmetics!(@ pictures $boards $visitor $name $arithmetic);)*
        $(arithmetics!(@ fills $boards $visitor $name $arithmetic);)*
    };
    (@ pictures pictures $visitor:ident $name:literal $arithmetic:ident) => {
        arithmetics!(@ $visitor $name $arithmetic)
    };
    (@ fills fills $visitor:ident $name:literal $arithmetic:ident) => {
        arithmetics!(@ $visitor $name $arithmetic)
    };
    // Other words have no fills; one that is not known does not compile in `render.rs`.
    (@ $pass:ident $boards:ident $visitor:ident $name:literal $arithmetic:ident) => {};
    (@ $visitor:ident $name:literal $arithmetic:ident) => {{
        use hemidisc::$arithmetic;
        hemidisc::for_each_effect!(effects $visitor $name $arithmetic);
    }};
}

fn all(visitor: &mut impl Visitor) -> Result<(), Error> {
    hemidisc::for_each_arithmetic!(arithmetics visitor);
    Ok(())
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    // An error leaves effects out, which the report detects.
    let _ = all(visitor);
}
