//! The rotation of a vector of the first octant to its angle, by a table and a small rotation.
//!
//! The concentric map's angle of a vector (m, n), 0 <= n <= m, is pi/4 t with t = n/m. A t_j =
//! j / 128 is near t, and the angle is pi/4 t_j + delta, with delta = pi/4 (n - m t_j) / m. The
//! difference n - m t_j is formed without a division and without rounding. Of it are made q =
//! m sin delta = pi/4 (n - m t_j) (1 - delta^2 / 6) and p = m cos delta = m - m delta^2 / 2. Both
//! are as exact as the words allow. Only the small second terms need the quotient, to 16 bits.
//! Taking m for a coordinate's m + 1/2 costs half an LSB, inward, and saves a bit.
//!
//! The vector (p, q) is rotated to t_j in three shears, y' = q + p T, x = p - y' S, y = y' + x T,
//! with S the sine and T the tangent of half the angle: three products instead of four.
//!
//! Coordinates m and n are in LSBs of Q31, units of 2^-31; the lengths from them in half that. A
//! vector is shortened by m >> [`INWARD`]: at the rim, by more than all roundings together can add
//! to its length.
//!
//! A suffix `_q24` says that a variable counts units of 2^-24, and so on; [`rotate_to_part`] has
//! them. tests/derive/fixed.py derives the tables and constants.

use super::wide::{HALVES, high, high_by_halves, high_signed, high_signed_by_halves, product};

/// At the rim 3 units of 2^-32; nearer the centre there is room. With 30, which is 1 unit, points
/// of the rim leave the disc: the test `lengths_are_not_above_the_rim`, and tests/derive/fixed.py,
/// find them.
const INWARD: u32 = 29;
/// pi/4 in units of 2^-62: floor.
const QUARTER_PI: u64 = 0x3243_f6a8_885a_308d;
/// pi/4 in units of 2^-26, less [`ARC_LESS`].
const ARC: u32 = (QUARTER_PI >> 36) as u32 - ARC_LESS;
/// What the cubic term leaves at the edge of a part, in units of 2^-26.
///
/// [`rotate_to_part`] takes 5/32 delta^3 for delta^3 / 6, which is delta^3 / 96 more. At the edge
/// of a part delta = pi/4 / 256, and pi/4 delta^2 / 96 is 5.17 units.
const ARC_LESS: u32 = 5;
/// 4/pi in units of 2^-62.
const FOUR_OVER_PI: i128 = 0x517c_c1b7_2722_0a94;
/// Parts of an octant; the table has both ends.
const PARTS: usize = 128;

/// The tangent of pi/8 t_j and the sine of pi/4 t_j in units of 2^-32, to the nearest.
const ROTATIONS: [[u32; PARTS + 1]; 2] = {
    let mut table = [[0; PARTS + 1]; 2];
    let mut part = 0;
    while part <= PARTS {
        let angle = QUARTER_PI as i128 * part as i128 / PARTS as i128;
        let (mut power, mut order) = (1_i128 << 62, 0);
        let mut sums = [0_i128; 2];
        while power > 0 {
            sums[order % 2] += if order % 4 < 2 { power } else { -power };
            order += 1;
            power = power * angle / ((order as i128) << 62);
        }
        let [cos, sin] = sums;
        // sin / (1 + cos)
        let tan = (sin << 62) / ((1 << 62) + cos);
        table[0][part] = ((tan + (1 << 29)) >> 30) as u32;
        table[1][part] = ((sin + (1 << 29)) >> 30) as u32;
        part += 1;
    }
    table
};
/// A separate table: its index is then the whole address of a load.
static TANGENTS: [u32; PARTS + 1] = ROTATIONS[0];
static SINES: [u32; PARTS + 1] = ROTATIONS[1];

/// The same words, upper halves first, for a core that multiplies by halves.
static ROTATIONS_BY_HALVES: [[[u16; 2]; 2]; PARTS + 1] = {
    let mut table = [[[0; 2]; 2]; PARTS + 1];
    let mut part = 0;
    while part <= PARTS {
        let (tan, sin) = (TANGENTS[part], SINES[part]);
        table[part] = [[(tan >> 16) as u16, tan as u16], [(sin >> 16) as u16, sin as u16]];
        part += 1;
    }
    table
};

/// 2^42 / m for m in the middle of [k, k + 1) 2^23, k from 32 on, floor: nearer the centre the
/// words are too short.
static RECIPROCALS: [u16; 224] = {
    let mut table = [0; 224];
    let mut k = 32;
    while k < 256 {
        table[k - 32] = ((1 << 20) / (2 * k + 1)) as u16;
        k += 1;
    }
    table
};

