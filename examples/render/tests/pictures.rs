//! Pictures: the same for every split, finite for every scene, right where the answer is known.

use super::{SMALL, each_arithmetic, pixels, rendered, scene, subsets};
use examples::render::assembly::{renderer_of, with_rows};
use examples::render::description::Scene;
use examples::render::effects::Effects;
use examples::render::file;
use examples::render::frame::{Region, Row, Settings};
use examples::render::sums::Sum;
use examples::render::values::{Angle, Point};
use hemidisc::LibmF32;
use testkit::tracer::Counts;

/// Calls a function with the rows of the still life.
fn with_still_life(run: impl FnMut(&Row<'_, f32>)) {
    with_still_life_of(&SMALL, run);
}

fn with_still_life_of(settings: &Settings, mut run: impl FnMut(&Row<'_, f32>)) {
    let scene = scene("still-life");
    with_rows::<LibmF32>(&scene, scene.effects(), settings, &mut run).unwrap();
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let scene = scene("still-life");
    let [one, three] = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| rendered("libm-f32", &scene, scene.effects(), &SMALL))
    });
    assert_eq!(one.sums, three.sums);
    assert_eq!(one.counts, three.counts);
}

#[test]
fn ranges_of_samples_add_up() {
    with_still_life(|row| {
        let (mut at_once, mut in_turn) = ([[0.0; 3]; 24], [[0.0; 3]; 24]);
        let counts = row([0, 9], 0..4, &mut at_once);
        let mut of_both = row([0, 9], 0..2, &mut in_turn);
        of_both += row([0, 9], 2..4, &mut in_turn);
        assert_eq!(in_turn, at_once);
        assert_eq!(of_both, counts);
    });
}

#[test]
fn a_frame_is_the_rounded_passes_of_its_rows() {
    let settings = Settings { samples: 20, ..SMALL };
    let scene = scene("still-life");
    let frame = rendered("libm-f32", &scene, scene.effects(), &settings);
    let mut expected = Vec::new();
    with_still_life_of(&settings, |row| {
        for y in 0..settings.size[1] {
            let passes = [0..8, 8..16, 16..20].map(|samples| {
                let mut pass = [[0.0; 3]; 24];
                row([0, y], samples, &mut pass);
                pass.map(Sum::of_pass)
            });
            expected.extend((0..24).map(|x| {
                let mut sum = passes[2][x];
                sum += passes[0][x];
                sum += passes[1][x];
                sum
            }));
        }
    });
    assert_eq!(frame.sums, expected);
}

#[test]
fn regions_in_any_order_make_up_the_frame() {
    let settings = Settings { samples: 20, ..SMALL };
    let (scene, render) = (scene("still-life"), renderer_of("fast-f32").unwrap());
    let whole = rendered("fast-f32", &scene, scene.effects(), &settings);
    let mut sums = vec![Sum::default(); whole.sums.len()];
    let mut counts = Counts::default();
    for passes in [1..3, 0..0, 0..1] {
        for rows in [7..16, 5..7, 7..7, 0..5] {
            let region = Region { rows, passes: passes.clone() };
            let part = render(&scene, scene.effects(), &settings, &region, &mut || {}).unwrap();
            let place = &mut sums[24 * region.rows.start as usize..24 * region.rows.end as usize];
            assert_eq!(part.sums.len(), place.len());
            place.iter_mut().zip(part.sums).for_each(|(sum, more)| *sum += more);
            counts += part.counts;
        }
    }
    assert_eq!(sums, whole.sums);
    assert_eq!(counts, whole.counts);
}

#[test]
fn parts_of_a_row_are_those_of_the_whole() {
    with_still_life(|row| {
        let (mut whole, mut parts) = ([[0.0; 3]; 24], [[0.0; 3]; 24]);
        row([0, 9], 0..4, &mut whole);
        let (left, right) = parts.split_at_mut(7);
        row([7, 9], 0..4, right);
        row([0, 9], 0..4, left);
        assert_eq!(parts, whole);
    });
}

#[test]
fn an_empty_scene_is_all_sky() {
    let mut empty = scene("still-life");
    empty.spheres.clear();
    empty.planes.clear();
    finite(&empty);
    let frame = rendered("libm-f64", &empty, Effects::NONE, &SMALL);
    assert_eq!(frame.counts.base.rays, 24 * 16 * 4);
    let pixels = pixels(&frame, &SMALL);
    assert!(pixels.iter().flatten().all(|component| *component > 0.0 && component.is_finite()));
}

#[test]
fn a_camera_inside_a_sphere_sees_its_inside() {
    let mut scene = scene("still-life");
    let silver = scene.spheres[0].centre;
    for place in [silver, Point([silver.0[0], silver.0[1], silver.0[2] + 0.7])] {
        scene.camera.position = place;
        finite(&scene);
    }
    // A light at the camera, and on the floor.
    for place in [silver, Point([0.0; 3])] {
        scene.light.position = place;
        finite(&scene);
    }
}

