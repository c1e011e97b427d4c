//! The drawing surface of the plates: text at pixels, panels in coordinates of what they show.
//!
//! `plotters` places everything on whole pixels, which makes curves wobble and circles sit off
//! their centres; so a plate is drawn ten times as large, and its header makes it small again.

use crate::gallery::curve::thin;
use plotters::coord::types::RangedCoordf64;
use plotters::coord::{Shift, cartesian::Cartesian2d};
use plotters::prelude::{
    Circle, DrawingArea, FontStyle, IntoDrawingArea, IntoFont, PathElement, Polygon, RGBColor,
    SVGBackend, ShapeStyle, Text, TextStyle, WHITE,
};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::error::Error;
use std::ops::Range;

pub type Drawn = Result<(), Box<dyn Error>>;

/// Units of the drawing in a pixel of the plate.
const FINE: f64 = 10.0;

pub const INK: RGBColor = RGBColor(0x1c, 0x1f, 0x24);
pub const NOTE: RGBColor = RGBColor(0x55, 0x5c, 0x66);
pub const LINE: RGBColor = RGBColor(0x8d, 0x97, 0xa5);
pub const GREY: RGBColor = RGBColor(0xa6, 0xac, 0xb4);
// From the palette of M. Okabe and K. Ito (2008), which colour-blind readers tell apart.
pub const VERMILION: RGBColor = RGBColor(0xd5, 0x5e, 0x00);
pub const BLUE: RGBColor = RGBColor(0x00, 0x72, 0xb2);
pub const GREEN: RGBColor = RGBColor(0x00, 0x9e, 0x73);
pub const PURPLE: RGBColor = RGBColor(0xa2, 0x4f, 0x86);

/// A rectangle of a plate in pixels: left, top, width and height.
#[derive(Clone, Copy)]
pub struct Frame {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
}

impl Frame {
    pub const fn square(x: f64, y: f64, side: f64) -> Self {
        Self { x, y, width: side, height: side }
    }
}

/// Where a text stands against its position.
#[derive(Clone, Copy)]
pub enum Align {
    Left,
    Centre,
    Right,
}

/// A whole plate.
pub struct Sheet<'a>(DrawingArea<SVGBackend<'a>, Shift>);

/// Draws a plate of a size in pixels; the text of the SVG file.
pub fn plate(
    [width, height]: [u32; 2],
    draw: impl FnOnce(&Sheet) -> Drawn,
) -> Result<String, Box<dyn Error>> {
    let mut svg = String::new();
    let fine = (width * FINE as u32, height * FINE as u32);
    let sheet = Sheet(SVGBackend::with_string(&mut svg, fine).into_drawing_area());
    sheet.0.fill(&WHITE)?;
    draw(&sheet)?;
    sheet.0.present()?;
    drop(sheet);
    let header = format!("<svg width=\"{}\" height=\"{}\"", fine.0, fine.1);
    let small = format!("<svg width=\"{width}\" height=\"{height}\"");
    // And without what is SVG's default anyway: a third of the file.
    Ok(svg
        .replacen(&header, &small, 1)
        .replace(" opacity=\"1\"", "")
        .replace(" stroke=\"none\" stroke-width=\"1\"", "")
        .replace(" \"/>", "\"/>"))
}

impl<'a> Sheet<'a> {
    /// A line of text; `y` is the middle of its height.
    pub fn text(
        &self,
        text: &str,
        at: [f64; 2],
        size: f64,
        align: Align,
        colour: RGBColor,
    ) -> Drawn {
        self.write(text, at, size, align, colour, FontStyle::Normal)
    }

    /// A heading.
    pub fn bold(&self, text: &str, at: [f64; 2], size: f64, align: Align) -> Drawn {
        self.write(text, at, size, align, INK, FontStyle::Bold)
    }

    fn write(
        &self,
        text: &str,
        [x, y]: [f64; 2],
        size: f64,
        align: Align,
        colour: RGBColor,
        style: FontStyle,
    ) -> Drawn {
        // plotters takes the height of a line for a font's size, and the backend divides it out.
        let font = ("sans-serif", size * FINE * 1.24).into_font().style(style);
        let horizontal = match align {
            Align::Left => HPos::Left,
            Align::Centre => HPos::Center,
            Align::Right => HPos::Right,
        };
        let style = TextStyle::from(font).color(&colour).pos(Pos::new(horizontal, VPos::Center));
        Ok(self.0.draw(&Text::new(text, (fine(x), fine(y)), style))?)
    }

    /// A part of the plate in coordinates of its own, y upwards.
    pub fn panel(&self, frame: Frame, x: Range<f64>, y: Range<f64>) -> Panel<'a> {
        let across = fine(frame.x)..fine(frame.x + frame.width);
        let up = fine(frame.y + frame.height)..fine(frame.y);
        let scale = f64::from(across.end - across.start) / (x.end - x.start);
        let coordinates = Cartesian2d::<RangedCoordf64, RangedCoordf64>::new(x, y, (across, up));
        Panel { area: self.0.clone().apply_coord_spec(coordinates), scale }
    }
}

/// A part of a plate with coordinates, equally long on both axes.
pub struct Panel<'a> {
    area: DrawingArea<SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>,
    scale: f64,
}

impl Panel<'_> {
    /// A curve through points, `width` pixels wide.
    pub fn curve(&self, points: &[[f64; 2]], width: f64, colour: RGBColor) -> Drawn {
        let style = ShapeStyle::from(&colour).stroke_width(fine(width).unsigned_abs());
        Ok(self.area.draw(&PathElement::new(self.thinned(points), style))?)
    }

    /// The inside of a closed curve.
    pub fn fill(&self, points: &[[f64; 2]], colour: RGBColor) -> Drawn {
        Ok(self
            .area
            .draw(&Polygon::new(self.thinned(points), ShapeStyle::from(&colour).filled()))?)
    }

    /// Dots with a radius in pixels.
    pub fn dots(&self, centres: &[[f64; 2]], radius: f64, colour: RGBColor) -> Drawn {
        let style = ShapeStyle::from(&colour).filled();
        centres.iter().try_for_each(|at| self.circle_of(*at, fine(radius), style))
    }

    /// Rings with a radius in pixels.
    pub fn rings(&self, centres: &[[f64; 2]], radius: f64, colour: RGBColor) -> Drawn {
        let style = ShapeStyle::from(&colour).stroke_width(fine(1.0).unsigned_abs());
        centres.iter().try_for_each(|at| self.circle_of(*at, fine(radius), style))
    }

    /// A circle about the origin of the panel's coordinates.
    pub fn circle(&self, radius: f64, width: f64, colour: RGBColor) -> Drawn {
        let style = ShapeStyle::from(&colour).stroke_width(fine(width).unsigned_abs());
        self.circle_of([0.0, 0.0], (radius * self.scale).round() as i32, style)
    }

    /// The points of a curve that make an eighth of a pixel's difference.
    fn thinned(&self, points: &[[f64; 2]]) -> Vec<(f64, f64)> {
        thin(points, 0.125 * FINE / self.scale).into_iter().map(|[x, y]| (x, y)).collect()
    }

    fn circle_of(&self, [x, y]: [f64; 2], radius: i32, style: ShapeStyle) -> Drawn {
        Ok(self.area.draw(&Circle::new((x, y), radius, style))?)
    }
}

fn fine(pixels: f64) -> i32 {
    (pixels * FINE).round() as i32
}
