//! Linear light as 16-bit colours, on sRGB's curve (IEC 61966-2-1), without a power at run time.
//!
//! A component has n + 1 levels, and edge i of n is the light that the curve takes to (i + 1/2) /
//! n: the level is the number of edges that the light has reached, and is the nearest to the curve
//! for every f32. The compiler computes the 94 edges; they take 376 bytes.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};

static FIVE_BITS: [f32; Rgb565::MAX_R as usize] = edges();
static SIX_BITS: [f32; Rgb565::MAX_G as usize] = edges();

/// The nearest colour. Light below 0 or NaN is black, above 1 full.
pub fn encode([r, g, b]: [f32; 3]) -> Rgb565 {
    let level = |edges: &[f32], light: f32| edges.partition_point(|edge| *edge <= light) as u8;
    Rgb565::new(level(&FIVE_BITS, r), level(&SIX_BITS, g), level(&FIVE_BITS, b))
}

/// The light at which each level above 0 begins.
const fn edges<const N: usize>() -> [f32; N] {
    let mut edges = [0.0; N];
    let mut i = 0;
    while i < N {
        let exact = light((i as f64 + 0.5) / N as f64);
        let nearest = exact as f32;
        // The first f32 that is not below the edge.
        edges[i] = if (nearest as f64) < exact { nearest.next_up() } else { nearest };
        i += 1;
    }
    edges
}

/// The light of a value on the curve.
const fn light(value: f64) -> f64 {
    if value <= 0.040_45 {
        return value / 12.92;
    }
    let base = (value + 0.055) / 1.055;
    // base^2.4 is base^2 times the fifth root of base^2, which Newton's steps reach from above.
    let square = base * base;
    let mut root = 1.0;
    let mut step = 0;
    while step < 32 {
        root -= (root - square / (root * root * root * root)) / 5.0;
        step += 1;
    }
    square * root
}