/// 2^46 / m for m in [2^28, 2^31), too small by at most 1 part in 2^14 at 2^31 and in 2^11.9 at
/// 2^28: a crude value and a Newton step. Undefined nearer the centre.
#[inline(always)]
const fn reciprocal(m: u32) -> Option<u32> {
    let k = (m >> 23).wrapping_sub(32) as usize;
    if k >= RECIPROCALS.len() {
        return None;
    }
    let crude = RECIPROCALS[k] as u32;
    // m crude / 2^42 is nearly 1: (m >> 11) * crude is that in units of 2^-31, and 2^32 is 2.
    let two_less_q31 = ((m >> 11) * crude).wrapping_neg();
    // 2^42 / m in units of 2^-16, then 2^46 / m.
    Some((crude * (two_less_q31 >> 15)) >> 12)
}

/// To units of 2^-24, which leave 16 bits of an arc of a part: from 2^-32.
const ARC_TO_Q24: u32 = 32 - 24;
/// `reciprocal` is 2^15 / (m 2^-31).
const RECIPROCAL_BITS: u32 = 15;
/// From 2^-24 2^-24 to units of 2^-32, and the half of it.
const SAGITTA_SHIFT: u32 = 24 + 24 - 32 + 1;
/// From 2^-32 2^-24 to units of 2^-32, and a quarter of it.
const CUBE_SHIFT: u32 = 24 + 2;

/// Rotates (m, 0) to the angle pi/4 (t_j + d / m), where j is `part`; m in units of 2^-31, d in
/// units of 2^-38, x and y in units of 2^-32. `reciprocal` is 2^46 / m for m as the integer that it
/// is.
#[inline(always)]
const fn rotate_to_part(m: u32, reciprocal: u32, part: u32, d_q38: i32) -> (u32, u32) {
    let part = part as usize;
    if part > PARTS {
        // Not with a true reciprocal.
        return (0, 0);
    }
    // m delta = pi/4 d: 2^-38 2^-26 = 2^-64, of which the upper half; below 2^24.
    let arc_q32 = if HALVES {
        high_signed_by_halves(d_q38, [(ARC >> 16) as u16, ARC as u16])
    } else {
        high_signed(d_q38, ARC)
    };
    // m delta, of 16 bits, and delta.
    let arc_q24 = arc_q32 >> ARC_TO_Q24;
    let delta_q24 = (arc_q24 * reciprocal.cast_signed()) >> RECIPROCAL_BITS;
    // m delta^2 / 2.
    let sagitta_q32 = arc_q24.wrapping_mul(delta_q24).cast_unsigned() >> SAGITTA_SHIFT;
    // m delta^3 / 2. Of it 5/16, for 1/3, is 5/4 times a quarter.
    let cube_q56 = sagitta_q32.cast_signed() * delta_q24;
    let q = arc_q32 - ((cube_q56 + (cube_q56 >> 2)) >> CUBE_SHIFT);
    // m cos delta; 2 m is m in units of 2^-32.
    let p = 2 * m - sagitta_q32 - (m >> INWARD);
    // `across` and both results in units of 2^-32. `across` is not below 0: d is not where t_j is
    // 0, and elsewhere is above -m / 256.
    if HALVES {
        let [tan, sin] = ROTATIONS_BY_HALVES[part];
        let across = high_by_halves(p, tan).wrapping_add_signed(q);
        let x = p.wrapping_sub(high_by_halves(across, sin));
        (x, high_by_halves(x, tan).wrapping_add(across))
    } else {
        let (tan, sin) = (TANGENTS[part], SINES[part]);
        let across = high(p, tan).wrapping_add_signed(q);
        let x = p.wrapping_sub(high(across, sin));
        (x, high(x, tan).wrapping_add(across))
    }
}

/// Half a part less 1/256 of one, in units of 2^-24 of a part: what rounds to the nearest part.
///
/// A reciprocal is too large by at most 2^-17 (the test `every_reciprocal_is_below_and_near`),
/// which is 2^-10 of 128 parts. With 1/256 less than half a part, the part chosen is never above
/// the nearest one.
const NEAREST_PART: u32 = (1 << 23) - (1 << 16);

