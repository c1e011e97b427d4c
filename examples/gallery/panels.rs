//! The panels that several plates share: a grid through a map, and a set of points on it.

use crate::grid::{Image, cells, lines};
use crate::statistics::closest_pair;
use examples::gallery::canvas::{
    Align, Drawn, Frame, GREY, INK, LINE, NOTE, Panel, Sheet, VERMILION,
};
use examples::gallery::curve::{chord, clipped};
use plotters::prelude::WHITE;

/// Cells of the coloured ground along an axis.
const GROUND: u32 = 8;
/// Half the side of a panel, in radii of the disc: the rim's points are drawn whole.
const HALF: f64 = 1.03;

/// A panel about the disc.
pub(crate) fn about_the_disc<'a>(sheet: &Sheet<'a>, frame: Frame) -> Panel<'a> {
    sheet.panel(frame, -HALF..HALF, -HALF..HALF)
}

/// The square's `n` x `n` grid through a map, each place in its colour.
pub(crate) fn ground(panel: &Panel, n: u32, image: Image) -> Drawn {
    for cell in cells(GROUND, image) {
        panel.fill(&cell.outline, cell.colour)?;
    }
    for line in lines(n, image) {
        panel.curve(&line, 0.7, LINE)?;
    }
    Ok(())
}

/// The square's `n` x `n` grid, cut by the circle; for an image that keeps its lines straight.
pub(crate) fn clipped_ground(panel: &Panel, n: u32, image: Image) -> Drawn {
    for cell in cells(GROUND, image) {
        let inside = clipped(&cell.outline);
        if !inside.is_empty() {
            panel.fill(&inside, cell.colour)?;
        }
    }
    for line in lines(n, image) {
        let ends = line.first().zip(line.last());
        if let Some(inside) = ends.and_then(|(from, to)| chord(*from, *to)) {
            panel.curve(&inside, 0.7, LINE)?;
        }
    }
    Ok(())
}

/// The square's border.
pub(crate) fn border(panel: &Panel) -> Drawn {
    let far = 0.5 * std::f64::consts::PI.sqrt();
    panel.curve(&[[-far, -far], [far, -far], [far, far], [-far, far], [-far, -far]], 1.0, INK)
}

/// Radius in pixels at which as many dots stay apart.
pub(crate) fn radius(count: usize) -> f64 {
    if count > 100 { 2.0 } else { 3.1 }
}

/// The points, the closest two of them joined.
pub(crate) fn points(panel: &Panel, points: &[[f64; 2]], radius: f64) -> Drawn {
    panel.dots(points, radius, INK)?;
    if let Some(pair) = closest_pair(points) {
        panel.dots(&pair, radius + 2.0, WHITE)?;
        panel.curve(&pair, 1.8, VERMILION)?;
        panel.dots(&pair, radius + 0.6, VERMILION)?;
    }
    Ok(())
}

/// Candidates that were thrown away.
pub(crate) fn rejected(panel: &Panel, points: &[[f64; 2]], radius: f64) -> Drawn {
    panel.rings(points, radius, GREY)
}

/// Points outside of where they belong.
pub(crate) fn misplaced(panel: &Panel, points: &[[f64; 2]], radius: f64) -> Drawn {
    panel.rings(points, radius + 0.3, VERMILION)
}

/// The names of the axes at the square's border, of a panel in `frame`.
pub(crate) fn axes(sheet: &Sheet, frame: Frame) -> Drawn {
    let inset = 0.5 * frame.width * (1.0 - 0.5 * std::f64::consts::PI.sqrt() / HALF);
    let (right, bottom) = (frame.x + frame.width - inset, frame.y + frame.height - inset);
    sheet.text("u →", [right, bottom + 10.0], 13.0, Align::Right, NOTE)?;
    sheet.text("v", [frame.x + inset - 9.0, frame.y + inset + 22.0], 13.0, Align::Centre, NOTE)?;
    sheet.text("↑", [frame.x + inset - 9.0, frame.y + inset + 8.0], 13.0, Align::Centre, NOTE)
}
