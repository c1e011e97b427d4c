//! A screen's pixels: each has a net, so has each block of them, and what cannot be is refused.

use hemidisc::invariant::consistent;
use hemidisc::{Domain, Error, Map, Points, Sampler, Screen};
use std::collections::HashSet;

/// The strata of u that points hit, of as many as there are points.
fn strata(points: impl ExactSizeIterator<Item = u32>) -> usize {
    let count = points.len() as u64;
    let hit: HashSet<_> = points.map(|cell| (u64::from(cell) * count) >> 32).collect();
    hit.len()
}

#[test]
fn pixels_and_blocks_of_pixels_are_nets() -> Result<(), Error> {
    let screen = Screen::new(Domain::new(7), [64, 48], 16)?;
    assert_eq!((screen.size(), screen.samples(), screen.domain()), ([64, 48], 16, Domain::new(7)));
    for (x, y) in [(0, 0), (8, 40), (56, 32)] {
        let pixel = screen.pixel(x, y)?;
        for log2 in 0..=4 {
            let samples: Vec<_> = (0..1 << log2).map(|i| pixel.sampler(i).child(1)).collect();
            let axes =
                [0, 1].map(|axis| strata(samples.iter().map(|sampler| sampler.pair()[axis])));
            assert_eq!(axes, [1 << log2; 2], "{x} {y}");
        }
        // A block of 8 x 8 pixels is a net of 1024 points.
        let mut points = Vec::new();
        for (dx, dy) in (0..64).map(|i| (i & 7, i >> 3)) {
            let pixel = screen.pixel(x + dx, y + dy)?;
            points.extend((0..16).map(|i| pixel.sampler(i).child(1).pair()));
        }
        let axes = [0, 1].map(|axis| strata(points.iter().map(|pair| pair[axis])));
        assert_eq!(axes, [1024; 2], "{x} {y}");
        let cells: HashSet<_> = points.iter().map(|[u, v]| (u >> 27, v >> 27)).collect();
        assert_eq!(cells.len(), 1024, "{x} {y}");
    }
    Ok(())
}

/// The coordinates themselves.
#[derive(Clone, Copy)]
struct Cells;

impl Map for Cells {
    type Point = [u32; 2];

    fn sample(&self, uv: [u32; 2]) -> [u32; 2] {
        uv
    }
}

/// The points of rows are those of the pixels one at a time, and rows follow each other to the end of
/// the line, whatever the screen's tiles.
#[test]
fn rows_are_their_pixels() -> Result<(), Error> {
    for (width, samples) in [
        (1, 1),
        (70, 1),
        (200, 16),
        (70_000, 3),
        (1000, 1 << 20),
        (300, 1 << 24),
        (40, 1 << 31),
        (5, u32::MAX),
    ] {
        let screen = Screen::new(Domain::new(7), [width, 5], samples)?;
        for (y, sample) in [(0, 0), (4, samples / 2), (3, samples), (1, samples - 1)] {
            let mut x = 0;
            while let Ok(row) = screen.row(x, y, sample) {
                let row = row.child(9);
                let mut filled = vec![[0; 2]; row.pixels() as usize];
                assert_eq!(Points::new(row, Cells).fill(&mut filled), filled.len());
                for (x, pair) in (x..).zip(filled) {
                    let one = screen.pixel(x, y)?.sampler(sample).child(9);
                    assert_eq!(pair, one.pair(), "{x} {y} {sample} of {width} {samples}");
                }
                assert_eq!(row.sampler(0), screen.pixel(x, y)?.sampler(sample).child(9));
                for start in [0, 64, row.pixels().saturating_sub(64), row.pixels(), 1 << 20] {
                    assert_eq!(consistent(&row, start), Ok(()));
                }
                x += row.pixels();
            }
            assert_eq!(x, width);
        }
    }
    Ok(())
}

/// No two samples of a screen are one, whatever its size.
#[test]
fn samples_are_distinct() -> Result<(), Error> {
    let sizes = [[1, 1], [3, 5], [17, 1], [1, 40]];
    for size in sizes {
        for samples in [1, 2, 3, 16, 17, 1 << 20, 1 << 31, u32::MAX] {
            let screen = Screen::new(Domain::new(7), size, samples)?;
            let mut seen = HashSet::new();
            let some = [0, 1, 2, 15, 16, samples / 2, samples - 1, samples, u32::MAX];
            let some: HashSet<u32> = some.into_iter().collect();
            for (x, y) in (0..size[0]).flat_map(|x| (0..size[1]).map(move |y| (x, y))) {
                for i in &some {
                    let sampler = screen.pixel(x, y)?.sampler(*i);
                    assert!(
                        seen.insert((sampler.domain(), sampler.index())),
                        "{size:?} {samples} {i}"
                    );
                }
            }
        }
    }
    Ok(())
}

/// Tiles: past 2^32 samples the domain is another one, and indices begin again.
#[test]
fn tiles_have_domains_of_their_own() -> Result<(), Error> {
    let root = Domain::new(7);
    let screen = Screen::new(root, [1 << 14, 1 << 14], 1 << 10)?;
    let [first, last] = [screen.pixel(0, 0)?.sampler(0), screen.pixel(2047, 2047)?.sampler(1023)];
    assert_eq!((first, last), (Sampler::new(root, 0), Sampler::new(root, u32::MAX)));
    let next = screen.pixel(2048, 0)?.sampler(0);
    assert_eq!(next.index(), 0);
    assert_ne!(next.domain(), root);
    let tiles: HashSet<_> = (0..8)
        .flat_map(|y| (0..8).map(move |x| [x << 11, y << 11]))
        .map(|[x, y]| screen.pixel(x, y).unwrap().sampler(0).domain())
        .collect();
    assert_eq!(tiles.len(), 64);
    // The largest screen: its last pixel has a place of 64 bits.
    let all = Screen::new(root, [u32::MAX; 2], u32::MAX)?;
    let corner = all.pixel(u32::MAX - 1, u32::MAX - 1)?;
    assert_ne!(corner.sampler(0).domain(), corner.sampler(0).child(0).domain());
    assert_ne!(corner.sampler(0).domain(), all.pixel(0, 0)?.sampler(0).domain());
    Ok(())
}

