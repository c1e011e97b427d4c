//! The promises over the whole domain of inputs: on the disc in exact arithmetic, z > 0, density
//! positive and finite, mirror images equal bit for bit, inverses.
//!
//! The rings of the square next to its edge, whose points round to the rim of the disc, are walked
//! in full: every minor coordinate that the type can tell apart.

use hemidisc::arithmetic::Float;
use hemidisc::invariant::{self, Exact, in_unit_disc};
use hemidisc::{Concentric, Cosine, Density, Invert, LibmF32, Polar, Power, Uniform};
use proptest::prelude::*;
use testkit::arithmetics::{Tested, every_arithmetic};
use testkit::promises::{AtSample, Total};
use testkit::rings::{distinct, outward};

/// Any bit pattern; the hard ones, near an edge, the centre or a power of two, as often as not.
fn coordinate() -> impl Strategy<Value = u32> {
    prop_oneof![
        any::<u32>(),
        (any::<u32>(), 0..32_u32).prop_map(|(k, shift)| k >> shift),
        (any::<u32>(), 0..32_u32).prop_map(|(k, shift)| !(k >> shift)),
        (any::<u32>(), 0..32_u32).prop_map(|(k, shift)| (k >> shift) ^ 0x8000_0000),
        (0..32_u32, -2..3_i32).prop_map(|(bit, off)| (1_u32 << bit).wrapping_add_signed(off)),
    ]
}

/// Coordinates of the square; on a diagonal one time in eight.
fn coordinates() -> impl Strategy<Value = [u32; 2]> {
    (coordinate(), coordinate(), 0..16_u32).prop_map(|(u, v, kind)| match kind {
        0 => [u, u],
        1 => [u, !u],
        _ => [u, v],
    })
}

