//! Error against cost, both in logarithms: a row of panels for each machine, a column for each map.
//!
//! The line of a panel is the Pareto frontier: no mark beats one on it in both error and cost.

use crate::frontier::{CORES, HOST, Mark, frontier, marks};
use crate::measure::Row;
use examples::gallery::canvas::{
    Align, BLUE, Drawn, Frame, GREEN, GREY, INK, LINE, NOTE, PURPLE, Panel, Sheet, VERMILION, plate,
};
use plotters::prelude::RGBColor;
use std::error::Error;
use std::ops::Range;

// Of the palette that the canvas takes its colours from.
const ORANGE: RGBColor = RGBColor(0xe6, 0x9f, 0x00);
const SKY: RGBColor = RGBColor(0x56, 0xb4, 0xe9);

const ARITHMETICS: [(&str, RGBColor); 7] = [
    ("libm-f64", INK),
    ("libm-f32", BLUE),
    ("fast-f32", VERMILION),
    ("micromath-f32", ORANGE),
    ("q31", GREEN),
    ("q15", PURPLE),
    ("q15-div", SKY),
];
const MAPS: [&str; 4] = ["disc", "uniform", "cosine", "power"];
const SIZE: [u32; 2] = [900, 1076];
const PANEL: [f64; 2] = [186.0, 138.0];
const GAP: [f64; 2] = [12.0, 44.0];
const LEFT: f64 = 92.0;
const TOP: f64 = 152.0;
const RADIUS: f64 = 4.0;
/// Powers of ten of the errors.
const ERRORS: Range<f64> = -16.4..-2.0;

/// The text of the SVG file.
pub fn pareto(rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let drawn = |row: &&Row| {
        MAPS.contains(&row.map) && ARITHMETICS.iter().any(|(name, _)| *name == row.arithmetic)
    };
    if let Some(Row { map, arithmetic, .. }) = rows.iter().find(|row| !drawn(row)) {
        return Err(format!("the plot has no place for {map} in {arithmetic}").into());
    }
    plate(SIZE, |sheet| {
        sheet.bold("What accuracy costs", [24.0, 28.0], 22.0, Align::Left)?;
        let what = "Largest error of a component of a point, of a disc or sphere of radius 1, against the cost of the point.";
        sheet.text(what, [24.0, 56.0], 13.0, Align::Left, NOTE)?;
        legend(sheet)?;
        let host = std::iter::once(HOST).zip([-1.4..0.7]);
        let boards = CORES.into_iter().map(|core| (core, 0.9..4.7));
        for ((machine, costs), line) in host.chain(boards).zip(0_u32..) {
            let y = TOP + f64::from(line) * (PANEL[1] + GAP[1]);
            for (map, column) in MAPS.into_iter().zip(0_u32..) {
                let x = LEFT + f64::from(column) * (PANEL[0] + GAP[0]);
                let frame = Frame { x, y, width: PANEL[0], height: PANEL[1] };
                let axes = Axes { frame, costs: costs.clone() };
                axes.draw(sheet, column == 0)?;
                let own: Vec<_> = rows.iter().filter(|row| row.map == map).collect();
                axes.marks(sheet, &own, machine)?;
                let centre = x + 0.5 * PANEL[0];
                if column == 0 {
                    sheet.text("error", [x - 6.0, y + 4.0], 12.0, Align::Right, INK)?;
                }
                if line == 0 {
                    sheet.bold(map, [centre, y - 14.0], 14.0, Align::Centre)?;
                }
            }
            let unit = if line == 0 {
                "Host: time a point, libm-f32 on the same map = 1".to_owned()
            } else {
                format!("{machine}: executed instructions a point")
            };
            let middle = LEFT + 2.0 * PANEL[0] + 1.5 * GAP[0];
            sheet.text(&unit, [middle, y + PANEL[1] + 29.0], 12.0, Align::Centre, INK)?;
        }
        Ok(())
    })
}