#[test]
fn what_cannot_be_is_refused() -> Result<(), Error> {
    let domain = Domain::new(0);
    assert_eq!(
        Screen::new(domain, [0, 5], 1).unwrap_err(),
        Error::EmptyGrid { columns: 0, rows: 5 }
    );
    assert_eq!(Screen::new(domain, [5, 5], 0).unwrap_err(), Error::EmptySet);
    let screen = Screen::new(domain, [640, 480], 1)?;
    for (x, y) in [(640, 0), (0, 480), (u32::MAX, u32::MAX)] {
        let error = screen.pixel(x, y).unwrap_err().to_string();
        let expected = format!(
            "pixel {x}, {y} of a screen of 640 x 480; accepted: x below 640 and y below 480"
        );
        assert_eq!(error, expected);
    }
    Ok(())
}

/// The error of a half-plane that drifts over the screen, alone and after a Gaussian of 2 pixels:
/// pixel by pixel it is that of independent domains; blurred it is 0.62 / 0.68 / 0.74 of it at most
/// at 1, 4 and 16 samples.
#[test]
fn its_error_is_blue_noise() -> Result<(), Error> {
    const WIDTH: u32 = 128;
    let root = Domain::new(5);
    let truths: Vec<f64> = (0..WIDTH * WIDTH).map(|i| area(i % WIDTH, i / WIDTH)).collect();
    for (samples, most) in [(1, 0.62), (4, 0.68), (16, 0.74)] {
        let screen = Screen::new(root, [WIDTH; 2], samples)?;
        let by_screen = |x, y, i| screen.pixel(x, y).unwrap().sampler(i).child(1);
        let by_pixel = |x, y, i| Sampler::new(root.pixel(x, y), i).child(1);
        let by_screen = errors(&truths, by_screen, samples);
        let by_pixel = errors(&truths, by_pixel, samples);
        let [alone, blurred] = [0.0, 2.0]
            .map(|sigma| rms(&gaussian(&by_screen, sigma)) / rms(&gaussian(&by_pixel, sigma)));
        assert!((0.9..1.1).contains(&alone), "{samples}: {alone}");
        assert!((0.3..=most).contains(&blurred), "{samples}: {blurred}");
        println!("{samples} samples: {alone:.3} alone, {blurred:.3} blurred");
    }
    return Ok(());

    /// Whether a point is on one side of a line through the pixel's square, whose angle and
    /// distance drift.
    fn inside(x: u32, y: u32, [u, v]: [f64; 2]) -> bool {
        let (x, y) = (f64::from(x), f64::from(y));
        let (sin, cos) = (0.7 + 0.01 * x + 0.006 * y).sin_cos();
        cos * (u - 0.5) + sin * (v - 0.5) < 0.25 * (0.05 * x + 0.03 * y).sin()
    }

    fn errors(
        truths: &[f64],
        sampler: impl Fn(u32, u32, u32) -> Sampler,
        samples: u32,
    ) -> Vec<f64> {
        let pixels = (0..WIDTH * WIDTH).map(|i| (i % WIDTH, i / WIDTH));
        let error = |((x, y), truth): ((u32, u32), &f64)| {
            let points = (0..samples).map(|i| sampler(x, y, i).pair());
            let points = points.map(|pair| pair.map(|cell| f64::from(cell) / 4_294_967_296.0));
            let hits = points.filter(|point| inside(x, y, *point)).count();
            hits as f64 / f64::from(samples) - truth
        };
        pixels.zip(truths).map(error).collect()
    }

    /// The share of the square on that side, by 64 x 64 points.
    fn area(x: u32, y: u32) -> f64 {
        let at = |i: u32| (f64::from(i) + 0.5) / 64.0;
        let points = (0..64).flat_map(|i| (0..64).map(move |j| [at(i), at(j)]));
        points.filter(|point| inside(x, y, *point)).count() as f64 / 4096.0
    }

    /// Blurred by a Gaussian of a deviation in pixels, along the torus; 0 leaves it as it is.
    fn gaussian(picture: &[f64], sigma: f64) -> Vec<f64> {
        let reach = (4.0 * sigma).ceil() as i32;
        let weight =
            |d: i32| if sigma > 0.0 { (-0.5 * (f64::from(d) / sigma).powi(2)).exp() } else { 1.0 };
        let total: f64 = (-reach..=reach).map(weight).sum();
        let width = WIDTH as i32;
        let blurred = |picture: &[f64], step: [i32; 2]| -> Vec<f64> {
            (0..width * width)
                .map(|i| {
                    let value = |d: i32| {
                        let x = (i % width + d * step[0]).rem_euclid(width);
                        let y = (i / width + d * step[1]).rem_euclid(width);
                        picture[(y * width + x) as usize]
                    };
                    (-reach..=reach).map(|d| weight(d) * value(d)).sum::<f64>() / total
                })
                .collect()
        };
        blurred(&blurred(picture, [1, 0]), [0, 1])
    }

    fn rms(picture: &[f64]) -> f64 {
        (picture.iter().map(|error| error * error).sum::<f64>() / picture.len() as f64).sqrt()
    }
}
