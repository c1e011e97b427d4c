//! The textbooks' formulas in f32, over the elementary functions of any library: peers of the maps,
//! here and in the firmware.
//!
//! - pbrt: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 4th edition, 2023,
//!   A.5: concentric and polar disc, uniform and cosine hemisphere.
//! - Suffern: K. Suffern, "Ray Tracing from the Ground Up", 2007, chapters 6 and 7: concentric disc
//!   and the power lobe.

use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// What the formulas call.
pub trait Functions {
    fn sin(x: f32) -> f32;
    fn cos(x: f32) -> f32;
    fn sqrt(x: f32) -> f32;
    fn pow(x: f32, y: f32) -> f32;
}

/// [0, 1), as usual: the top 24 bits.
#[inline(always)]
pub fn unit(k: u32) -> f32 {
    (k >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[inline(always)]
pub fn pbrt_concentric<F: Functions>([u, v]: [f32; 2]) -> [f32; 2] {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    if x == 0.0 && y == 0.0 {
        return [0.0, 0.0];
    }
    let (r, theta) = if x.abs() > y.abs() {
        (x, FRAC_PI_4 * (y / x))
    } else {
        (y, FRAC_PI_2 - FRAC_PI_4 * (x / y))
    };
    [r * F::cos(theta), r * F::sin(theta)]
}

#[inline(always)]
pub fn pbrt_polar<F: Functions>([u, v]: [f32; 2]) -> [f32; 2] {
    let (r, theta) = (F::sqrt(u), 2.0 * PI * v);
    [r * F::cos(theta), r * F::sin(theta)]
}

#[inline(always)]
pub fn pbrt_uniform<F: Functions>([u, v]: [f32; 2]) -> [f32; 3] {
    let r = F::sqrt((1.0 - u * u).max(0.0));
    let phi = 2.0 * PI * v;
    [r * F::cos(phi), r * F::sin(phi), u]
}

#[inline(always)]
pub fn pbrt_cosine<F: Functions>([u, v]: [f32; 2]) -> [f32; 3] {
    let [x, y] = pbrt_concentric::<F>([u, v]);
    [x, y, F::sqrt((1.0 - x * x - y * y).max(0.0))]
}

#[inline(always)]
pub fn suffern_concentric<F: Functions>([u, v]: [f32; 2]) -> [f32; 2] {
    let (x, y) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    let (r, octants) = if x > -y {
        if x > y { (x, y / x) } else { (y, 2.0 - x / y) }
    } else if x < y {
        (-x, 4.0 + y / x)
    } else {
        (-y, if y != 0.0 { 6.0 - x / y } else { 0.0 })
    };
    let phi = octants * FRAC_PI_4;
    [r * F::cos(phi), r * F::sin(phi)]
}

#[inline(always)]
pub fn suffern_power<F: Functions>(e: f32, [u, v]: [f32; 2]) -> [f32; 3] {
    let phi = 2.0 * PI * u;
    let cos_theta = F::pow(1.0 - v, 1.0 / (e + 1.0));
    let sin_theta = F::sqrt(1.0 - cos_theta * cos_theta);
    [sin_theta * F::cos(phi), sin_theta * F::sin(phi), cos_theta]
}
