//! What a fill of 256 points costs on this core: `path instructions stack`, a line each.

use board::{depth, exit, instructions, known_loop, println, start_counter};
use bytemuck::Pod;
use core::hint::black_box;
use hemidisc::sequence::SobolOwen;
use kernels::{CANDIDATES, COUNT, Visitor};

/// Rounds of the loop that shows that instructions are counted right.
const ROUNDS: u32 = 100_000;

/// Prints a line for each fill.
pub struct Counts<'a> {
    coordinates: &'a [[u32; 2]; CANDIDATES],
    /// Room for the largest points: three `f64`.
    room: &'a mut [u64; 3 * COUNT],
    /// What counting adds.
    overhead: u32,
}

impl Visitor for Counts<'_> {
    fn points<P: Pod>(
        &mut self,
        path: &'static str,
        fill: impl Fn(&[[u32; 2]], &mut [P]) -> usize,
    ) {
        // Rejection needs more coordinates than it keeps points; the others stop with the points.
        let coordinates = if path.contains("rejection") { CANDIDATES } else { COUNT };
        let Some(coordinates) = self.coordinates.get(..coordinates) else { return };
        let points: &mut [P] = bytemuck::cast_slice_mut(self.room);
        let Some(points) = points.get_mut(..COUNT) else { return };
        let mut filled = 0;
        let mut run = || filled = black_box(fill(black_box(coordinates), black_box(&mut *points)));
        let executed = instructions(&mut run) - self.overhead;
        let stack = depth(&mut run);
        if filled != COUNT {
            println!("{path}: {filled} points of {COUNT}");
            exit(1)
        }
        println!("{path} {executed} {stack}");
    }
}

/// Counts what the visitor is shown.
pub fn run(every: impl FnOnce(&mut Counts)) -> ! {
    start_counter();
    let overhead = instructions(|| black_box(()));
    println!("calibration/{} {} 0", 2 * ROUNDS, instructions(|| known_loop(ROUNDS)) - overhead);
    let mut coordinates = [[0; 2]; CANDIDATES];
    let sequence = SobolOwen::new(7);
    for (slot, index) in coordinates.iter_mut().zip(0..) {
        *slot = sequence.at(index);
    }
    let mut room = [0; 3 * COUNT];
    let mut counts = Counts { coordinates: &coordinates, room: &mut room, overhead };
    every(&mut counts);
    exit(0)
}
