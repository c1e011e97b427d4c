//! A vector of the first octant turned to its angle, by a table and a small rotation.
//!
//! The octant is cut into 128 parts. With a vector (a, b), 0 <= b <= a, in the j-th part, t = b/a is near
//! t_j = (j + 1/2) / 128, and the concentric map's angle is pi/4 t = pi/4 t_j + delta, where
//! delta = pi/4 (b - a t_j) / a. The difference is formed without a division and almost without rounding, so
//! q = a sin delta = pi/4 (b - a t_j) (1 - delta^2 / 6) and p = a cos delta = a - q delta / 2 are as exact as
//! the words allow; only the small second terms need the quotient, to 16 bits.
//!
//! Lengths are in units of 2^-32. The sines and cosines of the table are too small by [`INWARD`], more than
//! all roundings together can add to a length.

use super::wide::{HALVES, high, high_by_halves, high_signed, high_signed_by_halves, product};

/// What the table is shorter than 1 by, in units of 2^-40: 2.8 units of length.
///
/// Outward, the cuts of x and y and their last rounding add at most 3 / sqrt 2 = 2.1 units of length, the
/// cuts in the sagitta 0.9, the table's own rounding 0.7; the outermost ring is 1 unit from the rim.
const INWARD: u64 = 720;
/// pi/4 in units of 2^-62: floor.
const QUARTER_PI: u64 = 0x3243_f6a8_885a_308d;
/// 4/pi in units of 2^-62.
const FOUR_OVER_PI: i128 = 0x517c_c1b7_2722_0a94;
const PARTS: usize = 128;

/// Cosine and sine of pi/4 t_j.
static ROTATIONS: [[u32; 2]; PARTS] = {
    let mut table = [[0; 2]; PARTS];
    let mut part = 0;
    while part < PARTS {
        let angle = QUARTER_PI as i128 * (2 * part as i128 + 1) / (2 * PARTS as i128);
        let (mut power, mut order) = (1_i128 << 62, 0);
        let mut sums = [0_i128; 2];
        while power > 0 {
            sums[order % 2] += if order % 4 < 2 { power } else { -power };
            order += 1;
            power = power * angle / ((order as i128) << 62);
        }
        let mut axis = 0;
        while axis < 2 {
            let short = sums[axis] - ((sums[axis] * INWARD as i128) >> 40);
            table[part][axis] = ((short + (1 << 29)) >> 30) as u32;
            axis += 1;
        }
        part += 1;
    }
    table
};

/// The same words, upper halves first, for a core that multiplies by halves.
static ROTATIONS_BY_HALVES: [[[u16; 2]; 2]; PARTS] = {
    let mut table = [[[0; 2]; 2]; PARTS];
    let mut part = 0;
    while part < PARTS {
        let [cos, sin] = ROTATIONS[part];
        table[part] = [[(cos >> 16) as u16, cos as u16], [(sin >> 16) as u16, sin as u16]];
        part += 1;
    }
    table
};

/// 2^42 / a for a in the middle of [k, k + 1) 2^24, k from 128 on.
static RECIPROCALS: [u16; 128] = {
    let mut table = [0; 128];
    let mut k = 0;
    while k < 128 {
        // 2^42 / (2^24 (128 + k + 1/2)), rounded.
        table[k] = ((1 << 20) / (2 * (128 + k) + 1)).div_ceil(2) as u16;
        k += 1;
    }
    table
};

/// 2^48 / a for a of 32 significant bits, too small by at most 1 part in 2^15.4: a crude value and a
/// Newton step.
#[inline(always)]
const fn reciprocal(a: u32) -> u32 {
    let crude = RECIPROCALS[(a >> 24 & 127) as usize] as u32;
    // 2^31 (1 - a crude / 2^42), and less by what the cut of `a` may hide.
    let error = (1_u32 << 31).wrapping_sub(crude).wrapping_sub((a >> 11) * crude).cast_signed();
    let step = crude.cast_signed() * (error >> 4);
    ((crude << 6).cast_signed() + (step >> 21)).cast_unsigned()
}

/// Turns (a, 0), a of 32 significant bits, to t_j + d / a, where `offset` is d in units of 2^-38;
/// `reciprocal` is 2^48 / a.
#[inline(always)]
const fn turn(a: u32, reciprocal: u32, part: u32, offset: i32) -> (u32, u32) {
    let sign = offset >> 31;
    // |q| before its second term, in units of 2^-39; below 2^30.7.
    let arc = high(offset.unsigned_abs() << 1, (QUARTER_PI >> 30) as u32);
    // Of 16 bits: q in units of 2^-24, and delta.
    let short = (arc + (1 << 14)) >> 15;
    let delta = (short * reciprocal) >> 16;
    // q delta / 2, and from it q delta^2 / 6 in units of 2^-39.
    let sagitta = (short * delta + (1 << 16)) >> 17;
    let third = (((sagitta * delta) >> 17) * 171) >> 9;
    let p = a - sagitta;
    // Toward 0: near the axis it is negative, and a larger one would leave y below 0.
    let q = (((arc - third) >> 7).cast_signed() ^ sign) - sign;
    let part = (part & 127) as usize;
    if HALVES {
        let [cos, sin] = ROTATIONS_BY_HALVES[part];
        let (along, across) = (high_by_halves(p, cos), high_by_halves(p, sin));
        (
            along.wrapping_add_signed(high_signed_by_halves(-q, sin)),
            across.wrapping_add_signed(high_signed_by_halves(q, cos) + 1),
        )
    } else {
        let [cos, sin] = ROTATIONS[part];
        (
            high(p, cos).wrapping_add_signed(high_signed(-q, sin)),
            high(p, sin).wrapping_add_signed(high_signed(q, cos) + 1),
        )
    }
}

