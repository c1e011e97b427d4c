//! The textbooks' formulas in f32, over the elementary functions of any library: peers of the maps
//! and of what a renderer makes of them, here and in the firmware.
//!
//! - pbrt: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 4th edition, 2023,
//!   A.5: concentric and polar disc, uniform and cosine hemisphere.
//! - Suffern: K. Suffern, "Ray Tracing from the Ground Up", 2007, chapters 6 and 7: concentric disc
//!   and the power lobe; chapter 25: glossy reflection.
//! - Shirley: P. Shirley, T. D. Black and S. Hollasch, "Ray Tracing in One Weekend" and the books
//!   after it, 2016-2024: rejection, and the cosine hemisphere over the polar disc.
//! - Duff: T. Duff, J. Burgess, P. Christensen, C. Hery, A. Kensler, M. Liani and R. Villemin,
//!   "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.

use core::array::from_fn;
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

/// The power lobe with its density as the book has it, by a second power.
#[inline(always)]
pub fn suffern_power_with_density<F: Functions>(e: f32, uv: [f32; 2]) -> ([f32; 3], f32) {
    let direction = suffern_power::<F>(e, uv);
    (direction, (e + 1.0) / (2.0 * PI) * F::pow(direction[2], e))
}

/// The same density without a second power: cos^(e + 1) is 1 - v.
#[inline(always)]
pub fn suffern_power_with_density_divided<F: Functions>(e: f32, uv: [f32; 2]) -> ([f32; 3], f32) {
    let direction = suffern_power::<F>(e, uv);
    (direction, (e + 1.0) / (2.0 * PI) * (1.0 - uv[1]) / direction[2])
}

/// A lobe's sample about the mirror direction; on the other side of that where it is below the
/// surface.
#[inline(always)]
pub fn suffern_glossy(
    arriving: [f32; 3],
    normal: [f32; 3],
    (local, density): ([f32; 3], f32),
) -> ([f32; 3], f32) {
    let cosine = dot(arriving, normal);
    let mirror = from_fn(|i| arriving[i] - 2.0 * cosine * normal[i]);
    let direction = duff_about(mirror, local);
    // Light arrives from above, so that its cosine is negative where the normal is above.
    if dot(direction, normal) * cosine > 0.0 {
        let [x, y, z] = local;
        return (duff_about(mirror, [-x, -y, z]), density);
    }
    (direction, density)
}

/// The cosine hemisphere over the polar disc.
#[inline(always)]
pub fn shirley_cosine<F: Functions>([u, v]: [f32; 2]) -> [f32; 3] {
    let [x, y] = pbrt_polar::<F>([u, v]);
    [x, y, F::sqrt(1.0 - u)]
}

/// A point of the disc: of the square, until one is inside.
#[inline(always)]
pub fn shirley_disc(mut draw: impl FnMut() -> f32) -> [f32; 2] {
    loop {
        let [x, y] = from_fn(|_| 2.0 * draw() - 1.0);
        if x * x + y * y < 1.0 {
            return [x, y];
        }
    }
}

/// A point of the sphere: of the cube, until one is inside the ball.
#[inline(always)]
pub fn shirley_sphere<F: Functions>(mut draw: impl FnMut() -> f32) -> [f32; 3] {
    loop {
        let point: [f32; 3] = from_fn(|_| 2.0 * draw() - 1.0);
        let square = dot(point, point);
        if 0.0 < square && square <= 1.0 {
            let length = F::sqrt(square);
            return point.map(|component| component / length);
        }
    }
}

/// A uniform direction about a normal.
#[inline(always)]
pub fn shirley_uniform_about<F: Functions>(
    normal: [f32; 3],
    draw: impl FnMut() -> f32,
) -> [f32; 3] {
    let direction = shirley_sphere::<F>(draw);
    if dot(direction, normal) > 0.0 { direction } else { direction.map(|component| -component) }
}

/// A direction about a normal, by the cosine: the normal and a point of the sphere.
#[inline(always)]
pub fn shirley_cosine_about<F: Functions>(normal: [f32; 3], draw: impl FnMut() -> f32) -> [f32; 3] {
    let point = shirley_sphere::<F>(draw);
    let sum = from_fn(|i| normal[i] + point[i]);
    let square = dot(sum, sum);
    if square < 1e-16 {
        return normal;
    }
    let length = F::sqrt(square);
    sum.map(|component| component / length)
}

/// A local direction in the basis about a unit vector.
#[inline(always)]
pub fn duff_about(unit: [f32; 3], [x, y, z]: [f32; 3]) -> [f32; 3] {
    let [a, b] = duff_basis(unit);
    from_fn(|i| x * a[i] + y * b[i] + z * unit[i])
}

#[inline(always)]
fn duff_basis([x, y, z]: [f32; 3]) -> [[f32; 3]; 2] {
    let sign = 1.0_f32.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
}

#[inline(always)]
fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
