//! A sampler draws what its domain and index say, and its numbers are what their names promise.

use hemidisc::bits::hash::mix;
use hemidisc::sequence::{
    Correlated, GridSize, Halton, InDomain, Jittered, MultiJittered, R2, Random, Sequence, Shifted,
    Shuffled, Sobol, SobolOwen,
};
use hemidisc::{Domain, Error, FastF32, Sampler, UnitSquare, invariant};
use std::collections::HashSet;
use testkit::chi_square::assert_random;

fn pixel() -> Domain {
    Domain::new(7).pixel(3, 4)
}

#[test]
fn it_is_small_and_draws_by_domain_and_index() {
    assert_eq!(size_of::<Sampler>(), 12);
    assert_eq!(size_of::<Sampler<MultiJittered>>(), 16);
    for index in [0, 1, 63, 1 << 20, u32::MAX] {
        let sampler = Sampler::new(pixel(), index);
        assert_eq!((sampler.domain(), sampler.index()), (pixel(), index));
        let child = sampler.child(5);
        assert_eq!(child, Sampler::new(pixel().child(5), index));
        let expected = SobolOwen::in_domain(pixel().child(5)).at(index);
        assert_eq!(child.pair(), expected);
        assert_eq!(child.joint()[0], expected);
        let square = UnitSquare::<FastF32>::new();
        assert_eq!(child.sample(&square), square.sample(expected));
        assert_eq!(child.cell(), pixel().child(5).stream().at(index));
    }
}

/// A number is its cell, rounded down: also the last cell, which as an `f32` would be 2^32.
#[test]
fn numbers_are_below_1() {
    let samplers = (0..1 << 16).map(|i| Sampler::new(pixel(), i));
    for sampler in samplers {
        let cell = sampler.cell();
        assert_eq!(sampler.unit_f32(), (cell >> 8) as f32 / 16_777_216.0);
        assert_eq!(sampler.unit_f64(), f64::from(cell) / 4_294_967_296.0);
        assert_eq!(sampler.choose(10), ((u64::from(cell) * 10) >> 32) as u32);
        assert_eq!(sampler.choose(0), 0);
        assert_eq!(sampler.chance(0.25), cell < 1 << 30);
        assert!(sampler.chance(1.0) && sampler.chance(f32::INFINITY));
        assert!(!sampler.chance(0.0) && !sampler.chance(-1.0) && !sampler.chance(f32::NAN));
        let (chosen, rest) = sampler.pick(&[1_u32, 4]).unwrap();
        assert_eq!(chosen, usize::from(cell >= 1 << 30), "{cell:#x}");
        let (again, place) = sampler.pick(&[0.25_f32, 1.0]).unwrap();
        assert_eq!(again, usize::from(cell >= 1 << 30));
        let expected =
            if again == 0 { u64::from(cell) * 4 } else { (u64::from(cell) - (1 << 30)) * 4 / 3 };
        assert!(u64::from(place).abs_diff(expected) <= 4, "{place:#x} {expected:#x}");
        assert!(chosen < 2 && (rest as u64) < 1 << 32);
    }
    assert_eq!(Sampler::new(pixel(), 0).pick::<f32>(&[]), None);
    // The index of the greatest cell: scrambles are bijections.
    let stream = pixel().stream();
    let last = (0..=u32::MAX).step_by(1 << 8).map(|i| stream.at(i)).max().unwrap();
    assert!(last > u32::MAX - (1 << 10));
}

/// The branches of all samples are one sequence, past 2^32 branches too.
#[test]
fn branches_are_one_sequence() {
    let split = pixel().split(5, 4);
    for index in 0..100 {
        let branches = Sampler::new(pixel(), index).split(5, 4);
        let expected = split.branches(index).unwrap();
        let expected = expected.map(|branch| Sampler::new(split.domain(), branch));
        assert!(branches.eq(expected), "{index}");
    }
    assert_eq!(Sampler::new(pixel(), 5).split(5, 0).count(), 0);
    let mut seen = HashSet::new();
    for index in [0, 1, (1 << 30) - 1, 1 << 30, (1 << 30) + 1, u32::MAX] {
        for branch in Sampler::new(pixel(), index).split(5, 4) {
            assert!(seen.insert((branch.domain(), branch.index())), "{index}");
        }
    }
    let far: Vec<_> = Sampler::new(pixel(), u32::MAX).split(5, u32::MAX).take(2).collect();
    assert_eq!(far[0].domain(), far[1].domain());
    assert_ne!(far[0].pair(), far[1].pair());
}

