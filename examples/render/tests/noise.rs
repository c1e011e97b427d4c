//! How noise falls with the number of samples.

use super::scene;
use examples::render::assembly::with_rows;
use examples::render::description::Scene;
use examples::render::frame::Settings;
use examples::render::sequence::{Pixels, Sequence};
use hemidisc::FastF32;

const SIZE: [u32; 2] = [480, 320];
/// The distance between sampled pixels. In a smaller picture pixels are larger, and their noise
/// comes from the scene more than from the effect.
const STEP: usize = 16;
const SEEDS: u32 = 8;
/// Squares, so that multi-jittered sets are whole.
const SAMPLES: [u16; 4] = [4, 16, 64, 256];

/// The mean of each component of the pixels.
fn means(scene: &Scene, settings: &Settings) -> Vec<f64> {
    let mut means = Vec::new();
    let [width, height] = SIZE;
    let mut run = |row: &examples::render::frame::Row<'_, f32>| {
        for y in (0..height).step_by(STEP) {
            for x in (0..width).step_by(STEP) {
                let mut sum = [[0.0; 3]];
                row([x, y], 0..settings.samples.into(), &mut sum);
                means.extend(sum[0].map(|sum| f64::from(sum) / f64::from(settings.samples)));
            }
        }
    };
    with_rows::<FastF32>(scene, scene.effects(), settings, &mut run).unwrap();
    means
}

/// The variance of a pixel's component over seeds, in the mean over the picture.
fn variance(scene: &Scene, sequence: Sequence, samples: u16) -> f64 {
    let pictures: Vec<_> = (0..SEEDS)
        .map(|seed| {
            means(scene, &Settings { size: SIZE, samples, sequence, pixels: Pixels::Pixel, seed })
        })
        .collect();
    let seeds = f64::from(SEEDS);
    let components = pictures[0].len();
    let of_component = |n: usize| {
        let values = || pictures.iter().map(|picture| picture[n]);
        let mean = values().sum::<f64>() / seeds;
        values().map(|value| (value - mean).powi(2)).sum::<f64>() / (seeds - 1.0)
    };
    (0..components).map(of_component).sum::<f64>() / components as f64
}

/// The slope of log variance over log samples, by least squares.
fn slope(variances: &[f64]) -> f64 {
    let points = || SAMPLES.iter().zip(variances).map(|(n, v)| (f64::from(*n).ln(), v.ln()));
    let count = SAMPLES.len() as f64;
    let [x_mean, y_mean] =
        points().fold([0.0; 2], |[x, y], point| [x + point.0 / count, y + point.1 / count]);
    let [above, below] = points().fold([0.0; 2], |[above, below], (x, y)| {
        [above + (x - x_mean) * (y - y_mean), below + (x - x_mean).powi(2)]
    });
    above / below
}

#[test]
fn noise_falls_as_it_should() {
    for name in ["soft-shadow", "lens"] {
        let scene = scene(name);
        for (sequence_name, sequence) in Sequence::ALL {
            let variances = SAMPLES.map(|samples| variance(&scene, sequence, samples));
            let slope = slope(&variances);
            println!("{name} {sequence_name}: slope {slope:.3}, variances {variances:?}");
            // Independent samples: -1. Two-dimensional strata, where a pixel's value is that of an
            // edge through its lens or light: -3/2, and less where more than one pair of
            // coordinates matters.
            let expected = if sequence_name == "random" { -1.12..-0.88 } else { -1.6..-1.2 };
            assert!(expected.contains(&slope), "{name} {sequence_name}: {slope}");
        }
    }
}
