//! A lobe of one's own: Beckmann's distribution of microfacet normals over any disc map.
//!
//! `cargo run --release --example lobe` prints the mean of 1 / cos theta over 4096 normals, which
//! weighs each normal by its facet's area: for slopes of variance alpha^2 / 2 an axis it is
//! E[sqrt(1 + tan^2 theta)].
//!
//! A lobe is a [`Map`] that has a disc map. It takes r^2 and 1 - r^2 of a disc point, finds the angle
//! to the axis, and has [`DiscPoint::at`] place x and y. Blocks, frames and `Points` are then as for
//! the crate's own lobes.
//!
//! P. Beckmann and A. Spizzichino, "The Scattering of Electromagnetic Waves from Rough Surfaces",
//! 1963; B. Walter, S. Marschner, H. Li and K. Torrance, "Microfacet Models for Refraction through
//! Rough Surfaces", EGSR 2007, equations 25 and 28.
//!
//! [`DiscPoint::at`]: hemidisc::disc::DiscPoint::at

use hemidisc::arithmetic::Root;
use hemidisc::disc::DiscMap;
use hemidisc::frame::About;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Density, FastF32, Frame, Map, Points};

/// Normals of density exp(-tan^2 theta / alpha^2) / (pi alpha^2 cos^3 theta) per steradian.
#[derive(Clone, Copy, Debug)]
struct Beckmann<D> {
    alpha: f32,
    disc: D,
}

impl<D: DiscMap<Arithmetic: Root<Real = f32>>> Map for Beckmann<D> {
    type Point = [f32; 3];

    /// tan^2 theta = -alpha^2 ln(1 - r^2), of which r^2 knows the digits near the pole.
    fn sample(&self, uv: [u32; 2]) -> [f32; 3] {
        let point = self.disc.disc_point(uv);
        let log = if point.r2() < 0.5 { (-point.r2()).ln_1p() } else { point.one_minus_r2().ln() };
        let tan2 = -self.alpha * self.alpha * log;
        let [x, y] = point.at((tan2 / (1.0 + tan2)).sqrt());
        [x, y, 1.0 / (1.0 + tan2).sqrt()]
    }
}

impl<D: DiscMap<Arithmetic: Root<Real = f32>>> Density for Beckmann<D> {
    fn density(&self, [x, y, z]: [f32; 3]) -> f32 {
        if z <= 0.0 {
            return 0.0;
        }
        let alpha2 = self.alpha * self.alpha;
        let tan2 = (x * x + y * y) / (z * z);
        (-tan2 / alpha2).exp() / (core::f32::consts::PI * alpha2 * z * z * z)
    }
}

/// The mean of 1 / cos theta about the normal of a frame.
fn facets(alpha: f32, frame: Frame<f32>) -> f64 {
    let lobe = Beckmann { alpha, disc: Concentric::<FastF32>::new() };
    let normals = Points::new(SobolOwen::new(7), About::new(lobe, frame));
    let mut buffer = [[0.0; 3]; 4096];
    normals.fill(&mut buffer);
    let [_, _, axis] = frame.axes();
    let cosine = |normal: [f32; 3]| -> f64 {
        normal.iter().zip(axis).map(|(n, a)| f64::from(*n) * f64::from(a)).sum()
    };
    buffer.into_iter().map(|normal| 1.0 / cosine(normal)).sum::<f64>() / 4096.0
}

fn main() -> Result<(), hemidisc::Error> {
    let frame = Frame::new([0.6, 0.0, 0.8])?;
    for alpha in [0.05, 0.2, 0.5] {
        println!("alpha {alpha}: mean of 1 / cos theta {:.4}", facets(alpha, frame));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use hemidisc::{LibmF32, Polar, invariant};

    /// E[sqrt(1 + alpha^2 s)] of an exponential s, by 10^6 midpoints of its distribution.
    fn exact(alpha: f32) -> f64 {
        let alpha2 = f64::from(alpha).powi(2);
        let at = |i: u32| 1.0 - alpha2 * (1.0 - (f64::from(i) + 0.5) / 1e6).ln();
        (0..1_000_000).map(|i| at(i).sqrt()).sum::<f64>() / 1e6
    }

    #[test]
    fn facets_have_the_area_of_their_slopes() {
        for alpha in [0.05, 0.2, 0.5] {
            let found = facets(alpha, Frame::new([0.6, 0.0, 0.8]).unwrap());
            assert!((found / exact(alpha) - 1.0).abs() < 1e-3, "{alpha}: {found}");
        }
    }

    fn holds<D: DiscMap<Arithmetic: Root<Real = f32>>>(disc: D) {
        let words = (0..32).flat_map(|bit| [1_u32 << bit, !(1 << bit), (1 << bit) - 1]);
        for alpha in [1e-3, 0.5, 1.0] {
            let lobe = Beckmann { alpha, disc };
            for u in words.clone() {
                for v in words.clone() {
                    let result = invariant::hemisphere(&lobe, [u, v]);
                    // Far out a narrow lobe's density is smaller than an f32 can be.
                    let far = matches!(result, Err(invariant::Violation::NoDensity { .. }));
                    assert!(
                        result.is_ok() || far && alpha < 0.01,
                        "{alpha} {u:x} {v:x}: {result:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn directions_stay_on_the_hemisphere() {
        holds(Concentric::<FastF32>::new());
        holds(Polar::<FastF32>::new());
        holds(Concentric::<LibmF32>::new());
        holds(Polar::<LibmF32>::new());
    }

    /// The integral of the density over the hemisphere.
    #[test]
    fn the_density_is_one() {
        let lobe = Beckmann { alpha: 0.5, disc: Concentric::<LibmF32>::new() };
        let steps = 200_000;
        let sum: f64 = (0..steps)
            .map(|i| {
                let z = (f64::from(i) + 0.5) / f64::from(steps);
                f64::from(lobe.density([(1.0 - z * z).sqrt() as f32, 0.0, z as f32]))
            })
            .sum();
        // Per projected area: the normals' cosine is in the density of normals.
        let integral = sum / f64::from(steps) * core::f64::consts::TAU;
        assert!((integral - 1.0).abs() < 1e-3, "{integral}");
    }
}
