//! Three components: points, directions and colours.

use hemidisc::arithmetic::{Arithmetic, Real, Root};

/// Three numbers of an arithmetic.
pub type Vector<A> = [<A as Arithmetic>::Real; 3];

#[inline]
pub(super) fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
pub(super) fn sum<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    core::array::from_fn(|i| a[i] + b[i])
}

#[inline]
pub(super) fn difference<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    core::array::from_fn(|i| a[i] - b[i])
}

/// Component by component: a colour on a surface of another.
#[inline]
pub(super) fn product<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    core::array::from_fn(|i| a[i] * b[i])
}

#[inline]
pub(super) fn scaled<R: Real>(k: R, a: [R; 3]) -> [R; 3] {
    a.map(|component| k * component)
}

/// a + k b.
#[inline]
pub(super) fn along<R: Real>(a: [R; 3], k: R, b: [R; 3]) -> [R; 3] {
    core::array::from_fn(|i| a[i] + k * b[i])
}

/// Of unit length; a vector so short that its square has lost digits stays as it is.
#[inline]
pub(super) fn unit<A: Root>(a: Vector<A>) -> Vector<A> {
    let square = dot(a, a);
    if square >= A::Real::MIN_POSITIVE {
        let length = A::sqrt(square);
        a.map(|component| component / length)
    } else {
        a
    }
}