fn legend(sheet: &Sheet) -> Drawn {
    let whole = whole(sheet);
    let mut x = 30.0;
    for (name, colour) in ARITHMETICS {
        whole.dots(&[[x, -84.0]], RADIUS + 1.0, colour)?;
        sheet.text(name, [x + 10.0, 84.0], 13.0, Align::Left, INK)?;
        x += 34.0 + 7.6 * name.len() as f64;
    }
    whole.dots(&[[30.0, -106.0]], RADIUS, GREY)?;
    sheet.text("over the concentric disc map", [40.0, 106.0], 13.0, Align::Left, INK)?;
    whole.rings(&[[250.0, -106.0]], RADIUS, INK)?;
    sheet.text("over the polar one", [260.0, 106.0], 13.0, Align::Left, INK)?;
    whole.curve(&[[395.0, -106.0], [425.0, -106.0]], 1.2, LINE)?;
    sheet.text("nothing is both cheaper and more accurate", [432.0, 106.0], 13.0, Align::Left, INK)
}

/// The sheet in its own pixels, y upwards from minus its height.
fn whole<'a>(sheet: &Sheet<'a>) -> Panel<'a> {
    let [width, height] = SIZE.map(f64::from);
    sheet.panel(Frame { x: 0.0, y: 0.0, width, height }, 0.0..width, -height..0.0)
}

struct Axes {
    frame: Frame,
    /// Powers of ten.
    costs: Range<f64>,
}

impl Axes {
    fn at(&self, cost: f64, error: f64) -> [f64; 2] {
        let Frame { x, y, width, height } = self.frame;
        let share = |value: f64, range: &Range<f64>| {
            (value.log10() - range.start) / (range.end - range.start)
        };
        [x + width * share(cost, &self.costs), -(y + height * (1.0 - share(error, &ERRORS)))]
    }

    fn draw(&self, sheet: &Sheet, first: bool) -> Drawn {
        let whole = whole(sheet);
        let Frame { x, y, width, height } = self.frame;
        let (right, bottom) = (x + width, y + height);
        for power in [-16, -12, -8, -4] {
            let [_, at] = self.at(1.0, 10_f64.powi(power));
            whole.curve(&[[x, at], [right, at]], 0.5, GREY)?;
            if first {
                let label = superscript(power);
                sheet.text(&label, [x - 6.0, -at], 12.0, Align::Right, NOTE)?;
            }
        }
        for power in self.costs.start.ceil() as i32..=self.costs.end.floor() as i32 {
            let [at, _] = self.at(10_f64.powi(power), 1.0);
            whole.curve(&[[at, -y], [at, -bottom]], 0.5, GREY)?;
            let label = match power {
                -1 => "0.1".to_owned(),
                0 => "1".to_owned(),
                1 => "10".to_owned(),
                2 => "100".to_owned(),
                _ => superscript(power),
            };
            sheet.text(&label, [at, bottom + 11.0], 12.0, Align::Centre, NOTE)?;
        }
        whole.curve(&[[x, -y], [x, -bottom], [right, -bottom], [right, -y], [x, -y]], 1.0, LINE)
    }

    fn marks(&self, sheet: &Sheet, rows: &[&Row], machine: &str) -> Drawn {
        let whole = whole(sheet);
        let marks = marks(rows, machine);
        if marks.is_empty() {
            let Frame { x, y, width, height } = self.frame;
            let middle = [x + 0.5 * width, y + 0.5 * height];
            return sheet.text("not measured", middle, 12.0, Align::Centre, NOTE);
        }
        for Mark { cost, error, row } in &marks {
            assert!(
                self.costs.contains(&cost.log10()) && ERRORS.contains(&error.log10()),
                "{} of {machine} is off the plot: {cost}, {error}",
                row.arithmetic
            );
        }
        let mut steps: Vec<[f64; 2]> = Vec::new();
        for Mark { cost, error, .. } in frontier(&marks) {
            let [x, y] = self.at(cost, error);
            if let Some([_, above]) = steps.last().copied() {
                steps.push([x, above]);
            }
            steps.push([x, y]);
        }
        whole.curve(&steps, 1.2, LINE)?;
        for Mark { cost, error, row } in marks {
            let colour = ARITHMETICS.iter().find(|(name, _)| *name == row.arithmetic);
            let colour = colour.map_or(GREY, |(_, colour)| *colour);
            let at = [self.at(cost, error)];
            if row.disc == "polar" {
                whole.rings(&at, RADIUS - 0.5, colour)?;
            } else {
                whole.dots(&at, RADIUS, colour)?;
            }
        }
        Ok(())
    }
}

fn superscript(power: i32) -> String {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let text = power.unsigned_abs().to_string();
    let raised = text.chars().filter_map(|digit| digits.get(digit.to_digit(10)? as usize));
    format!("10{}{}", if power < 0 { "⁻" } else { "" }, raised.collect::<String>())
}
