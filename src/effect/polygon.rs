//! A regular polygon in the unit disc: the aperture of a lens with N blades.
//!
//! u chooses one of N triangles about the centre, and the rest of u and v a point of it, by E.
//! Heitz, "A Low-Distortion Map Between Triangle and Square", 2019: no square root, and neighbours
//! stay neighbours.

use crate::arithmetic::{Arithmetic, Real, RealKernel};
use crate::map::{Density, Invert, Map, Polar};
use crate::target::where_floats_round;

/// The unit square onto a regular polygon of N corners on the unit circle; area ratios are kept.
///
/// The corners are the polar map's outermost points, 6e-11 short of the circle. The blade is
/// floor(u N). A polygon with fewer than 3 corners does not compile.
///
/// ```
/// use hemidisc::{Density, LibmF32, effect::Polygon};
/// // A hexagon with a corner up.
/// let blades = Polygon::<LibmF32, 6>::new(1 << 30);
/// let [x, y] = blades.sample([1 << 31, 1 << 30]);
/// assert!(x * x + y * y < 1.0);
/// assert!((1.0 / blades.density([x, y]) - 2.598).abs() < 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polygon<A: Arithmetic, const N: usize> {
    /// Kept to be written.
    #[cfg(any(feature = "serde", feature = "defmt"))]
    rotation: u32,
    corners: [[A::Real; 2]; N],
}

impl<A: Arithmetic, const N: usize> Polygon<A, N> {
    /// The corners, counterclockwise.
    #[must_use]
    pub const fn corners(&self) -> &[[A::Real; 2]; N] {
        &self.corners
    }

    #[cfg(any(feature = "serde", feature = "defmt"))]
    pub(crate) const fn rotation(&self) -> u32 {
        self.rotation
    }
}

where_floats_round! {
    use crate::arithmetic::FastF32;

    impl<const N: usize> Polygon<FastF32, N> {
        /// [`new`](Self::new), as a `const fn`: for an aperture in a `static`.
        #[must_use]
        pub const fn const_new(rotation: u32) -> Self {
            let () = Self::AT_LEAST_3;
            let mut corners = [[0.0; 2]; N];
            let mut corner = 0;
            while corner < N {
                corners[corner] = FastF32::polar(place(corner, N, rotation));
                corner += 1;
            }
            Self {
                #[cfg(any(feature = "serde", feature = "defmt"))]
                rotation,
                corners,
            }
        }
    }
}

/// The coordinates of a corner of n for the polar map.
const fn place(corner: usize, n: usize, rotation: u32) -> [u32; 2] {
    let turn = (((corner as u64) << 32) / n as u64) as u32;
    [turn.wrapping_add(rotation), u32::MAX]
}

impl<A: Arithmetic<Real: Real>, const N: usize> Polygon<A, N> {
    const AT_LEAST_3: () = assert!(N >= 3, "a polygon has at least 3 corners");

    /// A polygon with a corner at an angle, in 2^-32 turns from the x axis.
    #[must_use]
    pub fn new(rotation: u32) -> Self {
        let () = Self::AT_LEAST_3;
        let corners =
            core::array::from_fn(|corner| Polar::<A>::new().sample(place(corner, N, rotation)));
        Self {
            #[cfg(any(feature = "serde", feature = "defmt"))]
            rotation,
            corners,
        }
    }

    /// 1 / area.
    #[inline]
    fn even() -> A::Real {
        A::Real::nearest(const { 1.0 / area(N) })
    }

    /// The corners of a blade, counterclockwise.
    #[inline]
    fn blade(&self, blade: usize) -> [[A::Real; 2]; 2] {
        let corner = |n: usize| self.corners.get(n).or(self.corners.first()).copied();
        [blade, blade + 1].map(|n| corner(n).unwrap_or_default())
    }

