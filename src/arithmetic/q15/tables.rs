//! The tables of Q15, computed when the crate is compiled; an image holds those that its maps read.
//!
//! A chord lies to one side of its curve, at most f'' w^2 / 8 from it in a bucket of width w. Each
//! chord is moved by half of that: what is left is f'' w^2 / 16 to both sides.
//!
//! tests/derive/q15.py derives every table and constant from its definition, and shows for those
//! that were chosen by a test that the next value fails.

/// Cosine and sine of pi/4 t, by their series; for t in [0, 2].
const fn cos_sin(t: f64) -> [f64; 2] {
    let angle = core::f64::consts::FRAC_PI_4 * t;
    let (mut cos, mut sin, mut term) = (0.0, 0.0, 1.0);
    let mut n = 0;
    while n < 24 {
        if n % 2 == 0 {
            cos += term
        } else {
            sin += term
        }
        n += 1;
        term *= angle / n as f64;
        if n % 2 == 0 {
            term = -term;
        }
    }
    [cos, sin]
}

/// Square root by Newton's steps from above; for x in [0, 4].
const fn sqrt(x: f64) -> f64 {
    let mut root = 2.0;
    let mut n = 0;
    while n < 40 {
        root = 0.5 * (root + x / root);
        n += 1;
    }
    root
}

/// 2^-x by the series of exp; for x in [-1, 2].
const fn exp2_neg(x: f64) -> f64 {
    let (mut sum, mut term, mut n) = (0.0, 1.0, 0);
    while n < 40 {
        sum += term;
        n += 1;
        term *= -x * core::f64::consts::LN_2 / n as f64;
    }
    sum
}

/// log2 by the series 2 atanh((x - 1) / (x + 1)); for x in [1/2, 2].
const fn log2(x: f64) -> f64 {
    let s = (x - 1.0) / (x + 1.0);
    let (mut sum, mut power, mut n) = (0.0, s, 1);
    while n < 80 {
        sum += power / n as f64;
        power *= s * s;
        n += 2;
    }
    2.0 * sum * core::f64::consts::LOG2_E
}

/// What a table holds.
#[derive(Clone, Copy)]
enum Function {
    /// sqrt x.
    Root,
    /// 1 / sqrt(1/2 + x / 2).
    ReciprocalRoot,
    /// log2(1 + x).
    Log,
    /// 2^-x.
    Exp,
    /// sqrt(-log2(1 - y) / y) of y = x / 2.
    Pole,
    /// sqrt((1 - 4^-x) / (2 ln 2 x)).
    Bend,
}

const fn value(function: Function, x: f64) -> f64 {
    // Where a quotient is 0/0 its neighbour stands in; the nodes are even closer to their limits.
    let x0 = if x < 1e-6 && x > -1e-6 { 1e-6 } else { x };
    match function {
        Function::Root => sqrt(x),
        Function::ReciprocalRoot => 1.0 / sqrt(0.5 + 0.5 * x),
        Function::Log => log2(1.0 + x),
        Function::Exp => exp2_neg(x),
        Function::Pole => sqrt(-log2(1.0 - 0.5 * x0) / (0.5 * x0)),
        Function::Bend => sqrt((1.0 - exp2_neg(2.0 * x0)) / (2.0 * core::f64::consts::LN_2 * x0)),
    }
}

/// Chords of a function of [0, 1) over `N` buckets; its argument in 2^-32.
///
/// A word has the value at the beginning of its bucket and the change over the bucket:
///
/// ```text
/// bit 31                          13 12                  1   0
///    +------------------------------+----------------------+---+
///    | value, 19 bits of 2^-19      | change, 12 bits of   | 0 |
///    | = 2^13 units of 2^-32        | 2^-17 a bucket       |   |
///    +------------------------------+----------------------+---+
/// ```
///
/// A bucket has 2^15 places. A change of 2^-17 a bucket is one of 2^-32 a place, so the value at a
/// place is the whole word plus (or minus) change times place: one table, one product and one sum.
/// The low field, twice the change, is read as part of the value; the value is chosen with that in
/// mind.
#[derive(Clone, Copy)]
pub(super) struct Chords<const N: usize>([u32; N]);

/// The largest change: 12 bits.
const CHANGE: u32 = (1 << 12) - 1;
/// The bits of a place within a bucket.
const PLACE_BITS: u32 = 15;
/// The places of a bucket.
const PLACES: u32 = 1 << PLACE_BITS;
/// The bits of a word below its value: the change and the 0.
const LOW_BITS: u32 = 13;
/// The least step of a word's value, in 2^-32.
const STEP: u64 = 1 << LOW_BITS;

