//! How rounding changes the evenness of a set.
//!
//! The area within a radius, or the probability within a polar angle, is a number t from 0 to 1
//! that is uniform: r^2 on the disc, 1 - z for the uniform hemisphere, s^2 for the cosine,
//! 1 - z^(e + 1) for the power lobe; and so is the angle about the axis. The deviation is the
//! largest difference, over all t, between the shares of rounded and of exact points below t
//! (two-sample Kolmogorov-Smirnov).

use hemidisc::Map;
use hemidisc::invariant::Exact;
use hemidisc::sequence::SobolOwen;
use std::f64::consts::TAU;
use testkit::errors::Reference;

/// Points of the set. Without scrambling many points of a net share one radius or angle, which any
/// rounding separates.
const COUNT: u32 = 1 << 16;

/// The larger of the two deviations of a map.
pub fn deviation<const D: usize, M: Map<Point = [R; D]>, R: Exact>(
    map: &M,
    kind: &str,
    e: f64,
    exact: impl Fn([u32; 2]) -> Reference,
) -> f64 {
    let sequence = SobolOwen::new(0);
    let uvs = || (0..COUNT).map(|i| sequence.at(i));
    let found = uvs().map(|uv| {
        let point = map.sample(uv).map(Exact::exact);
        let s2 = point[0] * point[0] + point[1] * point[1];
        placed(kind, e, [point[0], point[1]], s2, point.get(2).copied())
    });
    let exact = uvs().map(|uv| {
        let Reference { x, y, s2, z, .. } = exact(uv);
        placed(kind, e, [x.hi, y.hi], s2.hi, z.map(|z| z.hi))
    });
    let (found, exact): (Vec<_>, Vec<_>) = (found.collect(), exact.collect());
    let of = |axis: usize| {
        let sorted = |points: &[[f64; 2]]| {
            let mut places: Vec<_> = points.iter().map(|place| place[axis]).collect();
            places.sort_by(f64::total_cmp);
            places
        };
        apart(&sorted(&found), &sorted(&exact))
    };
    of(0).max(of(1))
}

/// The share within the point, and within its angle about the axis.
fn placed(kind: &str, e: f64, [x, y]: [f64; 2], s2: f64, z: Option<f64>) -> [f64; 2] {
    let within = match (kind, z) {
        ("uniform", Some(z)) => 1.0 - z,
        ("power", Some(z)) => -((e + 1.0) * z.ln()).exp_m1(),
        ("disc" | "cosine", _) => s2,
        _ => panic!("no share is known of {kind}"),
    };
    [within, (y.atan2(x) / TAU).rem_euclid(1.0)]
}

/// The largest difference of two empirical distributions, each sorted.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let (mut i, mut j, mut most) = (0, 0, 0_usize);
    while i < a.len() && j < b.len() {
        let step = a[i].min(b[j]);
        i += a[i..].iter().take_while(|x| **x <= step).count();
        j += b[j..].iter().take_while(|x| **x <= step).count();
        most = most.max(i.abs_diff(j));
    }
    most as f64 / a.len() as f64
}
