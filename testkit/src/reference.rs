//! The exact image of a coordinate: the textbook's formula in f64, on the coordinate that an
//! arithmetic reads.

use crate::arithmetics::{Tested, centre};
use crate::errors::{Pair, Reference};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

/// Whether a disc map of the catalogue is the polar one.
///
/// # Panics
/// For a name that it does not know: a new disc map needs an answer here.
pub fn is_polar(disc: &str) -> bool {
    match disc {
        "polar" => true,
        "concentric" => false,
        _ => panic!("no disc map is known as {disc}"),
    }
}

/// Direction, r^2 and 1 - r^2 in f64, straight from the definition.
pub fn disc<A: Tested>(name: &str, [u, v]: [u32; 2]) -> ([f64; 2], f64, f64) {
    let centre = centre::<A>;
    if is_polar(name) {
        let (sin, cos) = (TAU * centre(u)).sin_cos();
        return ([cos, sin], centre(v), centre(!v));
    }
    let (a, b) = (2.0 * centre(u) - 1.0, 2.0 * centre(v) - 1.0);
    let (r, phi) = if a.abs() >= b.abs() {
        (a, FRAC_PI_4 * (b / a))
    } else {
        (b, FRAC_PI_2 - FRAC_PI_4 * (a / b))
    };
    let (sin, cos) = phi.sin_cos();
    ([cos * r.signum(), sin * r.signum()], r * r, (1.0 - r.abs()) * (1.0 + r.abs()))
}

/// The exact point of a map, to about 4 units of 2^-53.
pub fn reference<A: Tested>(kind: &str, name: &str, e: f64, uv: [u32; 2]) -> Reference {
    let ([cos, sin], r2, rim) = disc::<A>(name, uv);
    let log = if r2 < 0.5 { (-r2).ln_1p() } else { rim.ln() };
    let (s2, z) = match kind {
        "disc" => (r2, None),
        "uniform" => (r2 * (1.0 + rim), Some(rim)),
        "cosine" => (r2, Some(rim.sqrt())),
        "power" => (-(2.0 * log / (e + 1.0)).exp_m1(), Some((log / (e + 1.0)).exp())),
        _ => panic!("no formula is known of {kind}"),
    };
    let density = match kind {
        "disc" => 1.0 / PI,
        "uniform" => 0.5 / PI,
        "cosine" => rim.sqrt() / PI,
        "power" => (e + 1.0) * (0.5 / PI) * (e / (e + 1.0) * log).exp(),
        _ => panic!("no density is known of {kind}"),
    };
    let single = |hi| Pair { hi, lo: 0.0 };
    let s = s2.sqrt();
    Reference {
        x: single(s * cos),
        y: single(s * sin),
        s2: single(s2),
        z: z.map(single),
        density: single(density),
    }
}
