//! The kernels of fast f32 over a block of points.
//!
//! One point is a dependency chain of 40 to 130 operations. Out-of-order execution
//! overlaps two or three such chains, but many short ones. So a block is processed in passes, each
//! over a part of the chain, with intermediate values on the stack. On x86-64 that is 1.2 to 1.3
//! times as fast as one loop, and more for the power lobe. A pass recomputes what is cheap, such as
//! a sign; the compiler removes the parts of a point that it does not use.

use super::disc::{FastDisc, direction, gaps};
use super::functions::ln_complement;
use super::lobes::{FastExponent, elevation};
use super::root::now;
use crate::arithmetic::DiscKernel;
use crate::block::{Block, Lanes};
use crate::target::form::LANE;

/// The points of a disc map.
#[inline(always)]
pub(super) fn disc<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    u: &Block<N>,
    v: &Block<N>,
    [x, y]: &mut [Lanes<f32, N>; 2],
) {
    in_octant::<D, N>(u, v, x, y);
    to_places::<D, N>(u, v, x, y);
}

/// The uniform lobe over the points of a disc map.
#[inline(always)]
pub(super) fn uniform<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    u: &Block<N>,
    v: &Block<N>,
    [x, y, z]: &mut [Lanes<f32, N>; 3],
) {
    for lane in 0..N {
        let disc = D::lane([u[lane], v[lane]]);
        x[lane] = disc.uniform_square();
        z[lane] = disc.one_minus_r2;
    }
    for sin in x.iter_mut() {
        *sin = now(*sin);
    }
    at_distances::<D, N>(u, v, x, y);
}

/// The cosine lobe over them.
#[inline(always)]
pub(super) fn cosine<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    u: &Block<N>,
    v: &Block<N>,
    [x, y, z]: &mut [Lanes<f32, N>; 3],
) {
    for lane in 0..N {
        z[lane] = D::lane([u[lane], v[lane]]).one_minus_r2;
    }
    for z in z {
        *z = now(*z);
    }
    in_octant::<D, N>(u, v, x, y);
    to_places::<D, N>(u, v, x, y);
}

/// The power lobe over them.
#[inline(always)]
pub(super) fn power<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    exponent: FastExponent,
    u: &Block<N>,
    v: &Block<N>,
    [x, y, z]: &mut [Lanes<f32, N>; 3],
) {
    for lane in 0..N {
        let FastDisc { r2, one_minus_r2, .. } = D::lane([u[lane], v[lane]]);
        z[lane] = ln_complement::<LANE>(r2, one_minus_r2);
    }
    for (square, z) in x.iter_mut().zip(z) {
        [*square, *z] = elevation::<LANE>(exponent, *z);
    }
    for sin in x.iter_mut() {
        *sin = now(*sin) * exponent.shrink;
    }
    at_distances::<D, N>(u, v, x, y);
}

/// Points in the directions of a disc map's points, at the distances from the axis in x.
#[inline(always)]
fn at_distances<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    u: &Block<N>,
    v: &Block<N>,
    x: &mut Lanes<f32, N>,
    y: &mut Lanes<f32, N>,
) {
    for lane in 0..N {
        y[lane] = D::lane([u[lane], v[lane]]).t;
    }
    for (x, y) in x.iter_mut().zip(y.iter_mut()) {
        let [cos, sin] = direction(*y, gaps(*y * *y));
        [*x, *y] = [*x * cos, *x * sin];
    }
    to_places::<D, N>(u, v, x, y);
}

/// x and y of the points, in the octant.
#[inline(always)]
fn in_octant<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    u: &Block<N>,
    v: &Block<N>,
    x: &mut Lanes<f32, N>,
    y: &mut Lanes<f32, N>,
) {
    let mut t = [0.0; N];
    for lane in 0..N {
        let FastDisc { ends, t: tangent, .. } = D::lane([u[lane], v[lane]]);
        [x[lane], y[lane]] = ends;
        t[lane] = tangent;
    }
    for lane in 0..N {
        let [cos, sin] = gaps(t[lane] * t[lane]);
        x[lane] -= x[lane] * cos;
        y[lane] -= y[lane] * sin;
    }
}

/// From the octant to their places.
#[inline(always)]
fn to_places<D: DiscKernel<Disc = FastDisc>, const N: usize>(
    u: &Block<N>,
    v: &Block<N>,
    x: &mut Lanes<f32, N>,
    y: &mut Lanes<f32, N>,
) {
    for lane in 0..N {
        let FastDisc { place, .. } = D::lane([u[lane], v[lane]]);
        [x[lane], y[lane]] = place.placed::<LANE>([x[lane], y[lane]], true);
    }
}
