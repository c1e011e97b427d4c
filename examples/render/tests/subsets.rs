//! Every subset of the effects, in every arithmetic that renders.

use super::{SMALL, bits, each_arithmetic, pixels, rendered, scene, subsets};
use crate::report::tally;
use examples::render::description::{Material, Scene};
use examples::render::effects::{Effect, Effects};
use examples::render::frame::Settings;
use examples::render::values::{Colour, Exponent, Radius};
use testkit::tracer::Tally;

/// A scene from whose text the other effects were taken out.
fn cut(scene: &Scene, effects: Effects) -> Scene {
    let mut scene = scene.clone();
    if !effects.has(Effect::ThinLens) {
        scene.lens = None;
    }
    if !effects.has(Effect::DiscLight) {
        scene.light.radius = None;
    }
    if !effects.has(Effect::AmbientOcclusion) {
        scene.ambient.reach = None;
    }
    if !effects.has(Effect::Glossy) {
        let plain = |material: &mut Material| {
            if let Some(reflection) = &mut material.reflection {
                reflection.exponent = None;
            }
        };
        scene.spheres.iter_mut().for_each(|sphere| plain(&mut sphere.material));
        scene.planes.iter_mut().for_each(|plane| plain(&mut plane.material));
    }
    assert_eq!(scene.effects(), effects);
    scene
}

#[test]
fn an_absent_effect_draws_no_points_and_is_not_seen() {
    let whole = scene("still-life");
    assert_eq!(whole.effects(), Effect::ALL.iter().copied().collect());
    for arithmetic in each_arithmetic() {
        let mut pictures = Vec::new();
        for effects in subsets() {
            let frame = rendered(arithmetic, &whole, effects, &SMALL);
            for effect in Effect::ALL.iter().copied() {
                let Tally { points, rays } = tally(&frame.counts, effect);
                let present = effects.has(effect);
                assert_eq!((points > 0, rays > 0), (present, present), "{effect:?} of {effects:?}");
            }
            let cut = cut(&whole, effects);
            let bits_of = |scene| bits(arithmetic, scene, effects);
            assert_eq!(bits_of(&whole), bits_of(&cut), "{arithmetic} {effects:?}");
            let never_had_it = rendered(arithmetic, &cut, effects, &SMALL);
            assert_eq!(frame.sums, never_had_it.sums, "{arithmetic} {effects:?}");
            assert_eq!(frame.counts, never_had_it.counts);
            pictures.push(bits_of(&whole));
        }
        // Each effect is seen where it is present.
        pictures.sort();
        pictures.dedup();
        assert_eq!(pictures.len(), 1 << Effect::ALL.len(), "{arithmetic}");
    }
}

#[test]
fn a_lens_of_radius_0_is_a_pinhole() {
    let mut scene = scene("still-life");
    if let Some(lens) = &mut scene.lens {
        lens.radius = Radius(0.0);
    }
    same_without(&scene, Effect::ThinLens);
}

#[test]
fn a_light_of_radius_0_is_a_point() {
    let mut scene = scene("still-life");
    scene.light.radius = Some(Radius(0.0));
    for two_sided in [false, true] {
        scene.light.two_sided = two_sided;
        same_without(&scene, Effect::DiscLight);
    }
}

/// All directions are within 7e-4 of the mirror's, which moves what is seen in the spheres by a
/// part of a pixel.
#[test]
fn a_lobe_of_1e8_is_a_mirror() {
    let mut scene = scene("still-life");
    for sphere in &mut scene.spheres {
        if let Some(reflection) = &mut sphere.material.reflection {
            reflection.exponent = Some(Exponent(1e8));
        }
    }
    let settings = Settings { samples: 64, ..SMALL };
    for arithmetic in each_arithmetic() {
        let [lobe, mirror] = [scene.effects(), scene.effects().without(Effect::Glossy)]
            .map(|effects| pixels(&rendered(arithmetic, &scene, effects, &settings), &settings));
        assert_ne!(lobe, mirror);
        for (lobe, mirror) in lobe.iter().flatten().zip(mirror.iter().flatten()) {
            assert!((lobe - mirror).abs() < 0.01, "{arithmetic}: {lobe} and {mirror}");
        }
    }
}

/// A light that does not shine, an ambient light of no radiance and reflectance 0 add nothing, so
/// that what is left shows whether the points of the other effects have changed.
#[test]
fn an_effect_does_not_change_the_noise_of_another() {
    let black = Colour::default();
    let mut unlit = scene("still-life");
    unlit.light.intensity = black;
    same_without(&unlit, Effect::DiscLight);
    let mut no_ambient = scene("still-life");
    no_ambient.ambient.colour = black;
    same_without(&no_ambient, Effect::AmbientOcclusion);
    let mut dull = scene("still-life");
    for sphere in &mut dull.spheres {
        if let Some(reflection) = &mut sphere.material.reflection {
            reflection.reflectance = black;
        }
    }
    same_without(&dull, Effect::Glossy);
}

/// Asserts that all pictures are the same bits with an effect and without it.
#[track_caller]
fn same_without(scene: &Scene, effect: Effect) {
    for arithmetic in each_arithmetic() {
        for effects in subsets().filter(|effects| effects.has(effect)) {
            let [with, without] =
                [effects, effects.without(effect)].map(|effects| bits(arithmetic, scene, effects));
            assert_eq!(with, without, "{arithmetic} {effects:?} without {effect:?}");
            let frame = rendered(arithmetic, scene, effects, &SMALL);
            assert!(tally(&frame.counts, effect).points > 0);
        }
    }
}