/// m cos(pi/4 n/m) and m sin(pi/4 n/m), 0 <= n <= m; `reciprocal` is 2^46 / m.
#[inline(always)]
const fn rotate_by_reciprocal(m: u32, n: u32, reciprocal: u32) -> (u32, u32) {
    // 2^31 n/m = 2^24 PARTS n/m.
    let t = (n >> 15) * reciprocal;
    // The nearest, or in doubt the lower one.
    let part = (t + NEAREST_PART) >> 24;
    // d = n - m t_j, modulo 2^32: n 2^-31 is 2^7 n 2^-38, and m 2^-31 / PARTS is m 2^-38.
    let d_q38 = (n << 7).wrapping_sub(m.wrapping_mul(part));
    rotate_to_part(m, reciprocal, part, d_q38.cast_signed())
}

/// One point in 64 is so near the centre that it is enlarged first.
#[cold]
#[inline(never)]
const fn enlarged(m: u32, n: u32) -> (u32, u32) {
    let (mut a, mut b, mut shift) = (2 * m + 1, 2 * n + 1, 0);
    while a >> 29 == 0 {
        a <<= 1;
        b <<= 1;
        shift += 1;
    }
    match reciprocal(a >> 1) {
        Some(reciprocal) => {
            let (x, y) = rotate_by_reciprocal(a >> 1, b >> 1, reciprocal);
            (x >> shift, y >> shift)
        }
        None => (0, 0),
    }
}

/// a cos(pi/4 b/a) and a sin(pi/4 b/a) in units of 2^-32 of a = m + 1/2 and b = n + 1/2,
/// 0 <= n <= m < 2^31.
#[inline(always)]
pub(in crate::arithmetic) const fn rotate(m: u32, n: u32) -> (u32, u32) {
    match reciprocal(m) {
        Some(reciprocal) => rotate_by_reciprocal(m, n, reciprocal),
        None => enlarged(m, n),
    }
}

/// Cosine and sine of pi/4 t in units of 2^-32, for an odd count t of 2^-30.
#[inline(always)]
pub(in crate::arithmetic) const fn cos_sin(t: u32) -> (u32, u32) {
    // A part is 2^23 units of 2^-30.
    let part = (t + (1 << 22)) >> 23;
    let d_q30 = t.wrapping_sub(part << 23).cast_signed();
    // m is 1, less an LSB, and 2^46 / 2^31 its reciprocal.
    rotate_to_part(0x7fff_ffff, 1 << RECIPROCAL_BITS, part, d_q30 << 8)
}

/// Cosine and sine of pi/4 t_j in units of 2^-32, j > 0.
const fn direction(part: u32) -> [u32; 2] {
    let part = (part & 127) as usize;
    let (tan, sin) = (TANGENTS[part], SINES[part]);
    // cos = 1 - sin tan
    [(product(tan, sin).wrapping_neg() >> 32) as u32, sin]
}

