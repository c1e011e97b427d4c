//! The kernels over a block of points, in passes.
//!
//! The chain of one point is 40 to 130 operations long, each of which waits for the last. A processor begins the
//! next points meanwhile, but has room for two or three such chains; of short ones it has many under way. So a
//! block runs in passes, each over a part of the chain, with what is between them on the stack: on x86-64 that is 1.2
//! to 1.3 times as fast as one loop, and more for the power lobe. Where a pass needs what is cheap to form, such as a
//! sign, it forms it again.

use super::FastF32;
use super::disc::{FastDisc, root_to_1};
use super::functions::{gaps, ln_complement, normal_sqrt};
use super::power::{FastExponent, elevation};
use crate::map::DiscMap;
use crate::sequence::{BLOCK, Block};

/// A number of each point.
type Lanes = [f32; BLOCK];

/// Coordinates and a disc map.
struct Points<'a, D> {
    disc: &'a D,
    u: &'a Block,
    v: &'a Block,
}

/// The points of a disc map.
#[inline(always)]
pub(super) fn disc<D: DiscMap<Arithmetic = FastF32>>(
    disc: &D,
    u: &Block,
    v: &Block,
    out: &mut [[f32; 2]; BLOCK],
) {
    let points = Points { disc, u, v };
    let (mut x, mut y) = ([0.0; BLOCK], [0.0; BLOCK]);
    points.octants(&mut x, &mut y);
    for (lane, slot) in out.iter_mut().enumerate() {
        let [x, y] = points.form(lane).turn.turned([x[lane], y[lane]]);
        slot[0] = x;
        slot[1] = y;
    }
}

/// The uniform lobe over them.
#[inline(always)]
pub(super) fn uniform<D: DiscMap<Arithmetic = FastF32>>(
    disc: &D,
    u: &Block,
    v: &Block,
    out: &mut [[f32; 3]; BLOCK],
) {
    let points = Points { disc, u, v };
    let (mut sines, mut z) = ([0.0; BLOCK], [0.0; BLOCK]);
    for lane in 0..BLOCK {
        let FastDisc { r2, rim, .. } = points.form(lane);
        sines[lane] = r2 * (1.0 + rim);
        z[lane] = rim;
    }
    for sin in &mut sines {
        *sin = root_to_1(*sin);
    }
    points.directions(sines, &z, out);
}

/// The cosine lobe over them.
#[inline(always)]
pub(super) fn cosine<D: DiscMap<Arithmetic = FastF32>>(
    disc: &D,
    u: &Block,
    v: &Block,
    out: &mut [[f32; 3]; BLOCK],
) {
    let points = Points { disc, u, v };
    let (mut x, mut y, mut z) = ([0.0; BLOCK], [0.0; BLOCK], [0.0; BLOCK]);
    for (lane, z) in z.iter_mut().enumerate() {
        *z = points.form(lane).rim;
    }
    for z in &mut z {
        *z = normal_sqrt(*z);
    }
    points.octants(&mut x, &mut y);
    points.store(&x, &y, &z, out);
}

/// The power lobe over them.
#[inline(always)]
pub(super) fn power<D: DiscMap<Arithmetic = FastF32>>(
    exponent: FastExponent,
    disc: &D,
    u: &Block,
    v: &Block,
    out: &mut [[f32; 3]; BLOCK],
) {
    let points = Points { disc, u, v };
    let (mut sines, mut z) = ([0.0; BLOCK], [0.0; BLOCK]);
    for (lane, log) in z.iter_mut().enumerate() {
        let FastDisc { r2, rim, .. } = points.form(lane);
        *log = ln_complement(r2, rim);
    }
    for (square, z) in sines.iter_mut().zip(&mut z) {
        [*square, *z] = elevation(exponent, *z);
    }
    for sin in &mut sines {
        *sin = exponent.distance(*sin);
    }
    points.directions(sines, &z, out);
}

impl<D: DiscMap<Arithmetic = FastF32>> Points<'_, D> {
    /// All of a point, of which the compiler leaves out what a pass does not use.
    #[inline(always)]
    fn form(&self, lane: usize) -> FastDisc {
        self.disc.disc::<true>([self.u[lane], self.v[lane]])
    }

    /// x and y of the points in the octant.
    #[inline(always)]
    fn octants(&self, x: &mut Lanes, y: &mut Lanes) {
        let mut t = [0.0; BLOCK];
        for lane in 0..BLOCK {
            let FastDisc { ends, t: tangent, .. } = self.form(lane);
            [x[lane], y[lane]] = ends;
            t[lane] = tangent;
        }
        less_gaps(x, y, &t);
    }

    /// Directions at distances from the axis, and with their z.
    #[inline(always)]
    fn directions(&self, distances: Lanes, z: &Lanes, out: &mut [[f32; 3]; BLOCK]) {
        let (mut x, mut y, mut t) = (distances, [0.0; BLOCK], [0.0; BLOCK]);
        for lane in 0..BLOCK {
            t[lane] = self.form(lane).t;
            y[lane] = x[lane] * t[lane];
        }
        less_gaps(&mut x, &mut y, &t);
        self.store(&x, &y, z, out);
    }

    /// From the octant to their places.
    #[inline(always)]
    fn store(&self, x: &Lanes, y: &Lanes, z: &Lanes, out: &mut [[f32; 3]; BLOCK]) {
        for (lane, slot) in out.iter_mut().enumerate() {
            let [x, y] = self.form(lane).turn.turned([x[lane], y[lane]]);
            slot[0] = x;
            slot[1] = y;
            slot[2] = z[lane];
        }
    }
}

/// From r and r t to x and y in the octant.
#[inline(always)]
fn less_gaps(x: &mut Lanes, y: &mut Lanes, t: &Lanes) {
    for lane in 0..BLOCK {
        let [cos, sin] = gaps(t[lane] * t[lane]);
        x[lane] -= x[lane] * cos;
        y[lane] -= y[lane] * sin;
    }
}
