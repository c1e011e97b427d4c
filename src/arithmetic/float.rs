//! The kernels of every map on floats, for any library of elementary functions.
//!
//! **Coordinates.** 2u - 1 of a cell k is (2j + 1) / 2^32 with the signed j = k - 2^31. Its magnitude is
//! (2m + 1) / 2^32 with m = j ^ (j >> 31), one correctly rounded conversion, so mirror images are equal
//! bit for bit. r^2 = (2m + 1)^2 / 2^64 and 1 - r^2 are exact integers of 64 bits, so each is correctly
//! rounded too: nothing cancels at the rim.
//!
//! **Concentric** (P. Shirley and K. Chiu, "A Low Distortion Map between Disk and Square", 1997).
//! With the larger magnitude r and the smaller n, phi = pi/4 n/r is in [0, pi/4]; x = r cos phi,
//! y = r sin phi, swapped where |v| is the larger. No pi/2 - phi, so nothing cancels near the diagonals.
//!
//! **Polar.** 2 pi u is folded to an octant on the integer: the angle within it is exact.
//!
//! **Lobes** take the direction (cos phi, sin phi) and form sin theta from r^2 and 1 - r^2: two roundings
//! fewer than scaling x and y.
//!
//! **Inward.** Rounding leaves about half of the rim outside the disc. Only those points move, by one
//! ulp of their larger component; shrinking all of them would cost accuracy everywhere.
//!
//! **Power.** With L = ln(1 - r^2), z = exp(L / (e + 1)). sqrt(1 - z^2) loses every digit of sin theta
//! by e = 1e8, so with q = -2 L / (e + 1), sin theta = sqrt(-expm1(-q)); where q nears the end of the
//! type's range (e near 3e38) it is sqrt(2 / (e + 1)) sqrt(-L), whose factors do not underflow. L comes
//! from r^2 where r^2 < 1/2, else from 1 - r^2.

use super::Arithmetic;
use crate::error::Error;
use crate::square::{centre_f32, centre_f64};
use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};
use core::str::FromStr;