/// a cos(pi/4 b/a) and a sin(pi/4 b/a) of odd a >= b, in the units of `a`.
#[inline(always)]
pub(in crate::arithmetic) const fn octant(mut a: u32, mut b: u32) -> (u32, u32) {
    let mut shift = 0;
    while a < 1 << 31 {
        a <<= 1;
        b <<= 1;
        shift += 1;
    }
    let reciprocal = reciprocal(a);
    let part = ((b >> 16) * reciprocal) >> 25;
    // b - a t_j in units of 2^-38, modulo 2^32: the halves of an odd `a` and of t_j are the last two terms.
    let offset = (b << 6)
        .wrapping_sub((a >> 1).wrapping_mul(part))
        .wrapping_sub(a >> 2)
        .wrapping_sub(part >> 1);
    let (x, y) = turn(a, reciprocal, part, offset.cast_signed());
    (x >> shift, y >> shift)
}

/// Cosine and sine of pi/4 t for an odd count t of 2^-30.
#[inline(always)]
pub(in crate::arithmetic) const fn unit(t: u32) -> (u32, u32) {
    let part = t >> 23 & 127;
    let offset = (t & 0x7f_ffff).cast_signed() - (1 << 22);
    turn(u32::MAX, 1 << 16, part, offset << 8)
}

/// The fraction t of an octant, in units of 2^-62, of the direction (a, b), 0 <= b <= a, a > 0: the inverse
/// of the rotation, by the same table and the arc tangent of what is left.
pub(in crate::arithmetic) fn fraction(a: u32, b: u32) -> u64 {
    // The last part whose t_j is not above the direction's.
    let mut part = 0;
    let mut step = PARTS / 2;
    while step > 0 {
        let [cos, sin] = ROTATIONS[(part + step) & 127];
        if product(b, cos) >= product(a, sin) {
            part += step;
        }
        step /= 2;
    }
    let [cos, sin] = ROTATIONS[part & 127];
    let [a, b, cos, sin] = [a, b, cos, sin].map(i128::from);
    // In [-1/300, 1/150], units of 2^-62; its fifth power is below them.
    let tan = ((b * cos - a * sin) << 62) / (a * cos + b * sin).max(1);
    let cube = (((tan * tan) >> 62) * tan) >> 62;
    let rest = ((tan - cube / 3) * FOUR_OVER_PI) >> 62;
    let t = rest + ((2 * part as i128 + 1) << 62) / (2 * PARTS as i128);
    u64::try_from(t.clamp(0, 1 << 62)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reciprocal depends on the upper 21 bits alone: for the least and the largest `a` of each, it is
    /// not too large and not too small, and the product that chooses the part stays in its word.
    #[test]
    fn every_reciprocal_is_below_and_near() {
        for upper in 1_u32 << 20..1 << 21 {
            for a in [upper << 11, upper << 11 | 0x7ff] {
                let (found, exact) = (u64::from(reciprocal(a)), (1_u64 << 48) / u64::from(a));
                assert!(found <= exact && found + 5 >= exact, "{a:#x}: {found}, not {exact}");
                assert!(u64::from(a >> 16) * found < 1 << 32, "{a:#x}");
            }
        }
    }

    /// Both sides of every edge between two parts, and where y is least: no length leaves its word.
    #[test]
    fn lengths_are_near_at_every_edge() {
        let mut worst = 0.0_f64;
        for a in
            [u32::MAX, u32::MAX - 2, 0xf000_0001, 0xb504_f333, 0x8000_0001, 0x7fff_ffff, 0x101, 1]
        {
            for part in 0..=128_u64 {
                let edge = (u64::from(a) * part) >> 7;
                for b in (edge.saturating_sub(9)..edge + 9).map(|b| b | 1) {
                    if b > u64::from(a) {
                        continue;
                    }
                    let (x, y) = octant(a, b as u32);
                    let [a, b, x, y] = [f64::from(a), b as f64, f64::from(x), f64::from(y)];
                    let angle = core::f64::consts::FRAC_PI_4 * (b / a);
                    worst = worst.max((x - a * angle.cos()).abs());
                    worst = worst.max((y - a * angle.sin()).abs());
                }
            }
        }
        // Units of 2^-32; a third of it is the inward scale.
        assert!((4.0..7.0).contains(&worst), "{worst}");
    }
}
