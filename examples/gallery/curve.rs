//! Curves as chains of points: thinned, and cut by the unit disc.

use std::f64::consts::TAU;

/// A curve with no more points than keep it within `tolerance` of where it was.
pub fn thin(curve: &[[f64; 2]], tolerance: f64) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = curve.first().copied().into_iter().collect();
    let mut from = 0;
    for to in 2..curve.len() {
        let (Some(start), Some(end), Some(between)) =
            (curve.get(from), curve.get(to), curve.get(from + 1..to))
        else {
            continue;
        };
        if between.iter().any(|point| off(*point, *start, *end) > tolerance) {
            from = to - 1;
            kept.extend(curve.get(from));
        }
    }
    kept.extend(curve.last().filter(|_| curve.len() > 1));
    kept
}

/// Distance of a point from the line through two others; from the first, if they are one.
fn off([x, y]: [f64; 2], [ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let length = dx.hypot(dy);
    if length < 1e-9 {
        (x - ax).hypot(y - ay)
    } else {
        ((x - ax) * dy - (y - ay) * dx).abs() / length
    }
}

/// The part of the straight line between two points that is inside the unit disc.
pub fn chord([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let (dx, dy) = (bx - ax, by - ay);
    // |a + t d|^2 = 1 at t = middle +- half.
    let squared = dx * dx + dy * dy;
    let middle = -(ax * dx + ay * dy) / squared;
    let half_squared = middle * middle - (ax * ax + ay * ay - 1.0) / squared;
    // A tangent touches at a point, which is nothing to draw; two equal ends give 0/0.
    if half_squared.is_nan() || half_squared <= 0.0 {
        return None;
    }
    let half = half_squared.sqrt();
    let (from, to) = ((middle - half).max(0.0), (middle + half).min(1.0));
    (from < to).then(|| [from, to].map(|t| [ax + t * dx, ay + t * dy]))
}

/// The part of a convex outline inside the unit disc: cut by the disc's tangents in turn.
pub fn clipped(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
    const TANGENTS: u32 = 180;
    let mut kept = outline.to_vec();
    for k in 0..TANGENTS {
        let (sin, cos) = (f64::from(k) * TAU / f64::from(TANGENTS)).sin_cos();
        let depth = |[x, y]: [f64; 2]| 1.0 - (cos * x + sin * y);
        let mut next = Vec::new();
        for (a, b) in kept.iter().zip(kept.iter().cycle().skip(1)) {
            let (da, db) = (depth(*a), depth(*b));
            if da >= 0.0 {
                next.push(*a);
            }
            if (da < 0.0) != (db < 0.0) {
                let t = da / (da - db);
                next.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
            }
        }
        kept = next;
    }
    kept
}
