//! Any bytes make `Arbitrary` give a value that its constructor accepts, and any value can be
//! reached.
#![cfg(all(feature = "libm", feature = "fixed-point", feature = "arbitrary"))]

use arbitrary::{Arbitrary, Unstructured};
use hemidisc::arithmetic::FixedExponent;
use hemidisc::domain::{Split, Stream};
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use hemidisc::frame::About;
use hemidisc::sequence::{
    self, Correlated, Hammersley, Jittered, NRooks, Regular, Sequence, Shuffled, Sobol,
};
use hemidisc::{
    Axis, Concentric, Coordinates, Cosine, Domain, FastF32, Frame, Invert, LibmF32, LibmF64,
    Points, Power, Q15, Q31, Unit, UnitSquare, for_each_disc_map, for_each_lobe, for_each_sequence,
    hemisphere, invariant,
};
use proptest::prelude::*;
use std::fmt::Debug;

/// The value of any bytes, also of none.
fn made<'a, T: Arbitrary<'a>>(bytes: &'a [u8]) -> T {
    let (least, most) = T::size_hint(0);
    assert!(most.is_none_or(|most| least <= most));
    let mut u = Unstructured::new(bytes);
    let value = T::arbitrary(&mut u).unwrap_or_else(|error| panic!("{error}: {bytes:x?}"));
    let taken = bytes.len() - u.len();
    assert!(most.is_none_or(|most| taken <= most), "{taken} bytes taken, {most:?} said");
    value
}

/// A set has points, and random access, iteration and blocks agree on them.
fn set<'a, S: Sequence + Arbitrary<'a> + Debug>(bytes: &'a [u8]) {
    let set = made::<S>(bytes);
    assert_ne!(set.size(), Some(0), "{set:?}");
    assert_eq!(invariant::consistent(&set, 64), Ok(()), "{set:?}");
}

fn lobe<'a, M>(bytes: &'a [u8], uv: [u32; 2])
where
    M: Invert<Point = [f32; 3]> + Arbitrary<'a>,
{
    assert_eq!(invariant::hemisphere(&made::<M>(bytes), uv), Ok(()));
}

fn disc<'a, M>(bytes: &'a [u8], uv: [u32; 2])
where
    M: Invert<Point = [f32; 2]> + Arbitrary<'a>,
{
    assert_eq!(invariant::disc(&made::<M>(bytes), uv), Ok(()));
}

macro_rules! sequences {
    ($bytes:ident $($file:ident $sequence:ident $name:literal $kind:ident $new:ident $parts:tt;)*) => {
        $(set::<sequence::$sequence>($bytes);)*
    };
}

macro_rules! discs {
    ($bytes:ident $uv:ident $($file:ident $map:ident $name:literal;)*) => {
        $(disc::<hemidisc::disc::$map<LibmF32>>($bytes, $uv);)*
    };
}

/// Every lobe over every disc map.
macro_rules! lobes {
    ($bytes:ident $uv:ident $($file:ident $type:ident $over:ident $name:literal $taken:tt;)*) => {
        $(for_each_disc_map!(over $bytes $uv $over);)*
    };
}

macro_rules! over {
    ($bytes:ident $uv:ident $over:ident $($file:ident $map:ident $name:literal;)*) => {
        $(lobe::<hemisphere::$over<LibmF32, hemidisc::disc::$map<LibmF32>>>($bytes, $uv);)*
    };
}

