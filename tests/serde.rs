//! Every value is read back as it was written, in the form of its constructor's arguments. What a
//! constructor refuses is not read, and the message is the constructor's.
#![cfg(all(feature = "libm", feature = "fixed-point", feature = "serde"))]

use hemidisc::arithmetic::FixedExponent;
use hemidisc::catalogue::Parameters;
use hemidisc::effect::{
    AmbientOcclusion, BelowHorizon, DirectionSample, DiscLight, Glossy, LensRay, LightSample,
    Polygon, ThinLens,
};
use hemidisc::frame::About;
use hemidisc::invariant::Violation;
use hemidisc::sequence::{
    self, Correlated, GridSize, Halton, Hammersley, Jittered, MultiJittered, NRooks, R2, Random,
    Regular, Shifted, Shuffled, Sobol, SobolOwen,
};
use hemidisc::{
    Axis, Concentric, Coordinates, Cosine, Domain, Error, FastF32, Frame, LibmF32, LibmF64, Points,
    Polar, Power, Q15, Q15Div, Q31, Sampler, Screen, Uniform, Unit, UnitSquare, for_each_sequence,
    made_by,
};
use serde::{Serialize, de::DeserializeOwned};
use std::fmt::Debug;

/// The value is written so, and so it is read.
#[track_caller]
fn written<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T, text: &str) {
    assert_eq!(ron::to_string(&value).unwrap(), text);
    assert_eq!(ron::from_str::<T>(text).unwrap(), value, "{text}");
}

/// The value is read back as it was.
#[track_caller]
fn kept<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T) {
    let text = ron::to_string(&value).unwrap();
    assert_eq!(ron::from_str::<T>(&text).unwrap(), value, "{text}");
}

/// The text is not read, for the reason that a constructor gives.
#[track_caller]
fn refused<T: DeserializeOwned + Debug>(text: &str, reason: Error) {
    match ron::from_str::<T>(text) {
        Ok(value) => panic!("{text} is read as {value:?}"),
        Err(error) => assert_eq!(error.code.to_string(), reason.to_string(), "{text}"),
    }
}

/// The error of a constructor.
#[track_caller]
fn reason<T: Debug>(refused: Result<T, Error>) -> Error {
    refused.unwrap_err()
}

#[test]
fn domains_are_kept() {
    written(Coordinates([1, u32::MAX]), "((1,4294967295))");
    for seed in [0, 1, 7, u32::MAX] {
        let domain = Domain::new(seed).pixel(3, 9).child(seed);
        kept(domain);
        kept(domain.split(5, 4));
        kept(domain.stream());
    }
    let text = ron::to_string(&Domain::new(7)).unwrap();
    written(Domain::new(7).stream(), &format!("(domain:{text})"));
}