/// Spheres that shine, without any other light.
fn shining(spheres: &str) -> Scene {
    let text = format!(
        "(
            camera: (position: (0, 0, 0), ahead: (0, 0, -1), field_of_view: 4),
            light: (position: (0, 9, 0), toward: (0, -1, 0), intensity: (0, 0, 0)),
            ambient: (colour: (0, 0, 0)),
            sky: (horizon: (0, 0, 0), zenith: (0, 0, 0)),
            spheres: [{spheres}],
        )"
    );
    file::parsed(&text).unwrap()
}

#[test]
fn the_nearest_surface_is_seen_and_the_inside_of_one_around_the_camera() {
    let sphere = |z: f64, radius: f64, red: f64| {
        format!(
            "(centre: (0, 0, {z}), radius: {radius}, material: \
             (albedo: (0, 0, 0), emission: ({red}, 0, 0))),"
        )
    };
    let (near, far, around) =
        (sphere(-3.0, 1.0, 0.5), sphere(-9.0, 2.0, 0.25), sphere(0.0, 50.0, 0.125));
    for (spheres, expected) in [
        (near.clone() + &far + &around, 0.5),
        (around.clone() + &far + &near, 0.5),
        (far.clone() + &around, 0.25),
        (around.clone() + &far, 0.25),
        (around, 0.125),
        (sphere(9.0, 2.0, 1.0), 0.0),
    ] {
        for arithmetic in each_arithmetic() {
            let frame = rendered(arithmetic, &shining(&spheres), Effects::NONE, &SMALL);
            let all = |pixel: &[f64; 3]| *pixel == [expected, 0.0, 0.0];
            assert!(pixels(&frame, &SMALL).iter().all(all), "{spheres}");
        }
    }
}

#[track_caller]
fn finite(scene: &Scene) {
    for arithmetic in each_arithmetic() {
        for effects in subsets() {
            let frame = rendered(arithmetic, scene, effects, &SMALL);
            let good = |component: &f64| component.is_finite() && *component >= 0.0;
            assert!(pixels(&frame, &SMALL).iter().flatten().all(good), "{arithmetic} {effects:?}");
        }
    }
}

/// albedo / pi times I cos t cos s / d^2, and the ambient light.
#[test]
fn a_floor_under_a_light_is_as_bright_as_it_should_be() {
    let text = "(
        camera: (position: (0, 3, 0), ahead: (0.6, -1, 0), field_of_view: 1),
        light: (position: (0, 2, 0), toward: (0, -1, 0), intensity: (40, 20, 10)),
        ambient: (colour: (0.3, 0.2, 0.1)),
        sky: (horizon: (0, 0, 0), zenith: (0, 0, 0)),
        planes: [(point: (0, 0, 0), normal: (0, 1, 0), material: (albedo: (0.5, 0.5, 1)))],
    )";
    let mut scene = file::parsed(text).unwrap();
    scene.camera.field_of_view = Angle(0.001);
    let settings = Settings { size: [1, 1], samples: 1, ..SMALL };
    // Looked at 1.8 from the point below the light.
    let square: f64 = 1.8 * 1.8 + 2.0 * 2.0;
    let shape = (2.0 / square.sqrt()).powi(2) / square / std::f64::consts::PI;
    let expected = [0.5 * (40.0 * shape + 0.3), 0.5 * (20.0 * shape + 0.2), 10.0 * shape + 0.1];
    for arithmetic in each_arithmetic() {
        let frame = rendered(arithmetic, &scene, Effects::NONE, &settings);
        for (found, expected) in pixels(&frame, &settings)[0].into_iter().zip(expected) {
            assert!(
                (found / expected - 1.0).abs() < 1e-4,
                "{arithmetic}: {found} is not {expected}"
            );
        }
    }
}

#[test]
fn arithmetics_agree_on_the_picture() {
    let scene = scene("still-life");
    let settings = Settings { samples: 16, ..SMALL };
    let reference = rendered("libm-f64", &scene, scene.effects(), &settings);
    let reference = pixels(&reference, &settings);
    for arithmetic in each_arithmetic() {
        let frame = rendered(arithmetic, &scene, scene.effects(), &settings);
        let pixels = pixels(&frame, &settings);
        let pairs = pixels.iter().flatten().zip(reference.iter().flatten());
        let distance = pairs.map(|(a, b)| (a - b).abs()).sum::<f64>() / (3.0 * 24.0 * 16.0);
        assert!(distance < 2e-3, "{arithmetic} is off by {distance} in the mean");
    }
}
