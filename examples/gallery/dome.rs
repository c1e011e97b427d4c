//! The hemisphere as seen from above or from the side, by parallel projection.

use crate::grid::{cells, lines};
use examples::gallery::canvas::{Drawn, Frame, INK, LINE, Panel, Sheet};
use plotters::prelude::RGBColor;

/// Cells of the coloured ground along an axis.
const GROUND: u32 = 8;
/// Cells between the lines.
const CELLS: u32 = 16;
/// Where no coordinate's direction reaches.
const PALE: RGBColor = RGBColor(0xf1, 0xf2, 0xf4);

/// From where the hemisphere is looked at: sine and cosine of the height above its horizon.
#[derive(Clone, Copy)]
pub(crate) struct View {
    sin: f64,
    cos: f64,
}

/// From straight above: the disc below the directions.
pub(crate) const TOP: View = View { sin: 1.0, cos: 0.0 };
/// From 30 degrees above the horizon, y pointing away.
pub(crate) const SIDE: View = View { sin: 0.5, cos: 0.866_025_404 };

impl View {
    /// Where a direction is seen: across, and up.
    pub(crate) fn seen(self, [x, y, z]: [f64; 3]) -> [f64; 2] {
        [x, y * self.sin + z * self.cos]
    }

    /// Whether a direction is on the side that faces the viewer.
    fn faces(self, [_, y, z]: [f64; 3]) -> bool {
        z * self.sin - y * self.cos >= 0.0
    }

    /// A panel `width` pixels wide, and its height.
    pub(crate) fn panel<'a>(
        self,
        sheet: &Sheet<'a>,
        x: f64,
        y: f64,
        width: f64,
    ) -> (Panel<'a>, f64) {
        const HALF: f64 = 1.03;
        let (low, high) = (-HALF * self.sin, HALF);
        let height = width * (high - low) / (2.0 * HALF);
        (sheet.panel(Frame { x, y, width, height }, -HALF..HALF, low..high), height)
    }

    /// The square's grid on the dome, each place in its colour, and the dome's outline.
    pub(crate) fn ground(self, panel: &Panel, image: impl Fn([u32; 2]) -> [f64; 3]) -> Drawn {
        let outline = self.outline();
        panel.fill(&outline, PALE)?;
        let mut ground = cells(GROUND, &image);
        // What faces away is painted first, and over.
        ground.sort_by_key(|cell| cell.outline.iter().filter(|d| self.faces(**d)).count());
        for cell in ground {
            let outline: Vec<_> = cell.outline.iter().map(|d| self.seen(*d)).collect();
            panel.fill(&outline, cell.colour)?;
        }
        for line in lines(CELLS, &image) {
            // The runs of a line that face the viewer.
            for run in line.split(|d| !self.faces(*d)) {
                let run: Vec<_> = run.iter().map(|d| self.seen(*d)).collect();
                if run.len() > 1 {
                    panel.curve(&run, 0.6, LINE)?;
                }
            }
        }
        panel.curve(&outline, 1.0, INK)
    }

    /// The horizon's near half, and the half of the great circle at right angles to the view.
    fn outline(self) -> Vec<[f64; 2]> {
        let half_turn = |from: u32| {
            (from..=from + 180).map(|degrees| f64::from(degrees).to_radians().sin_cos())
        };
        let near = half_turn(180).map(|(sin, cos)| self.seen([cos, sin, 0.0]));
        let far = half_turn(0).map(|(sin, cos)| [cos, sin]);
        near.chain(far).collect()
    }

    /// The directions on the near side.
    pub(crate) fn directions(self, panel: &Panel, directions: &[[f64; 3]], radius: f64) -> Drawn {
        let near = directions.iter().filter(|d| self.faces(**d));
        let seen: Vec<_> = near.map(|d| self.seen(*d)).collect();
        panel.dots(&seen, radius, INK)
    }
}