/// f32 or f64: what the kernels need of a float besides arithmetic. Sealed.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Into<f64>
    + FromStr<Err: Display>
    + sealed::Sealed
{
    #[doc(hidden)]
    const ZERO: Self;
    #[doc(hidden)]
    const HALF: Self;
    #[doc(hidden)]
    const ONE: Self;
    #[doc(hidden)]
    const TWO: Self;
    #[doc(hidden)]
    const FOUR: Self;
    #[doc(hidden)]
    const EPSILON: Self;
    #[doc(hidden)]
    const MIN_POSITIVE: Self;
    /// Far above the smallest normal number, far below 1.
    #[doc(hidden)]
    const TINY: Self;
    #[doc(hidden)]
    const FRAC_PI_4: Self;
    #[doc(hidden)]
    const FRAC_4_PI: Self;
    #[doc(hidden)]
    const FRAC_1_PI: Self;
    /// n / 2^32, correctly rounded.
    #[doc(hidden)]
    fn over_2_32(n: u32) -> Self;
    /// n / 2^64, correctly rounded.
    #[doc(hidden)]
    fn over_2_64(n: u64) -> Self;
    /// (2k + 1) / 2^33, correctly rounded.
    #[doc(hidden)]
    fn centre(k: u32) -> Self;
    /// (2k + 1) / 2^33, toward zero.
    #[doc(hidden)]
    fn centre_down(k: u32) -> Self;
    /// floor(2^bits x), saturating at 0 and 2^32 - 1; 0 for NaN.
    #[doc(hidden)]
    fn cell(self, bits: u32) -> u32;
    #[doc(hidden)]
    fn magnitude(self) -> Self;
    #[doc(hidden)]
    fn with_sign(self, sign: Self) -> Self;
    #[doc(hidden)]
    fn finite(self) -> bool;
    /// The next number toward zero; for positive numbers.
    #[doc(hidden)]
    fn below(self) -> Self;
    /// Whether a^2 + b^2 > 1, never wrong when true is due; 1/2 <= a <= 2, 0 <= b <= a.
    #[doc(hidden)]
    fn outside(a: Self, b: Self) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! real {
    ($float:ident, $bits:literal, $integer:ident, $fine:literal, $centre_down:ident) => {
        impl Real for $float {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const FOUR: Self = 4.0;
            const EPSILON: Self = $float::EPSILON;
            const MIN_POSITIVE: Self = $float::MIN_POSITIVE;
            const TINY: Self = $float::MIN_POSITIVE * (1_u64 << 32) as $float;
            const FRAC_PI_4: Self = core::$float::consts::FRAC_PI_4;
            const FRAC_4_PI: Self = 4.0 * core::$float::consts::FRAC_1_PI;
            const FRAC_1_PI: Self = core::$float::consts::FRAC_1_PI;

            #[inline(always)]
            fn over_2_32(n: u32) -> Self {
                n as $float * (1.0 / 4_294_967_296.0)
            }
            #[inline(always)]
            fn over_2_64(n: u64) -> Self {
                n as $float * (1.0 / 18_446_744_073_709_551_616.0)
            }
            #[inline(always)]
            fn centre(k: u32) -> Self {
                (2 * u64::from(k) + 1) as $float * (1.0 / 8_589_934_592.0)
            }
            #[inline(always)]
            fn centre_down(k: u32) -> Self {
                $centre_down(k)
            }
            #[inline(always)]
            fn cell(self, bits: u32) -> u32 {
                (self * (1_u64 << bits) as $float) as u32
            }
            #[inline(always)]
            fn magnitude(self) -> Self {
                self.abs()
            }
            #[inline(always)]
            fn with_sign(self, sign: Self) -> Self {
                self.copysign(sign)
            }
            #[inline(always)]
            fn finite(self) -> bool {
                self.is_finite()
            }
            #[inline(always)]
            fn below(self) -> Self {
                Self::from_bits(self.to_bits() - 1)
            }
            /// `a` is a multiple of 2^-bits, so its square is exact in the integer; `b` is rounded
            /// up to a multiple of 2^-fine, finer than a step of `a` can tell.
            #[inline]
            fn outside(a: Self, b: Self) -> bool {
                const ONE: $integer = 1 << $bits;
                const FINE: $float = (1_u64 << $fine) as $float;
                let a = (a * ONE as $float) as $integer;
                if a > ONE {
                    return true;
                }
                let scaled = b * FINE;
                let floor = scaled as $integer;
                let b = floor + $integer::from((floor as $float) < scaled);
                let room = ((ONE - a) * (ONE + a)) << (2 * ($fine - $bits));
                b.checked_mul(b).is_none_or(|square| square > room)
            }
        }
    };
}
real!(f32, 24, u64, 32, centre_f32);
real!(f64, 53, u128, 63, centre_f64);

/// A library of elementary functions on one float type: seven functions give every map.
///
/// The arguments always lie in the ranges given. Errors of a function add to those of the maps; the square
/// root must be good to 1 % for the points to stay on the disc.
pub trait Float: Copy + Default + Debug + PartialEq + Send + Sync + 'static {
    /// Its name on command lines and in tables.
    const NAME: &'static str;
    /// `f32` or `f64`.
    type Real: Real;

    /// Square root of x in [0, MAX].
    fn sqrt(x: Self::Real) -> Self::Real;
    /// Sine and cosine of x in [0, pi/4].
    fn sin_cos(x: Self::Real) -> (Self::Real, Self::Real);
    /// Arc tangent of x in [0, 1].
    fn atan(x: Self::Real) -> Self::Real;
    /// Logarithm of x in (0, 1].
    fn ln(x: Self::Real) -> Self::Real;
    /// ln(1 + x) for x in [-1/2, 0].
    fn ln_1p(x: Self::Real) -> Self::Real;
    /// Exponential of x, of either sign; infinite above the range, 0 below it.
    fn exp(x: Self::Real) -> Self::Real;
    /// exp(x) - 1 for x <= 0.
    fn exp_m1(x: Self::Real) -> Self::Real;
}

