//! The peers: `rand_distr`'s disc and sphere on xoshiro128++, `sobol_burley`, the textbooks'
//! formulas on std's and glibc's f32 functions, and `slice::fill`, the least that a fill can cost.

use crate::buffers::{Coordinates, Visitor};
use benches::EXPONENT;
use benches::functions::Std;
use benches::random::{SEED, generator};
use rand_distr::{Distribution, UnitDisc, UnitSphere};
use rand_xoshiro::rand_core::Rng;
use std::hint::black_box;
use testkit::textbook::{
    pbrt_concentric, pbrt_cosine, pbrt_polar, pbrt_uniform, suffern_concentric, suffern_power, unit,
};

/// `sobol_burley` has as many points.
const BURLEY: u32 = 1 << 16;

/// What a map is compared with, on one disc map or on any (`-`); and a sequence.
const OF: [(&str, &str, &str); 16] = [
    ("sequence", "-", "peer/sequence/-/xoshiro128++"),
    ("sequence", "-", "peer/square/-/sobol_burley"),
    ("square", "-", "peer/square/-/slice-fill"),
    ("square", "-", "peer/square/-/sobol_burley"),
    ("square", "-", "peer/square/-/sobol_burley-4d"),
    ("disc", "-", "peer/disc/-/rand_distr"),
    ("disc", "concentric", "peer/disc/concentric/pbrt"),
    ("disc", "concentric", "peer/disc/concentric/suffern"),
    ("disc", "polar", "peer/disc/polar/pbrt"),
    ("uniform", "-", "peer/uniform/-/rand_distr"),
    ("uniform", "-", "peer/uniform/-/pbrt"),
    ("cosine", "-", "peer/uniform/-/rand_distr"),
    ("cosine", "-", "peer/cosine/concentric/pbrt"),
    ("power", "-", "peer/uniform/-/rand_distr"),
    ("power", "-", "peer/power/polar/suffern"),
    ("power", "-", "peer/power/polar/suffern-libm-powf"),
];

/// The paths that a fill is compared with: the same map on libm's f32, and the peers.
pub(crate) fn of(path: &str) -> Vec<String> {
    let parts: Vec<_> = path.split('/').collect();
    let (map, disc, libm) = match parts[..] {
        ["map", map, disc, _] => (map, disc, Some(format!("map/{map}/{disc}/libm-f32"))),
        ["fused", "sobol", map, disc, _] => {
            (map, disc, Some(format!("fused/sobol/{map}/{disc}/libm-f32")))
        }
        ["fused", _, map, disc, _] => (map, disc, None),
        ["sequence", _] => ("sequence", "-", None),
        // The plain fill of the same map.
        ["apart" | "turned", map, disc, arithmetic] => {
            return vec![format!("map/{map}/{disc}/{arithmetic}")];
        }
        _ => return Vec::new(),
    };
    let same = OF.into_iter().filter(|(of, on, _)| *of == map && (*on == "-" || *on == disc));
    libm.into_iter().chain(same.map(|(.., peer)| peer.to_owned())).collect()
}

pub(crate) fn every<'a>(
    coordinates: &'a Coordinates,
    points: usize,
    visitor: &mut impl Visitor<'a>,
) {
    formulas(coordinates, points, visitor);

    let mut rng = generator(points);
    drawn(visitor, "sequence/-/xoshiro128++", points, move |_| [rng.next_u32(), rng.next_u32()]);
    let mut rng = generator(points);
    drawn(visitor, "disc/-/rand_distr", points, move |_| -> [f32; 2] { UnitDisc.sample(&mut rng) });
    let mut rng = generator(points);
    let sphere = move |_| -> [f32; 3] { UnitSphere.sample(&mut rng) };
    drawn(visitor, "uniform/-/rand_distr", points, sphere);

    let burley = |index| {
        let sample = |axis| sobol_burley::sample(index % BURLEY, axis, SEED);
        [sample(0), sample(1)]
    };
    drawn(visitor, "square/-/sobol_burley", points, burley);
    // All four dimensions of a set at once, of which two are kept.
    let burley = |index| {
        let [u, v, ..] = sobol_burley::sample_4d(index % BURLEY, 0, SEED);
        [u, v]
    };
    drawn(visitor, "square/-/sobol_burley-4d", points, burley);

    visitor.fill("peer/square/-/slice-fill", || {
        let mut buffer = vec![[0.0_f32; 2]; points];
        move || black_box(&mut buffer).fill(black_box([0.25, 0.75]))
    });
}

fn formulas<'a>(coordinates: &'a Coordinates, points: usize, visitor: &mut impl Visitor<'a>) {
    let mut peers = Formulas { coordinates, points, visitor };
    peers.fill("disc/concentric/pbrt", pbrt_concentric::<Std>);
    peers.fill("disc/concentric/suffern", suffern_concentric::<Std>);
    peers.fill("disc/polar/pbrt", pbrt_polar::<Std>);
    peers.fill("uniform/-/pbrt", pbrt_uniform::<Std>);
    peers.fill("cosine/concentric/pbrt", pbrt_cosine::<Std>);
    peers.fill("power/polar/suffern", |uv| suffern_power::<Std>(EXPONENT, uv));
    peers.fill("power/polar/suffern-libm-powf", |uv| suffern_power::<Std<true>>(EXPONENT, uv));
}

struct Formulas<'a, 'v, V> {
    coordinates: &'a Coordinates,
    points: usize,
    visitor: &'v mut V,
}

impl<'a, V: Visitor<'a>> Formulas<'a, '_, V> {
    /// Points of stored coordinates by a formula.
    fn fill<P: Copy + Default + 'a>(&mut self, name: &str, formula: impl Fn([f32; 2]) -> P + 'a) {
        #[inline(never)]
        fn fill<P>(stored: &[[u32; 2]], buffer: &mut [P], formula: impl Fn([f32; 2]) -> P) {
            for (slot, uv) in buffer.iter_mut().zip(stored) {
                *slot = formula(uv.map(unit));
            }
        }
        self.visitor.fill(&format!("peer/{name}"), || {
            let stored = self.coordinates.windows(self.points);
            let mut windows = stored.chunks_exact(self.points).cycle();
            let mut buffer = vec![P::default(); self.points];
            move || {
                if let Some(stored) = windows.next() {
                    fill(black_box(stored), black_box(&mut buffer), &formula);
                }
            }
        });
    }
}

/// Points that are drawn, by index or from a generator.
fn drawn<'a, P: Copy + Default + 'a>(
    visitor: &mut impl Visitor<'a>,
    name: &str,
    points: usize,
    mut draw: impl FnMut(u32) -> P + 'a,
) {
    #[inline(never)]
    fn fill<P>(buffer: &mut [P], mut draw: impl FnMut(u32) -> P) {
        for (slot, index) in buffer.iter_mut().zip(0..) {
            *slot = draw(index);
        }
    }
    visitor.fill(&format!("peer/{name}"), || {
        let mut buffer = vec![P::default(); points];
        move || fill(black_box(&mut buffer), &mut draw)
    });
}
