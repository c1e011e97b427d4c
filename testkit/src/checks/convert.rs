//! A user's floats, bits or text: each value is converted exactly, or refused with an error that
//! names it and what is accepted.

use arbitrary::{Arbitrary, Unstructured};
use hemidisc::arithmetic::FixedExponent;
use hemidisc::{Axis, Coordinates, Error, LibmF32, LibmF64, Power, Q15, Q31};

#[derive(Arbitrary, Debug)]
struct Input<'a> {
    numbers: [f64; 2],
    cells: [u32; 2],
    q31: i32,
    q15: i16,
    exponent: FixedExponent,
    text: &'a str,
}

pub fn check(data: &[u8]) -> arbitrary::Result<()> {
    let input: Input = Unstructured::new(data).arbitrary()?;
    let doubles = input.numbers;
    is_checked(doubles, Coordinates::try_from(doubles));
    let singles = doubles.map(|x| x as f32);
    is_checked(singles.map(f64::from), Coordinates::try_from(singles));
    cells(Coordinates(input.cells));
    exponents(doubles[0]);
    text(input.text, input.exponent);
    fixed(input.q15, input.q31);
    Ok(())
}

/// One line that says what is accepted.
pub fn assert_clear(error: &Error) {
    let text = error.to_string();
    assert!(!text.contains('\n') && text.contains("; accepted"), "{text}");
}

/// floor(2^32 x) of numbers in [0, 1), or the first that is not one.
fn is_checked(numbers: [f64; 2], found: Result<Coordinates, Error>) {
    let bad = numbers.into_iter().zip([Axis::U, Axis::V]).find(|(x, _)| !(*x >= 0.0 && *x < 1.0));
    match (found, bad) {
        (Ok(Coordinates(cells)), None) => {
            for (cell, number) in cells.into_iter().zip(numbers) {
                let scaled = number * 4_294_967_296.0;
                assert!(f64::from(cell) <= scaled && scaled < f64::from(cell) + 1.0, "{number:e}");
            }
        }
        (Err(error), Some((value, axis))) => {
            let Error::Coordinate { axis: found, value: named } = error else { panic!("{error}") };
            assert_eq!((found, named.to_bits()), (axis, value.to_bits()));
            assert!(
                error.to_string().contains(&format!("coordinate {axis} is {value}")),
                "{error}"
            );
            assert_clear(&error);
        }
        (found, bad) => panic!("{numbers:?}: {found:?}, {bad:?}"),
    }
}

/// Centres, exactly and toward zero.
fn cells(square: Coordinates) {
    assert_eq!(Coordinates::try_from(square.to_f64()), Ok(square));
    assert_eq!(Coordinates::from(<[u32; 2]>::from(square)), square);
    for (single, double) in square.to_f32().into_iter().zip(square.to_f64()) {
        assert!(f64::from(single) <= double && f64::from(single.next_up()) > double, "{square:x?}");
    }
}

fn exponents(number: f64) {
    let accepted = number > -1.0 && number.is_finite();
    match Power::<LibmF64>::new(number) {
        Ok(_) => assert!(accepted, "{number}"),
        Err(error) => {
            assert!(
                matches!(error, Error::Exponent { value } if value.to_bits() == number.to_bits())
            );
            assert!(!accepted, "{number}");
            assert_clear(&error);
        }
    }
    let single = number as f32;
    assert_eq!(Power::<LibmF32>::new(single).is_ok(), single > -1.0 && single.is_finite());
    match FixedExponent::try_from(number) {
        Ok(exponent) => {
            let value = exponent.to_bits() as f64 * 0.5_f64.powi(32);
            assert!((value - number).abs() <= 0.5_f64.powi(33), "{number:e} became {value:e}");
        }
        Err(error) => {
            assert!(
                matches!(error, Error::FixedExponent { value } if value.to_bits() == number.to_bits())
            );
            assert!(!(0.0..4_294_967_296.0).contains(&number), "{number:e}");
            assert_clear(&error);
        }
    }
}

fn text(text: &str, exponent: FixedExponent) {
    match (text.parse::<FixedExponent>(), text.parse::<f64>()) {
        (Ok(exponent), Ok(number)) => assert_eq!(FixedExponent::try_from(number), Ok(exponent)),
        (Err(error), _) => assert_clear(&error),
        (Ok(_), Err(_)) => panic!("{text} is no number"),
    }
    // As many digits as an f64 has: the highest 53 bits come back.
    let highest = exponent.to_bits().leading_zeros().min(11);
    let kept = exponent.to_bits() >> (11 - highest) << (11 - highest);
    let decimal = (kept as f64 * 0.5_f64.powi(32)).to_string();
    assert_eq!(decimal.parse(), Ok(FixedExponent::from_bits(kept)));
}

/// Numbers of fixed point: their decimals are exact, their floats exact or toward zero.
fn fixed(short: i16, long: i32) {
    let (q15, q31) = (Q15::from_bits(short), Q31::from_bits(long));
    assert_eq!((q15.to_bits(), q31.to_bits()), (short, long));
    assert_eq!(q15.to_f64(), f64::from(short) / 32_768.0);
    assert_eq!(q31.to_f64(), f64::from(long) / 2_147_483_648.0);
    assert_eq!((f64::from(q15), f64::from(q31)), (q15.to_f64(), q31.to_f64()));
    assert_eq!((f64::from(q15.to_f32()), f32::from(q15)), (q15.to_f64(), q15.to_f32()));
    let single = f64::from(q31.to_f32());
    assert!(single.abs() <= q31.to_f64().abs() && single * q31.to_f64() >= 0.0, "{q31:?}");
    assert!(f64::from(q31.to_f32().abs().next_up()) > q31.to_f64().abs(), "{q31:?}");
    assert_eq!(q15.to_string().parse(), Ok(q15.to_f64()));
    assert_eq!(q31.to_string().parse(), Ok(q31.to_f64()));
    assert_eq!(format!("{q31:.2}"), format!("{:.2}", q31.to_f64()));
    assert_eq!((-q15).to_bits(), short.saturating_neg());
    assert_eq!((-q31).to_bits(), long.saturating_neg());
    assert_eq!(q15 < Q15::ZERO, short < 0);
}
