//! The share of a power lobe that is above a plane through its centre: a glossy reflection at a
//! grazing angle.
//!
//! With the axis at an elevation a above the plane and n = e + 1, d share / da is proportional to
//! cos^e a. So the share is (1 + P) / 2, where P is the integral of cos^e from 0 to a over that to
//! pi / 2. It is Student's distribution function at t = sqrt(n) tan a, with n degrees of freedom.
//!
//! **Large n.** With w^2 = -2 ln cos a the integrand is exp(-g w^2 / 2) sqrt(h / sinh h) dw,
//! g = n - 1/2, h = w^2 / 2. The root is 1 - h^2 / 12 + h^4 / 160 - ... Let z = w sqrt g and
//! k = 1 / (48 g^2). Up to the second term P is erf(z / sqrt 2) + k sqrt(2 / pi) exp(-z^2 / 2)
//! (z^3 + 3z) / (1 - 3k). The third term is below 2e-6 from g = 12 on.
//!
//! **Small n.** Let B(e) be the integral to pi / 2. Integration by parts gives
//! P(e) = P(e + 2) - cos^(e + 1) a sin a / ((e + 2) B(e + 2)) and B(e) = B(e + 2) (e + 2) / (e + 1).
//! At most seven steps lead to g = 12.
//!
//! The error is below 1e-6, and the error of the arithmetic's functions. erf is 7.1.26 of
//! M. Abramowitz and I. Stegun, "Handbook of Mathematical Functions", 1964, within 1.5e-7.

use super::functions::Float;
use super::real::{Real, RealKernel};

/// The share for an exponent n - 1, from sin a, in [0, 1], and cos^2 a.
pub(super) fn above<T: Float>(n: T::Real, sin: T::Real, cos2: T::Real) -> T::Real {
    let (one, two) = (T::Real::ONE, T::Real::TWO);
    let number = T::Real::nearest;
    if cos2 <= T::Real::ZERO {
        return one;
    }
    let w = width::<T>(sin, cos2);
    let (mut top, mut steps) = (n, 0);
    while top < number(12.5) {
        top = top + two;
        steps += 1;
    }
    let g = top - T::Real::HALF;
    let k = one / (number(48.0) * g * g);
    let rest = one - number(3.0) * k;
    let z = T::sqrt(g) * w;
    // Beyond 9 the rest is below 1e-18.
    let mut p = one;
    if z < number(9.0) {
        let fall = T::exp(-(z * z) * T::Real::HALF);
        let bump = number(0.797_884_560_802_865_4) * fall;
        p = erf::<T>(z, fall) + k * bump * z * (z * z + number(3.0)) / rest;
    }
    if steps > 0 {
        let mut whole = T::sqrt(number(core::f64::consts::FRAC_PI_2) / g) * rest;
        let (mut sum, mut m) = (one, top - two);
        for _ in 1..steps {
            sum = one + cos2 * (m - one) / m * sum;
            whole = whole * (m + one) / m;
            m = m - two;
        }
        let power = T::exp(-(n * w * w) * T::Real::HALF);
        p = p - power * sin * sum / ((n + one) * whole);
    }
    let p = if p > T::Real::ZERO { p } else { T::Real::ZERO };
    if p < one { T::Real::HALF + p * T::Real::HALF } else { one }
}

/// sqrt(-2 ln cos a): from the sine near the plane, whose square may underflow, and from the cosine
/// near the normal.
fn width<T: Float>(sin: T::Real, cos2: T::Real) -> T::Real {
    let sin2 = sin * sin;
    if sin2 < T::Real::EPSILON {
        sin
    } else if sin2 <= T::Real::HALF {
        T::sqrt(-T::ln_1p(-sin2))
    } else {
        let cos2 = if cos2 > T::Real::MIN_POSITIVE { cos2 } else { T::Real::MIN_POSITIVE };
        T::sqrt(-T::ln(cos2))
    }
}

/// erf(z / sqrt 2), of z >= 0 and exp(-z^2 / 2).
fn erf<T: Float>(z: T::Real, fall: T::Real) -> T::Real {
    const TERMS: [f64; 5] =
        [0.254_829_592, -0.284_496_736, 1.421_413_741, -1.453_152_027, 1.061_405_429];
    const SLOPE: f64 = 0.327_591_1 * core::f64::consts::FRAC_1_SQRT_2;
    let t = T::Real::ONE / (T::Real::ONE + T::Real::nearest(SLOPE) * z);
    let terms = TERMS.into_iter().rev().map(T::Real::nearest);
    let sum = terms.fold(T::Real::ZERO, |sum, term| (sum + term) * t);
    T::Real::ONE - sum * fall
}
