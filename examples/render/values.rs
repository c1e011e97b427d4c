//! Numbers of a scene, checked as they are read so that an error has the line it is on.
//!
//! The crate's own constructors check what they take, in f64.

use hemidisc::effect::{AmbientOcclusion, BelowHorizon, Glossy, ThinLens};
use hemidisc::{Concentric, Frame, LibmF64};
use serde::Deserialize;

/// So that squares are numbers in every arithmetic.
const MOST: f64 = 1e15;

macro_rules! checked {
    ($(#[$doc:meta] $name:ident($of:ty, $text:literal) $check:expr;)*) => {$(
        #[$doc]
        #[derive(Clone, Copy, Debug, Deserialize)]
        #[serde(try_from = $text)]
        pub struct $name(pub $of);

        impl TryFrom<$of> for $name {
            type Error = String;

            fn try_from(value: $of) -> Result<Self, String> {
                let check: fn($of) -> Result<(), String> = $check;
                check(value).map(|()| Self(value))
            }
        }
    )*};
}

checked! {
    /// A place.
    Point([f64; 3], "[f64; 3]") |place| all(place, |x| x.abs() <= MOST, "numbers from -1e15 to 1e15");
    /// Any length but 0.
    Direction([f64; 3], "[f64; 3]") |direction| said(Frame::normalized(direction));
    /// Linear red, green and blue.
    Colour([f64; 3], "[f64; 3]") |colour| {
        all(colour, |part| (0.0..=MOST).contains(&part), "numbers from 0 to 1e15")
    };
    /// Of a lens or a light: 0 is a point.
    Radius(f64, "f64") |radius| said(ThinLens::new(Concentric::<LibmF64>::new(), radius, 1.0));
    /// Infinity included.
    Distance(f64, "f64") |distance| said(AmbientOcclusion::<LibmF64>::new(distance));
    /// Of a lobe.
    Exponent(f64, "f64") |exponent| said(Glossy::<LibmF64>::new(exponent, BelowHorizon::Flip));
    /// Of a thing.
    Size(f64, "f64") |size| {
        all([size], |size| (1.0 / MOST..=MOST).contains(&size), "a number from 1e-15 to 1e15")
    };
    /// In degrees.
    Angle(f64, "f64") |angle| {
        all([angle], |angle| angle > 0.0 && angle < 180.0, "a number above 0 and below 180")
    };
}

impl Default for Colour {
    /// Black.
    fn default() -> Self {
        Self([0.0; 3])
    }
}

fn said<T>(result: Result<T, hemidisc::Error>) -> Result<(), String> {
    result.map(|_| ()).map_err(|error| error.to_string())
}

fn all<const N: usize>(
    numbers: [f64; N],
    good: fn(f64) -> bool,
    accepted: &str,
) -> Result<(), String> {
    match numbers.into_iter().find(|number| !good(*number)) {
        Some(wrong) => Err(format!("{wrong}; accepted: {accepted}")),
        None => Ok(()),
    }
}