impl<const N: usize> Chords<N> {
    /// The function times `scale` plus a bias, from the bucket `from` on. The bias is in 2^-32;
    /// `ends` are the biases at the first end of the chords and at 1.
    const fn new(function: Function, from: usize, scale: f64, bias: f64, ends: [f64; 2]) -> Self {
        const ONE: f64 = 4_294_967_296.0;
        let (mut words, width, mut i) = ([0; N], 1.0 / N as f64, from);
        while i < N {
            let x = i as f64 * width;
            let (first, last) = (value(function, x) * scale, value(function, x + width) * scale);
            // Half of the largest distance from the curve, to either side.
            let bend = 0.5 * (first + last) - value(function, x + 0.5 * width) * scale;
            let first = (first - 0.5 * bend) * ONE + if i == from { ends[0] } else { bias };
            let last = (last - 0.5 * bend) * ONE + if i == N - 1 { ends[1] } else { bias };
            // 1 has no place.
            let (first, last) = (first.min(ONE - 1.0), last.min(ONE - 1.0));
            let change = ((last - first).abs() / PLACES as f64 + 0.5) as u32;
            assert!(change <= CHANGE);
            // What the last place adds.
            let rise = if last < first { 0 } else { change as u64 * (PLACES - 1) as u64 };
            // Exact in the middle of the bucket, and less the word's low field, which adds to what
            // is read.
            let middle = (PLACES / 2) as f64;
            let half = middle * if last < first { -(change as f64) } else { change as f64 };
            let begin = 0.5 * (first + last) - half - 2.0 * change as f64;
            // To the nearest step, or the last one that keeps every place below 1.
            let mut begin = (begin + (STEP / 2) as f64) as u64 & !(STEP - 1);
            while begin + 2 * change as u64 + rise >= 1 << 32 {
                begin -= STEP;
            }
            words[i] = begin as u32 | change << 1;
            i += 1;
        }
        Self(words)
    }

    /// Its word, and the place within.
    #[inline(always)]
    const fn word(&self, x: u32) -> (u32, u32) {
        let bits = N.ilog2();
        (self.0[(x >> (32 - bits)) as usize & (N - 1)], (x << bits) >> (32 - PLACE_BITS))
    }

    #[inline(always)]
    pub(super) const fn rising(&self, x: u32) -> u32 {
        let (word, place) = self.word(x);
        word + (word >> 1 & CHANGE) * place
    }

    #[inline(always)]
    pub(super) const fn falling(&self, x: u32) -> u32 {
        let (word, place) = self.word(x);
        word - (word >> 1 & CHANGE) * place
    }
}

/// Half an LSB of Q15 in 2^-32: a shift to LSBs then rounds to the nearest.
pub(super) const HALF: u32 = 1 << 16;
const HALF_LSB: f64 = HALF as f64;
/// Half of 2^-16 in 2^-32: a shift to 16 bits then rounds to the nearest.
const HALF_16: f64 = (1 << 15) as f64;
/// The bias of [`ROOT`] at 1/4, which is the rim of the uniform lobe.
///
/// The largest multiple of 0.05 half LSBs with which no point of the uniform lobe leaves the disc.
/// `python3 tests/derive/q15.py --search` finds it; the exhaustive test (tests/arithmetic/q15.rs)
/// confirms it.
const ROOT_AT_RIM: f64 = -0.15 * HALF_LSB;

/// sqrt x of x >= 1/4, plus [`HALF`], but for the bucket at 1/4.
pub(super) const ROOT: Chords<128> =
    Chords::new(Function::Root, 32, 1.0, HALF_LSB, [ROOT_AT_RIM, HALF_LSB]);
/// 1 / sqrt(1/2 + x / 2), halved.
pub(super) const RECIPROCAL_ROOT: Chords<128> =
    Chords::new(Function::ReciprocalRoot, 0, 0.5, HALF_16, [HALF_16; 2]);
/// log2(1 + x).
pub(super) const LOG: Chords<64> = Chords::new(Function::Log, 0, 1.0, HALF_16, [HALF_16; 2]);
/// 2^-x, plus [`HALF`].
pub(super) const EXP: Chords<64> = Chords::new(Function::Exp, 0, 1.0, HALF_LSB, [HALF_LSB; 2]);
/// sqrt(-log2(1 - y) / y) of y = x / 2, halved.
pub(super) const POLE: Chords<64> = Chords::new(Function::Pole, 0, 0.5, HALF_16, [HALF_16; 2]);
/// sqrt((1 - 4^-x) / (2 ln 2 x)).
pub(super) const BEND: Chords<64> = Chords::new(Function::Bend, 0, 1.0, HALF_16, [HALF_16; 2]);

