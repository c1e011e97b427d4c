//! Pictures whose pixels are known: what is lit, what is hidden, what is reflected and where it is
//! seen.

use super::{SMALL, pixels, rendered};
use examples::render::description::Scene;
use examples::render::file;
use examples::render::frame::Settings;
use std::f64::consts::PI;

/// One pixel of many samples.
const POINT: Settings = Settings { size: [1, 1], samples: 1024, ..SMALL };

/// A scene in a black world from its other parts.
fn parsed(camera: &str, light: &str, ambient: &str, sky: f64, rest: &str) -> Scene {
    let text = format!(
        "(camera: ({camera}), light: ({light}), ambient: ({ambient}),
        sky: (horizon: ({sky}, {sky}, {sky}), zenith: ({sky}, {sky}, {sky})), {rest})"
    );
    file::parsed(&text).unwrap()
}

const UNLIT: &str = "position: (0, 9, 0), toward: (0, -1, 0), intensity: (0, 0, 0)";
const DARK: &str = "colour: (0, 0, 0)";
const AHEAD: &str = "position: (0, 0, 0), ahead: (0, 0, -1), field_of_view: 40";
/// Looks straight down at (0, 0, 0) from a side, at a spot as small as can be.
const AT_THE_ORIGIN: &str = "position: (2, 2, 0), ahead: (-1, -1, 0), field_of_view: 0.001";
const FLOOR: &str = "(point: (0, 0, 0), normal: (0, 1, 0), material: (albedo: (0.5, 0.5, 0.5)))";

fn seen(scene: &Scene, settings: &Settings) -> Vec<f64> {
    let frame = rendered("libm-f64", scene, scene.effects(), settings);
    pixels(&frame, settings).iter().map(|pixel| pixel[0]).collect()
}

#[track_caller]
fn near(found: f64, exact: f64, tolerance: f64) {
    assert!((found - exact).abs() <= tolerance, "{found}, not {exact} within {tolerance}");
}

/// White on white: whatever is reflected is as bright as the sky, by a mirror or through a lobe.
#[test]
fn a_reflection_is_as_bright_as_what_it_shows() {
    for exponent in ["", ", exponent: 1", ", exponent: 1000"] {
        let ball = format!(
            "spheres: [(centre: (0, 0, -3), radius: 1, material: (albedo: (0, 0, 0), \
             reflection: (reflectance: (0.5, 0.5, 0.5){exponent})))]"
        );
        let pixels = seen(&parsed(AHEAD, UNLIT, DARK, 1.0, &ball), &SMALL);
        assert_eq!(pixels.iter().copied().fold(f64::INFINITY, f64::min), 0.5, "{exponent}");
        assert_eq!(pixels[0], 1.0);
    }
}

/// Under a sphere of radius r at a height h the floor is open to 1 - (r / h)^2, as long as the
/// sphere is in reach.
#[test]
fn occlusion_hides_what_is_above() {
    let things = format!(
        "spheres: [(centre: (0, 2, 0), radius: 1, material: (albedo: (0, 0, 0)))], planes: [{FLOOR}]"
    );
    for (reach, open) in [("inf", 0.75), ("0.5", 1.0)] {
        let ambient = format!("colour: (0.8, 0.8, 0.8), reach: {reach}");
        let pixel = seen(&parsed(AT_THE_ORIGIN, UNLIT, &ambient, 0.0, &things), &POINT)[0];
        near(pixel, 0.4 * open, 2e-3);
    }
}

/// A ball between light and floor hides it, and one behind the light does not.
#[test]
fn what_is_between_a_light_and_a_floor_hides_it() {
    let things = |height: f64| {
        format!(
            "spheres: [(centre: (0, {height}, 0), radius: 0.4, material: (albedo: (0, 0, 0)))], \
             planes: [{FLOOR}]"
        )
    };
    for radius in ["", ", radius: 0.1"] {
        let light =
            format!("position: (0, 3, 0), toward: (0, -1, 0), intensity: (9, 9, 9){radius}");
        let pixel = |height| {
            seen(
                &parsed(AT_THE_ORIGIN, &light, "colour: (0.2, 0.2, 0.2)", 0.0, &things(height)),
                &POINT,
            )[0]
        };
        near(pixel(1.0), 0.1, 1e-9);
        near(pixel(4.0), 0.1 + 0.5 * 9.0 / 9.0 / PI, 1e-3);
    }
}

/// A lamp to the upper right is there in the picture.
#[test]
fn right_is_right_and_up_is_up() {
    let lamp = "spheres: [(centre: (0.6, 0.35, -3), radius: 0.1, material: \
                (albedo: (0, 0, 0), emission: (1, 1, 1)))]";
    let pixels = seen(&parsed(AHEAD, UNLIT, DARK, 0.0, lamp), &SMALL);
    let [width, height] = SMALL.size.map(|side| side as usize);
    let lit: Vec<_> = (0..pixels.len()).filter(|n| pixels[*n] > 0.0).collect();
    assert!(!lit.is_empty());
    assert!(lit.iter().all(|n| n % width >= width / 2 && n / width < height / 2), "{lit:?}");
}

/// A lamp at a distance z is blurred to a disc of radius r |1 / z - 1 / f| in the image plane
/// z = 1.
#[test]
fn a_blur_is_as_wide_as_the_lens_says() {
    const SIDE: u32 = 64;
    let settings = Settings { size: [SIDE, SIDE], samples: 1024, ..SMALL };
    let lamp = "lens: (radius: 0.2, focus: 2), spheres: [(centre: (0, 0, -4), radius: 0.08, material: \
                (albedo: (0, 0, 0), emission: (1, 1, 1)))]";
    let pixels = seen(&parsed(AHEAD, UNLIT, DARK, 0.0, lamp), &settings);
    let half = f64::from(SIDE) / 2.0;
    let pixel = 20_f64.to_radians().tan() / half;
    let (mut total, mut second, mut widest) = (0.0, 0.0, 0.0_f64);
    for (n, value) in pixels.iter().enumerate().filter(|(_, value)| **value > 0.0) {
        let x = ((n as u32 % SIDE) as f64 + 0.5 - half) * pixel;
        let y = ((n as u32 / SIDE) as f64 + 0.5 - half) * pixel;
        total += value;
        second += value * (x * x + y * y);
        widest = widest.max(x.hypot(y));
    }
    let radius = 0.2 * (1.0 / 2.0 - 1.0 / 4.0);
    // A disc's mean square is r^2 / 2; to it come that of the lamp, 0.02 wide there, and a sixth of
    // a square pixel.
    let square = radius * radius + 0.02 * 0.02 + pixel * pixel / 3.0;
    near((2.0 * second / total).sqrt(), square.sqrt(), 0.01 * radius);
    assert!(widest < radius + 0.02 + pixel, "{widest}");
}
