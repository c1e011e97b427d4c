//! Colours against sRGB's curve by its formula, in f64.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use testkit::panel::srgb::encode;

fn curve(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}

/// The least light of a value on the curve: by bisection, not by a formula.
fn light(value: f64) -> f64 {
    let (mut below, mut above) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (below + above) / 2.0;
        *(if curve(middle) < value { &mut below } else { &mut above }) = middle;
    }
    above
}

#[track_caller]
fn nearest(light: f32) {
    let colour = encode([light; 3]);
    let levels =
        [(colour.r(), Rgb565::MAX_R), (colour.g(), Rgb565::MAX_G), (colour.b(), Rgb565::MAX_B)];
    for (level, highest) in levels {
        let exact = f64::from(highest) * curve(light.into());
        assert_eq!(f64::from(level), exact.round(), "of {light}, which is {exact}");
    }
}

#[test]
fn levels_are_the_nearest_on_the_curve() {
    (0..=1 << 20).for_each(|k| nearest(k as f32 / (1 << 20) as f32));
    for highest in [Rgb565::MAX_R, Rgb565::MAX_G] {
        for level in 0..highest {
            let edge = light((f64::from(level) + 0.5) / f64::from(highest)) as f32;
            (edge.to_bits() - 64..edge.to_bits() + 64).map(f32::from_bits).for_each(nearest);
        }
    }
}

#[test]
fn light_off_the_curve_is_black_or_full() {
    for light in [0.0, -0.0, -1.0, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE] {
        assert_eq!(encode([light; 3]), Rgb565::BLACK, "{light}");
    }
    for light in [1.0, 1.5, f32::MAX, f32::INFINITY] {
        assert_eq!(encode([light; 3]), Rgb565::WHITE, "{light}");
    }
    assert_eq!(encode([1.0, 0.0, 0.0]), Rgb565::RED);
    assert_eq!(encode([0.0, 1.0, 0.0]), Rgb565::GREEN);
    assert_eq!(encode([0.0, 0.0, 1.0]), Rgb565::BLUE);
}
