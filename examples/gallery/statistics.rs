//! The statistics of a set of points in the table: minimum distance, half-plane discrepancy,
//! uniformity.
//!
//! All are functions of f64 points alone, so that the tests below can hold them against values
//! worked out by hand.

use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::f64::consts::{PI, TAU};

/// What is said of a set of points on the disc.
#[derive(Clone, Copy)]
pub(crate) struct Measured {
    /// How many points there are.
    pub(crate) kept: usize,
    pub(crate) distance: f64,
    /// The distance as a fraction of a hexagonal packing's.
    pub(crate) spread: f64,
    pub(crate) discrepancy: f64,
    /// Chi-square over [`cells`], over its degrees of freedom: 1 is expected of independent points.
    pub(crate) chi_square: f64,
    /// Of that chi-square.
    pub(crate) p: f64,
}

impl Measured {
    /// Measures what a disc map made of `candidates` points of the square.
    pub(crate) fn of(points: &[[f64; 2]], candidates: u32) -> Self {
        let [rings, sectors] = cells(candidates);
        let distance = minimum_distance(points);
        let chi_square = chi_square(points, [rings, sectors]);
        Self {
            kept: points.len(),
            distance,
            spread: spread(distance, points.len(), PI),
            discrepancy: half_plane_discrepancy(points),
            chi_square: chi_square / (rings * sectors - 1) as f64,
            p: p_value(chi_square, rings * sectors).unwrap_or(f64::NAN),
        }
    }
}

/// Rings and sectors of the chi-square: at least 5 points expected in a cell even where rejection
/// keeps 3 of 4, and none of them powers of two, as the strata of most sequences are.
pub(crate) const fn cells(candidates: u32) -> [usize; 2] {
    if candidates < 256 { [3, 3] } else { [5, 7] }
}