/// Lines for a bucket of t: cos(pi/4 t) = a - b t and sin(pi/4 t) = c + d t, in 2^-15.
#[derive(Clone, Copy)]
pub(super) struct Lines {
    pub(super) a: u16,
    pub(super) b: u16,
    pub(super) c: u16,
    pub(super) d: u16,
}

/// Buckets of t in [0, 1]. A crude quotient is up to 1/33 larger: 62 is the most for which it stays
/// below 64, the end of [`LINES`].
pub(super) const BUCKETS: u32 = 62;

/// How much smaller than 1 the circle of the lines is, so that no line leaves the disc where a
/// crude quotient takes it beyond its bucket.
///
/// The least multiple of 0.05 LSBs with which no point of the disc or the uniform lobe is outside.
/// `python3 tests/derive/q15.py --search` finds it, and a point outside with 0.60; the exhaustive
/// test (tests/q15) confirms it.
const INWARD: f64 = 0.65 / 32_768.0;

/// How many units of 2^-15 a line's slope may be from the tangent's.
///
/// From 4 to 32 units [`INWARD`] may be 0.65 LSB; with 2 or 48 it must be more. Within that range a
/// longer reach has smaller errors: a line is within 0.77 LSB over its bucket with 24, within 0.91
/// with 4 and within 0.72 with 32. So 24 is a choice, not an optimum; another value changes bytes.
/// `python3 tests/derive/q15.py --search` shows both.
const SLOPES: i64 = 24;

/// The line of slope near `slope` that comes nearest to `height` at `centre`, in 2^-15: intercept
/// and slope. A slope a few units off tilts the line little, and reaches heights between units at
/// the centre.
const fn line(height: f64, slope: f64, centre: f64) -> [f64; 2] {
    let (mut best, mut least) = ([0.0, 0.0], 1.0);
    let nearest = (slope * 32_768.0) as i64;
    let mut s = nearest - SLOPES;
    while s <= nearest + SLOPES {
        let exact = height * 32_768.0 - s as f64 * centre;
        // To the nearest; the sum is positive, for a cast cuts toward zero.
        let intercept = ((exact + 65_536.5) as i64 - 65_536) as f64;
        let error = if intercept > exact { intercept - exact } else { exact - intercept };
        if error < least {
            (best, least) = ([intercept, s as f64], error);
        }
        s += 1;
    }
    best
}

/// Those of [`BUCKETS`] buckets, and two beyond for crude quotients.
pub(super) const LINES: [Lines; 64] = {
    let mut lines = [Lines { a: 0, b: 0, c: 0, d: 0 }; 64];
    let mut i = 0;
    while i < lines.len() {
        let centre = (i as f64 + 0.5) / BUCKETS as f64;
        let [cos, sin] = cos_sin(centre);
        let angle = core::f64::consts::FRAC_PI_4;
        let [a, b] = line(cos * (1.0 - INWARD), -angle * sin, centre);
        let [c, d] = line(sin * (1.0 - INWARD), angle * cos, centre);
        lines[i] = Lines { a: a as u16, b: (-b) as u16, c: c as u16, d: d as u16 };
        i += 1;
    }
    lines
};

/// The reciprocals' units: buckets in 2^-22. With 2^-23 they would not have 16 bits.
pub(super) const RECIPROCAL_SHIFT: u32 = 22;

/// BUCKETS / a of the middle of each interval of the top 8 bits of a divisor, from 2^12 on; to the
/// nearest.
pub(super) const RECIPROCAL: [u16; 256] = {
    let mut table = [0; 256];
    let mut i = 16;
    while i < 256 {
        let middle = 256.0 * (i as f64 + 0.5);
        table[i] = ((BUCKETS << RECIPROCAL_SHIFT) as f64 / middle + 0.5) as u16;
        i += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::fixed::derived::{Q15_TABLES, assert_derived};

    #[test]
    fn tables_are_those_of_the_script() {
        assert_derived(Q15_TABLES, "ROOT", &ROOT.0);
        assert_derived(Q15_TABLES, "RECIPROCAL_ROOT", &RECIPROCAL_ROOT.0);
        assert_derived(Q15_TABLES, "LOG", &LOG.0);
        assert_derived(Q15_TABLES, "EXP", &EXP.0);
        assert_derived(Q15_TABLES, "POLE", &POLE.0);
        assert_derived(Q15_TABLES, "BEND", &BEND.0);
        let lines = LINES.map(|line| [line.a, line.b, line.c, line.d]);
        assert_derived(Q15_TABLES, "LINES", lines.as_flattened());
        assert_derived(Q15_TABLES, "RECIPROCAL", &RECIPROCAL);
        assert_derived(Q15_TABLES, "BUCKETS", &[BUCKETS]);
        assert_derived(Q15_TABLES, "RECIPROCAL_SHIFT", &[RECIPROCAL_SHIFT]);
    }
}
