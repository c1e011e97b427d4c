//! The rim where e is small.

use super::{CELLS, MAGNITUDES};
use hemidisc::arithmetic::{Arithmetic, FixedExponent};
use hemidisc::catalogue::{MapVisitor, power_maps};
use hemidisc::{Invert, Q15, Q15Div};
use testkit::reference::is_polar;

/// Where e is small sin theta is nearly 1 over a wide rim, and a unit too much leaves the disc. All
/// rings from r = 0.95 or so on; a plain run takes the last 32 and a sample.
struct Rim(f64);

impl Rim {
    fn rows(count: u32) -> impl Iterator<Item = u32> {
        let full = std::env::var_os("HEMIDISC_EXHAUSTIVE").is_some();
        let inner = (count / 20 * 19..count - 32).step_by(if full { 1 } else { 211 });
        inner.chain(count - 32..count)
    }
}

impl<A: Arithmetic<Real = Q15>> MapVisitor<A> for Rim {
    fn disc<M: Invert<Point = [Q15; 2]>>(&mut self, _: &'static str, _: M) {}

    fn hemisphere<M: Invert<Point = [Q15; 3]>>(
        &mut self,
        _: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let inside = |uv| {
            let point = map.sample(uv);
            let [x, y] = [point[0], point[1]].map(|c| i32::from(c.to_bits()));
            assert!(x * x + y * y <= 1 << 30, "{} {disc}, e = {}: {point:?}", A::NAME, self.0);
        };
        if is_polar(disc) {
            for (v, u) in Self::rows(CELLS).flat_map(|v| (0..CELLS / 4).map(move |u| (v, u))) {
                inside([u << 16, v << 16]);
            }
        } else {
            for (a, b) in Self::rows(MAGNITUDES).flat_map(|a| (0..=a).map(move |b| (a, b))) {
                let [a, b] = [a, b].map(|m| (MAGNITUDES + m) << 16);
                inside([a, b]);
                inside([b, a]);
            }
        }
    }
}

#[test]
fn small_exponents_stay_inside_at_the_rim() {
    for e in [0.0, 0.05, 0.3, 0.9] {
        let exponent = FixedExponent::try_from(e).unwrap();
        power_maps::<Q15>(exponent, &mut Rim(e)).unwrap();
        power_maps::<Q15Div>(exponent, &mut Rim(e)).unwrap();
    }
}
