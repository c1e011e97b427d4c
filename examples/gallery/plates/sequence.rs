//! A plate for each sequence: the square and its images side by side, with 64 and with 256 points.

use super::title;
use crate::grid::{self, Image};
use crate::panels::{
    about_the_disc, axes, border, clipped_ground, ground, points, radius, rejected,
};
use crate::sets::{OnDisc, Set};
use crate::statistics::minimum_distance;
use examples::gallery::canvas::{Align, Drawn, Frame, INK, NOTE, Sheet, plate};
use std::error::Error;

const SIDE: f64 = 276.0;
const GAP: f64 = 16.0;
const MARGIN: f64 = 24.0;
const TOP: f64 = 132.0;
const ROW: f64 = SIDE + 72.0;

const LEGEND: [&str; 2] = [
    "Orange: the closest two points; grey rings: rejected. Ground: blue to amber along u, darker \
     to lighter along v. Lengths are in radii of the disc.",
    "Half-plane: the largest difference, over all half-planes, between the fraction of the points \
     and the fraction of the disc's area inside.",
];

/// The columns: name, what it does, and where it takes the grid.
const COLUMNS: [(&str, &str, Image); 4] = [
    ("square", "of the disc's area", grid::square),
    ("rejection", "keep what is inside", grid::centred),
    ("polar", "φ = 2πu, r = √v", grid::polar),
    ("concentric", "squares to circles", grid::concentric),
];

/// The plate of one sequence's sets, smallest first.
pub(crate) fn draw(sets: &[&Set]) -> Result<String, Box<dyn Error>> {
    let width = 2.0 * MARGIN + 4.0 * SIDE + 3.0 * GAP;
    let height = TOP + ROW * sets.len() as f64 + 44.0;
    plate([width as u32, height as u32], |sheet| {
        head(sheet, sets)?;
        for (set, row) in sets.iter().zip(0_u32..) {
            let y = TOP + ROW * f64::from(row);
            for ((name, _, image), column) in COLUMNS.into_iter().zip(0_u32..) {
                let frame = Frame::square(column_x(column), y, SIDE);
                one(sheet, frame, set, name, image)?;
            }
        }
        for (line, y) in LEGEND.into_iter().zip([38.0, 18.0]) {
            sheet.text(line, [MARGIN, height - y], 12.0, Align::Left, NOTE)?;
        }
        Ok(())
    })
}

fn column_x(column: u32) -> f64 {
    MARGIN + f64::from(column) * (SIDE + GAP)
}

fn head(sheet: &Sheet, sets: &[&Set]) -> Drawn {
    let Some(largest) = sets.last() else { return Ok(()) };
    sheet.bold(title(largest.sequence), [MARGIN, 30.0], 24.0, Align::Left)?;
    sheet.text(&verdict(largest), [MARGIN, 62.0], 14.0, Align::Left, NOTE)?;
    for ((name, what, _), column) in COLUMNS.into_iter().zip(0_u32..) {
        let x = column_x(column) + 0.5 * SIDE;
        sheet.bold(name, [x, 98.0], 16.0, Align::Centre)?;
        sheet.text(what, [x, 118.0], 12.0, Align::Centre, NOTE)?;
    }
    Ok(())
}

/// Which map keeps the points further apart, as measured.
fn verdict(set: &Set) -> String {
    let (Some(polar), Some(concentric)) = (set.on_disc("polar"), set.on_disc("concentric")) else {
        return String::new();
    };
    let (p, c) = (polar.measured.distance, concentric.measured.distance);
    let winner = match p / c {
        ratio if ratio > 1.1 => "polar keeps these points further apart",
        ratio if ratio < 1.0 / 1.1 => "concentric keeps these points further apart",
        _ => "the two are alike",
    };
    format!(
        "With {} points the closest two are {p:.4} apart under polar and {c:.4} under \
         concentric: {winner}.",
        set.count
    )
}

fn one(sheet: &Sheet, frame: Frame, set: &Set, name: &str, image: Image) -> Drawn {
    let panel = about_the_disc(sheet, frame);
    let n = set.count.isqrt();
    let dot = radius(set.coordinates.len());
    let [first, second] = if let Some(disc) = set.on_disc(name) {
        if name == "rejection" {
            clipped_ground(&panel, n, image)?;
        } else {
            ground(&panel, n, image)?;
        }
        panel.circle(1.0, 1.0, INK)?;
        rejected(&panel, &disc.rejected, dot)?;
        points(&panel, &disc.points, dot)?;
        captions(set, disc)
    } else {
        ground(&panel, n, image)?;
        border(&panel)?;
        axes(sheet, frame)?;
        let square: Vec<_> = set.coordinates.iter().map(|uv| image(*uv)).collect();
        points(&panel, &square, dot)?;
        [format!("{} points", set.count), format!("min distance {:.4}", minimum_distance(&square))]
    };
    let x = frame.x + 0.5 * frame.width;
    let y = frame.y + frame.height;
    sheet.bold(&first, [x, y + 14.0], 13.0, Align::Centre)?;
    sheet.text(&second, [x, y + 33.0], 12.0, Align::Centre, NOTE)
}

fn captions(set: &Set, disc: &OnDisc) -> [String; 2] {
    let m = disc.measured;
    let kept = match m.kept {
        kept if kept < set.coordinates.len() => format!("{kept} of {} kept", set.count),
        kept => format!("{kept} points"),
    };
    [kept, format!("min distance {:.4}, half-plane {:.4}", m.distance, m.discrepancy)]
}
