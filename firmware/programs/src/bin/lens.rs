//! An example to copy: lens samples for each pixel of a camera, without a float, an allocator or a
//! panic.
//!
//! Two lamps are seen through a thin lens. The left one is in focus; the right one is twice as far
//! away, so that its light spreads over a disc, the lens's own shape. A pixel takes 64 points on
//! the lens from a domain of its own into a buffer in RAM, and counts the rays that meet a lamp.
#![no_std]
#![no_main]

use board::{exit, write};
use heapless::Vec;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Domain, Points, Q15};
use static_cell::ConstStaticCell;

/// Lens samples of a pixel.
const SAMPLES: usize = 64;
const WIDTH: usize = 64;
const HEIGHT: i32 = 24;
/// Lengths are in units of 2^-15 of the picture's height.
const ONE: i32 = 1 << 15;
/// The lens's radius.
const APERTURE: i32 = ONE * 3 / 4;
const LAMP: i32 = ONE / 4;
const NEAR: [i32; 2] = [-ONE * 3 / 4, 0];
const FAR: [i32; 2] = [ONE * 3 / 2, 0];

/// Whether a point is within a lamp's radius of it.
fn meets([x, y]: [i32; 2], [lamp_x, lamp_y]: [i32; 2]) -> bool {
    let (x, y) = ((x - lamp_x) >> 3, (y - lamp_y) >> 3);
    x * x + y * y < (LAMP >> 3) * (LAMP >> 3)
}

/// How many of a pixel's rays meet a lamp; `focus` is where all of them cross the plane in focus.
fn hits(focus: [i32; 2], lens: &[[Q15; 2]]) -> usize {
    let rays =
        lens.iter().map(|point| point.map(|x| (i32::from(x.to_bits()) * (APERTURE >> 6)) >> 9));
    let hit = rays.filter(|[x, y]| {
        // At twice the distance of the plane in focus a ray is as far beyond its axis as it began
        // before it.
        let far = [2 * focus[0] - x, 2 * focus[1] - y];
        meets(focus, NEAR) || meets(far, FAR)
    });
    hit.count()
}

/// The points of the pixel at hand.
static LENS: ConstStaticCell<Vec<[Q15; 2], SAMPLES>> = ConstStaticCell::new(Vec::new());

#[board::entry]
fn main() -> ! {
    // It is taken here alone, and once.
    let Some(lens) = LENS.try_take() else { exit(1) };
    let camera = Domain::new(7);
    let mut line = [b'\n'; WIDTH + 1];
    for row in 0..HEIGHT {
        for (column, character) in (0_i32..).zip(line.iter_mut().take(WIDTH)) {
            let pixel = camera.pixel(column.cast_unsigned(), row.cast_unsigned());
            lens.clear();
            Points::new(SobolOwen::in_domain(pixel), Concentric::<Q15>::new())
                .extend_heapless(lens);
            // A character is twice as high as wide.
            let x = (2 * column - WIDTH as i32 + 1) * (ONE / 2 / HEIGHT);
            let y = (2 * row - HEIGHT + 1) * (ONE / HEIGHT);
            let hits = hits([x, y], lens);
            // A shade for each power of two.
            *character = b" .:-=+*#"[(usize::BITS - hits.leading_zeros()) as usize & 7];
        }
        write(&line);
    }
    exit(0)
}
