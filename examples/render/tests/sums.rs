//! Sums in fixed point: exact units, rounding, order, and what is out of range.

use examples::render::sums::{MOST_PASSES, Sum, means};

const UNIT: f64 = 1.0 / 4_294_967_296.0;
const LIMIT: f64 = 262_144.0;

fn of_passes(passes: &[f64]) -> Sum {
    let mut sum = Sum::default();
    passes.iter().for_each(|pass| sum += Sum::of_pass([*pass; 3]));
    sum
}

#[track_caller]
fn mean(passes: &[f64], samples: u32) -> f64 {
    let means = means(&[of_passes(passes)], samples);
    assert_eq!(means[0], [means[0][0]; 3]);
    means[0][0]
}

#[test]
fn a_pass_is_rounded_to_the_nearest_unit() {
    let cases = [
        (0.0, 0),
        (-0.0, 0),
        (UNIT, 1),
        (0.5 * UNIT, 1),
        (0.499 * UNIT, 0),
        (1.5 * UNIT, 2),
        (-0.5 * UNIT, -1),
        (-2.25 * UNIT, -2),
        (1.0, 1 << 32),
        (1e-300, 0),
    ];
    for (pass, units) in cases {
        assert_eq!(Sum::of_pass([pass; 3]).0, [units; 3], "{pass}");
    }
    assert_eq!(Sum::of_pass([0.1_f32, 0.0, 1.0]).0, [429_496_736, 0, 1 << 32]);
}

#[test]
fn passes_add_up_in_any_order() {
    let passes = [0.1, 0.2, 0.3, 1e5, 3e-9, -2e-7, 0.7];
    let sum = of_passes(&passes);
    let mut turned = passes;
    let mut floats = Vec::new();
    for _ in 0..passes.len() {
        turned.rotate_left(1);
        floats.push(turned.iter().map(|pass| *pass as f32).sum::<f32>());
        assert_eq!(of_passes(&turned), sum);
        let (left, right) = turned.split_at(2);
        let mut in_parts = of_passes(right);
        in_parts += of_passes(left);
        assert_eq!(in_parts, sum);
    }
    assert!(floats.iter().any(|sum| *sum != floats[0]), "floats would do: {floats:?}");
}

#[test]
fn a_mean_is_the_sum_over_the_samples() {
    assert_eq!(mean(&[2.0, 0.25, 0.75], 24), 0.125);
    assert_eq!(mean(&[], 8), 0.0);
}

#[test]
fn what_is_out_of_range_is_infinite_whatever_is_added() {
    for pass in [LIMIT, -LIMIT, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        for passes in [&[pass][..], &[pass, 1.0], &[1.0, pass], &[-1.0, pass], &[pass, pass]] {
            assert_eq!(mean(passes, 8), f64::INFINITY, "{passes:?}");
        }
    }
    assert_eq!(mean(&[LIMIT - 1.0], 8), (LIMIT - 1.0) / 8.0);
}

#[test]
fn the_brightest_passes_fit() {
    let largest = LIMIT - UNIT;
    for pass in [largest, -largest] {
        let mut sum = Sum::default();
        (0..MOST_PASSES).for_each(|_| sum += Sum::of_pass([pass; 3]));
        let units = i64::from(MOST_PASSES) * ((1 << 50) - 1);
        assert_eq!(sum.0, [if pass > 0.0 { units } else { -units }; 3]);
    }
}
