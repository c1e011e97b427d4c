//! The hemisphere: 256 directions for each exponent, over both disc maps, from above and the side.

use super::title;
use crate::dome::{SIDE, TOP};
use crate::sets::{EXPONENTS, OnHemisphere, Set};
use crate::statistics::minimum_angle;
use examples::gallery::canvas::{Align, Drawn, NOTE, Sheet, plate};
use hemidisc::Polar;
use hemidisc::{LibmF64, Map, Power};
use std::error::Error;

const WIDTH: f64 = 276.0;
const GAP: f64 = 16.0;
const MARGIN: f64 = 24.0;
const HEAD: f64 = 154.0;
const ROW: f64 = 578.0;

pub(crate) fn draw(set: &Set) -> Result<String, Box<dyn Error>> {
    let width = 2.0 * MARGIN + 4.0 * WIDTH + 3.0 * GAP;
    let height = HEAD + 2.0 * ROW - 10.0;
    plate([width as u32, height as u32], |sheet| {
        let title = format!("{} directions on the hemisphere, {}", set.count, title(set.sequence));
        sheet.bold(&title, [MARGIN, 30.0], 24.0, Align::Left)?;
        let what = [
            "The lobes cosᵉ θ over two disc maps, from above and from 30° above the horizon, \
             with the square's 16 x 16 cells.",
            "Pale: where no 32-bit coordinate reaches, for fewer than one direction in 2³¹ would \
             be there.",
        ];
        for (line, y) in what.into_iter().zip([60.0, 80.0]) {
            sheet.text(line, [MARGIN, y], 13.0, Align::Left, NOTE)?;
        }
        for (exponent, column) in EXPONENTS.into_iter().zip(0_u32..) {
            let x = MARGIN + f64::from(column) * (WIDTH + GAP);
            heading(sheet, x, exponent)?;
            let e = exponent.into();
            if let Some(lobe) = set.on_hemisphere("concentric", exponent) {
                one(sheet, [x, HEAD], lobe, Power::<LibmF64>::new(e)?)?;
            }
            if let Some(lobe) = set.on_hemisphere("polar", exponent) {
                let map = Power::over(e, Polar::<LibmF64>::new())?;
                one(sheet, [x, HEAD + ROW], lobe, map)?;
            }
        }
        Ok(())
    })
}

/// The name of a lobe.
pub(crate) fn name(exponent: f32) -> String {
    match exponent {
        0.0 => "e = 0: uniform".into(),
        1.0 => "e = 1: cosine".into(),
        e => format!("e = {e}"),
    }
}

/// The angle about the pole that holds half of all directions, in degrees.
pub(crate) fn half_angle(exponent: f32) -> f64 {
    0.5_f64.powf(1.0 / (f64::from(exponent) + 1.0)).acos().to_degrees()
}

/// The median of the directions' angles to the pole, in degrees.
pub(crate) fn median_angle(directions: &[[f64; 3]]) -> f64 {
    let mut z: Vec<_> = directions.iter().map(|[_, _, z]| *z).collect();
    z.sort_by(f64::total_cmp);
    let middle = z.get((z.len().saturating_sub(1)) / 2..=z.len() / 2).unwrap_or_default();
    (middle.iter().sum::<f64>() / middle.len() as f64).acos().to_degrees()
}

fn heading(sheet: &Sheet, x: f64, exponent: f32) -> Drawn {
    let x = x + 0.5 * WIDTH;
    sheet.bold(&name(exponent), [x, 116.0], 16.0, Align::Centre)?;
    let half = format!("half of all directions within {:.1}°", half_angle(exponent));
    sheet.text(&half, [x, 136.0], 12.0, Align::Centre, NOTE)
}

fn one(
    sheet: &Sheet,
    [x, y]: [f64; 2],
    lobe: &OnHemisphere,
    map: impl Map<Point = [f64; 3]>,
) -> Drawn {
    let mut below = y;
    for view in [TOP, SIDE] {
        let (panel, height) = view.panel(sheet, x, below, WIDTH);
        view.ground(&panel, |uv| map.sample(uv))?;
        view.directions(&panel, &lobe.directions, 2.0)?;
        below += height + 14.0;
    }
    let x = x + 0.5 * WIDTH;
    sheet.bold(&format!("over {}", lobe.disc), [x, below + 6.0], 13.0, Align::Centre)?;
    let measured = format!(
        "half within {:.1}°, closest two {:.2}° apart",
        median_angle(&lobe.directions),
        minimum_angle(&lobe.directions)
    );
    sheet.text(&measured, [x, below + 25.0], 12.0, Align::Centre, NOTE)
}
