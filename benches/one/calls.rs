//! How calls are timed: through a function that is not inlined, independent of each other and each
//! waiting for the last.

use crate::inputs::{Given, Input, Inputs, WINDOW};
use crate::words::Word;
use benches::rounds::Contender;
use std::hint::black_box;

/// The ends of the paths of both measurements.
pub(crate) const THROUGHPUT: &str = "throughput";
/// See [`THROUGHPUT`].
pub(crate) const LATENCY: &str = "latency";

/// All that is timed.
pub(crate) struct Calls<'a> {
    inputs: &'a Inputs,
    contenders: Vec<Contender<'a>>,
}

impl<'a> Calls<'a> {
    pub(crate) fn new(inputs: &'a Inputs) -> Self {
        Self { inputs, contenders: Vec::new() }
    }

    /// Takes in a call: `take` picks what it takes, and is no part of it.
    pub(crate) fn call<I, O: Word>(
        &mut self,
        path: &str,
        take: impl Fn(Given) -> I + Copy + 'a,
        call: impl FnMut(I) -> O + Clone + 'a,
    ) {
        let (mut windows, mut own) = (self.inputs.windows(), call.clone());
        self.contender(path, THROUGHPUT, WINDOW, move || {
            if let Some(window) = windows.next() {
                black_box(independent(window, take, &mut own));
            }
        });
        let (mut windows, mut own) = (self.inputs.windows(), call);
        self.contender(path, LATENCY, WINDOW, move || {
            if let Some(window) = windows.next() {
                black_box(dependent(window, take, &mut own));
            }
        });
    }

    /// Takes in what makes so many points at once.
    pub(crate) fn fill(&mut self, path: &str, points: usize, mut fill: impl FnMut(&Input) + 'a) {
        let mut windows = self.inputs.windows();
        let fills = WINDOW.div_ceil(points);
        self.contender(path, THROUGHPUT, fills * points, move || {
            windows.next().into_iter().flatten().take(fills).for_each(&mut fill);
        });
    }

    fn contender(&mut self, path: &str, kind: &str, points: usize, run: impl FnMut() + 'a) {
        self.contenders.push(Contender::new(format!("{path}/{kind}"), points, 1, run));
    }

    pub(crate) fn contenders(self) -> Vec<Contender<'a>> {
        self.contenders
    }
}

/// Throughput: calls overlap.
fn independent<I, O: Word>(
    window: &[Input],
    take: impl Fn(Given) -> I,
    call: &mut impl FnMut(I) -> O,
) -> u32 {
    let after = |sum, input| sum ^ apart(call, take(Given::after(input, 0))).word();
    window.iter().fold(0, after)
}

/// Latency: a call waits for the bits of the last result.
fn dependent<I, O: Word>(
    window: &[Input],
    take: impl Fn(Given) -> I,
    call: &mut impl FnMut(I) -> O,
) -> u32 {
    let none = black_box(0);
    let after = |last: u32, input| apart(call, take(Given::after(input, last & none))).word();
    window.iter().fold(0, after)
}

/// A function of its own for each call, so that a profile distinguishes them, too.
#[inline(never)]
fn apart<I, O>(call: &mut impl FnMut(I) -> O, given: I) -> O {
    call(given)
}
