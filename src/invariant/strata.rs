//! Strata: that every cell of a grid holds exactly one point of a set.

use super::Violation;
use crate::sequence::Sequence;

/// That each of `columns` x `rows` cells holds exactly one of the points `start` .. `start` +
/// columns x rows.
///
/// `marks` is memory for one bit a cell: columns x rows / 32 words, rounded up.
///
/// # Errors
/// [`Violation::Stratum`] with the first point that falls into an occupied cell;
/// [`Violation::NoRoom`] if `marks` is too short.
///
/// ```
/// use hemidisc::{invariant, sequence::Jittered};
/// invariant::cells(&Jittered::new(5, 7, 1)?, 0, [5, 7], &mut [0; 2])?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn cells<S: Sequence>(
    sequence: &S,
    start: u32,
    [columns, rows]: [u32; 2],
    marks: &mut [u32],
) -> Result<(), Violation> {
    let count = u64::from(columns) * u64::from(rows);
    let needed = count.div_ceil(32);
    let marks = usize::try_from(needed).ok().and_then(|needed| marks.get_mut(..needed));
    let Some(marks) = marks else {
        return Err(Violation::NoRoom { needed });
    };
    marks.fill(0);
    for (offset, [u, v]) in (0..count).zip(sequence.iter(start)) {
        let cell = stratum(u, columns) + stratum(v, rows) * u64::from(columns);
        let (word, bit) = ((cell / 32) as usize, 1 << (cell % 32));
        // There are as many points as cells: without a collision every cell holds one.
        match marks.get_mut(word) {
            Some(word) if *word & bit == 0 => *word |= bit,
            _ => {
                let index = start.wrapping_add(offset as u32);
                return Err(Violation::Stratum { grid: [columns, rows], index });
            }
        }
    }
    Ok(())
}

/// That each of `count` columns and each of `count` rows holds exactly one of the points
/// `start` .. `start` + `count`.
///
/// # Errors
/// As [`cells`], whose memory it needs for `count` cells.
pub fn rooks<S: Sequence>(
    sequence: &S,
    start: u32,
    count: u32,
    marks: &mut [u32],
) -> Result<(), Violation> {
    cells(sequence, start, [count, 1], marks)?;
    cells(sequence, start, [1, count], marks)
}

/// That the 2^m points from `start` on are a (0, m, 2)-net: each elementary interval of area 2^-m,
/// of every shape 2^a x 2^(m - a), holds exactly one.
///
/// # Errors
/// As [`cells`], whose memory it needs for 2^m cells, m <= 31.
pub fn net<S: Sequence>(
    sequence: &S,
    start: u32,
    m: u32,
    marks: &mut [u32],
) -> Result<(), Violation> {
    if m > 31 {
        return Err(Violation::NoRoom { needed: 1_u64.checked_shl(m - 5).unwrap_or(u64::MAX) });
    }
    for a in 0..=m {
        cells(sequence, start, [1 << a, 1 << (m - a)], marks)?;
    }
    Ok(())
}

/// The stratum of a cell: floor(k count / 2^32).
fn stratum(k: u32, count: u32) -> u64 {
    (u64::from(k) * u64::from(count)) >> 32
}
