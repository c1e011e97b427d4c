//! A panel in memory that refuses what a driver would have to put right, and that can fail.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// Where a panel is among other things that the driver draws on.
const CORNER: Point = Point::new(-3, 5);

/// What went wrong: the number of the transfer.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Broken(pub(super) usize);

#[derive(Debug)]
pub(super) struct Target {
    area: Rectangle,
    pixels: Vec<Rgb565>,
    /// Calls of the driver.
    pub(super) transfers: usize,
    /// The first of them that fails.
    broken_from: usize,
}

impl Target {
    pub(super) fn new(size: [u32; 2]) -> Self {
        let area = Rectangle::new(CORNER, size.into());
        let pixels = vec![Rgb565::MAGENTA; (size[0] * size[1]) as usize];
        Self { area, pixels, transfers: 0, broken_from: usize::MAX }
    }

    /// A panel that fails from a transfer on, counted from 0.
    pub(super) fn broken(size: [u32; 2], broken_from: usize) -> Self {
        Self { broken_from, ..Self::new(size) }
    }

    /// The colour at (x, y) from the panel's corner.
    pub(super) fn at(&self, x: u32, y: u32) -> Rgb565 {
        self.pixels[(y * self.area.size.width + x) as usize]
    }

    /// The pixels of a colour, from the origin that the driver has.
    pub(super) fn of(&self, colour: Rgb565) -> impl Iterator<Item = Point> {
        let pixels = self.area.points().zip(&self.pixels);
        pixels.filter(move |(_, pixel)| **pixel == colour).map(|(point, _)| point)
    }

    pub(super) fn pixels(&self) -> &[Rgb565] {
        &self.pixels
    }
}

impl Dimensions for Target {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Target {
    type Color = Rgb565;
    type Error = Broken;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Broken>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        let transfer = self.transfers;
        self.transfers += 1;
        if transfer >= self.broken_from {
            return Err(Broken(transfer));
        }
        for Pixel(point, colour) in pixels {
            assert!(self.area.contains(point), "{point} is not in {:?}", self.area);
            let Point { x, y } = point - self.area.top_left;
            self.pixels[y as usize * self.area.size.width as usize + x as usize] = colour;
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Broken> {
        self.draw_iter(area.points().map(|point| Pixel(point, colour)))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colours: I) -> Result<(), Broken>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        let count = (area.size.width * area.size.height) as usize;
        // One more than there should be, of what may have no end.
        let colours: Vec<_> = colours.into_iter().take(count + 1).collect();
        assert_eq!(colours.len(), count, "colours for {area:?}");
        self.draw_iter(area.points().zip(colours).map(|(point, colour)| Pixel(point, colour)))
    }
}
