//! Lens samples of six sequences, side by side: from Q15 to pixels, in integers.
//!
//! A component of b / 2^15 is in pixel floor((b + 2^15) d / 2^16) of a disc d pixels wide: from 0
//! to d - 1 for every 16-bit b.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_5X8};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, PrimitiveStyle, Rectangle};
use embedded_graphics::text::{Alignment, Baseline, Text, TextStyle, TextStyleBuilder};
use hemidisc::sequence::{Correlated, Halton, Jittered, NRooks, Random, SobolOwen};
use hemidisc::{Q15, table};

/// Points of each disc.
pub const COUNT: usize = 256;
/// Of the sequences.
pub const SEED: u32 = 7;

/// The points of a sequence, which the compiler puts into flash: 1 KiB.
macro_rules! points {
    ($($sequence:tt)*) => {{
        static POINTS: [[Q15; 2]; COUNT] = table!(Concentric<Q15>, $($sequence)*, COUNT);
        &POINTS
    }};
}

/// Captions and points of the discs, by rows.
pub static DISCS: [(&str, &[[Q15; 2]; COUNT]); COLUMNS * ROWS] = [
    ("random", points!(Random::new(SEED))),
    ("jittered", points!(Jittered::new(16, 16, SEED)?)),
    ("n-rooks", points!(NRooks::new(COUNT as u32, SEED)?)),
    ("correlated", points!(Correlated::new(16, 16, SEED)?)),
    ("Halton", points!(Halton::new())),
    ("Sobol-Owen", points!(SobolOwen::new(SEED))),
];
const COLUMNS: usize = 3;
const ROWS: usize = 2;

/// Of a point.
pub const DOT: Rgb565 = Rgb565::new(31, 52, 12);
const RIM: PrimitiveStyle<Rgb565> = PrimitiveStyle::with_stroke(Rgb565::new(9, 20, 12), 1);
const CAPTION: MonoTextStyle<'static, Rgb565> =
    MonoTextStyle::new(&FONT_5X8, Rgb565::new(22, 46, 24));
const BELOW: TextStyle =
    TextStyleBuilder::new().alignment(Alignment::Center).baseline(Baseline::Top).build();
/// Rows of pixels for a caption and the gaps about it.
const CAPTION_ROWS: u32 = 12;

/// Draws all discs, as large as the target lets them be; none on a target without the room.
///
/// # Errors
/// Those of the target.
pub fn draw<D: DrawTarget<Color = Rgb565>>(target: &mut D) -> Result<(), D::Error> {
    target.clear(Rgb565::BLACK)?;
    for (cell, (caption, points)) in cells(target.bounding_box()).zip(DISCS) {
        let disc = disc(cell);
        if disc.diameter == 0 {
            continue;
        }
        // On a small panel a caption is cut off where the neighbour's begins.
        let mut target = target.clipped(&cell);
        disc.into_styled(RIM).draw(&mut target)?;
        target.draw_iter(points.iter().map(|point| Pixel(pixel(disc, *point), DOT)))?;
        let below = Point::new(disc.center().x, disc.top_left.y + disc.diameter as i32 + 2);
        Text::with_text_style(caption, below, CAPTION, BELOW).draw(&mut target)?;
    }
    Ok(())
}

/// The cells of a panel, by rows.
pub fn cells(panel: Rectangle) -> impl Iterator<Item = Rectangle> {
    let edge = |k: usize, of: usize, side: u32| (side * k as u32 / of as u32) as i32;
    let corner = move |column, row| {
        let Size { width, height } = panel.size;
        panel.top_left + Point::new(edge(column, COLUMNS, width), edge(row, ROWS, height))
    };
    (0..COLUMNS * ROWS).map(move |index| {
        let (column, row) = (index % COLUMNS, index / COLUMNS);
        let [from, to] = [corner(column, row), corner(column + 1, row + 1)];
        Rectangle::new(from, Size::new((to.x - from.x) as u32, (to.y - from.y) as u32))
    })
}

/// The disc of a cell, above its caption.
pub fn disc(cell: Rectangle) -> Circle {
    let height = cell.size.height.saturating_sub(CAPTION_ROWS);
    let above = Rectangle::new(cell.top_left, Size::new(cell.size.width, height));
    Circle::with_center(above.center(), cell.size.width.min(height).saturating_sub(2))
}

/// The pixel of a point; x goes to the right and y up.
pub fn pixel(disc: Circle, point: [Q15; 2]) -> Point {
    let [across, up] = point.map(|component| {
        let from_edge = u32::from(component.to_bits().cast_unsigned() ^ 1 << 15);
        ((from_edge * disc.diameter) >> 16) as i32
    });
    disc.top_left + Point::new(across, disc.diameter as i32 - 1 - up)
}
