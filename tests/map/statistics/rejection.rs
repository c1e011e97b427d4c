//! Rejection: the survivors are the candidates inside the disc, pi / 4 of them, uniform on it.

use hemidisc::{
    LibmF32,
    disc::Rejection,
    sequence::{Random, Regular, Sequence, SobolOwen},
};
use std::f64::consts::{FRAC_PI_4, TAU};
use testkit::arithmetics::Tested;
use testkit::chi_square::{assert_random, statistic};

const COUNT: u32 = 1 << 16;

/// 16 x 16 cells of the disc: angle and r^2.
fn counts<R: Into<f64>>(points: impl Iterator<Item = [R; 2]>) -> [u32; 256] {
    let mut counts = [0; 256];
    for point in points {
        let [x, y] = point.map(Into::into);
        let r2: f64 = x * x + y * y;
        assert!(r2 <= 1.0);
        let turn = (f64::atan2(y, x) / TAU).rem_euclid(1.0);
        let cell = |fraction: f64| ((fraction * 16.0) as usize).min(15);
        counts[cell(turn) * 16 + cell(r2)] += 1;
    }
    counts
}

fn survivors_are_uniform<A: Tested>() {
    for seed in [0, 1, 0xdead_beef] {
        let (random, scrambled) = (Random::new(seed), SobolOwen::new(seed));
        let what = |of: &str| format!("{of}, {}, seed {seed:#x}", A::NAME);

        let mut kept = Rejection::<A, _>::new((0..COUNT).map(|i| random.at(i)));
        assert_random(&counts(kept.by_ref()), &what("survivors"));
        let fraction = kept.kept() as f64 / f64::from(COUNT);
        assert_eq!(kept.drawn(), u64::from(COUNT));
        // Four standard deviations of a binomial count.
        let spread = (FRAC_PI_4 * (1.0 - FRAC_PI_4) / f64::from(COUNT)).sqrt();
        assert!((fraction - FRAC_PI_4).abs() < 4.0 * spread, "{}: {fraction}", what("kept"));

        // The last candidate of a limit is mapped wherever it lies, so every limit is uniform; 31
        // misses in a row do not happen, so with a limit of 32 all are survivors.
        for limit in [1, 2, 3, 32] {
            let mut kept = Rejection::<A, _>::with_limit(random.iter(0), limit).unwrap();
            let points = kept.by_ref().take(COUNT as usize);
            assert_random(&counts(points), &what(&format!("at most {limit} draws")));
            let lost = (1.0 - FRAC_PI_4).powi(limit as i32 - 1);
            let survivors = kept.kept() as f64 / f64::from(COUNT);
            assert!((survivors - (1.0 - lost)).abs() < 0.01, "{limit}: {survivors}");
        }
        let mut kept = Rejection::<A, _>::with_draws(random.iter(0), COUNT);
        assert_eq!(kept.by_ref().count() as u64, kept.kept());
        assert_eq!(kept.drawn(), u64::from(COUNT));

        // Even candidates leave even survivors (measured 11 to 13), but the rim cuts the strata.
        let mut kept = Rejection::<A, _>::new((0..COUNT).map(|i| scrambled.at(i)));
        let deviation = statistic(&counts(kept.by_ref()));
        let fraction = kept.kept() as f64 / f64::from(COUNT);
        assert!(deviation < 25.0, "{}: {deviation}", what("even survivors"));
        assert!((fraction - FRAC_PI_4).abs() < 3e-4, "{}: {fraction}", what("even kept"));
    }
}

testkit::test_each_arithmetic!(survivors_are_uniform);

/// The exact count of centres of a grid inside the disc: (2c + 1 - m)^2 + (2r + 1 - m)^2 <= m^2.
#[test]
fn survivors_of_a_grid_are_counted() {
    for m in [1_i64, 2, 3, 4, 10, 64, 255, 256] {
        let odd = |c: i64| (2 * c + 1 - m).pow(2);
        let inside = (0..m).flat_map(|c| (0..m).map(move |r| (c, r)));
        let expected = inside.filter(|&(c, r)| odd(c) + odd(r) <= m * m).count();
        let grid = Regular::new(m as u32, m as u32).unwrap();
        let mut kept = Rejection::<LibmF32, _>::new((0..(m * m) as u32).map(|i| grid.at(i)));
        assert_eq!(kept.by_ref().count(), expected, "{m} x {m}");
        assert_eq!((kept.drawn(), kept.kept()), ((m * m) as u64, expected as u64));
    }
}
