//! The tables of Q15, computed when the crate is compiled; an image holds those that its maps read.
//!
//! A chord lies to one side of its curve, so each is moved by half of the largest distance, f'' w^2 / 16 for
//! a bucket of width w: what is left is that much to both sides.

/// Cosine and sine of pi/4 t, by their series; for t in [0, 2].
const fn octant(t: f64) -> [f64; 2] {
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
    InverseRoot,
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
        Function::InverseRoot => 1.0 / sqrt(0.5 + 0.5 * x),
        Function::Log => log2(1.0 + x),
        Function::Exp => exp2_neg(x),
        Function::Pole => sqrt(-log2(1.0 - 0.5 * x0) / (0.5 * x0)),
        Function::Bend => sqrt((1.0 - exp2_neg(2.0 * x0)) / (2.0 * core::f64::consts::LN_2 * x0)),
    }
}

/// Chords of a function of [0, 1) over `N` buckets; its argument in 2^-32.
///
/// A word is the value at its bucket's beginning, 19 bits of 2^-19, above what it changes by over the
/// bucket, 12 bits of 2^-17, and a 0. The value at a place within the bucket, of 15 bits, is the whole word
/// plus (or minus) their product: one table, one product and one sum.
#[derive(Clone, Copy)]
pub(super) struct Chords<const N: usize>([u32; N]);

const CHANGE: u32 = (1 << 12) - 1;

impl<const N: usize> Chords<N> {
    /// The function times `scale`, plus a bias of 2^-32 that is another where the chords begin, and at 1; from
    /// a bucket on.
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
            let change = ((last - first).abs() / 32_768.0 + 0.5) as u32;
            assert!(change <= CHANGE);
            let rise = if last < first { 0 } else { change as u64 * 32_767 };
            // Exact in the middle of the bucket, and less the word's low bits, which add to what is read.
            let half = 16_384.0 * if last < first { -(change as f64) } else { change as f64 };
            let begin = 0.5 * (first + last) - half - 2.0 * change as f64;
            let mut begin = (begin + 4_096.0) as u64 & !0x1fff;
            while begin + 2 * change as u64 + rise >= 1 << 32 {
                begin -= 1 << 13;
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
        (self.0[(x >> (32 - bits)) as usize & (N - 1)], (x << bits) >> 17)
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

/// Half an LSB in 2^-32: what is then shifted to LSBs is rounded.
pub(super) const HALF: u32 = 1 << 16;
const HALF_LSB: f64 = HALF as f64;
/// Half of 2^-16.
const HALF_16: f64 = 32_768.0;

/// sqrt x of x >= 1/4, plus [`HALF`]. Next to 1/4 it is that much smaller than the curve that the uniform lobe
/// stays inside at the rim.
pub(super) const ROOT: Chords<128> =
    Chords::new(Function::Root, 32, 1.0, HALF_LSB, [-0.15 * HALF_LSB, HALF_LSB]);
/// 1 / sqrt(1/2 + x / 2), halved.
pub(super) const INVERSE_ROOT: Chords<128> =
    Chords::new(Function::InverseRoot, 0, 0.5, HALF_16, [HALF_16; 2]);
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

/// Buckets of t in [0, 1]; a crude quotient is up to 1/33 larger, and still below [`LINES`]'s end.
pub(super) const BUCKETS: u32 = 62;

/// How much smaller than 1 the circle of the lines is, so that no line leaves the disc where a crude quotient
/// takes it beyond its bucket: chosen as small as the exhaustive test lets it be.
const INWARD: f64 = 0.65 / 32_768.0;

/// The line of slope near `slope` that comes nearest to `height` at `centre`, in 2^-15: intercept and slope.
/// Slopes a few units off tilt the line by nothing that counts but reach heights between units.
const fn line(height: f64, slope: f64, centre: f64) -> [f64; 2] {
    let (mut best, mut least) = ([0.0, 0.0], 1.0);
    let nearest = (slope * 32_768.0) as i64;
    let mut s = nearest - 24;
    while s <= nearest + 24 {
        let exact = height * 32_768.0 - s as f64 * centre;
        let intercept = ((exact + 65_536.5) as i64 - 65_536) as f64;
        let error = if intercept > exact { intercept - exact } else { exact - intercept };
        if error < least {
            (best, least) = ([intercept, s as f64], error);
        }
        s += 1;
    }
    best
}

pub(super) const LINES: [Lines; 64] = {
    let mut lines = [Lines { a: 0, b: 0, c: 0, d: 0 }; 64];
    let mut i = 0;
    while i < lines.len() {
        let centre = (i as f64 + 0.5) / BUCKETS as f64;
        let [cos, sin] = octant(centre);
        let angle = core::f64::consts::FRAC_PI_4;
        let [a, b] = line(cos * (1.0 - INWARD), -angle * sin, centre);
        let [c, d] = line(sin * (1.0 - INWARD), angle * cos, centre);
        lines[i] = Lines { a: a as u16, b: (-b) as u16, c: c as u16, d: d as u16 };
        i += 1;
    }
    lines
};

/// The reciprocals' units: buckets in 2^-22.
pub(super) const RECIPROCAL_SHIFT: u32 = 22;

/// BUCKETS / a of the middle of each interval of the top 8 bits of a divisor, from 2^12 on.
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
