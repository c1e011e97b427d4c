//! The picture for the crate's front page: the square, its two images, and three lobes above them.

use super::hemisphere::{half_angle, name};
use super::title;
use crate::dome::SIDE;
use crate::grid::{self, Image};
use crate::panels::{about_the_disc, axes, border, ground, points};
use crate::sets::Set;
use crate::statistics::minimum_distance;
use examples::gallery::canvas::{Align, Drawn, Frame, INK, NOTE, Sheet, plate};
use hemidisc::{LibmF64, Power};
use std::error::Error;

const WIDTH: f64 = 280.0;
const GAP: f64 = 14.0;
const MARGIN: f64 = 16.0;
const DISCS: f64 = 62.0;
const DOMES: f64 = 450.0;
const DOT: f64 = 1.9;

/// The plate of one set, with a word on `counterexample`'s.
pub(crate) fn draw(set: &Set, counterexample: &Set) -> Result<String, Box<dyn Error>> {
    plate([900, 752], |sheet| {
        let discs: [(&str, &str, Image); 3] = [
            ("the square", "", grid::square),
            ("polar", "φ = 2πu, r = √v", grid::polar),
            ("concentric", "squares to circles", grid::concentric),
        ];
        for ((name, what, image), column) in discs.into_iter().zip(0_u32..) {
            let what = if column == 0 {
                format!("{} points, {}", set.count, title(set.sequence))
            } else {
                what.into()
            };
            disc(sheet, x(column), set, [name, &what], image)?;
        }
        for (exponent, column) in [0.0, 1.0, 10.0].into_iter().zip(0_u32..) {
            dome(sheet, x(column), set, exponent)?;
        }
        sheet.text(&but(counterexample), [450.0, 716.0], 12.0, Align::Centre, NOTE)?;
        let pale = "Grid: the square's 16 x 16 cells, at the disc's area. Orange: the closest two. \
                    Pale: where no 32-bit coordinate reaches.";
        sheet.text(pale, [450.0, 736.0], 12.0, Align::Centre, NOTE)
    })
}

/// That no map is the better one for every sequence.
fn but(set: &Set) -> String {
    let distance = |map| set.on_disc(map).map_or(f64::NAN, |disc| disc.measured.distance);
    let (polar, concentric) = (distance("polar"), distance("concentric"));
    format!(
        "It depends on the sequence: of {} {} points the closest two are {polar:.4} apart under \
         polar, {concentric:.4} under concentric.",
        set.count,
        title(set.sequence)
    )
}

/// How a lobe lifts a disc point.
fn lift(exponent: f32) -> &'static str {
    match exponent {
        0.0 => "z = 1 − r²",
        1.0 => "z = √(1 − r²)",
        _ => "z = (1 − r²)^(1 / (e + 1))",
    }
}

fn x(column: u32) -> f64 {
    MARGIN + f64::from(column) * (WIDTH + GAP)
}

fn disc(sheet: &Sheet, x: f64, set: &Set, [map, what]: [&str; 2], image: Image) -> Drawn {
    let frame = Frame::square(x, DISCS, WIDTH);
    let panel = about_the_disc(sheet, frame);
    ground(&panel, set.count.isqrt(), image)?;
    let on_disc = set.on_disc(map);
    let placed = match on_disc {
        Some(disc) => disc.points.clone(),
        None => set.coordinates.iter().map(|uv| image(*uv)).collect(),
    };
    if on_disc.is_some() {
        panel.circle(1.0, 1.0, INK)?;
    } else {
        border(&panel)?;
        axes(sheet, frame)?;
    }
    points(&panel, &placed, DOT)?;
    let middle = x + 0.5 * WIDTH;
    sheet.bold(map, [middle, 18.0], 17.0, Align::Centre)?;
    sheet.text(what, [middle, 42.0], 13.0, Align::Centre, NOTE)?;
    let distance = format!("closest two {:.4} apart", minimum_distance(&placed));
    sheet.text(&distance, [middle, DISCS + WIDTH + 16.0], 13.0, Align::Centre, NOTE)
}

fn dome(sheet: &Sheet, x: f64, set: &Set, exponent: f32) -> Drawn {
    let Some(lobe) = set.on_hemisphere("concentric", exponent) else { return Ok(()) };
    let map = Power::<LibmF64>::new(exponent.into())?;
    let (panel, height) = SIDE.panel(sheet, x, DOMES, WIDTH);
    SIDE.ground(&panel, |uv| map.sample(uv))?;
    SIDE.directions(&panel, &lobe.directions, DOT)?;
    let middle = x + 0.5 * WIDTH;
    sheet.bold(&name(exponent), [middle, DOMES - 44.0], 17.0, Align::Centre)?;
    sheet.text(lift(exponent), [middle, DOMES - 20.0], 13.0, Align::Centre, NOTE)?;
    let half = format!("half within {:.1}° of the pole", half_angle(exponent));
    sheet.text(&half, [middle, DOMES + height + 18.0], 13.0, Align::Centre, NOTE)
}