/// What every family promises: pairs of two children are independent, and their numbers and second
/// pairs are none of the first.
fn independent<S: InDomain>(size: S::Size, what: &str) {
    let mut counts = [[0; 256]; 5];
    let cell = |a: u32, b: u32| (a >> 28 << 4 | b >> 28) as usize;
    for i in 0..1 << 16 {
        let (key, index) = (i >> 4, i & 15);
        let sampler = Sampler::<S>::of(Domain::new(7).child(key), size, index);
        let ([a, b], [[c, _], [d, _]]) = (sampler.pair(), sampler.child(1).joint());
        let [[e, _], [f, g]] = sampler.joint();
        assert_eq!(e, a);
        for (counts, place) in counts.iter_mut().zip([
            cell(a, c),
            cell(b, c),
            cell(a, sampler.cell()),
            cell(a, f ^ g),
            cell(c, d),
        ]) {
            counts[place] += 1;
        }
    }
    for (place, counts) in counts.iter().enumerate() {
        // Within a domain the numbers are more even than random ones.
        let statistic = testkit::chi_square::statistic(counts);
        assert!(statistic < 400.0, "{what}, {place}: {statistic}");
    }
}

#[test]
fn children_of_every_family_are_independent() -> Result<(), Error> {
    let grid = GridSize::new(4, 4)?;
    independent::<SobolOwen>((), "sobol-owen");
    independent::<Random>((), "random");
    independent::<R2>((), "r2");
    independent::<Halton>((), "halton");
    independent::<Jittered>(grid, "jittered");
    independent::<MultiJittered>(grid, "multi-jittered");
    independent::<Correlated>(grid, "correlated");
    Ok(())
}

/// The members of a family keep the promise of their sequence.
#[test]
fn members_keep_their_strata() -> Result<(), Error> {
    for seed in 0..50 {
        let domain = Domain::new(seed);
        let size = GridSize::new(4, 8)?;
        assert_eq!([size.columns(), size.rows()], [4, 8]);
        let set = MultiJittered::in_domain(domain, size);
        assert_eq!(set.size(), Some(32));
        invariant::cells(&set, 0, [4, 8], &mut [0; 1]).unwrap();
        invariant::cells(&set, 0, [32, 1], &mut [0; 1]).unwrap();
        let halton = Halton::in_domain(domain, ());
        // A shift moves at most one point across each border.
        let mut counts = [0; 64];
        for i in 0..64 {
            counts[(halton.at(i)[0] >> 26) as usize] += 1;
        }
        assert!(counts.iter().all(|count| *count == 1), "{counts:?}");
        let shifted = Shifted::new(Sobol::new(0), domain);
        let shuffled = Shuffled::new(shifted, domain);
        assert_eq!(shuffled.sequence(), &shifted);
    }
    for (columns, rows) in [(0, 4), (4, 0), (65_536, 1), (1, u32::MAX)] {
        let error = GridSize::new(columns, rows).unwrap_err().to_string();
        assert!(error.contains(&format!("{columns} x {rows}")), "{error}");
    }
    assert_eq!(GridSize::new(65_535, 65_535)?.columns(), 65_535);
    Ok(())
}

/// The wrong guess of an index: a domain for each sample. It is as noisy as random numbers, and the
/// right one is not.
#[test]
fn samples_of_a_pixel_are_even() {
    let inside = |[u, v]: [u32; 2]| {
        let [x, y] = [u, v].map(|cell| f64::from(cell) / 4_294_967_296.0);
        f64::from(u8::from(x * 0.7 + y < 0.9))
    };
    let error = |draw: &dyn Fn(Domain, u32) -> Sampler| {
        let squares = (0..500).map(|key| {
            let pixel = Domain::new(7).child(key);
            let sum: f64 = (0..64).map(|i| inside(draw(pixel, i).pair())).sum();
            (sum / 64.0 - 0.55).powi(2)
        });
        (squares.sum::<f64>() / 500.0).sqrt()
    };
    let right = error(&|pixel, i| Sampler::new(pixel, i).child(1));
    let wrong = error(&|pixel, i| Sampler::new(pixel.child(i), 0).child(1));
    assert!(right < 0.3 * wrong, "{right} {wrong}");
    // That of random numbers, sqrt(0.55 0.45 / 64).
    assert!((wrong / 0.062 - 1.0).abs() < 0.15, "{wrong}");
}

