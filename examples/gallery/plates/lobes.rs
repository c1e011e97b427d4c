//! The lobes d = cos^e theta as the lecture draws them, d against theta in polar coordinates; and
//! beside them where 256 directions of each really went.

use super::hemisphere::{median_angle, name};
use crate::sets::{EXPONENTS, Set};
use examples::gallery::canvas::{
    Align, BLUE, Drawn, Frame, GREEN, GREY, INK, NOTE, PURPLE, Sheet, VERMILION, plate,
};
use plotters::prelude::RGBColor;
use std::error::Error;

const COLOURS: [RGBColor; 4] = [BLUE, VERMILION, GREEN, PURPLE];
const MARGIN: f64 = 24.0;
const PLOT: Frame = Frame { x: 30.0, y: 96.0, width: 640.0, height: 360.0 };
/// Left edge of the bars.
const BARS: f64 = 700.0;
/// Degrees of theta in a bar.
const BIN: f64 = 5.0;

pub(crate) fn draw(set: &Set) -> Result<String, Box<dyn Error>> {
    plate([1180, 520], |sheet| {
        sheet.bold("The lobe d = cosᵉ θ", [MARGIN, 30.0], 24.0, Align::Left)?;
        let left = "Distance d from the centre in the direction θ from the pole.";
        sheet.text(left, [MARGIN, 62.0], 14.0, Align::Left, NOTE)?;
        let right = format!(
            "{} {} directions in bars of 5° of θ; lines: expected.",
            set.count, set.sequence
        );
        sheet.text(&right, [BARS, 62.0], 14.0, Align::Left, NOTE)?;
        polar_plot(sheet)?;
        for ((exponent, colour), row) in EXPONENTS.into_iter().zip(COLOURS).zip(0_u32..) {
            if let Some(lobe) = set.on_hemisphere("concentric", exponent) {
                histogram(sheet, 90.0 + 98.0 * f64::from(row), exponent, &lobe.directions, colour)?;
            }
        }
        let axis = 90.0 + 98.0 * 4.0;
        for degrees in [0, 30, 60, 90] {
            let x = BARS + 340.0 * f64::from(degrees) / 90.0;
            sheet.text(&format!("{degrees}°"), [x, axis], 12.0, Align::Centre, NOTE)?;
        }
        sheet.text("θ", [1060.0, axis], 12.0, Align::Left, NOTE)
    })
}

/// Where the angle `degrees` from the pole is at a distance, the pole upwards.
fn at(degrees: f64, distance: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [distance * sin, distance * cos]
}

fn polar_plot(sheet: &Sheet) -> Drawn {
    let panel = sheet.panel(PLOT, -1.12..1.12, -0.1..1.16);
    let pixel = |[x, y]: [f64; 2]| {
        [PLOT.x + PLOT.width * (x + 1.12) / 2.24, PLOT.y + PLOT.height * (1.16 - y) / 1.26]
    };
    let arc =
        |distance: f64| -> Vec<_> { (-90..=90).map(|k| at(f64::from(k), distance)).collect() };
    for distance in [0.25, 0.5, 0.75] {
        panel.curve(&arc(distance), 0.7, GREY)?;
    }
    for degrees in (-90_i32..=90).step_by(30) {
        panel.curve(&[[0.0, 0.0], at(degrees.into(), 1.0)], 0.7, GREY)?;
        let label = format!("{}°", degrees.abs());
        sheet.text(&label, pixel(at(degrees.into(), 1.065)), 12.0, Align::Centre, NOTE)?;
    }
    for distance in [0.0, 0.5, 1.0] {
        let [x, y] = pixel([distance, 0.0]);
        sheet.text(&format!("{distance}"), [x, y + 14.0], 12.0, Align::Centre, NOTE)?;
    }
    // Each label stands where its curve is alone; from the thinnest lobe a line leads to it.
    let labels = [(-48.0, -0.03), (40.0, 0.03), (-13.0, -0.03), (4.65, 0.155)];
    for ((exponent, colour), (label, aside)) in EXPONENTS.into_iter().zip(COLOURS).zip(labels) {
        let d = |degrees: f64| degrees.to_radians().cos().max(0.0).powf(exponent.into());
        let lobe: Vec<_> = (-900..=900).map(|k| 0.1 * f64::from(k)).map(|k| at(k, d(k))).collect();
        panel.curve(&lobe, 2.2, colour)?;
        let [x, y] = at(label, d(label));
        if aside > 0.1 {
            panel.curve(&[[x, y], [x + aside - 0.02, y]], 1.0, colour)?;
        }
        let align = if aside < 0.0 { Align::Right } else { Align::Left };
        sheet.text(&format!("e = {exponent}"), pixel([x + aside, y]), 14.0, align, colour)?;
    }
    Ok(())
}

fn histogram(
    sheet: &Sheet,
    y: f64,
    exponent: f32,
    directions: &[[f64; 3]],
    colour: RGBColor,
) -> Drawn {
    let mut counts = [0.0_f64; (90.0 / BIN) as usize];
    for [x, y, z] in directions {
        let bin = (x.hypot(*y).atan2(*z).to_degrees() / BIN) as usize;
        if let Some(count) = counts.get_mut(bin) {
            *count += 1.0;
        }
    }
    // A fraction 1 - cos^(e + 1) theta of all directions is within theta.
    let e = f64::from(exponent);
    let beyond = |k: u32| (BIN * f64::from(k)).to_radians().cos().max(0.0).powf(e + 1.0);
    let expected = |k: u32| directions.len() as f64 * (beyond(k) - beyond(k + 1));
    let top = (0..).zip(counts).fold(0.0, |top: f64, (k, count)| top.max(count).max(expected(k)));
    let frame = Frame { x: BARS, y, width: 340.0, height: 78.0 };
    let panel = sheet.panel(frame, 0.0..90.0, 0.0..1.08 * top);
    for (k, count) in (0..).zip(counts) {
        let (from, to) = (f64::from(k) * BIN, f64::from(k + 1) * BIN);
        let (left, right) = (from + 0.35, to - 0.35);
        panel.fill(&[[left, 0.0], [right, 0.0], [right, count], [left, count]], GREY)?;
        panel.curve(&[[from, expected(k)], [to, expected(k)]], 2.4, colour)?;
    }
    panel.curve(&[[0.0, 0.0], [90.0, 0.0]], 1.0, INK)?;
    sheet.bold(&name(exponent), [1052.0, y + 24.0], 14.0, Align::Left)?;
    let half = format!("half within {:.1}°", median_angle(directions));
    sheet.text(&half, [1052.0, y + 44.0], 12.0, Align::Left, NOTE)
}
