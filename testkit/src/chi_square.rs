//! Pearson's chi-square test of counts in equally likely cells.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Sum of (count - expected)^2 / expected over equally likely cells.
pub fn statistic(counts: &[u32]) -> f64 {
    let total: f64 = counts.iter().map(|&count| f64::from(count)).sum();
    let expected = total / counts.len() as f64;
    counts.iter().map(|&count| (f64::from(count) - expected).powi(2) / expected).sum()
}

/// The probability that independent uniform draws deviate at least as much.
pub fn p_value(counts: &[u32]) -> f64 {
    let freedom = (counts.len() - 1) as f64;
    ChiSquared::new(freedom).unwrap().sf(statistic(counts))
}

/// Fails unless the counts look random: neither too uneven nor too even.
///
/// All seeds are fixed, so the bounds are far out: what they catch is gross, and stays caught.
pub fn assert_random(counts: &[u32], what: &str) {
    let p = p_value(counts);
    assert!((1e-6..=1.0 - 1e-9).contains(&p), "{what}: p = {p:e} for {counts:?}");
}

/// Fails if the counts are too uneven.
///
/// For tests of few cells, where evenness is no sign of a fault.
pub fn assert_uniform(counts: &[u32], what: &str) {
    let p = p_value(counts);
    assert!((1e-6..=1.0).contains(&p), "{what}: p = {p:e} for {counts:?}");
}