/// Any finite exponent above -1, in every binade.
fn exponent() -> impl Strategy<Value = f32> {
    prop_oneof![
        any::<u32>()
            .prop_map(f32::from_bits)
            .prop_filter("accepted", |e| *e > -1.0 && e.is_finite()),
        (-1.0_f32..0.0).prop_filter("above -1", |e| *e > -1.0),
        prop::sample::select(vec![0.0, 1.0, f32::MAX, -1.0 + f32::EPSILON / 2.0, 1e8]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn every_promise_holds_for_every_map(
        uv in coordinates(),
        exponent in exponent(),
        bits in any::<u64>(),
    ) {
        every_arithmetic(&mut AtSample { uv, exponent, bits });
        total(Uniform::<Checked>::new().sample(uv), exponent);
        total(Power::over(exponent, Polar::<Checked>::new()).unwrap().sample(uv), exponent);
    }

    #[test]
    fn inverse_and_density_are_total(bits in any::<[u32; 3]>(), uv in coordinates(), e in exponent()) {
        let anything = bits.map(f32::from_bits);
        let sampled = Power::<LibmF32>::new(e).unwrap().sample(uv);
        let off = [sampled[0], sampled[1], f32::from_bits(bits[2])];
        for direction in [anything, off, anything.map(|x| x % 1.0), [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]] {
            total(direction, e);
            every_arithmetic(&mut Total { numbers: direction.map(f64::from), exponent: e.into() });
        }
    }
}

/// Whatever is asked of, an answer comes: no panic, no argument that a library of functions does
/// not expect, a density that is a number and 0 below the horizon.
fn total([x, y, z]: [f32; 3], e: f32) {
    let lobes =
        (Power::<Checked>::new(e).unwrap(), Power::over(e, Polar::<Checked>::new()).unwrap());
    for density in [
        lobes.0.density([x, y, z]),
        Uniform::<Checked>::new().density([x, y, z]),
        Cosine::<Checked>::new().density([x, y, z.min(1.0)]),
        Concentric::<Checked>::new().density([x, y]),
    ] {
        assert!(density >= 0.0 && density.is_finite(), "{x} {y} {z}, e = {e}: {density}");
        assert!(z > 0.0 || density == 0.0 || density == std::f32::consts::FRAC_1_PI);
    }
    let _ = lobes.0.invert([x, y, z]);
    let _ = lobes.1.invert([x, y, z]);
    let _ = Uniform::<Checked>::new().invert([x, y, z]);
    let _ = Uniform::over(Polar::<Checked>::new()).invert([x, y, z]);
    let _ = Cosine::<Checked>::new().invert([x, y, z]);
    let _ = Cosine::over(Polar::<Checked>::new()).invert([x, y, z]);
    let _ = Concentric::<Checked>::new().invert([x, y]);
    let _ = Polar::<Checked>::new().invert([x, y]);
}

/// libm f32, but insisting on the ranges that `Float` documents.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Checked;

impl Float for Checked {
    const NAME: &'static str = "checked";
    type Real = f32;

    fn sqrt(x: f32) -> f32 {
        assert!((0.0..=f32::MAX).contains(&x), "sqrt({x})");
        libm::sqrtf(x)
    }
    fn sin_cos(x: f32) -> (f32, f32) {
        assert!((0.0..=std::f32::consts::FRAC_PI_4).contains(&x), "sin_cos({x})");
        (libm::sinf(x), libm::cosf(x))
    }
    fn atan(x: f32) -> f32 {
        assert!((0.0..=1.0).contains(&x), "atan({x})");
        libm::atanf(x)
    }
    fn ln(x: f32) -> f32 {
        assert!(x > 0.0 && x <= 1.0, "ln({x})");
        libm::logf(x)
    }
    fn ln_1p(x: f32) -> f32 {
        assert!((-0.5..=0.0).contains(&x), "ln_1p({x})");
        libm::log1pf(x)
    }
    fn exp(x: f32) -> f32 {
        assert!(!x.is_nan(), "exp({x})");
        libm::expf(x)
    }
    fn exp_m1(x: f32) -> f32 {
        assert!(x <= 0.0, "exp_m1({x})");
        libm::expm1f(x)
    }
}

/// Counts the points of a ring, on both sides of its diagonal, and asserts that none is outside.
fn walk_ring<A: Tested>(major: u32, stride: usize) -> u64 {
    let (disc, uniform) = (Concentric::<A>::new(), Uniform::<A>::new());
    let mut walked = 0;
    for minor in distinct::<A>(stride) {
        for uv in [[outward(major), outward(minor)], [outward(minor), outward(major)]] {
            let [x, y] = disc.sample(uv).map(Exact::exact);
            assert!(in_unit_disc([x, y]), "{} {uv:08x?}", A::NAME);
            let [x, y, z] = uniform.sample(uv).map(Exact::exact);
            assert!(in_unit_disc([x, y]) && z > 0.0, "{} {uv:08x?}", A::NAME);
            walked += 1;
        }
    }
    walked
}

fn no_point_of_the_outer_rings_is_outside<A: Tested>() {
    // Magnitudes that round to 1 and to each of the three f32 below it; or the last four of 16 bits.
    let full = std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some();
    let stride = if full || A::BITS < 32 { 1 } else { 61 };
    let fine = [0x7fff_ffff, 0x7fff_ff80, 0x7fff_ff00, 0x7fff_fe80];
    let radii = fine.map(|m| ((2 * m + 1) as f32 / 4_294_967_296.0).to_bits());
    assert_eq!(radii, [0, 1, 2, 3].map(|below| 1.0_f32.to_bits() - below));
    let rings = if A::BITS < 32 { [0, 1, 2, 3].map(|n| 0x7fff_ffff - (n << 16)) } else { fine };
    let walked: u64 = rings.into_iter().map(|major| walk_ring::<A>(major, stride)).sum();
    println!("{}: {walked} points of the outer rings walked, 0 outside", A::NAME);
    let total = distinct::<A>(stride).count() as u64 * 2 * rings.len() as u64;
    assert_eq!(walked, total);
}

testkit::test_each_arithmetic!(no_point_of_the_outer_rings_is_outside);

fn the_seam_and_the_rim_of_polar_are_on_the_disc<A: Tested>() {
    for v in (0..40_000).map(|i| u32::MAX - i * 7) {
        // With 16 bits of v as many more of u.
        let other = v.wrapping_mul(0x9e37_79b9);
        for u in [0, 1, v, v << 7, other, 1 << 30, (1 << 30) - 1, 1 << 31, 3 << 29, u32::MAX] {
            invariant::disc(&Polar::<A>::new(), [u, v])
                .unwrap_or_else(|v| panic!("{}: {v}", A::NAME));
        }
    }
}

testkit::test_each_arithmetic!(the_seam_and_the_rim_of_polar_are_on_the_disc);
