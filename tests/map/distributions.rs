//! With `rand`'s prelude and `Map` both in scope `sample` means the map's: a dependency that turns
//! the feature `rand` on breaks no build. This file compiles, or it fails.

use hemidisc::effect::Polygon;
use hemidisc::frame::About;
use hemidisc::sequence::SobolOwen;
use hemidisc::{
    Concentric, Cosine, Density, FastF32, Frame, Map, Points, Polar, Power, Uniform, UnitSquare,
};
use rand::prelude::*;
use rand::rngs::SmallRng;

const UV: [u32; 2] = [0x1234_5678, 0x9abc_def0];

/// A map of a user's own, in a function of a user's own.
#[derive(Clone, Copy)]
struct Halved<M>(M);

impl<M: Map<Point = [f32; 2]>> Map for Halved<M> {
    type Point = [f32; 2];

    fn sample(&self, uv: [u32; 2]) -> [f32; 2] {
        self.0.sample(uv).map(|x| x / 2.0)
    }
}

fn generic<M: Map>(map: M) -> M::Point {
    map.sample(UV)
}

fn generic_with_density<M: Density>(map: &M) -> M::Point {
    map.sample_with_density(UV).0
}

/// By value, by reference, through a field, generic, and drawn by a generator: one point.
macro_rules! one_point {
    ($($map:expr),* $(,)?) => {$({
        let map = $map;
        let point = map.sample(UV);
        assert_eq!((&map).sample(UV), point);
        assert_eq!(Points::new(SobolOwen::new(1), map).map().sample(UV), point);
        assert_eq!(generic(map), point);
        assert_eq!(generic_with_density(&map), point);
        let mut words = SmallRng::seed_from_u64(7);
        let uv = [words.next_u32(), words.next_u32()];
        let mut rng = SmallRng::seed_from_u64(7);
        assert_eq!(rng.sample(map), map.sample(uv));
        assert_eq!(rng, words);
        assert_eq!(SmallRng::seed_from_u64(7).sample_iter(map).next(), Some(map.sample(uv)));
    })*};
}

#[test]
fn sample_is_the_maps_beside_rands_prelude() {
    let frame = Frame::from_normal([0.6_f32, 0.0, -0.8]);
    let power = Power::<FastF32>::new(50.0).unwrap();
    one_point!(
        UnitSquare::<FastF32>::new(),
        Concentric::<FastF32>::new(),
        Polar::<FastF32>::new(),
        Uniform::<FastF32>::new(),
        Cosine::over(Polar::<FastF32>::new()),
        power,
        power.about(frame),
        About::new(Uniform::<FastF32>::new(), frame),
        Polygon::<FastF32, 5>::new(0),
    );
    let own = Halved(Concentric::<FastF32>::new());
    assert_eq!(own.sample(UV), generic(own));
    #[cfg(feature = "fixed-point")]
    one_point!(Concentric::<hemidisc::Q15>::new(), Cosine::<hemidisc::Q31>::new());
}