macro_rules! kept_sequences {
    ($parameters:ident
        $($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*
    ) => {$(
        let made = sequence::$sequence::$new($($parameters.$part),*);
        kept(made_by!($kind made));
    )*};
}

#[test]
fn every_sequence_is_kept() -> Result<(), Error> {
    for seed in [0, 1, 7, 0x1234_5678, u32::MAX] {
        let parameters = Parameters::new(36, seed);
        for_each_sequence!(kept_sequences parameters);
    }
    Ok(())
}

#[test]
fn sequences_are_the_arguments_of_their_constructors() {
    for seed in [0, 1, 7, 0x1234_5678, u32::MAX] {
        kept(Random::new(seed));
        written(Sobol::new(seed), &format!("(seed:{seed})"));
        written(R2::new(seed), &format!("(seed:{seed})"));
        kept(SobolOwen::new(seed));
        kept(Shuffled::new(Hammersley::new(9).unwrap(), Domain::new(seed)));
        written(NRooks::new(12, seed).unwrap(), &format!("(count:12,seed:{seed})"));
        let text = format!("(columns:4,rows:9,seed:{seed})");
        written(Jittered::new(4, 9, seed).unwrap(), &text);
        written(MultiJittered::new(4, 9, seed).unwrap(), &text);
        written(Correlated::new(4, 9, seed).unwrap(), &text);
    }
    written(Regular::new(4, 9).unwrap(), "(columns:4,rows:9)");
    written(Hammersley::new(10).unwrap(), "(count:10)");
    written(Halton::new(), "()");
    let domain = Domain::new(3).child(4);
    let text = ron::to_string(&domain).unwrap();
    written(SobolOwen::in_domain(domain), &format!("(domain:{text})"));
    written(Random::in_domain(domain), &format!("(domain:{text})"));
    let shuffled = Shuffled::new(Regular::new(2, 3).unwrap(), domain);
    written(shuffled, &format!("(sequence:(columns:2,rows:3),domain:{text})"));
    written(Shifted::new(Halton::new(), domain), &format!("(sequence:(),domain:{text})"));
}

#[test]
fn samplers_are_a_domain_and_an_index() {
    let domain = Domain::new(3).child(4);
    let text = ron::to_string(&domain).unwrap();
    written(Sampler::new(domain, 5), &format!("(domain:{text},size:(),index:5)"));
    let size = GridSize::new(4, 9).unwrap();
    written(size, "(columns:4,rows:9)");
    let sampler = Sampler::<MultiJittered>::of(domain, size, 7);
    written(sampler, &format!("(domain:{text},size:(columns:4,rows:9),index:7)"));
    let screen = Screen::new(domain, [640, 480], 12).unwrap();
    written(screen, &format!("(domain:{text},size:(640,480),samples:12)"));
    refused::<GridSize>("(columns:0,rows:9)", reason(GridSize::new(0, 9)));
    refused::<GridSize>("(columns:70000,rows:9)", reason(GridSize::new(70_000, 9)));
    let text = format!("(domain:{text},size:(0,480),samples:12)");
    refused::<Screen>(&text, reason(Screen::new(domain, [0, 480], 12)));
}

#[test]
fn maps_are_the_arguments_of_their_constructors() {
    written(UnitSquare::<FastF32>::new(), "()");
    written(Concentric::<Q31>::new(), "()");
    written(Polar::<LibmF64>::new(), "()");
    written(Uniform::<LibmF32>::new(), "(disc:())");
    written(Cosine::over(Polar::<Q15Div>::new()), "(disc:())");
    written(Power::<LibmF32>::new(0.1).unwrap(), "(exponent:0.1,disc:())");
    kept(Power::over(-0.999_f64, Polar::<LibmF64>::new()).unwrap());
    kept(Power::<FastF32>::new(1e30).unwrap());
    for bits in [0, 1, 0x1234_5678_9abc_def0, u64::MAX] {
        let exponent = FixedExponent::from_bits(bits);
        kept(exponent);
        kept(Power::<Q15>::new(exponent).unwrap());
        kept(Power::<Q31>::new(exponent).unwrap());
    }
    let frame = Frame::new([0.0, -1.0, 0.0_f32]).unwrap();
    written(frame, "(z:(0.0,-1.0,0.0),tangent:None)");
    assert_eq!(ron::from_str::<Frame<f32>>("(z:(0.0,-1.0,0.0))").unwrap(), frame);
    let tilted = Frame::with_tangent(frame.unit(), [3.0, 0.0, 4.0]).unwrap();
    let [x, ..] = tilted.axes();
    let text = format!("(z:(0.0,-1.0,0.0),tangent:Some(({:?},{:?},{:?})))", x[0], x[1], x[2]);
    written(tilted, &text);
    written(-frame.unit(), "(vector:(-0.0,1.0,-0.0))");
    kept(Unit::normalized([0.1_f64, -7.0, 1e-9]).unwrap());
    for i in 0..100 {
        let normal = Uniform::<LibmF32>::new().sample(SobolOwen::new(1).at(i));
        let tangent = Uniform::<LibmF32>::new().sample(SobolOwen::new(2).at(i));
        kept(Frame::with_tangent(Unit::new(normal).unwrap(), tangent).unwrap());
    }
    kept(Frame::normalized([0.1, -7.0, 1e-9]).unwrap());
    kept(Frame::normalized([0.1, -7.0, -1e-9]).unwrap());
    let about: About<_, f32> = Cosine::<LibmF32>::new().about(frame);
    written(about, "(map:(disc:()),frame:(z:(0.0,-1.0,0.0),tangent:None))");
    kept([Q15::MAX, -Q15::LSB]);
    kept([Q31::MAX, Q31::from_bits(i32::MIN)]);
}

#[test]
fn points_are_a_range_of_a_sequence_through_a_map() {
    let (sobol, disc) = (Sobol::new(0), Concentric::<LibmF32>::new());
    let points = Points::with_range(sobol, disc, 5..9).unwrap();
    written(points, "(sequence:(seed:0),map:(),start:5,len:4)");
    kept(Points::new(sobol, disc));
    // The last index of all; and none, before it and after a set.
    kept(Points::with_range(sobol, disc, u32::MAX - 3..).unwrap());
    kept(Points::with_range(sobol, disc, 1..).unwrap());
    kept(Points::with_range(sobol, disc, u32::MAX..u32::MAX).unwrap());
    let set = Hammersley::new(8).unwrap();
    kept(Points::with_range(set, disc, 8..8).unwrap());
    kept(Points::new(set, disc).shard(1, 3).unwrap());
}

#[test]
fn effects_are_the_arguments_of_their_constructors() {
    let disc = Concentric::<LibmF32>::new();
    let lens = ThinLens::new(disc, 0.005, 2.1).unwrap();
    written(lens, "(aperture:(),radius:0.005,focal_distance:2.1)");
    kept(ThinLens::new(Polygon::<LibmF64, 6>::new(77), 0.1, f64::INFINITY).unwrap());
    written(Polygon::<LibmF32, 5>::new(1 << 30), "(rotation:1073741824)");
    let frame = Frame::new([0.0, 0.0, 1.0]).unwrap();
    let light = DiscLight::<LibmF32>::new([1.0, 2.0, 3.0], frame, 0.5).unwrap();
    let text = "(centre:(1.0,2.0,3.0),frame:(z:(0.0,0.0,1.0),tangent:None),radius:0.5,two_sided:";
    written(light, &format!("{text}false)"));
    written(light.two_sided(), &format!("{text}true)"));
    written(AmbientOcclusion::<LibmF64>::new(0.3).unwrap(), "(reach:0.3)");
    let gloss = Glossy::<LibmF32>::new(50.0, BelowHorizon::Flip).unwrap();
    written(gloss, "(exponent:50.0,below_horizon:Flip)");
    for below in [BelowHorizon::Reject, BelowHorizon::Flip, BelowHorizon::Zero] {
        kept(below);
    }
    let ray: LensRay<f32> = lens.ray([0.1, -0.2], [1, 2]);
    kept(ray);
    let sample: LightSample<f32> = light.sample([0.0, 0.0, 9.0], [1, 2]);
    kept(sample);
    let sample: Option<DirectionSample<f32>> =
        gloss.sample(Unit::new([0.0, -1.0, 0.0]).unwrap(), frame.unit(), [1, 2]);
    kept(sample.unwrap());
}

#[test]
fn errors_are_kept() {
    kept([Axis::U, Axis::V]);
    let error = Coordinates::try_from([0.25_f64, 1.0]).unwrap_err();
    written(error, "Coordinate(axis:V,value:1.0)");
    kept(Error::StoredTooLong { len: usize::MAX });
    kept(Error::NoDraws);
    kept(Violation::NotInverted { uv: [1, 2], got: [3, u32::MAX] });
    kept(Violation::NoRoom { needed: u64::MAX });
}

#[test]
fn what_a_constructor_refuses_is_not_read() {
    refused::<Regular>("(columns:0,rows:4)", reason(Regular::new(0, 4)));
    let grid = "(columns:65536,rows:65536,seed:7)";
    refused::<Jittered>(grid, reason(Jittered::new(1 << 16, 1 << 16, 7)));
    refused::<MultiJittered>(grid, reason(MultiJittered::new(1 << 16, 1 << 16, 7)));
    refused::<Correlated>(grid, reason(Correlated::new(1 << 16, 1 << 16, 7)));
    refused::<NRooks>("(count:0,seed:7)", reason(NRooks::new(0, 7)));
    refused::<Hammersley>("(count:0)", reason(Hammersley::new(0)));
    let shuffled =
        format!("(sequence:(count:0),domain:{})", ron::to_string(&Domain::new(0)).unwrap());
    refused::<Shuffled<Hammersley>>(&shuffled, Error::EmptySet);

    let exponent = "(exponent:-1,disc:())";
    refused::<Power<LibmF32>>(exponent, reason(Power::<LibmF32>::new(-1.0)));
    refused::<Power<LibmF64, Polar<LibmF64>>>(exponent, Error::Exponent { value: -1.0 });
    refused::<Frame<f32>>("(z:(0,0,2))", reason(Frame::new([0.0, 0.0, 2.0_f32])));
    refused::<Unit<f64>>("(vector:(0,0,1.1))", reason(Unit::new([0.0, 0.0, 1.1])));
    let along = "(z:(0,0,1),tangent:Some((0,0,-3)))";
    refused::<Frame<f32>>(along, Error::Parallel { cosine: -1.0 });
    let about = "(map:(disc:()),frame:(z:(0,0,0)))";
    refused::<About<Cosine<LibmF32>, f32>>(about, reason(Frame::new([0.0_f32; 3])));

    type Set = Points<Hammersley, UnitSquare<FastF32>>;
    type Endless = Points<Sobol, UnitSquare<FastF32>>;
    let range = |start, count, len| Error::Range { start, count, len };
    refused::<Set>("(sequence:(count:8),map:(),start:5,len:4)", range(5, 4, 8));
    refused::<Set>("(sequence:(count:8),map:(),start:9,len:0)", range(9, 0, 8));
    let beyond = "(sequence:(seed:0),map:(),start:4294967295,len:2)";
    refused::<Endless>(beyond, range(u32::MAX.into(), 2, 1 << 32));

    type Lens = ThinLens<Concentric<LibmF32>, f32>;
    let lens = "(aperture:(),radius:-1,focal_distance:2)";
    refused::<Lens>(lens, Error::Radius { value: -1.0 });
    let lens = "(aperture:(),radius:1,focal_distance:0)";
    refused::<Lens>(lens, Error::Distance { value: 0.0 });
    let light = "(centre:(0,0,inf),frame:(z:(0,0,1)),radius:1,two_sided:true)";
    refused::<DiscLight<LibmF32>>(light, Error::Position { value: f64::INFINITY });
    let light = "(centre:(0,0,0),frame:(z:(0,0,1)),radius:-1,two_sided:true)";
    refused::<DiscLight<LibmF32>>(light, Error::Radius { value: -1.0 });
    refused::<AmbientOcclusion<LibmF32>>("(reach:-1)", Error::Distance { value: -1.0 });
    let gloss = "(exponent:-2,below_horizon:Flip)";
    refused::<Glossy<LibmF32>>(gloss, Error::Exponent { value: -2.0 });
}

/// A misspelt name, and one too many.
#[test]
fn only_a_form_is_read() {
    for text in ["(columns:4,row:9)", "(columns:4,rows:9,seed:7)", "(columns:4)"] {
        assert!(ron::from_str::<Regular>(text).is_err(), "{text}");
    }
}
