//! The heuristics of multiple importance sampling, and what is a delta distribution.

use super::{Float, assert_near, each_float};
use hemidisc::arithmetic::Real;
use hemidisc::effect::{
    BelowHorizon, DiscLight, Glossy, ThinLens, balance_heuristic, power_heuristic,
};
use hemidisc::{Concentric, Cosine, Frame, Power, Uniform};

/// p / (p + q) and p^2 / (p^2 + q^2), where f64 has the squares.
fn shares_are_those_of_the_formulas<A: Float>() {
    let sizes = [1e-12, 1e-3, 0.25, 1.0, 3.0, 1e4, 1e12];
    for p in sizes {
        for q in sizes {
            let (small, large) = (A::real(p), A::real(q));
            let balance: f64 = balance_heuristic(small, false, large).into();
            let power: f64 = power_heuristic(small, false, large).into();
            let (first, second) = (p / (p + q), p * p / (p * p + q * q));
            assert_near(balance / first, 1.0, 1e-6, "balance");
            // The least share is below the numbers of f32.
            let least = A::Real::MIN_POSITIVE.into();
            assert_near(power, second, 1e-6 * second + least, "power");
        }
    }
}

/// For any two numbers the share is in [0, 1], and the two shares of a direction add up to 1.
fn shares_are_total<A: Float>() {
    let zero = A::Real::ZERO;
    let least = A::Real::MIN_POSITIVE * A::Real::EPSILON;
    let numbers = [
        zero,
        -zero,
        least,
        A::Real::MIN_POSITIVE,
        A::Real::ONE,
        A::Real::MAX,
        A::Real::ONE / zero,
        A::real(f64::NAN),
        -A::Real::ONE,
    ];
    for heuristic in [balance_heuristic, power_heuristic] {
        for p in numbers {
            for q in numbers {
                let share: f64 = heuristic(p, false, q).into();
                assert!((0.0..=1.0).contains(&share), "{p:?} {q:?}: {share}");
                assert_eq!(heuristic(p, true, q), A::Real::ONE, "{p:?} {q:?}");
                if p > zero && q > zero {
                    let other: f64 = heuristic(q, false, p).into();
                    assert_near(share + other, 1.0, 1e-6, "together");
                }
            }
        }
        // The squares of these leave the range.
        let [most, least] = [A::Real::MAX, A::Real::MIN_POSITIVE];
        assert_eq!(heuristic(most, false, most), A::Real::HALF);
        assert_eq!(heuristic(least, false, least), A::Real::HALF);
        assert_eq!(heuristic(zero, false, zero), zero);
        assert_eq!(heuristic(A::Real::ONE, false, zero), A::Real::ONE);
    }
}

/// A point light in the power heuristic counts whole, where MAX^2 / MAX^2 is no number.
fn a_point_counts_whole<A: Float>() {
    let down = Frame::new(A::vector([0.0, 0.0, -1.0])).unwrap();
    let light = |radius| DiscLight::<A>::new(A::vector([0.0, 0.0, 2.0]), down, radius).unwrap();
    let lens = |radius| ThinLens::new(Concentric::<A>::new(), radius, A::Real::TWO).unwrap();
    let gloss = Glossy::<A>::new(A::parameter(1e8), BelowHorizon::Flip).unwrap();
    let point = light(A::Real::ZERO);
    let sample = point.sample(A::vector([0.0; 3]), [0, 0]);
    for other in [A::Real::ZERO, A::Real::ONE, A::Real::MAX] {
        let share = power_heuristic(sample.density, point.is_delta(), other);
        assert_eq!(share, A::Real::ONE);
    }
    // A radius whose square underflows is one that no direction hits.
    let tiny = A::Real::MIN_POSITIVE;
    for (radius, is_delta) in [(A::Real::ZERO, true), (tiny, true), (A::real(1e-3), false)] {
        assert_eq!((light(radius).is_delta(), lens(radius).is_delta()), (is_delta, is_delta));
    }
    assert!(!gloss.is_delta() && !Uniform::<A>::new().is_delta() && !Cosine::<A>::new().is_delta());
    assert!(!Power::<A>::new(A::parameter(1e30)).unwrap().is_delta());
}

each_float!(shares_are_those_of_the_formulas shares_are_total a_point_counts_whole);
