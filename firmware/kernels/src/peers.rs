//! The peers: the textbooks' formulas on `libm` and `micromath`, and the concentric map on the fixed-point
//! sines of `idsp` and `cordic`.
//!
//! - pbrt: M. Pharr, W. Jakob and G. Humphreys, "Physically Based Rendering", 4th edition, 2023, A.5:
//!   concentric and polar disc, uniform and cosine hemisphere.
//! - Suffern: K. Suffern, "Ray Tracing from the Ground Up", 2007, chapters 6 and 7: concentric disc and the power
//!   lobe.

use crate::Visitor;
use core::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use fixed::types::{I3F13, I3F29};
use micromath::F32Ext;

trait Functions {
    fn sin(x: f32) -> f32;
    fn cos(x: f32) -> f32;
    fn sqrt(x: f32) -> f32;
    fn pow(x: f32, y: f32) -> f32;
}

struct Libm;
impl Functions for Libm {
    #[inline(always)]
    fn sin(x: f32) -> f32 {
        libm::sinf(x)
    }
    #[inline(always)]
    fn cos(x: f32) -> f32 {
        libm::cosf(x)
    }
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    #[inline(always)]
    fn pow(x: f32, y: f32) -> f32 {
        libm::powf(x, y)
    }
}

struct Micromath;
impl Functions for Micromath {
    #[inline(always)]
    fn sin(x: f32) -> f32 {
        F32Ext::sin(x)
    }
    #[inline(always)]
    fn cos(x: f32) -> f32 {
        F32Ext::cos(x)
    }
    #[inline(always)]
    fn sqrt(x: f32) -> f32 {
        F32Ext::sqrt(x)
    }
    #[inline(always)]
    fn pow(x: f32, y: f32) -> f32 {
        F32Ext::powf(x, y)
    }
}

