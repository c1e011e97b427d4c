//! The depth of the stack: the memory below it is painted, and the lowest overwritten byte found
//! afterwards.

use crate::board::paint;
use core::ptr::read_volatile;

/// Bytes that are painted; a call that goes deeper is reported as this deep.
pub const PAINTED: usize = 4096;
const PAINT: u32 = 0xdead_10cc;

/// The deepest byte below this function's own frame that `f` wrote.
#[inline(never)]
pub fn depth(mut f: impl FnMut()) -> usize {
    // SAFETY: the board's RAM goes down as far as this below the stack of the programs, and nothing
    // is kept there.
    let top = unsafe { paint(PAINT, PAINTED) };
    f();
    let mut address = top - PAINTED;
    // SAFETY: as above.
    while address < top && unsafe { read_volatile(address as *const u32) } == PAINT {
        address += 4;
    }
    top - address
}
