//! A processor may flush subnormal numbers to 0, as operand and as result (FTZ, DAZ): no point and
//! no density is then NaN. *Stability* in the README says which bits differ.
//!
//! A plain run has subnormal numbers. `bash .ci/run flush` links the C compiler's start file that
//! turns them off, and runs this test and the goldens.

use hemidisc::catalogue::{MapVisitor, maps, power_maps};
use hemidisc::{Density, Invert, bits::hash::mix};
use std::hint::black_box;
use testkit::arithmetics::Tested;
use testkit::test_each_arithmetic;

/// Coordinates all over the square, and close to its edges, its corners and its centre.
fn coordinates() -> impl Iterator<Item = [u32; 2]> {
    (0..20_000_u32).map(|i| {
        let [a, b] = [mix(i), mix(!i)];
        let near = |edge: u32| edge ^ (a >> (b % 32));
        match i % 6 {
            0 => [a, b],
            1 => [near(0), b],
            2 => [b, near(u32::MAX)],
            3 => [near(u32::MAX), near(1 << 31)],
            4 => [near(1 << 31), (1 << 31) ^ (b >> (a % 32))],
            _ => [near(0), near(0)],
        }
    })
}

struct NoNan {
    exponent: &'static str,
}

impl NoNan {
    fn assert<M: Density<Point = [R; D]>, R: Copy + Into<f64>, const D: usize>(
        &self,
        map: M,
        name: &str,
        density: fn(&M, [R; D]) -> R,
        sample: fn(&M, [u32; 2]) -> ([R; D], R),
    ) {
        for uv in coordinates() {
            let (point, of_sample) = sample(&map, uv);
            let densities: [f64; 2] = [of_sample.into(), density(&map, point).into()];
            let what = format!("{name}, e = {}, {uv:x?}: {densities:?}", self.exponent);
            assert!(!point.iter().any(|&component| component.into().is_nan()), "{what}");
            assert!(
                densities.iter().all(|density| density.is_finite() && *density > 0.0),
                "{what}"
            );
        }
    }
}

impl<A: Tested> MapVisitor<A> for NoNan {
    fn disc<M: Invert<Point = [A::Real; 2]>>(&mut self, name: &'static str, map: M) {
        self.assert(map, name, M::density, M::sample_with_density);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]>>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        self.assert(map, &format!("{name} over {disc}"), M::density, M::sample_with_density);
    }
}

/// Each arithmetic takes those that its parameter can hold.
const EXPONENTS: [&str; 11] =
    ["-0.99", "-0.5", "0", "1", "50", "1e8", "1e30", "1.7e38", "1.8e38", "3.4e38", "1.79e308"];

fn nothing_is_nan<A: Tested>() {
    if std::env::var_os("HEMIDISC_FLUSH").is_some() {
        assert_eq!(black_box(f32::MIN_POSITIVE) * black_box(0.5), 0.0, "nothing is flushed");
        assert_eq!(black_box(f32::from_bits(1)) * black_box(2.0_f32.powi(100)), 0.0);
    }
    maps::<A>(&mut NoNan { exponent: "-" });
    let mut lobes = 0;
    for exponent in EXPONENTS {
        let Ok(parameter) = exponent.parse() else { continue };
        lobes += usize::from(power_maps::<A>(parameter, &mut NoNan { exponent }).is_ok());
    }
    assert!(lobes >= 4, "{lobes} exponents");
}
test_each_arithmetic!(nothing_is_nan);
