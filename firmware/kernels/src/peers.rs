//! The peers: the textbooks' formulas on `libm` and `micromath`, and the concentric map on the
//! fixed-point sines of `idsp` and `cordic`.

use crate::Visitor;
use fixed::types::{I3F13, I3F29};
use micromath::F32Ext;
use testkit::textbook::{
    Functions, pbrt_concentric, pbrt_cosine, pbrt_polar, pbrt_uniform, suffern_concentric,
    suffern_power, unit,
};

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
