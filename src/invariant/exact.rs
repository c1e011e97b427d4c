//! x^2 + y^2 <= 1 without rounding.

/// A component of a point that an `f64` holds exactly.
pub trait Exact: Copy + Default {
    /// The same value.
    fn exact(self) -> f64;

    /// Whether another number is this one negated, bit for bit.
    fn mirrors(self, other: Self) -> bool {
        self.exact().to_bits() == (-other.exact()).to_bits()
    }
}

impl Exact for f32 {
    fn exact(self) -> f64 {
        self.into()
    }
}

impl Exact for f64 {
    fn exact(self) -> f64 {
        self
    }
}

/// Fixed point has one 0, so the bits of the doubles may differ where those of the numbers do not.
#[cfg(feature = "fixed-point")]
macro_rules! fixed {
    ($($number:ident),*) => {$(
        impl Exact for crate::$number {
            fn exact(self) -> f64 {
                self.to_f64()
            }

            fn mirrors(self, other: Self) -> bool {
                self.to_bits().checked_neg() == Some(other.to_bits())
            }
        }
    )*};
}
#[cfg(feature = "fixed-point")]
fixed!(Q15, Q31);

/// Whether x^2 + y^2 <= 1 in exact arithmetic; false for infinities and NaN.
///
/// With a >= b the magnitudes: below a = 0.7 the sum is at most 0.98. Above it a is a multiple A of
/// 2^-53, so 1 - a^2 is the integer W = 2^106 - A^2 in units of 2^-106. b is m 2^-s with an integer
/// m of 53 bits. So b^2 <= 1 - a^2 is m^2 <= W 2^(2s - 106): a comparison of integers of 128 bits.
///
/// ```
/// use hemidisc::invariant::in_unit_disc;
/// assert!(in_unit_disc([1.0, 0.0]));
/// assert!(!in_unit_disc([1.0, 1e-300]));
/// assert!(in_unit_disc([0.6, 0.8 - f64::EPSILON]));
/// ```
#[must_use]
pub fn in_unit_disc([x, y]: [f64; 2]) -> bool {
    let (x, y) = (x.abs(), y.abs());
    let (a, b) = if x > y { (x, y) } else { (y, x) };
    if !(a <= 1.0 && b <= 1.0) {
        return false;
    }
    if a < 0.7 {
        return true;
    }
    let whole = (a * (1_u64 << 53) as f64) as u128;
    let room = (1 << 106) - whole * whole;
    let bits = b.to_bits();
    // A subnormal b has the exponent of the smallest normal ones and no leading 1.
    let exponent = (bits >> 52) as i32;
    let mantissa = u128::from(bits & ((1 << 52) - 1) | u64::from(exponent > 0) << 52);
    // s = 1075 - exponent >= 52, for b <= 1.
    let shift = 2 * (1075 - exponent.max(1)) - 106;
    let square = mantissa * mantissa;
    if shift < 0 {
        // b = 1, and a >= b.
        return false;
    }
    // The square has at most 106 bits.
    let (high, low) = match shift {
        0..106 => (square >> shift, square & ((1 << shift) - 1)),
        _ => (0, square),
    };
    high < room || high == room && low == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pythagorean_points_are_on_the_circle() {
        // a^2 + b^2 = 1 exactly needs a power of two for a hypotenuse, so only the axes are on it;
        // one step outward must fail, one inward hold.
        for [x, y] in [[1.0, 0.0], [0.0, -1.0], [-1.0, -0.0]] {
            assert!(in_unit_disc([x, y]), "{x} {y}");
        }
        let above = f64::from_bits(1.0_f64.to_bits() + 1);
        assert!(!in_unit_disc([above, 0.0]) && !in_unit_disc([1.0, f64::from_bits(1)]));
    }

    /// sqrt(1 - a^2) rounded down to a multiple of 2^-53 by integers alone, for comparison.
    #[test]
    fn the_edge_is_found_to_one_ulp() {
        let mut state = 1_u64;
        for _ in 0..20_000 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let whole = (1_u64 << 53) - (state >> (12 + state % 40));
            let room = (1_u128 << 106) - u128::from(whole) * u128::from(whole);
            let edge = room.isqrt() as u64;
            let [a, b] = [whole, edge].map(|n| n as f64 / (1_u64 << 53) as f64);
            if a < 0.708 || b > a || edge >= 1 << 53 {
                continue;
            }
            let outside = (edge + 1) as f64 / (1_u64 << 53) as f64;
            assert!(in_unit_disc([a, b]) && in_unit_disc([-b, a]), "{a:e} {b:e}");
            assert!(!in_unit_disc([a, outside]), "{a:e} {outside:e}");
        }
    }

    /// The two doubles on either side of sqrt(1 - a^2); sometimes the square of the outer one
    /// exceeds 1 - a^2 by less than one unit of 2^-106, and only its last bits tell.
    #[test]
    fn the_last_bits_count() {
        let mut within_a_unit = 0;
        for k in 1..4000_u128 {
            let whole = (1 << 53) - k;
            let room = (1_u128 << 106) - whole * whole;
            // b = m 2^-s with m of 53 bits; m^2 and room 2^shift are in the same unit.
            let shift = (room.leading_zeros() - 22) & !1;
            let edge = (room << shift).isqrt();
            let scale = 0.5_f64.powi((shift as i32 + 106) / 2);
            let a = whole as f64 * 0.5_f64.powi(53);
            assert!(in_unit_disc([a, edge as f64 * scale]), "{k}");
            assert!(!in_unit_disc([a, (edge + 1) as f64 * scale]), "{k}");
            within_a_unit += u32::from((edge + 1).pow(2) >> shift == room);
        }
        assert_eq!(within_a_unit, 10);
    }

    #[test]
    fn not_numbers_are_outside() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!in_unit_disc([bad, 0.0]) && !in_unit_disc([0.0, bad]));
        }
    }
}
