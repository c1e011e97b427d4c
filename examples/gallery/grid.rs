//! The square's grid, drawn through a map: lines and cells as curves on the disc.
//!
//! Lines are sampled densely through the map in f64; a panel thins them to what the eye can see.

use hemidisc::{Concentric, Coordinates, LibmF64, Polar};
use plotters::prelude::RGBColor;

/// Where a map takes a point of the square.
pub(crate) type Image = fn([u32; 2]) -> [f64; 2];

/// The square about the origin, as large in area as the disc: lengths on both can be compared.
pub(crate) fn square(uv: [u32; 2]) -> [f64; 2] {
    Coordinates(uv).to_f64().map(|k| (k - 0.5) * std::f64::consts::PI.sqrt())
}

/// The candidates of rejection: [-1, 1]^2.
pub(crate) fn centred(uv: [u32; 2]) -> [f64; 2] {
    Coordinates(uv).to_f64().map(|k| 2.0 * k - 1.0)
}

pub(crate) fn polar(uv: [u32; 2]) -> [f64; 2] {
    Polar::<LibmF64>::new().sample(uv)
}

pub(crate) fn concentric(uv: [u32; 2]) -> [f64; 2] {
    Concentric::<LibmF64>::new().sample(uv)
}

/// Samples along a whole line to begin with: a multiple of the cells of every grid.
const SAMPLES: u32 = 128;
/// The longest step between samples of a curve, in radii of the disc.
const STEP: f64 = 0.03;

/// The image of the straight line between two points of the square.
pub(crate) fn line<const D: usize>(
    image: impl Fn([u32; 2]) -> [f64; D],
    from: [f64; 2],
    to: [f64; 2],
) -> Vec<[f64; D]> {
    // 1 is not a coordinate: the cast saturates to the last cell.
    let cell = |k: f64| (k * 4_294_967_296.0) as u32;
    let at = |t: f64| image([0, 1].map(|axis| cell(from[axis] + t * (to[axis] - from[axis]))));
    let length = (to[0] - from[0]).abs() + (to[1] - from[1]).abs();
    let steps = ((f64::from(SAMPLES) * length).ceil() as u32).max(1);
    let mut curve = vec![at(0.0)];
    for step in 1..=steps {
        let t = |step: u32| f64::from(step) / f64::from(steps);
        // Near the rim a lobe of large e takes a cell a long way: halve until the steps are short.
        let mut pending = vec![[t(step - 1), t(step)]];
        while let Some([a, b]) = pending.pop() {
            let (p, q) = (at(a), at(b));
            let squared: f64 = p.iter().zip(&q).map(|(p, q)| (p - q) * (p - q)).sum();
            if squared > STEP * STEP && b - a > 1e-11 {
                let middle = 0.5 * (a + b);
                pending.extend([[middle, b], [a, middle]]);
            } else {
                curve.push(q);
            }
        }
    }
    curve
}

/// The lines between `n` x `n` cells, and the two pairs of edges.
pub(crate) fn lines<const D: usize>(
    n: u32,
    image: impl Fn([u32; 2]) -> [f64; D],
) -> Vec<Vec<[f64; D]>> {
    let at = |k: u32| f64::from(k) / f64::from(n);
    let upright = (0..=n).map(|k| line(&image, [at(k), 0.0], [at(k), 1.0]));
    let across = (0..=n).map(|k| line(&image, [0.0, at(k)], [1.0, at(k)]));
    upright.chain(across).collect()
}

/// A cell of the square: its outline under a map, and the colour of its place.
pub(crate) struct Cell<const D: usize> {
    pub(crate) outline: Vec<[f64; D]>,
    pub(crate) colour: RGBColor,
}

/// The `n` x `n` cells of the square.
pub(crate) fn cells<const D: usize>(n: u32, image: impl Fn([u32; 2]) -> [f64; D]) -> Vec<Cell<D>> {
    let at = |k: u32| f64::from(k) / f64::from(n);
    let corners = |i, j| [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1], [i, j]];
    let cell = |[i, j]: [u32; 2]| {
        let corners = corners(i, j).map(|corner| corner.map(at));
        let sides = corners.iter().zip(corners.iter().skip(1));
        let outline = sides.flat_map(|(from, to)| line(&image, *from, *to)).collect();
        let middle = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(n));
        Cell { outline, colour: colour(middle) }
    };
    (0..n * n).map(|k| cell([k % n, k / n])).collect()
}

/// The colour of a place on the square: blue by rose to amber along u, which readers of every kind
/// of sight can order, and darker to lighter along v.
pub(crate) fn colour([u, v]: [f64; 2]) -> RGBColor {
    const ALONG_U: [[f64; 3]; 3] =
        [[112.0, 160.0, 230.0], [212.0, 160.0, 200.0], [248.0, 186.0, 84.0]];
    let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
    let [left, middle, right] = ALONG_U;
    let (from, to, t) =
        if u < 0.5 { (left, middle, 2.0 * u) } else { (middle, right, 2.0 * u - 1.0) };
    let channel = |c: usize| mix(mix(from[c], to[c], t), 255.0, 0.1 + 0.65 * v).round() as u8;
    RGBColor(channel(0), channel(1), channel(2))
}
