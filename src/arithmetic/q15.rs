//! Q15: points of 16-bit integers, by tables and 16 x 16 bit products; for cores without a divider.

use super::Q15;

mod disc;
mod lobes;
mod tables;

pub use disc::Q15Disc;
pub use lobes::Q15Exponent;

impl Q15 {
    /// The concentric map, as `Concentric<Q15>` gives it; for tables in flash.
    #[inline(always)]
    pub const fn concentric(uv: [u32; 2]) -> [Self; 2] {
        Self::store(disc::concentric(uv))
    }

    /// Rounds a point of the disc.
    #[inline(always)]
    const fn store(disc: Q15Disc) -> [Self; 2] {
        let Q15Disc { magnitude: [x, y], sign: [sign_x, sign_y], .. } = disc;
        [
            Self::from_bits(disc::rounded(x, sign_x)),
            Self::from_bits(disc::rounded(y, sign_y)),
        ]
    }

    /// TEMPORARY
    pub const fn polar(uv: [u32; 2]) -> [Self; 2] {
        Self::store(disc::polar(uv))
    }
    /// TEMPORARY
    pub fn lift(polar: bool, lobe: u32, e: Q15Exponent, uv: [u32; 2]) -> [Self; 3] {
        let disc = if polar { disc::polar(uv) } else { disc::concentric(uv) };
        match lobe { 0 => lobes::uniform(disc), 1 => lobes::cosine(disc), _ => lobes::power(e, disc) }.map(Self::from_bits)
    }
    /// T
    pub const fn exponent(e: super::FixedExponent) -> Q15Exponent { Q15Exponent::new(e) }
}