/// The fraction t of an octant, in units of 2^-62, of the direction (a, b), 0 <= b <= a, a > 0: the
/// inverse of the rotation, by the same table and the arc tangent of what is left.
pub(in crate::arithmetic) fn fraction(a: u32, b: u32) -> u64 {
    // The last part whose t_j is not above the direction's.
    let mut part = 0;
    let mut step = PARTS as u32 / 2;
    while step > 0 {
        let [cos, sin] = direction(part + step);
        if product(b, cos) >= product(a, sin) {
            part += step;
        }
        step /= 2;
    }
    let [cos, sin] = if part == 0 { [u32::MAX, 0] } else { direction(part) };
    let [a, b, cos, sin] = [a, b, cos, sin].map(i128::from);
    // At most 1/160, units of 2^-62: the arc tangent is x - x^3/3, for x^5/5 is below 2^-38.
    let tan = ((b * cos - a * sin) << 62) / (a * cos + b * sin).max(1);
    let cube = (((tan * tan) >> 62) * tan) >> 62;
    let rest = ((tan - cube / 3) * FOUR_OVER_PI) >> 62;
    let t = rest + ((part as i128) << 62) / PARTS as i128;
    u64::try_from(t.clamp(0, 1 << 62)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arithmetic::fixed::derived::{FIXED_TABLES, assert_derived};
    use crate::bits::hash::mix;

    #[test]
    fn tables_are_those_of_the_script() {
        assert_derived(FIXED_TABLES, "QUARTER_PI", &[QUARTER_PI]);
        assert_derived(FIXED_TABLES, "FOUR_OVER_PI", &[FOUR_OVER_PI as u64]);
        assert_derived(FIXED_TABLES, "ARC", &[ARC]);
        assert_derived(FIXED_TABLES, "NEAREST_PART", &[NEAREST_PART]);
        assert_derived(FIXED_TABLES, "INWARD", &[INWARD]);
        assert_derived(FIXED_TABLES, "TANGENTS", &TANGENTS);
        assert_derived(FIXED_TABLES, "SINES", &SINES);
        assert_derived(FIXED_TABLES, "RECIPROCALS", &RECIPROCALS);
    }

    /// The reciprocal depends on the upper 20 bits alone: for the least and the largest `m` of
    /// each, it is not too large and not too small, and the product that chooses the part stays in
    /// its word.
    #[test]
    fn every_reciprocal_is_below_and_near() {
        for upper in 1_u32 << 17..1 << 20 {
            let (least, largest) = (upper << 11, upper << 11 | 0x7ff);
            let found = reciprocal(least).unwrap();
            assert_eq!(reciprocal(largest), Some(found));
            // Relative errors: of 1/3900 the part chosen is 1/30 of its width from the nearest one.
            let error = |m: u32| 1.0 - f64::from(found) * f64::from(m) / 2_f64.powi(46);
            assert!(error(least) >= 0.0 && error(least) < 1.0 / 3900.0, "{least:#x}: {found}");
            // Times 2^-17.7 m that of a sagitta in LSBs.
            assert!(error(least) * f64::from(least) < 180_000.0, "{least:#x}: {found}");
            assert!(error(largest) > -2_f64.powi(-17), "{largest:#x}: {found}");
            assert!(u64::from(largest >> 15) * u64::from(found) < 1 << 31, "{largest:#x}");
        }
    }

    /// Between two parts, where the quotient decides, the small rotation is largest: with every
    /// reciprocal, its words are wide enough (a test without its assertions of overflow asserts
    /// less).
    #[test]
    fn no_word_is_too_short() {
        for k in 32_u32..256 {
            for m in [k << 23, k << 23 | 0x7f_ffff, k << 23 | mix(k) >> 9] {
                for i in 0..128 * 8 {
                    let (part, near) = (i / 8, i % 8);
                    let n = ((u64::from(m) * (256 * (2 * part + 1) + 5 * near - 5)) >> 16) as u32;
                    let (x, y) = rotate(m, n);
                    let [a, b, x, y] = [m, n, x, y].map(f64::from);
                    let angle = core::f64::consts::FRAC_PI_4 * (b / a);
                    let error = (x / 2.0 - a * angle.cos()).hypot(y / 2.0 - a * angle.sin());
                    assert!(error < 4.0, "{m:#x} {n:#x}: {error}");
                }
            }
        }
    }

    /// Both sides of every edge between two parts, and where y is least: no length leaves its word.
    #[test]
    fn lengths_are_near_at_every_edge() {
        let mut worst = [0.0_f64; 4];
        for m in [
            0x7fff_ffff,
            0x7fff_fffe,
            0x7800_0000,
            0x5a82_7999,
            0x4000_0000,
            0x3fff_ffff,
            0x1000_0001,
            0x0800_0000,
            0x07ff_ffff,
            0x80,
            1,
            0,
        ] {
            for part in 0..=128_u64 {
                let edge = (u64::from(m) * part) >> 7;
                for n in edge.saturating_sub(9)..edge + 9 {
                    if n > u64::from(m) {
                        continue;
                    }
                    let (x, y) = rotate(m, n as u32);
                    let [a, b] = [f64::from(m) + 0.5, n as f64 + 0.5];
                    let angle = core::f64::consts::FRAC_PI_4 * (b / a);
                    let (dx, dy) = (
                        f64::from(x) / 2.0 - a * angle.cos(),
                        f64::from(y) / 2.0 - a * angle.sin(),
                    );
                    worst =
                        [worst[0].min(dx), worst[1].max(dx), worst[2].min(dy), worst[3].max(dy)];
                }
            }
        }
        // LSBs; half of it is the inward scale.
        assert!(worst.iter().all(|error| error.abs() < 4.5), "{worst:?}");
    }

    /// At the rim no length exceeds that of the coordinates, not even before it is cut to LSBs.
    #[test]
    fn lengths_are_not_above_the_rim() {
        let mut worst = f64::MIN;
        for i in 0..2_000_000_u32 {
            let m = 0x7fff_ffff - (mix(!i) >> (8 + i % 24));
            let n = high(mix(i), m);
            let (x, y) = rotate(m, n);
            worst = worst.max(f64::from(x).hypot(f64::from(y)) - 2.0 * f64::from(m) - 1.0);
        }
        assert!((-0.5..0.0).contains(&worst), "{worst}");
    }
}