/// An exponent e > -1 with what the power lobe needs of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PowerExponent<R> {
    e: R,
    e_plus_1: R,
    /// What rounding has taken from e + 1, relative to it.
    lost: R,
    /// sqrt(2 / (e + 1)): the scale of sin theta at the pole.
    spread: R,
}

impl<R: Real> PowerExponent<R> {
    /// The exponent as the user gave it.
    pub fn value(self) -> R {
        self.e
    }
}

/// The magnitude m of a coordinate about the centre, 2u - 1 = +-(2m + 1) / 2^32, and its sign.
#[inline(always)]
fn fold(k: u32) -> (u32, i32) {
    let j = (k ^ 0x8000_0000).cast_signed();
    let sign = j >> 31;
    ((j ^ sign).cast_unsigned(), sign)
}

#[inline(always)]
fn signed<R: Real>(magnitude: R, sign: i32) -> R {
    if sign < 0 { -magnitude } else { magnitude }
}

#[inline(always)]
fn sorted<R: Real>(a: R, b: R) -> (R, R) {
    if b > a { (b, a) } else { (a, b) }
}

/// Moves a point that rounding has left outside the disc to the next one inside.
#[inline(always)]
fn inward<T: Float>(x: T::Real, y: T::Real) -> [T::Real; 2] {
    let near = T::Real::ONE - T::Real::EPSILON * T::Real::FOUR;
    if x * x + y * y > near { pull::<T>(x, y) } else { [x, y] }
}

/// The rare part of [`inward`]: near the rim, or far outside for a library with coarse functions.
#[inline(never)]
fn pull<T: Float>(x: T::Real, y: T::Real) -> [T::Real; 2] {
    let far = T::Real::ONE + T::Real::EPSILON * T::Real::FOUR;
    let (mut a, mut b) = sorted(x.magnitude(), y.magnitude());
    let length_squared = a * a + b * b;
    if length_squared > far {
        let scale = T::Real::ONE / T::sqrt(length_squared);
        (a, b) = (a * scale, b * scale);
    }
    while T::Real::outside(a, b) {
        a = a.below();
    }
    let [a, b] = if y.magnitude() > x.magnitude() { [b, a] } else { [a, b] };
    [a.with_sign(x), b.with_sign(y)]
}

/// A point of the disc: r (x, y).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatDisc<R> {
    /// (cos phi, sin phi); up to a common factor where an inverse begins.
    direction: [R; 2],
    r: R,
    r2: R,
    /// 1 - r^2.
    rim: R,
}

#[inline(always)]
fn concentric<T: Float>([u, v]: [u32; 2]) -> FloatDisc<T::Real> {
    let ((m_u, sign_u), (m_v, sign_v)) = (fold(u), fold(v));
    let swap = m_v > m_u;
    let (major, minor) = if swap { (2 * m_v + 1, 2 * m_u + 1) } else { (2 * m_u + 1, 2 * m_v + 1) };
    let r = T::Real::over_2_32(major);
    let (sin, cos) = T::sin_cos(T::Real::FRAC_PI_4 * (T::Real::over_2_32(minor) / r));
    let (x, y) = if swap { (sin, cos) } else { (cos, sin) };
    let square = u64::from(major) * u64::from(major);
    FloatDisc {
        direction: [signed(x, sign_u), signed(y, sign_v)],
        r,
        r2: T::Real::over_2_64(square),
        // 2^64 - square; a major magnitude is odd, so the square is not 0.
        rim: T::Real::over_2_64(square.wrapping_neg()),
    }
}

