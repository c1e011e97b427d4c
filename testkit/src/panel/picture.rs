//! A picture while it is rendered: from coarse to fine, a part of a row at a time.
//!
//! A pass renders the rows halfway between those of the passes before it, and draws each down to
//! the next row that is there. No row is rendered twice, and nothing is kept of the picture but the
//! part of a row at hand: for 64 pixels 768 bytes of sums and 128 of colours.

use super::srgb;
use core::ops::Range;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// Pixels that are rendered and sent at once.
const PART: usize = 64;

/// Some rows of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Pass {
    /// Those whose number has these low bits,
    low: u32,
    /// of the bits in here.
    mask: u32,
    /// How many rows each is drawn over.
    tall: u32,
}

/// The passes that make a picture: each row is in one of them.
pub const PASSES: [Pass; 4] = [
    Pass { low: 0, mask: 7, tall: 8 },
    Pass { low: 4, mask: 7, tall: 4 },
    Pass { low: 2, mask: 3, tall: 2 },
    Pass { low: 1, mask: 1, tall: 1 },
];

/// Renders and draws a pass over the whole target.
///
/// `row` is the renderer's: it adds a range of samples to each of the sums, which are those of the
/// pixels from (x, y) to the right. `samples` are those of each pixel.
///
/// # Errors
/// Those of the target.
pub fn draw<D: DrawTarget<Color = Rgb565>>(
    target: &mut D,
    pass: Pass,
    samples: u16,
    row: impl Fn([u32; 2], Range<u32>, &mut [[f32; 3]]),
) -> Result<(), D::Error> {
    let Rectangle { top_left, size: Size { width, height } } = target.bounding_box();
    let share = 1.0 / f32::from(samples);
    for y in (0..height).filter(|y| y & pass.mask == pass.low) {
        let tall = pass.tall.min(height - y);
        for x in (0..width).step_by(PART) {
            let (mut sums, mut colours) = ([[0.0; 3]; PART], [Rgb565::BLACK; PART]);
            let wide = PART.min((width - x) as usize);
            let (sums, colours) = (&mut sums[..wide], &mut colours[..wide]);
            row([x, y], 0..samples.into(), sums);
            for (colour, sum) in colours.iter_mut().zip(sums) {
                *colour = srgb::encode(sum.map(|sum| share * sum));
            }
            let corner = top_left + Point::new(x as i32, y as i32);
            let area = Rectangle::new(corner, Size::new(wide as u32, tall));
            let rows = colours.iter().copied().cycle().take(wide * tall as usize);
            target.fill_contiguous(&area, rows)?;
        }
    }
    Ok(())
}
