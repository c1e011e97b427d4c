//! Every map in every arithmetic at raw coordinates and exponents: the invariants in exact
//! arithmetic, symmetry, inverse, density and accuracy within the contracts; every arithmetic
//! against every other; the square, rejection, and draws by chance.

use super::agreement;
use super::draws::Draws;
use crate::arithmetics::{EachArithmetic, Number, Tested, every_arithmetic};
use crate::promises::{AtSample, Total};
use arbitrary::{Arbitrary, Unstructured};
use hemidisc::disc::Rejection;
use hemidisc::invariant::{Exact, in_unit_disc};
use hemidisc::{Density, Invert, LibmF32, LibmF64, Power, UnitSquare};

/// Numbers first, in the order of the dictionary: coordinates, exponents, points.
#[derive(Arbitrary, Debug)]
struct Input {
    uv: [u32; 2],
    exponent: f32,
    /// Of an exponent of each arithmetic's own.
    bits: u64,
    /// A point or direction, perhaps invalid.
    numbers: [f64; 3],
    draws: Draws,
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let Input { uv, exponent, bits, numbers, mut draws } = Unstructured::new(data).arbitrary()?;
    let accepted = exponent > -1.0 && exponent.is_finite();
    assert_eq!(Power::<LibmF32>::new(exponent).is_ok(), accepted, "{exponent}");
    let exponent = if accepted { exponent } else { 0.0 };
    every_arithmetic(&mut AtSample { uv, exponent, bits });
    every_arithmetic(&mut Total { numbers, exponent: exponent.into() });
    every_arithmetic(&mut Square { uv });
    agreement::check(uv, exponent);
    every_arithmetic(&mut draws);
    Ok(())
}

/// The square as numbers, and the candidates of rejection.
struct Square {
    uv: [u32; 2],
}

impl EachArithmetic for Square {
    fn each<A: Tested>(&mut self) {
        let (uv, name) = (self.uv, A::NAME);
        let square = UnitSquare::<A>::new();
        let point = square.sample(uv);
        for (read, exact) in point.into_iter().zip(UnitSquare::<LibmF64>::new().sample(uv)) {
            let read: f64 = read.exact();
            // Toward zero, or of the leading bits: never below the cell that is read.
            let coarse = 0.5_f64.powi(A::BITS as i32 - 1);
            assert!((0.0..1.0).contains(&read), "{name} {uv:08x?}: {read}");
            assert!(
                (read - exact).abs() <= coarse.max(exact * f64::from(f32::EPSILON)),
                "{name} {uv:08x?}"
            );
        }
        assert_eq!(square.sample(square.invert(point)), point, "{name} {uv:08x?}: inverse");
        assert_eq!(square.density(point).exact(), A::Real::nearest(1.0).exact(), "{name}");

        let centred = |k: u32| (2.0 * f64::from(k) + 1.0) * 0.5_f64.powi(32) - 1.0;
        let exactly = |uv: [u32; 2]| in_unit_disc(uv.map(centred));
        let inside = Rejection::<A>::inside(uv);
        assert_eq!(inside, exactly(uv), "{uv:08x?}");
        // The two coordinates on either side of the circle.
        let edge = (1.0 - centred(uv[0]).powi(2)).sqrt() * 2_147_483_648.0;
        for v in [0, 1, 2].map(|n| 0x7fff_ffff + (edge as u32).min(0x7fff_fffe) + n) {
            assert_eq!(Rejection::<A>::inside([uv[0], v]), exactly([uv[0], v]), "{uv:08x?}");
        }
        let kept = Rejection::<A>::sample(uv);
        assert_eq!(kept.is_some(), inside);
        if let Some(point) = kept {
            let exact = point.map(Exact::exact);
            assert!(in_unit_disc(exact), "{name} {uv:08x?}: {exact:?}");
            assert!(Rejection::<A>::density(point).exact() > 0.0, "{name} {uv:08x?}");
            let _ = Rejection::<A>::invert(point);
        }
    }
}