#[inline(always)]
fn polar<T: Float>([u, v]: [u32; 2]) -> FloatDisc<T::Real> {
    // u and !u are mirror images in the x axis: fold before rounding.
    let below = u.cast_signed() >> 31;
    let half = u ^ below.cast_unsigned();
    // 31 bits of a half turn: the quarter, the octant in it, 29 bits within.
    let left = half & 1 << 30 != 0;
    let quarter = if left { half ^ 0x7fff_ffff } else { half };
    let steep = quarter & 1 << 29 != 0;
    let octant = if steep { quarter ^ 0x3fff_ffff } else { quarter };
    let within = T::Real::over_2_32(2 * octant + 1) * T::Real::FOUR;
    let (sin, cos) = T::sin_cos(T::Real::FRAC_PI_4 * within);
    let (x, y) = if steep { (sin, cos) } else { (cos, sin) };
    let r2 = T::Real::centre(v);
    FloatDisc {
        direction: [if left { -x } else { x }, signed(y, below)],
        r: T::sqrt(r2),
        r2,
        rim: T::Real::centre(!v),
    }
}

/// A point from its direction and distance to the axis.
#[inline(always)]
fn scaled<T: Float>([x, y]: [T::Real; 2], by: T::Real) -> [T::Real; 2] {
    inward::<T>(x * by, y * by)
}

/// x^2 + y^2 of a direction or a point of the disc.
#[inline(always)]
fn length_squared<R: Real>(x: R, y: R) -> R {
    x * x + y * y
}

/// ln z of a direction times e + 1, that is ln(1 - r^2) of its disc point: from z near the horizon,
/// from x and y near the pole, where z has rounded to 1.
#[inline]
fn log_rim<T: Float>(exponent: PowerExponent<T::Real>, [x, y, z]: [T::Real; 3]) -> T::Real {
    let s2 = length_squared(x, y);
    if s2 <= T::Real::HALF {
        // ln z = ln(1 - s^2) / 2 = -g s^2 / 2; scaled first, for s^2 may underflow where s does not.
        let scaled = length_squared(x / exponent.spread, y / exponent.spread);
        let g = if s2 < T::Real::EPSILON { T::Real::ONE } else { T::ln_1p(-s2) / -s2 };
        -(scaled * g)
    } else {
        let z = if z > T::Real::MIN_POSITIVE { unit(z) } else { T::Real::MIN_POSITIVE };
        exponent.e_plus_1 * T::ln(z)
    }
}

/// The nearest number in [0, 1]; 0 for NaN.
#[inline(always)]
fn unit<R: Real>(x: R) -> R {
    if x > R::ZERO { if x < R::ONE { x } else { R::ONE } } else { R::ZERO }
}

impl<T: Float> Arithmetic for T {
    const NAME: &'static str = T::NAME;
    /// Blocks were faster on x86-64 for every sequence and map tried; on a microcontroller the arrays
    /// cost more than they save.
    const BLOCKED: bool = cfg!(not(any(target_arch = "arm", target_arch = "riscv32")));

    type Real = T::Real;
    type Disc = FloatDisc<T::Real>;
    type Parameter = T::Real;
    type Exponent = PowerExponent<T::Real>;

    #[inline(always)]
    fn square(uv: [u32; 2]) -> [T::Real; 2] {
        uv.map(T::Real::centre_down)
    }

    #[inline(always)]
    fn centred(uv: [u32; 2]) -> [T::Real; 2] {
        let [x, y] = uv.map(|k| {
            let (m, sign) = fold(k);
            signed(T::Real::over_2_32(2 * m + 1), sign)
        });
        inward::<T>(x, y)
    }

    #[inline(always)]
    fn concentric<const RIM: bool>(uv: [u32; 2]) -> FloatDisc<T::Real> {
        concentric::<T>(uv)
    }

    #[inline(always)]
    fn polar<const RIM: bool>(uv: [u32; 2]) -> FloatDisc<T::Real> {
        polar::<T>(uv)
    }

    #[inline(always)]
    fn store(disc: FloatDisc<T::Real>) -> [T::Real; 2] {
        scaled::<T>(disc.direction, disc.r)
    }

    /// sin theta = sqrt(1 - (1 - r^2)^2) = sqrt(r^2 (1 + (1 - r^2))).
    #[inline(always)]
    fn uniform(disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let [x, y] = scaled::<T>(disc.direction, T::sqrt(disc.r2 * (T::Real::ONE + disc.rim)));
        [x, y, disc.rim]
    }

