//! A perspective camera: x to the right, y up, z ahead.

use super::Vector;
use super::vector::{along, cross, sum, unit};
use hemidisc::arithmetic::{Arithmetic, Real, Root};
use hemidisc::{Error, Frame, Unit};

/// A half-line; the direction is of unit length.
#[derive(Clone, Copy, Debug)]
pub struct Ray<A: Arithmetic> {
    /// Where it starts.
    pub origin: [A::Real; 3],
    /// Where it goes.
    pub direction: [A::Real; 3],
}

/// Where pixels look.
#[derive(Clone, Copy, Debug)]
pub struct Camera<A: Arithmetic> {
    position: [A::Real; 3],
    axes: [[A::Real; 3]; 3],
    /// Width of a pixel on the image plane z = 1.
    pixel: A::Real,
    /// Half the image in pixels.
    centre: [A::Real; 2],
}

impl<A: Root> Camera<A> {
    /// A camera at a position that looks ahead at a picture of at least one pixel, with the world's
    /// y axis up in the image; `slope` is the tangent of half the vertical field of view.
    ///
    /// # Errors
    /// [`Error::NoDirection`] if ahead is zero, infinite or NaN.
    pub fn new(
        position: [A::Real; 3],
        ahead: [A::Real; 3],
        slope: A::Real,
        [width, height]: [u32; 2],
    ) -> Result<Self, Error> {
        let frame = Frame::normalized(ahead)?;
        let [across, _, z] = frame.axes();
        let level = cross(z, [A::Real::ZERO, A::Real::ONE, A::Real::ZERO]);
        // If ahead is straight up or down, every direction across is level.
        let x = Unit::normalized(level).map_or(across, Unit::get);
        let centre = [width, height].map(|pixels| A::Real::HALF * count(pixels));
        let pixel = slope / centre[1];
        Ok(Self { position, axes: [x, cross(x, z), z], pixel, centre })
    }

    /// The point of the image plane z = 1 at a place within a pixel, both from the top left.
    #[inline]
    pub fn image_point(&self, pixel: [u32; 2], within: [A::Real; 2]) -> [A::Real; 2] {
        let [x, y] = core::array::from_fn(|i| {
            (count::<A::Real>(pixel[i]) + within[i] - self.centre[i]) * self.pixel
        });
        [x, -y]
    }

    /// The world's ray of one in camera space.
    #[inline]
    pub fn ray(&self, origin: Vector<A>, direction: Vector<A>) -> Ray<A> {
        let turned = |[x, y, z]: Vector<A>| {
            let [right, up, ahead] = self.axes;
            core::array::from_fn(|i| x * right[i] + y * up[i] + z * ahead[i])
        };
        Ray { origin: sum(self.position, turned(origin)), direction: unit::<A>(turned(direction)) }
    }
}

impl<A: Root> Ray<A> {
    /// The point at a distance.
    #[inline]
    pub(super) fn at(&self, distance: A::Real) -> Vector<A> {
        along(self.origin, distance, self.direction)
    }
}

/// A number of pixels; exact below 2^24.
#[inline]
fn count<R: Real>(pixels: u32) -> R {
    R::over_2_32(pixels) / R::over_2_32(1)
}
