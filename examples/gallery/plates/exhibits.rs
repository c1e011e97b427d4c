//! What goes wrong with the naive forms, each beside the right one.
//!
//! They are here and not in the crate: a radius that is uniform, and the lecture's polar "mapping",
//! which converts to polar coordinates and back again.

use crate::grid::{Image, centred, polar};
use crate::panels::{about_the_disc, ground, misplaced, radius};
use crate::sets::Set;
use examples::gallery::canvas::{
    Align, BLUE, Drawn, Frame, INK, NOTE, Panel, Sheet, VERMILION, plate,
};
use hemidisc::Coordinates;
use std::error::Error;

const SIDE: f64 = 300.0;
const GAP: f64 = 24.0;
const MARGIN: f64 = 24.0;
const TOP: f64 = 130.0;
const ROW: f64 = SIDE + 108.0;
/// Rings of equal area that points are counted in.
const RINGS: usize = 8;
/// Cells of the grid along an axis.
const CELLS: u32 = 16;

/// Polar with r = v instead of r = sqrt(v).
fn crowded(uv: [u32; 2]) -> [f64; 2] {
    let [x, y] = polar(uv);
    // r is sqrt(v) already, and r r is v.
    let r = x.hypot(y);
    [x * r, y * r]
}

/// The lecture's formula: r = sqrt(x^2 + y^2), theta = atan2(y, x), then r cos theta, r sin theta.
fn slide([x, y]: [f64; 2]) -> [f64; 2] {
    let (r, theta) = ((x * x + y * y).sqrt(), y.atan2(x));
    [r * theta.cos(), r * theta.sin()]
}

/// The lecture's formula on the unit square, as it is written.
fn slide_unit(uv: [u32; 2]) -> [f64; 2] {
    slide(Coordinates(uv).to_f64())
}

/// The lecture's formula on [-1, 1]^2.
fn slide_centred(uv: [u32; 2]) -> [f64; 2] {
    slide(centred(uv))
}

/// How many of a set's points an image leaves outside of the disc.
fn outside(set: &Set, image: Image) -> usize {
    set.coordinates.iter().filter(|uv| !within(image(**uv))).count()
}

fn within([x, y]: [f64; 2]) -> bool {
    x * x + y * y <= 1.0
}

/// The plate of one set; `all` are the sets over which the range of losses is told.
pub(crate) fn draw(set: &Set, all: &[Vec<Set>]) -> Result<String, Box<dyn Error>> {
    let width = 2.0 * MARGIN + 3.0 * SIDE + 2.0 * GAP;
    plate([width as u32, (TOP + 2.0 * ROW - 58.0) as u32], |sheet| {
        sheet.bold("What goes wrong", [MARGIN, 30.0], 24.0, Align::Left)?;
        let what = format!(
            "{} {} points through two naive forms of the polar map, and the right one.",
            set.count, set.sequence
        );
        sheet.text(&what, [MARGIN, 60.0], 14.0, Align::Left, NOTE)?;
        let [a, b, c] = [0.0, 1.0, 2.0].map(|column| MARGIN + column * (SIDE + GAP));

        let inner = |image: Image| {
            let points = set
                .coordinates
                .iter()
                .filter(|uv| image(**uv).iter().map(|k| k * k).sum::<f64>() < 0.25);
            percent(points.count(), set.coordinates.len())
        };
        exhibit(
            sheet,
            [a, TOP],
            set,
            crowded,
            [
                "r = v",
                &format!("inner quarter of the area: {} of the points", inner(crowded)),
                "they crowd at the centre",
            ],
        )?;
        exhibit(
            sheet,
            [b, TOP],
            set,
            polar,
            [
                "right: r = √v",
                &format!("inner quarter of the area: {} of the points", inner(polar)),
                "as it should be",
            ],
        )?;
        rings(sheet, [c, TOP], set)?;

        let below = TOP + ROW;
        exhibit(
            sheet,
            [a, below],
            set,
            slide_unit,
            [
                "the slide's polar map, on [0, 1]²",
                "r = √(x² + y²), θ = atan2(y, x): the identity",
                &losses(set, all, slide_unit),
            ],
        )?;
        exhibit(
            sheet,
            [b, below],
            set,
            slide_centred,
            [
                "the slide's polar map, on [-1, 1]²",
                "the identity again: no point moves",
                &losses(set, all, slide_centred),
            ],
        )?;
        exhibit(
            sheet,
            [c, below],
            set,
            polar,
            ["right: φ = 2πu, r = √v", "every point on the disc", ""],
        )
    })
}

fn percent(part: usize, whole: usize) -> String {
    format!("{:.1} %", 100.0 * part as f64 / whole as f64)
}

/// The points left outside: of this set, and the least and most of every sequence's.
fn losses(set: &Set, all: &[Vec<Set>], image: Image) -> String {
    let each = || {
        all.iter()
            .flatten()
            .filter(|other| other.count == set.count)
            .map(|set| 100.0 * outside(set, image) as f64 / set.coordinates.len() as f64)
    };
    let (least, most) = (each().fold(f64::INFINITY, f64::min), each().fold(0.0, f64::max));
    let here = percent(outside(set, image), set.coordinates.len());
    format!("{here} outside (of all sequences: {least:.1} to {most:.1} %)")
}