/// The joint four: the first 2^m points of every aligned block have 2^3 in each of the boxes of
/// volume 2^(3 - m), for Sobol and scrambled.
#[test]
fn four_dimensions_are_even_together() {
    let joint = |seed: u32, index: u32| -> [u32; 4] {
        let [[u, v], [w, x]] = match seed {
            0 => Sobol::new(0).joint(index),
            1 => Sobol::new(mix(9)).joint(index),
            seed => SobolOwen::new(seed).joint(index),
        };
        [u, v, w, x]
    };
    for (seed, start) in [(0, 0), (1, 256), (2, 0), (3, 1 << 20), (4, u32::MAX - 255)] {
        let points: Vec<_> = (0..256).map(|i| joint(seed, start + i)).collect();
        // Shapes of 2^5 boxes: 8 points of 256 in each.
        for a in 0..=5 {
            for b in 0..=5 - a {
                for c in 0..=5 - a - b {
                    let bits = [a, b, c, 5 - a - b - c];
                    let mut counts = [0; 32];
                    for point in &points {
                        let place = point.iter().zip(bits).fold(0, |place, (cell, bits)| {
                            place << bits | ((u64::from(*cell) << bits) >> 32) as usize
                        });
                        counts[place] += 1;
                    }
                    assert_eq!(counts, [8; 32], "seed {seed}, {bits:?}");
                }
            }
        }
    }
}

/// The scrambles of the four dimensions are independent.
#[test]
fn the_second_pair_has_keys_of_its_own() {
    let mut counts = [[0; 256]; 6];
    for seed in 0..1 << 14 {
        let [[u, v], [w, x]] = SobolOwen::new(seed).joint(0);
        let pairs = [(u, v), (u, w), (u, x), (v, w), (v, x), (w, x)];
        for (counts, (a, b)) in counts.iter_mut().zip(pairs) {
            counts[(a >> 28 << 4 | b >> 28) as usize] += 1;
        }
    }
    for counts in counts {
        assert_random(&counts, "pairs of the first four-dimensional points");
    }
}

/// The share of the cube [0, 1]^4 where the sum of weights times coordinates is below c, exactly: a sum
/// over the corners (D. Barrow and P. Smith, "Spline Notation Applied to a Volume Problem", The
/// American Mathematical Monthly 86(1), 1979).
fn share_below(weights: [f64; 4], c: f64) -> f64 {
    // A coordinate with a negative weight is counted from its other end.
    let c = c - weights.iter().filter(|weight| **weight < 0.0).sum::<f64>();
    let weights = weights.map(f64::abs);
    let corners = (0..16_u32).map(|corner| {
        let at: f64 = (0..4).filter(|axis| corner >> axis & 1 == 1).map(|axis| weights[axis]).sum();
        let sign = if corner.count_ones() % 2 == 0 { 1.0 } else { -1.0 };
        sign * (c - at).max(0.0).powi(4)
    });
    corners.sum::<f64>() / (24.0 * weights.iter().product::<f64>())
}

/// The edge of an object out of focus is a half-space of pixel and lens: 3000 of them, each in a pixel
/// of its own. Two pairs of different domains have 1.1, 1.25 and 1.4 times the error of a joint four
/// at 16, 64 and 256 samples, or more.
#[test]
fn a_joint_four_has_less_error_on_edges_out_of_focus() {
    use std::f64::consts::TAU;
    for (samples, least) in [(16, 1.1), (64, 1.25), (256, 1.4)] {
        let [mut joint, mut padded] = [0.0; 2];
        for trial in 0..3000 {
            let number = |key: u32| f64::from(mix(8 * trial + key)) / 4_294_967_296.0;
            let [(a, b), (c, d)] = [0, 1].map(|key| (TAU * number(key)).sin_cos());
            let blur = 0.2 + 1.3 * number(2);
            let weights = [a, b, blur * c, blur * d];
            // With less the sum over corners would cancel.
            if weights.iter().any(|weight| weight.abs() < 0.02) {
                continue;
            }
            let edge = 0.6 * number(3) - 0.3 + weights.iter().sum::<f64>() / 2.0;
            let exact = share_below(weights, edge);
            let domain = Domain::new(9).child(trial);
            let error = |draw: &dyn Fn(Sampler) -> [[u32; 2]; 2]| {
                let below = (0..samples).filter(|index| {
                    let [[x, y], [u, v]] = draw(Sampler::new(domain, *index));
                    let place = [x, y, u, v].map(|cell| (f64::from(cell) + 0.5) / 4_294_967_296.0);
                    weights.iter().zip(place).map(|(weight, x)| weight * x).sum::<f64>() < edge
                });
                (below.count() as f64 / f64::from(samples) - exact).powi(2)
            };
            joint += error(&Sampler::joint);
            padded += error(&|sampler| [0, 1].map(|key| sampler.child(key).pair()));
        }
        let ratio = (padded / joint).sqrt();
        println!("{samples} samples: two pairs have {ratio:.3} times the error of a joint four");
        assert!(ratio >= least, "{samples}: {ratio}");
    }
}
