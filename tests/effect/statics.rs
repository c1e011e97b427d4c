//! Effects, frames and lobes in a `static`: the bits of `new`, and its errors.

use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use hemidisc::{Concentric, Error, FastF32, Frame, Polar, Power, Unit};
#[cfg(feature = "fixed-point")]
use hemidisc::{Q15, Q15Div, Q31, arithmetic::FixedExponent};

macro_rules! accepted {
    ($made:expr) => {
        match $made {
            Ok(made) => made,
            Err(_) => panic!("refused"),
        }
    };
}

const TOWARD: [f32; 3] = [0.2, -0.9, 0.4];
const NEAR: [f32; 3] = [0.6, 0.0, -0.801];

static UNIT: Unit<f64> = accepted!(Unit::<f64>::const_normalized([1e-200, -3e-200, 5e-201]));
static NORMAL: Unit<f32> = accepted!(Unit::<f32>::const_new(NEAR));
static FRAME: Frame<f64> = accepted!(Frame::<f64>::const_new([0.6, 0.0, -0.801]));
static TILTED: Frame<f32> = accepted!(Frame::<f32>::const_normalized(TOWARD));
static LAMP: DiscLight<FastF32> =
    accepted!(DiscLight::<FastF32>::const_new([1.0, 3.0, -0.3], TILTED, 0.7)).two_sided();
static LENS: ThinLens<Polygon<FastF32, 7>, f32> =
    accepted!(ThinLens::<_, f32>::const_new(Polygon::const_new(0x1234_5678), 0.3, 4.9));
static PINHOLE: ThinLens<Concentric<FastF32>, f32> =
    accepted!(ThinLens::<_, f32>::const_new(Concentric::new(), 0.0, f32::INFINITY));
static OCCLUSION: AmbientOcclusion<FastF32> =
    accepted!(AmbientOcclusion::<FastF32>::const_new(1.5));
static GLOSS: Glossy<FastF32> = accepted!(Glossy::<FastF32>::const_new(3.7, BelowHorizon::Zero));
static LOBE: Power<FastF32, Polar<FastF32>> =
    accepted!(Power::<FastF32, Polar<_>>::const_over(1e30, Polar::new()));

#[test]
fn a_static_is_what_new_gives() {
    assert_eq!(Unit::normalized([1e-200, -3e-200, 5e-201]), Ok(UNIT));
    assert_eq!(Unit::new(NEAR), Ok(NORMAL));
    assert_eq!(Frame::new([0.6, 0.0, -0.801]), Ok(FRAME));
    assert_eq!(Frame::normalized(TOWARD), Ok(TILTED));
    let lamp = DiscLight::<FastF32>::new([1.0, 3.0, -0.3], TILTED, 0.7).unwrap();
    assert_eq!(lamp.two_sided(), LAMP);
    assert_eq!(ThinLens::new(Polygon::new(0x1234_5678), 0.3, 4.9), Ok(LENS));
    assert_eq!(ThinLens::new(Concentric::new(), 0.0, f32::INFINITY), Ok(PINHOLE));
    assert_eq!(AmbientOcclusion::new(1.5), Ok(OCCLUSION));
    assert_eq!(Glossy::new(3.7, BelowHorizon::Zero), Ok(GLOSS));
    assert_eq!(Power::over(1e30, Polar::new()), Ok(LOBE));
    for e in [-0.999, -0.3, 0.0, 0.1, 1.0, 50.0, 1e6, 4e12, 1e30, f32::MAX] {
        assert_eq!(Power::<FastF32>::const_new(e), Power::new(e), "{e}");
    }
    for rotation in [0, 1, 1 << 30, u32::MAX] {
        assert_eq!(Polygon::<FastF32, 16>::const_new(rotation), Polygon::new(rotation));
    }
}

#[test]
fn what_new_refuses_no_static_takes() {
    let exponent = Power::<FastF32>::const_new(-1.0).map(|_| ()).unwrap_err();
    assert_eq!(exponent, Error::Exponent { value: -1.0 });
    assert_eq!(Glossy::<FastF32>::const_new(-1.0, BelowHorizon::Flip), Err(exponent));
    let zero = Unit::<f32>::const_normalized([0.0; 3]);
    assert_eq!(zero, Err(Error::NoDirection));
    assert_eq!(Frame::<f64>::const_new([0.0, 2.0, 0.0]), Frame::new([0.0, 2.0, 0.0]));
    let disc = Concentric::<FastF32>::new();
    for (radius, focus) in [(-1.0, 1.0), (1.0, 0.0), (4.0, 1e-38), (f32::MAX, 1.0), (1.0, 2.0)] {
        let lens = ThinLens::<_, f32>::const_new(disc, radius, focus);
        assert_eq!(lens, ThinLens::new(disc, radius, focus), "{radius} {focus}");
    }
    for (y, radius) in [(f32::MAX, f32::MAX.sqrt() * 0.5), (f32::INFINITY, 1.0), (0.0, -1.0)] {
        let light = DiscLight::<FastF32>::const_new([0.0, y, 0.0], TILTED, radius);
        assert_eq!(light, DiscLight::new([0.0, y, 0.0], TILTED, radius), "{y} {radius}");
    }
    for reach in [0.0, -1.0, f32::INFINITY] {
        let occlusion = AmbientOcclusion::<FastF32>::const_new(reach);
        assert_eq!(occlusion, AmbientOcclusion::new(reach), "{reach}");
    }
}

#[cfg(feature = "fixed-point")]
#[test]
fn lobes_of_fixed_point_are_what_new_gives() {
    const FIFTY: FixedExponent = FixedExponent::from_bits(50 << 32);
    static Q31_LOBE: Power<Q31> = accepted!(Power::<Q31>::const_new(FIFTY));
    static Q15_LOBE: Power<Q15> = accepted!(Power::<Q15>::const_new(FIFTY));
    static DIV_LOBE: Power<Q15Div, Polar<Q15Div>> =
        accepted!(Power::<Q15Div, Polar<_>>::const_over(FIFTY, Polar::new()));
    assert_eq!(Power::new(FIFTY), Ok(Q31_LOBE));
    assert_eq!(Power::new(FIFTY), Ok(Q15_LOBE));
    assert_eq!(Power::over(FIFTY, Polar::new()), Ok(DIV_LOBE));
    for bits in [0, 1, 0x1234_5678_9abc_def0, u64::MAX] {
        let e = FixedExponent::from_bits(bits);
        let lobe = Power::<Q31>::const_new(e).unwrap();
        let uv = [0x1234_5678, 0x9abc_def0];
        assert_eq!(lobe.sample(uv), Power::<Q31>::new(e).unwrap().sample(uv));
    }
}