    #[inline(always)]
    fn cosine(disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let [x, y] = scaled::<T>(disc.direction, disc.r);
        [x, y, T::sqrt(disc.rim)]
    }

    fn exponent(e: T::Real) -> Result<PowerExponent<T::Real>, Error> {
        let e_plus_1 = e + T::Real::ONE;
        // e + 1 may round to 0 for e above -1 only if e is -1 itself; NaN fails the comparison.
        if !(e_plus_1 > T::Real::ZERO && e.finite()) {
            return Err(Error::Exponent { value: e.into() });
        }
        // Knuth's two-sum: e_plus_1 and the two parts' losses make e + 1 exactly.
        let one_part = e_plus_1 - e;
        let lost = (e - (e_plus_1 - one_part)) + (T::Real::ONE - one_part);
        Ok(PowerExponent {
            e,
            e_plus_1,
            lost: lost / e_plus_1,
            spread: T::sqrt(T::Real::TWO / e_plus_1),
        })
    }

    #[inline]
    fn power(exponent: PowerExponent<T::Real>, disc: FloatDisc<T::Real>) -> [T::Real; 3] {
        let log = if disc.r2 < T::Real::HALF { T::ln_1p(-disc.r2) } else { T::ln(disc.rim) };
        let log_z = log / exponent.e_plus_1;
        let z = T::exp(log_z);
        // What e + 1 has lost would cost |ln z| eps: exp(l / (1 + d)) is exp(l) (1 - l d).
        let z = z - z * (log_z * exponent.lost);
        // Below e = 0 the true z leaves the range of the type in the last cells.
        let z = if z < T::Real::MIN_POSITIVE { T::Real::MIN_POSITIVE } else { z };
        let q = -T::Real::TWO * log_z;
        let sin = if q > T::Real::TINY {
            T::sqrt(-T::exp_m1(-q))
        } else {
            exponent.spread * T::sqrt(-log)
        };
        let [x, y] = scaled::<T>(disc.direction, sin);
        [x, y, z]
    }

    #[inline]
    fn load([x, y]: [T::Real; 2]) -> FloatDisc<T::Real> {
        let (a, b) = sorted(x.magnitude(), y.magnitude());
        let rim = (T::Real::ONE - a) * (T::Real::ONE + a) - b * b;
        lowered::<T>([x, y], length_squared(x, y), rim)
    }

    #[inline]
    fn lower_uniform([x, y, z]: [T::Real; 3]) -> FloatDisc<T::Real> {
        lowered::<T>([x, y], length_squared(x, y) / (T::Real::ONE + z), z)
    }

    #[inline]
    fn lower_cosine([x, y, z]: [T::Real; 3]) -> FloatDisc<T::Real> {
        lowered::<T>([x, y], length_squared(x, y), z * z)
    }

    #[inline]
    fn lower_power(
        exponent: PowerExponent<T::Real>,
        [x, y, z]: [T::Real; 3],
    ) -> FloatDisc<T::Real> {
        let log = log_rim::<T>(exponent, [x, y, z]);
        lowered::<T>([x, y], -T::exp_m1(log), T::exp(log))
    }

    #[inline]
    fn invert_square(point: [T::Real; 2]) -> [u32; 2] {
        point.map(|x| x.cell(32))
    }

    #[inline]
    fn invert_centred(point: [T::Real; 2]) -> [u32; 2] {
        point.map(|x| unfold(x.magnitude().cell(31), x))
    }

