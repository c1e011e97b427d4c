//! A camera with a thin lens, that looks at a point.

use crate::scene::{Ray, towards};
use crate::vector::{Vector, along, cross, difference, unit};

#[derive(Clone, Copy, Debug)]
pub(crate) struct Camera {
    position: Vector,
    /// From the position to the middle of the top left pixel's corner, in the plane of focus.
    corner: Vector,
    /// Pixels to the right and down, in the plane of focus.
    right: Vector,
    down: Vector,
    /// Radii of the lens.
    lens: [Vector; 2],
}

const POSITION: Vector = [2.2, 1.9, 8.0];
const TARGET: Vector = [-0.05, 0.75, 0.4];
/// Tangent of half the vertical field of view.
const SLOPE: f32 = 0.27;
const FOCAL_DISTANCE: f32 = 7.4;
const LENS_RADIUS: f32 = 0.12;

impl Camera {
    pub(crate) fn new([width, height]: [u32; 2]) -> Self {
        let ahead = towards(POSITION, TARGET);
        let x = unit(cross(ahead, [0.0, 1.0, 0.0]));
        let y = cross(x, ahead);
        let [width, height] = [width, height].map(|pixels| pixels as f32);
        let pixel = 2.0 * SLOPE * FOCAL_DISTANCE / height;
        let middle = ahead.map(|component| FOCAL_DISTANCE * component);
        let left = along(middle, -0.5 * width * pixel, x);
        Self {
            position: POSITION,
            corner: along(left, 0.5 * height * pixel, y),
            right: x.map(|component| pixel * component),
            down: y.map(|component| -pixel * component),
            lens: [x, y].map(|axis| axis.map(|component| LENS_RADIUS * component)),
        }
    }

    /// The ray from a point of the lens, of the unit disc, through a point of the picture, in
    /// pixels from the top left.
    pub(crate) fn ray(&self, [x, y]: [f32; 2], [across, up]: [f32; 2]) -> Ray {
        let [a, b] = self.lens;
        let from_centre = along(along([0.0; 3], across, a), up, b);
        let in_focus = along(along(self.corner, x, self.right), y, self.down);
        Ray {
            origin: along(self.position, 1.0, from_centre),
            direction: unit(difference(in_focus, from_centre)),
        }
    }
}