fn valid(bytes: &[u8], uv: [u32; 2]) {
    for_each_sequence!(sequences bytes);
    set::<Shuffled<Correlated>>(bytes);
    for_each_disc_map!(discs bytes uv);
    disc::<Polygon<LibmF32, 5>>(bytes, uv);
    for_each_lobe!(lobes bytes uv);
    assert_eq!(invariant::hemisphere(&made::<Power<Q15>>(bytes), uv), Ok(()));
    assert_eq!(invariant::hemisphere(&made::<Power<LibmF64>>(bytes), uv), Ok(()));
    let points: Points<Hammersley, UnitSquare<FastF32>> = made(bytes);
    let all = u64::from(points.sequence().size().unwrap_or(0));
    assert!(points.len() <= all as u32 && points.iter().len() as u32 == points.len());
    made::<Points<Sobol, Concentric<Q31>>>(bytes);

    let frame = made::<Frame<f32>>(bytes);
    assert_eq!(Frame::new(frame.axes()[2]), Ok(frame));
    let frame = made::<Frame<f64>>(bytes);
    assert_eq!(Frame::new(frame.axes()[2]), Ok(frame));
    made::<About<Cosine<LibmF32>, f32>>(bytes);
    let unit = made::<Unit<f32>>(bytes);
    assert_eq!(Unit::new(unit.get()), Ok(unit));
    let domain: Domain = made(bytes);
    let (split, stream): (Split, Stream) = (made(bytes), made(bytes));
    assert_eq!(stream, domain.stream());
    split.branches(0).unwrap_or_default();
    made::<Axis>(bytes);
    made::<Coordinates>(bytes);
    made::<FixedExponent>(bytes);
    made::<[Q15; 3]>(bytes);

    let lens: ThinLens<Concentric<LibmF32>, f32> = made(bytes);
    let ray = lens.ray([0.25, -0.5], uv);
    assert!(ray.origin.into_iter().chain(ray.direction).all(f32::is_finite), "{lens:?}");
    let light: DiscLight<LibmF32> = made(bytes);
    assert!(light.sample([0.0; 3], uv).weight.is_finite(), "{light:?}");
    assert!(made::<AmbientOcclusion<LibmF64>>(bytes).reach() > 0.0);
    let up = Unit::new([0.0, 1.0, 0.0]).unwrap();
    let gloss: Glossy<LibmF32> = made(bytes);
    let sample = gloss.sample(-up, up, uv);
    assert!(sample.is_none_or(|sample| sample.direction[1] > -1e-6), "{gloss:?}");
    made::<BelowHorizon>(bytes);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    #[test]
    fn any_bytes_make_a_valid_value(
        bytes in prop::collection::vec(any::<u8>(), 0..100),
        edge in prop::sample::select(vec![0x00_u8, 0x7f, 0x80, 0xff]),
        edges in 0..100_usize,
        uv in any::<[u32; 2]>(),
    ) {
        valid(&bytes, uv);
        // Many numbers at once at the end of their range: zeros, infinities, NaN.
        let mut bytes = bytes;
        bytes.iter_mut().take(edges).for_each(|byte| *byte = edge);
        valid(&bytes, uv);
    }
}

/// Bytes that a person can write: each part as it is, where it is valid.
#[test]
fn parts_are_taken_as_they_are() {
    let words = |words: &[u32]| words.iter().flat_map(|k| k.to_le_bytes()).collect::<Vec<_>>();
    assert_eq!(made::<Jittered>(&words(&[4, 9, 7])), Jittered::new(4, 9, 7).unwrap());
    assert_eq!(made::<NRooks>(&words(&[u32::MAX, 1])), NRooks::new(u32::MAX, 1).unwrap());
    // Empty, and too large.
    assert_eq!(made::<Regular>(&[]), Regular::new(1, 1).unwrap());
    assert_eq!(made::<Regular>(&words(&[3, u32::MAX])), Regular::new(3, u32::MAX / 3).unwrap());
    let exponent = |e: f32| made::<Power<LibmF32>>(&words(&[e.to_bits()])).exponent();
    assert_eq!([50.0, -0.5, f32::MAX].map(exponent), [50.0, -0.5, f32::MAX]);
    assert_eq!([-1.0, f32::NAN, f32::INFINITY].map(exponent), [0.0; 3]);
    let z = |s: f32, t: f32| made::<Frame<f32>>(&words(&[s.to_bits(), t.to_bits()])).axes()[2];
    assert_eq!((z(0.0, 0.0), z(1.0, 0.0)), ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0]));
    assert_eq!(z(f32::NAN, f32::INFINITY), [0.0, 0.0, 1.0]);
}