    #[inline]
    fn invert_concentric(disc: FloatDisc<T::Real>) -> [u32; 2] {
        let [x, y] = disc.direction;
        let (steep, t) = octant::<T>(x, y);
        let major = if disc.r2 < T::Real::HALF {
            disc.r.cell(31)
        } else {
            0x7fff_ffff_u32.saturating_sub((disc.rim / (T::Real::ONE + disc.r)).cell(31))
        };
        // On a diagonal rounding must not make the minor the larger one, which has the radius.
        let major = major.min(0x7fff_ffff);
        let minor = (T::Real::over_2_32(2 * major + 1) * t).cell(31).min(major);
        let (m_u, m_v) = if steep { (minor, major) } else { (major, minor) };
        [unfold(m_u, x), unfold(m_v, y)]
    }

    #[inline]
    fn invert_polar(disc: FloatDisc<T::Real>) -> [u32; 2] {
        let [x, y] = disc.direction;
        let (steep, t) = octant::<T>(x, y);
        let octant = t.cell(29).min(0x1fff_ffff);
        let quarter = if steep { octant ^ 0x3fff_ffff } else { octant };
        let half = if x < T::Real::ZERO { quarter ^ 0x7fff_ffff } else { quarter };
        let u = if y < T::Real::ZERO { !half } else { half };
        let v = if disc.r2 < T::Real::HALF { disc.r2.cell(32) } else { !disc.rim.cell(32) };
        [u, v]
    }

    #[inline]
    fn square_density([u, v]: [T::Real; 2]) -> T::Real {
        let inside = |x: T::Real| x >= T::Real::ZERO && x < T::Real::ONE;
        if inside(u) && inside(v) { T::Real::ONE } else { T::Real::ZERO }
    }

    #[inline]
    fn disc_density([x, y]: [T::Real; 2]) -> T::Real {
        if length_squared(x, y) <= T::Real::ONE { T::Real::FRAC_1_PI } else { T::Real::ZERO }
    }

    #[inline]
    fn uniform_density([_, _, z]: [T::Real; 3]) -> T::Real {
        if z > T::Real::ZERO { T::Real::FRAC_1_PI * T::Real::HALF } else { T::Real::ZERO }
    }

    #[inline]
    fn cosine_density([_, _, z]: [T::Real; 3]) -> T::Real {
        if z > T::Real::ZERO { T::Real::FRAC_1_PI * z } else { T::Real::ZERO }
    }

    #[inline]
    fn power_density(exponent: PowerExponent<T::Real>, direction: [T::Real; 3]) -> T::Real {
        let [x, y, z] = direction;
        let above = z > T::Real::ZERO && length_squared(x, y).finite();
        if !above {
            return T::Real::ZERO;
        }
        // e ln z = e / (e + 1) ln(1 - r^2), which stays moderate for any e: at most -ln MIN_POSITIVE
        // for e < 0, so the density does not overflow.
        let log = exponent.e / exponent.e_plus_1 * log_rim::<T>(exponent, direction);
        exponent.e_plus_1 * (T::Real::FRAC_1_PI * T::Real::HALF) * T::exp(log)
    }
}

/// A point of the disc where an inverse begins.
#[inline(always)]
fn lowered<T: Float>(direction: [T::Real; 2], r2: T::Real, rim: T::Real) -> FloatDisc<T::Real> {
    let r2 = unit(r2);
    FloatDisc { direction, r: T::sqrt(r2), r2, rim: unit(rim) }
}

/// Whether |y| > |x|, and the angle from the nearer axis as a fraction of an octant.
#[inline(always)]
fn octant<T: Float>(x: T::Real, y: T::Real) -> (bool, T::Real) {
    let (x, y) = (x.magnitude(), y.magnitude());
    let (a, b) = sorted(x, y);
    // Not a number where the point is the centre, infinite or none.
    let ratio = b / a;
    let t = if ratio <= T::Real::ONE { T::atan(ratio) * T::Real::FRAC_4_PI } else { T::Real::ZERO };
    (y > x, t)
}

/// The coordinate of a magnitude and its sign: the inverse of [`fold`].
#[inline(always)]
fn unfold<R: Real>(magnitude: u32, sign: R) -> u32 {
    let m = magnitude.min(0x7fff_ffff);
    if sign < R::ZERO { 0x7fff_ffff - m } else { 0x8000_0000 + m }
}