fn exhibit(
    sheet: &Sheet,
    [x, y]: [f64; 2],
    set: &Set,
    image: Image,
    [title, first, second]: [&str; 3],
) -> Drawn {
    let panel = about_the_disc(sheet, Frame::square(x, y, SIDE));
    let points: Vec<_> = set.coordinates.iter().map(|uv| image(*uv)).collect();
    let (inside, outside): (Vec<_>, Vec<_>) = points.into_iter().partition(|point| within(*point));
    ground(&panel, CELLS, image)?;
    panel.circle(1.0, 1.0, INK)?;
    panel.dots(&inside, radius(set.coordinates.len()), INK)?;
    misplaced(&panel, &outside, radius(set.coordinates.len()))?;
    captions(sheet, [x, y], [title, first, second])
}

fn captions(sheet: &Sheet, [x, y]: [f64; 2], [title, first, second]: [&str; 3]) -> Drawn {
    let x = x + 0.5 * SIDE;
    sheet.bold(title, [x, y - 18.0], 15.0, Align::Centre)?;
    sheet.text(first, [x, y + SIDE + 16.0], 12.0, Align::Centre, NOTE)?;
    sheet.text(second, [x, y + SIDE + 33.0], 12.0, Align::Centre, NOTE)
}

/// Points in each ring of equal area, of the crowded map and of the right one.
fn rings(sheet: &Sheet, [x, y]: [f64; 2], set: &Set) -> Drawn {
    let counts = |image: Image| {
        let mut counts = [0.0; RINGS];
        for [x, y] in set.coordinates.iter().map(|uv| image(*uv)) {
            let ring = ((x * x + y * y) * RINGS as f64) as usize;
            if let Some(count) = counts.get_mut(ring.min(RINGS - 1)) {
                *count += 1.0;
            }
        }
        counts
    };
    let (naive, right) = (counts(crowded), counts(polar));
    let top = naive.into_iter().chain(right).fold(0.0, f64::max);
    let frame = Frame { x: x + 14.0, y, width: SIDE - 14.0, height: SIDE - 24.0 };
    let panel = sheet.panel(frame, 0.0..RINGS as f64, 0.0..1.1 * top);
    let bar = |panel: &Panel, from: f64, height: f64, colour| {
        panel
            .fill(&[[from, 0.0], [from + 0.38, 0.0], [from + 0.38, height], [from, height]], colour)
    };
    let pixel = |ring: f64, count: f64| {
        [
            frame.x + frame.width * ring / RINGS as f64,
            frame.y + frame.height * (1.0 - count / (1.1 * top)),
        ]
    };
    for (ring, (naive, right)) in (0_u32..).zip(naive.into_iter().zip(right)) {
        let from = f64::from(ring);
        bar(&panel, from + 0.1, naive, VERMILION)?;
        bar(&panel, from + 0.5, right, BLUE)?;
        let [x, _] = pixel(from + 0.5, 0.0);
        sheet.text(
            &format!("{}", ring + 1),
            [x, frame.y + frame.height + 12.0],
            12.0,
            Align::Centre,
            NOTE,
        )?;
    }
    let even = set.coordinates.len() as f64 / RINGS as f64;
    panel.curve(&[[0.0, 0.0], [RINGS as f64, 0.0]], 1.0, INK)?;
    panel.curve(&[[0.0, even], [RINGS as f64, even]], 1.0, INK)?;
    let [x1, y1] = pixel(RINGS as f64, 0.92 * top);
    sheet.text("r = v", [x1, y1], 14.0, Align::Right, VERMILION)?;
    sheet.text("r = √v", [x1, y1 + 20.0], 14.0, Align::Right, BLUE)?;
    sheet.text(&format!("even: {even}"), [x1, y1 + 40.0], 14.0, Align::Right, INK)?;
    captions(
        sheet,
        [x, y],
        [
            "points in rings of equal area",
            "from the centre (1) to the rim (8)",
            &format!("r = v: {} in the first, {} in the last", naive[0], naive[RINGS - 1]),
        ],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slides_form_is_the_identity() {
        for k in 0..1000_u32 {
            let uv = [k.wrapping_mul(0xc13f_a9a9), k.wrapping_mul(0x91e1_0da5)];
            let (from, to) = (centred(uv), slide_centred(uv));
            assert!((from[0] - to[0]).hypot(from[1] - to[1]) < 1e-15, "{from:?} moved to {to:?}");
        }
    }

    #[test]
    fn the_crowded_form_has_r_equal_to_v() {
        for [u, v] in [[0.1, 0.2], [0.4, 0.5], [0.9, 0.99]] {
            let uv = [u, v].map(|k| (k * 4_294_967_296.0) as u32);
            let [x, y] = crowded(uv);
            assert!((x.hypot(y) - v).abs() < 1e-9);
        }
    }
}