/// The two points that are closest, if there are two.
pub(crate) fn closest_pair<const D: usize>(points: &[[f64; D]]) -> Option<[[f64; D]; 2]> {
    let pairs = points
        .iter()
        .enumerate()
        .flat_map(|(i, p)| points.iter().skip(i + 1).map(move |q| [*p, *q]));
    pairs.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

fn distance<const D: usize>([p, q]: &[[f64; D]; 2]) -> f64 {
    p.iter().zip(q).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The smallest distance between two of the points; infinite for fewer than two.
pub(crate) fn minimum_distance<const D: usize>(points: &[[f64; D]]) -> f64 {
    closest_pair(points).map_or(f64::INFINITY, |pair| distance(&pair))
}

/// The smallest angle between two unit vectors, in degrees.
pub(crate) fn minimum_angle(directions: &[[f64; 3]]) -> f64 {
    2.0 * (0.5 * minimum_distance(directions)).min(1.0).asin().to_degrees()
}

/// A minimum distance as a fraction of the largest possible one, that of a hexagonal packing of
/// `count` points on `area` (A. Lagae and P. Dutre 2008, "relative radius"): comparable between
/// maps that keep different numbers of points.
pub(crate) fn spread(distance: f64, count: usize, area: f64) -> f64 {
    distance / (2.0 * area / (3_f64.sqrt() * count as f64)).sqrt()
}

/// The fraction of the unit disc's area beyond a line at signed distance `t` from the centre.
fn cap(t: f64) -> f64 {
    let t = t.clamp(-1.0, 1.0);
    (t.acos() - t * (1.0 - t * t).sqrt()) / PI
}

/// Max over all half-planes of |fraction of the points inside - fraction of the area inside|.
///
/// Exact but for rounding, not a search. Move a half-plane without letting a point cross its edge:
/// only the area changes, so a worst one has a point on the edge. Turn it about that point: the
/// area is extremal where the edge is at right angles to the point's radius, else the turn goes
/// on until a second point is met. So the edges through each pair, and through each point at right
/// angles to its radius, are all that can be worst; the points on the edge count as in or as out.
/// The other side of an edge gives the same difference.
pub(crate) fn half_plane_discrepancy(points: &[[f64; 2]]) -> f64 {
    // A coordinate in f32 is good to 6e-8; points of a grid that far off a line are on it.
    const ON_EDGE: f64 = 1e-6;
    let worst_at = |[nx, ny]: [f64; 2], t: f64| {
        let (mut beyond, mut closed) = (0_u32, 0_u32);
        for [x, y] in points {
            let s = nx * x + ny * y - t;
            beyond += u32::from(s > ON_EDGE);
            closed += u32::from(s >= -ON_EDGE);
        }
        let off = |inside: u32| (f64::from(inside) / points.len() as f64 - cap(t)).abs();
        off(beyond).max(off(closed))
    };
    let mut worst = 0.0_f64;
    for (i, [x, y]) in points.iter().enumerate() {
        let radius = x.hypot(*y);
        let radial = if radius > ON_EDGE { [x / radius, y / radius] } else { [1.0, 0.0] };
        worst = worst.max(worst_at(radial, radius));
        for [qx, qy] in points.iter().skip(i + 1) {
            let (dx, dy) = (qx - x, qy - y);
            let length = dx.hypot(dy);
            if length > ON_EDGE {
                let normal = [-dy / length, dx / length];
                worst = worst.max(worst_at(normal, normal[0] * x + normal[1] * y));
            }
        }
    }
    worst
}

/// Pearson's chi-square of the points over `rings` x `sectors` cells of equal area of the disc.
pub(crate) fn chi_square(points: &[[f64; 2]], [rings, sectors]: [usize; 2]) -> f64 {
    let mut counts = vec![0_u32; rings * sectors];
    // Sectors start at an angle that is no fraction of a turn that a grid's points would lie on.
    const START: f64 = 0.618_034;
    for [x, y] in points {
        let ring = ((x * x + y * y) * rings as f64) as usize;
        let turn = ((y.atan2(*x) - START) / TAU).rem_euclid(1.0);
        let sector = (turn * sectors as f64) as usize;
        // Rounding may give the very last ring or sector one too many.
        let cell = ring.min(rings - 1) * sectors + sector.min(sectors - 1);
        if let Some(count) = counts.get_mut(cell) {
            *count += 1;
        }
    }
    let expected = points.len() as f64 / counts.len() as f64;
    counts.iter().map(|count| (f64::from(*count) - expected).powi(2) / expected).sum()
}

/// How likely independent uniform points are to be at least as uneven: near 0 for a set that is not
/// uniform, near 1 for one that is more even than chance.
pub(crate) fn p_value(chi_square: f64, cells: usize) -> Option<f64> {
    Some(ChiSquared::new(cells.checked_sub(1)? as f64).ok()?.sf(chi_square))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn close(got: f64, wanted: f64) {
        assert!((got - wanted).abs() <= 1e-6, "{got}, wanted {wanted}");
    }

    #[test]
    fn minimum_distance_is_that_of_the_closest_pair() {
        close(minimum_distance(&[[0.0, 0.0], [3.0, 4.0]]), 5.0);
        // 3-4-5 triangle: the shortest side, wherever it stands in the list.
        for shift in 0..3 {
            let mut triangle = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.3]];
            triangle.rotate_left(shift);
            close(minimum_distance(&triangle), 0.3);
        }
        assert_eq!(minimum_distance(&[[1.0, 0.0]]), f64::INFINITY);
    }

    #[test]
    fn minimum_angle_is_in_degrees() {
        close(minimum_angle(&[[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), 90.0);
        let (s, c) = (0.5, 0.75_f64.sqrt());
        close(minimum_angle(&[[0.0, 0.0, 1.0], [s, 0.0, c], [-1.0, 0.0, 0.0]]), 30.0);
    }

    #[test]
    fn spread_of_a_hexagonal_packing_is_1() {
        // A triangular lattice of side 1 has one point on each sqrt(3) / 2 of area.
        close(spread(1.0, 100, 100.0 * 3_f64.sqrt() / 2.0), 1.0);
        close(spread(0.5, 100, 100.0 * 3_f64.sqrt() / 2.0), 0.5);
    }

    #[test]
    fn cap_areas() {
        close(cap(-1.0), 1.0);
        close(cap(0.0), 0.5);
        // At 1/2: (pi / 3 - sqrt(3) / 4) / pi.
        close(cap(0.5), 1.0 / 3.0 - 3_f64.sqrt() / (4.0 * PI));
        close(cap(0.5) + cap(-0.5), 1.0);
        close(cap(1.0), 0.0);
    }

    #[test]
    fn half_plane_discrepancy_of_few_points() {
        let cap = 1.0 / 3.0 - 3_f64.sqrt() / (4.0 * PI);
        // At the centre, a half-plane that just holds the point holds half of the area.
        close(half_plane_discrepancy(&[[0.0, 0.0]]), 0.5);
        // At the rim, the tangent holds the point and no area.
        close(half_plane_discrepancy(&[[0.0, -1.0]]), 1.0);
        // At half the radius, the chord at right angles holds the point and a small cap.
        for [c, s] in [[1.0, 0.0], [0.6, 0.8], [-0.8, 0.6]] {
            close(half_plane_discrepancy(&[[0.5 * c, 0.5 * s]]), 1.0 - cap);
        }
        // Opposite points: both on one diameter, and half of the area beyond it.
        close(half_plane_discrepancy(&[[0.5, 0.0], [-0.5, 0.0]]), 0.5);
        // The chord of the pair holds both, and a cap; beyond it on the other side is none of them.
        let h = 0.75_f64.sqrt();
        close(half_plane_discrepancy(&[[0.5, h], [0.5, -h]]), 1.0 - cap);
        close(half_plane_discrepancy(&[[0.5, -h], [0.5, h]]), 1.0 - cap);
        // A triangle on the rim: outside a side there is a cap without a point, and with its ends
        // that cap has two points of three.
        close(half_plane_discrepancy(&[[1.0, 0.0], [-0.5, h], [-0.5, -h]]), 2.0 / 3.0 - cap);
    }

    /// The same by another way: many directions, and for each the edges through every point.
    fn searched(points: &[[f64; 2]]) -> f64 {
        let mut worst = 0.0_f64;
        for k in 0..4096 {
            let (sin, cos) = (f64::from(k) * TAU / 4096.0).sin_cos();
            let mut depths: Vec<_> = points.iter().map(|[x, y]| cos * x + sin * y).collect();
            depths.sort_by(|a, b| b.total_cmp(a));
            for (before, t) in (0_u32..).zip(&depths) {
                for inside in [before, before + 1] {
                    worst = worst.max((f64::from(inside) / points.len() as f64 - cap(*t)).abs());
                }
            }
        }
        worst
    }

    #[test]
    fn half_plane_discrepancy_is_the_limit_of_a_search() {
        for start in [0, 100, 200] {
            let golden = |k: u32| (f64::from(k) * 0.618_034 * TAU).sin_cos();
            // Points of an uneven spiral.
            let point = |k: u32| (f64::from(k % 37) / 37.0, golden(k));
            let points: Vec<_> =
                (start..start + 41).map(point).map(|(r, (sin, cos))| [r * cos, r * sin]).collect();
            let (exact, found) = (half_plane_discrepancy(&points), searched(&points));
            assert!(found <= exact + 1e-6 && found > exact - 2e-3, "{found} of {exact}");
        }
    }

    #[test]
    fn chi_square_counts_cells_of_equal_area() {
        // Two rings meet at r = sqrt(1/2): 3 points against 1, where 2 are expected in each.
        let points = [[0.70, 0.0], [0.0, 0.70], [-0.70, 0.0], [0.0, -0.72]];
        close(chi_square(&points, [2, 1]), (1.0 + 1.0) / 2.0);
        // All in one of four sectors: 9 / 1 and three times 1 / 1.
        close(chi_square(&[[0.3, 0.6]; 4], [1, 4]), 9.0 + 3.0);
        // One in each of four.
        let even = [[0.5, 0.5], [-0.5, 0.5], [0.5, -0.5], [-0.5, -0.5]];
        close(chi_square(&even, [1, 4]), 0.0);
        // The rim belongs to the last ring.
        close(chi_square(&[[1.0, 0.0], [0.0, 0.1]], [2, 1]), 0.0);
    }

    #[test]
    fn p_value_of_two_degrees_of_freedom_is_an_exponential() {
        let p = |chi, cells| p_value(chi, cells).unwrap();
        close(p(0.0, 3), 1.0);
        close(p(2.0, 3), (-1.0_f64).exp());
        close(p(2.0 * 20_f64.ln(), 3), 0.05);
        // One degree: 95 % of a normal variable lie within 1.959964.
        close(p(1.959_964_f64.powi(2), 2), 0.05);
        assert_eq!(p_value(1.0, 0), None);
    }
}
