//! The maps as command lines name them: `disc-` and a disc map, `hemisphere-` and a lobe, the
//! square and rejection.

/// The coordinates themselves.
pub const SQUARE: &str = "square";
/// Rejection from the square about the disc: not one-to-one.
pub const REJECTION: &str = "disc-rejection";

macro_rules! discs {
    ($($file:ident $map:ident $name:literal;)*) => {
        const DISCS: &[&str] = &[$(concat!("disc-", $name)),*];
    };
}
hemidisc::for_each_disc_map!(discs);

macro_rules! hemispheres {
    ($($file:ident $type:ident $over:ident $name:literal ($($taken:ident)?);)*) => {
        const HEMISPHERES: &[&str] = &[$(concat!("hemisphere-", $name)),*];
        const OF_AN_EXPONENT: &[&str] = &[$($(hemispheres!(@ $taken $name),)?)*];
    };
    (@ exponent $name:literal) => {
        concat!("hemisphere-", $name)
    };
}
hemidisc::for_each_lobe!(hemispheres);

/// The maps that keep every point.
pub fn one_to_one() -> impl Iterator<Item = &'static str> {
    [SQUARE].into_iter().chain(DISCS.iter().chain(HEMISPHERES).copied())
}

/// All maps.
pub fn all() -> impl Iterator<Item = &'static str> {
    [SQUARE, REJECTION].into_iter().chain(one_to_one().skip(1))
}

/// Whether a map is of the hemisphere, which has a disc map below it.
pub fn is_hemisphere(map: &str) -> bool {
    HEMISPHERES.contains(&map)
}

/// Whether a map takes an exponent.
pub fn takes_exponent(map: &str) -> bool {
    OF_AN_EXPONENT.contains(&map)
}

/// The maps that take an exponent, in one text.
pub fn of_an_exponent() -> String {
    OF_AN_EXPONENT.join(" or ")
}