/// [0, 1), as usual: the top 24 bits.
#[inline(always)]
fn unit(k: u32) -> f32 {
    (k >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[inline(always)]
fn pbrt_concentric<F: Functions>([u, v]: [f32; 2]) -> [f32; 2] {
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
fn pbrt_polar<F: Functions>([u, v]: [f32; 2]) -> [f32; 2] {
    let (r, theta) = (F::sqrt(u), 2.0 * PI * v);
    [r * F::cos(theta), r * F::sin(theta)]
}

#[inline(always)]
fn pbrt_uniform<F: Functions>([u, v]: [f32; 2]) -> [f32; 3] {
    let r = F::sqrt((1.0 - u * u).max(0.0));
    let phi = 2.0 * PI * v;
    [r * F::cos(phi), r * F::sin(phi), u]
}

#[inline(always)]
fn pbrt_cosine<F: Functions>([u, v]: [f32; 2]) -> [f32; 3] {
    let [x, y] = pbrt_concentric::<F>([u, v]);
    [x, y, F::sqrt((1.0 - x * x - y * y).max(0.0))]
}

#[inline(always)]
fn suffern_concentric<F: Functions>([u, v]: [f32; 2]) -> [f32; 2] {
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
fn suffern_power<F: Functions>(e: f32, [u, v]: [f32; 2]) -> [f32; 3] {
    let phi = 2.0 * PI * u;
    let cos_theta = F::pow(1.0 - v, 1.0 / (e + 1.0));
    let sin_theta = F::sqrt(1.0 - cos_theta * cos_theta);
    [sin_theta * F::cos(phi), sin_theta * F::sin(phi), cos_theta]
}

/// 2u - 1 in 2^-16 and 2^-32, at the centre of its cell.
#[inline(always)]
fn centred(k: u32) -> i32 {
    2 * ((k ^ 0x8000_0000).cast_signed() >> 16) + 1
}

/// The phase of pi/4 numerator / denominator, 2^31 for pi, of 16 bits.
#[inline(always)]
fn phase(numerator: i32, denominator: i32) -> i32 {
    ((numerator << 14) / denominator) << 15
}

#[inline(always)]
fn idsp_q15([u, v]: [u32; 2]) -> [i16; 2] {
    let (x, y) = (centred(u), centred(v));
    let (r, phase) =
        if x.abs() > y.abs() { (x, phase(y, x)) } else { (y, (1 << 30) - phase(x, y)) };
    let (cos, sin) = idsp::cossin(phase);
    [(r * (cos >> 16)) >> 16, (r * (sin >> 16)) >> 16].map(|x| x as i16)
}

#[inline(always)]
fn idsp_q31([u, v]: [u32; 2]) -> [i32; 2] {
    let [x, y] = [u, v].map(|k| (k ^ 0x8000_0000).cast_signed() | 1);
    let phase = |n: i32, d: i32| ((i64::from(n) << 29) / i64::from(d)) as i32;
    let (r, phase) = if x.unsigned_abs() > y.unsigned_abs() {
        (x, phase(y, x))
    } else {
        (y, (1 << 30) - phase(x, y))
    };
    let (cos, sin) = idsp::cossin(phase);
    [cos, sin].map(|factor| ((i64::from(r) * i64::from(factor)) >> 31) as i32)
}

macro_rules! cordic {
    ($function:ident, $number:ident, $bits:ident, $shift:literal) => {
        #[inline(always)]
        fn $function([u, v]: [u32; 2]) -> [$bits; 2] {
            let [x, y] = [u, v].map(|k| {
                $number::from_bits(((k ^ 0x8000_0000).cast_signed() >> $shift | 1) as $bits)
            });
            let (r, angle) = if x.abs() > y.abs() {
                (x, $number::FRAC_PI_4 * (y / x))
            } else {
                (y, $number::FRAC_PI_2 - $number::FRAC_PI_4 * (x / y))
            };
            let (sin, cos) = cordic::sin_cos(angle);
            [(r * cos).to_bits(), (r * sin).to_bits()]
        }
    };
}
cordic!(cordic_i3f13, I3F13, i16, 18);
cordic!(cordic_i3f29, I3F29, i32, 2);

/// A function that fills by a formula, under its path.
macro_rules! peers {
    ($visitor:ident: $($path:literal $point:ty, $uv:ident => $sample:expr;)*) => {$({
        #[unsafe(export_name = concat!("peer/", $path))]
        #[inline(never)]
        fn fill(coordinates: &[[u32; 2]], points: &mut [$point]) -> usize {
            for (slot, $uv) in points.iter_mut().zip(coordinates) {
                *slot = $sample;
            }
            points.len()
        }
        $visitor.points(concat!("peer/", $path), fill);
    })*};
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    // Prepared, as a renderer would: the exponent's own 1 / (e + 1) is folded by the compiler.
    const E: f32 = 50.0;
    peers! {
        visitor:
        "disc/concentric/pbrt-libm" [f32; 2], uv => pbrt_concentric::<Libm>(uv.map(unit));
        "disc/concentric/pbrt-micromath" [f32; 2], uv => pbrt_concentric::<Micromath>(uv.map(unit));
        "disc/concentric/suffern-libm" [f32; 2], uv => suffern_concentric::<Libm>(uv.map(unit));
        "disc/concentric/suffern-micromath" [f32; 2], uv => suffern_concentric::<Micromath>(uv.map(unit));
        "disc/concentric/idsp-q15" [i16; 2], uv => idsp_q15(*uv);
        "disc/concentric/idsp-q31" [i32; 2], uv => idsp_q31(*uv);
        "disc/concentric/cordic-i3f13" [i16; 2], uv => cordic_i3f13(*uv);
        "disc/concentric/cordic-i3f29" [i32; 2], uv => cordic_i3f29(*uv);
        "disc/polar/pbrt-libm" [f32; 2], uv => pbrt_polar::<Libm>(uv.map(unit));
        "disc/polar/pbrt-micromath" [f32; 2], uv => pbrt_polar::<Micromath>(uv.map(unit));
        "uniform/-/pbrt-libm" [f32; 3], uv => pbrt_uniform::<Libm>(uv.map(unit));
        "uniform/-/pbrt-micromath" [f32; 3], uv => pbrt_uniform::<Micromath>(uv.map(unit));
        "cosine/concentric/pbrt-libm" [f32; 3], uv => pbrt_cosine::<Libm>(uv.map(unit));
        "cosine/concentric/pbrt-micromath" [f32; 3], uv => pbrt_cosine::<Micromath>(uv.map(unit));
        "power/polar/suffern-libm" [f32; 3], uv => suffern_power::<Libm>(E, uv.map(unit));
        "power/polar/suffern-micromath" [f32; 3], uv => suffern_power::<Micromath>(E, uv.map(unit));
    }
}
