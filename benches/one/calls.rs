//! How calls are timed: through a function that is not inlined, in three ways.
//!
//! The function reads what it takes from memory, and gives one word of all bits of the result. So
//! nothing is written to the stack for a call, where a processor may wait long for what it wrote in
//! other pieces than it reads.

use crate::inputs::{Given, Input, Inputs, WINDOW};
use crate::words::Word;
use benches::rounds::{Contender, Measurement, shortest};
use std::hint::black_box;

/// Calls that do not wait for each other, of inputs that the branch predictor has not seen of late.
pub(crate) const THROUGHPUT: &str = "throughput";
/// Each call waits for the bits of the last result.
pub(crate) const LATENCY: &str = "latency";
/// Calls that do not wait, of the same few inputs again and again. The branch predictor knows them:
/// the least that a formula with branches can take, and less than in a renderer.
pub(crate) const REPEATED: &str = "repeated";

/// How often inputs repeat before they are timed, and while.
const REPEATS: usize = 20;

/// All that is timed.
pub(crate) struct Calls<'a> {
    inputs: &'a Inputs,
    fresh: Vec<Contender<'a>>,
    repeated: Vec<Contender<'a>>,
}

impl<'a> Calls<'a> {
    pub(crate) fn new(inputs: &'a Inputs) -> Self {
        Self { inputs, fresh: Vec::new(), repeated: Vec::new() }
    }

    /// Takes in a call.
    pub(crate) fn call<O: Word>(&mut self, path: &str, call: impl FnMut(Given) -> O + Clone + 'a) {
        let (mut windows, mut own) = (self.inputs.windows(), call.clone());
        self.fresh.push(contender(path, THROUGHPUT, 1, move || {
            black_box(independent(windows.next().unwrap_or(&[]), &mut own));
        }));
        let (mut windows, mut own) = (self.inputs.windows(), call.clone());
        self.fresh.push(contender(path, LATENCY, 1, move || {
            black_box(dependent(windows.next().unwrap_or(&[]), &mut own));
        }));
        let (window, mut own) = (self.inputs.windows().next().unwrap_or(&[]), call);
        self.repeated.push(contender(path, REPEATED, REPEATS, move || {
            black_box(independent(window, &mut own));
        }));
    }

    /// Takes in what makes so many points at once, of which there are whole windows.
    pub(crate) fn fill(&mut self, path: &str, points: usize, mut fill: impl FnMut(Given) + 'a) {
        let mut windows = self.inputs.windows();
        let fills = WINDOW.div_ceil(points);
        let path = format!("{path}/{THROUGHPUT}");
        self.fresh.push(Contender::new(path, fills * points, 1, move || {
            let window = windows.next().into_iter().flatten();
            window.take(fills).for_each(|input| fill(Given::after(input, 0)));
        }));
    }

    /// Times all. Those that repeat come after the others: they take longer, and vary less.
    pub(crate) fn measure(self, rounds: usize) -> Vec<Measurement> {
        let mut measured = shortest(self.fresh, rounds);
        measured.extend(shortest(self.repeated, rounds.div_ceil(REPEATS)));
        measured
    }
}

fn contender<'a>(path: &str, kind: &str, runs: usize, run: impl FnMut() + 'a) -> Contender<'a> {
    Contender::new(format!("{path}/{kind}"), WINDOW, runs, run)
}

fn independent<O: Word, C: FnMut(Given) -> O>(window: &[Input], call: &mut C) -> u32 {
    let (apart, none) = (black_box(apart::<O, C> as Apart<C>), black_box(0));
    let called = |input| apart(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, call, input, none);
    window.iter().map(called).fold(0, |sum, word| sum ^ word)
}

fn dependent<O: Word, C: FnMut(Given) -> O>(window: &[Input], call: &mut C) -> u32 {
    let (apart, none) = (black_box(apart::<O, C> as Apart<C>), black_box(0));
    window.iter().fold(0, |last, input| {
        apart(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, call, input, last & none)
    })
}

/// Zeros for the registers of floats, then what is called, and what it takes.
type Apart<C> = fn(f32, f32, f32, f32, f32, f32, f32, f32, &mut C, &Input, u32) -> u32;

/// A function of its own for each call, of which the caller knows the address alone.
///
/// The zeros are not used. On x86-64 a conversion to a float keeps the upper part of its register,
/// so it waits for what was there before: without them a call may wait for the last result without
/// taking it. What runs between two calls of a renderer has overwritten these registers.
#[expect(clippy::too_many_arguments, reason = "one for each register")]
#[inline(never)]
fn apart<O: Word, C: FnMut(Given) -> O>(
    _: f32,
    _: f32,
    _: f32,
    _: f32,
    _: f32,
    _: f32,
    _: f32,
    _: f32,
    call: &mut C,
    input: &Input,
    last: u32,
) -> u32 {
    call(Given::after(input, last)).word()
}