    /// The shares of the two corners at a point of a blade.
    #[inline]
    fn shares(&self, blade: usize, point: [A::Real; 2]) -> [A::Real; 2] {
        let [a, b] = self.blade(blade);
        let whole = cross(a, b);
        [cross(point, b) / whole, cross(a, point) / whole]
    }

    /// The blade in which a point is least outside, and the shares of its corners.
    fn found(&self, point: [A::Real; 2]) -> (usize, [A::Real; 2]) {
        let mut best = (0, self.shares(0, point));
        for blade in 1..N {
            let shares = self.shares(blade, point);
            let least = |[a, b]: [A::Real; 2]| if a < b { a } else { b };
            if least(shares) > least(best.1) {
                best = (blade, shares);
            }
        }
        best
    }
}

/// N/2 sin x, x = 2 pi / N: the area of the polygon with N corners on the unit circle, as
/// pi sin x / x by Taylor's series, within 2 ulp. Its terms after the 13th are below 2e-20.
const fn area(n: usize) -> f64 {
    let x = core::f64::consts::TAU / n as f64;
    let mut sum = 1.0;
    let mut k = 12;
    while k > 0 {
        sum = 1.0 - x * x / (2 * k * (2 * k + 1)) as f64 * sum;
        k -= 1;
    }
    core::f64::consts::PI * sum
}

#[inline]
fn cross<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    a[0] * b[1] - a[1] * b[0]
}

impl<A: Arithmetic<Real: Real>, const N: usize> Map for Polygon<A, N> {
    type Point = [A::Real; 2];

    #[inline]
    fn sample(&self, [u, v]: [u32; 2]) -> [A::Real; 2] {
        let wide = u64::from(u) * N as u64;
        let [a, b] = self.blade((wide >> 32) as usize);
        let [s, t] = A::square([wide as u32, v]);
        let (s, t) = if t > s {
            let s = s * A::Real::HALF;
            (s, t - s)
        } else {
            let t = t * A::Real::HALF;
            (s - t, t)
        };
        [a[0] * s + b[0] * t, a[1] * s + b[1] * t]
    }
}

impl<A: Arithmetic<Real: Real>, const N: usize> Density for Polygon<A, N> {
    /// 1 / area inside, 0 outside.
    #[inline]
    fn density(&self, point: [A::Real; 2]) -> A::Real {
        let (blade, [s, t]) = self.found(point);
        let [a, b] = self.blade(blade);
        // The relative error of a share grows as 1 / area of the blade.
        let slack = A::Real::EPSILON * A::Real::FOUR / cross(a, b);
        if s >= -slack && t >= -slack && s + t <= A::Real::ONE + slack {
            Self::even()
        } else {
            A::Real::ZERO
        }
    }

    /// Every sample is inside: no blade is searched for.
    #[inline]
    fn sample_with_density(&self, uv: [u32; 2]) -> ([A::Real; 2], A::Real) {
        (self.sample(uv), Self::even())
    }
}

impl<A: Arithmetic<Real: Real>, const N: usize> Invert for Polygon<A, N> {
    #[inline]
    fn invert(&self, point: [A::Real; 2]) -> [u32; 2] {
        let (blade, [s, t]) = self.found(point);
        let (s, t) = if t > s { (s + s, t + s) } else { (s + t, t + t) };
        let [u, v] = [s, t].map(|x| x.cell(32));
        let blades = (blade as u64) << 32;
        // Rounded down it may be in the blade before, where the same v is another place.
        let first = blades.div_ceil(N as u64);
        [((blades | u64::from(u)) / N as u64).max(first) as u32, v]
    }
}

impl<A: Arithmetic<Real: Real>, const N: usize> Default for Polygon<A, N> {
    /// With a corner on the x axis.
    fn default() -> Self {
        Self::new(0)
    }
}

crate::map::sampled!(
    [A: Arithmetic<Real: Real>, const N: usize]
    Polygon<A, N>, [A::Real; 2]
);
