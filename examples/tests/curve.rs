//! Curves of the gallery: what thinning and cutting leave of them.

use examples::gallery::curve::{chord, clipped, thin};
use std::f64::consts::TAU;

#[test]
fn thinning_keeps_corners_and_curves() {
    let tolerance = 1e-3;
    let straight: Vec<_> = (0..=10).map(|k| [f64::from(k), 2.0 * f64::from(k)]).collect();
    assert_eq!(thin(&straight, tolerance), [[0.0, 0.0], [10.0, 20.0]]);
    let bent = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]];
    assert_eq!(thin(&bent, tolerance), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0]]);
    // A chord of an angle a is a^2 / 8 off its arc: one radian takes 1 / sqrt(8 h) of them.
    let arc: Vec<_> = (0..=1000).map(|k| (f64::from(k) / 1000.0).sin_cos().into()).collect();
    let chords = (thin(&arc, tolerance).len() - 1) as f64;
    let wanted = 1.0 / (8.0 * tolerance).sqrt();
    assert!((wanted..wanted + 2.0).contains(&chords), "{chords}, about {wanted}");
}

#[test]
fn chords_end_on_the_circle() {
    let cut = [
        ([-2.0, 0.6], [2.0, 0.6], [[-0.8, 0.6], [0.8, 0.6]]),
        ([0.0, 0.0], [0.0, 2.0], [[0.0, 0.0], [0.0, 1.0]]),
        ([0.5, 0.0], [0.0, 0.5], [[0.5, 0.0], [0.0, 0.5]]),
    ];
    for (from, to, wanted) in cut {
        let got = chord(from, to).unwrap();
        let near = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-12;
        assert!(got.as_flattened().iter().zip(wanted.as_flattened()).all(near), "{got:?}");
    }
    assert_eq!(chord([-2.0, 1.5], [2.0, 1.5]), None);
    assert_eq!(chord([2.0, 0.0], [3.0, 0.0]), None);
    assert_eq!(chord([0.5, 0.5], [0.5, 0.5]), None);
}

#[test]
fn clipping_a_square_leaves_the_disc() {
    let square = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let disc = clipped(&square);
    let sides = disc.iter().zip(disc.iter().cycle().skip(1));
    let area: f64 = sides.map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0])).sum();
    // 180 tangents enclose 180 tan(pi / 180).
    let wanted = 180.0 * (TAU / 360.0).tan();
    assert!((area - wanted).abs() < 1e-9, "{area}, wanted {wanted}");
    let inner = square.map(|corner| corner.map(|k| 0.5 * k));
    assert_eq!(clipped(&inner), inner);
    assert!(clipped(&square.map(|[x, y]| [x + 3.0, y])).is_empty());
}
