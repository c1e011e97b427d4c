//! That the sources sample the same distributions, and what this crate's are worth.

use crate::arguments::{Arguments, one_line};
use crate::measure::{Measured, SOURCES, sources};
use crate::path::View;
use crate::picture::{Picture, render, side_by_side};
use crate::report::Report;
use crate::source::{Blocks, Formulas, OneByOne, Rejection, Request, Source};
use crate::vector::{difference, dot, scaled};
use clap::Parser;

const SMALL: [u32; 2] = [48, 32];

fn picture(source: usize, seed: u32, samples: u32) -> Picture {
    render(&View::new(SMALL), SOURCES[source].1, seed, samples, &mut || ()).unwrap()
}

/// Means over all that a path may draw, and what they should be.
fn moments<S: Source>() -> Vec<[f64; 2]> {
    const COUNT: u32 = 1 << 14;
    let normal = [0.48, -0.6, 0.64];
    let mut source = S::new(&Request::new(3, [1, 1], COUNT).unwrap());
    source.pixel(0, 0);
    let mut sums = [[0.0, 0.0]; 17];
    for sample in 0..COUNT {
        let [[x, y], lens] = source.begin(sample);
        source.bounce();
        let lobe = source.lambert(normal);
        let height = dot(lobe, normal);
        let across = difference(lobe, scaled(height, normal));
        source.bounce();
        let ball = source.ball();
        source.bounce();
        let chance = f32::from(u8::from(source.chance(0.3)));
        let values = [
            [x, 1.0 / 2.0],
            [y, 1.0 / 2.0],
            [x * x, 1.0 / 3.0],
            [x * y, 1.0 / 4.0],
            [lens[0], 0.0],
            [lens[1], 0.0],
            [lens[0] * lens[0], 1.0 / 4.0],
            [lens[1] * lens[1], 1.0 / 4.0],
            [height, 2.0 / 3.0],
            [height * height, 1.0 / 2.0],
            [across[0], 0.0],
            [across[2], 0.0],
            [ball[0] + ball[1], 0.0],
            [ball[2], 0.0],
            [ball[2] * ball[2], 1.0 / 5.0],
            [dot(ball, ball), 3.0 / 5.0],
            [chance, 0.3],
        ];
        for (sum, [value, expected]) in sums.iter_mut().zip(values) {
            *sum = [sum[0] + f64::from(value) / f64::from(COUNT), f64::from(expected)];
        }
    }
    sums.to_vec()
}

/// Within five times the largest standard deviation that a mean of so many can have.
#[test]
fn sources_have_the_same_distributions() {
    let each =
        [moments::<Rejection>(), moments::<Formulas>(), moments::<OneByOne>(), moments::<Blocks>()];
    for (moments, (source, _)) in each.iter().zip(SOURCES) {
        for (at, [mean, expected]) in moments.iter().enumerate() {
            assert!((mean - expected).abs() < 0.02, "{source}, {at}: {mean}, not {expected}");
        }
    }
}

/// A pixel's standard deviation is 0.1 at a sample, and the mean's here 0.0002.
#[test]
fn pictures_have_the_same_mean() {
    let mean = |source| {
        let picture = picture(source, 1, 128);
        let pixels = picture.iter().flatten();
        let sum = pixels.fold([0.0; 3], |sum, pixel| [0, 1, 2].map(|i| sum[i] + pixel[i]));
        sum.map(|sum| sum / f64::from(SMALL[0] * SMALL[1]))
    };
    let expected = mean(0);
    for (source, (name, _)) in SOURCES.iter().enumerate() {
        for (found, expected) in mean(source).into_iter().zip(expected) {
            assert!((found - expected).abs() < 0.001, "{name}: {found}, not {expected}");
        }
    }
}

#[test]
fn paths_are_deterministic() {
    for source in 0..SOURCES.len() {
        assert_eq!(picture(source, 1, 2), picture(source, 1, 2));
        assert_ne!(picture(source, 1, 2), picture(source, 2, 2));
    }
}

#[test]
fn blocks_have_the_bits_of_one_by_one() {
    for samples in [1, 3, 16, 70] {
        assert_eq!(picture(2, 1, samples), picture(3, 1, samples), "{samples}");
    }
}

#[test]
fn points_are_worth_more_than_random_samples() {
    let view = View::new(SMALL);
    let reference = picture(3, 9, 1024);
    let [rejection, formulas, _, blocks] =
        sources(&view, 16, &reference, &mut || ()).unwrap().map(|measured| measured.error);
    let random = rejection / formulas;
    assert!((0.9..1.1).contains(&random), "{rejection}, {formulas}");
    let gain = rejection / blocks;
    assert!((1.25..2.0).contains(&gain), "{rejection}, {blocks}");
}

#[test]
fn rows_are_relative_to_random_numbers() {
    let measured = [(100.0, 0.2), (80.0, 0.25), (120.0, 0.1), (88.0, 0.1)]
        .map(|(nanoseconds, error)| Measured { nanoseconds, error });
    let mut report = Report::new();
    report.add(10, &measured);
    let rows = report.rows.iter();
    let found: Vec<_> = rows.map(|row| (row.time, row.met)).collect();
    assert_eq!(found, [(1.25, None), (1.0, None), (1.5, Some(false)), (1.1, Some(true))]);
    assert_eq!(report.rows[3].worth, 4.0);
    assert!(report.table().contains("not met"));
}

#[test]
fn pictures_are_side_by_side() {
    let view = View::new([11, 3]);
    let of = |light| vec![[[light; 3]; 64]; view.tiles().len()];
    let (size, pixels) = side_by_side(&view, &[of(0.0), of(0.5)]);
    assert_eq!((size, pixels.len()), ([26, 3], 78));
    for row in pixels.chunks(26) {
        assert_eq!(row[..11], [[0.0; 3]; 11]);
        assert_eq!(row[11..15], [[1.0; 3]; 4]);
        assert_eq!(row[15..], [[0.5; 3]; 11]);
    }
}

#[test]
fn refusals_are_one_line() {
    let refused = |arguments: &str| {
        let arguments = arguments.split_whitespace();
        Arguments::try_parse_from(["weekend"].into_iter().chain(arguments)).err().unwrap()
    };
    for (arguments, expected) in [
        ("--width 0", "--width: \"0\": 0 is not in 1..=2048; accepted: an integer 1..=2048"),
        ("--samples -1", "--samples: \"-1\": -1 is not in 1..=1024; accepted: an integer 1..=1024"),
        ("--out", "--out: no value; accepted: the path of a directory"),
        ("--seed 3", "\"--seed\": unknown argument; accepted: --width, --height, --samples, --out"),
    ] {
        assert_eq!(one_line(&refused(arguments)), expected);
    }
}
