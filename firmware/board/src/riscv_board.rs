//! RV32: `minstret` counts instructions.

pub use riscv_rt::entry;

use core::arch::asm;
use riscv::register::minstret;

/// Starts the counter; it runs from reset.
pub fn start_counter() {}

#[inline(always)]
pub(crate) fn counter() -> u32 {
    minstret::read() as u32
}

#[inline(always)]
pub(crate) fn instructions_since(start: u32) -> u32 {
    (minstret::read() as u32).wrapping_sub(start)
}

/// A loop of two instructions `rounds` times.
#[inline(always)]
pub fn known_loop(rounds: u32) {
    // SAFETY: it changes a register of its own.
    unsafe {
        asm!("2: addi {0}, {0}, -1", "bnez {0}, 2b", inout(reg) rounds => _, options(nomem, nostack))
    };
}

/// Writes a word over so many bytes below the stack pointer, and says where that points.
///
/// # Safety
/// They are in RAM, and nothing else is there.
#[inline(always)]
pub(crate) unsafe fn paint(word: u32, bytes: usize) -> usize {
    let top;
    // SAFETY: the caller's contract. It is one asm block, so that the pointer is the end of this
    // function's frame.
    unsafe {
        asm!(
            "mv {top}, sp", "mv {at}, {top}",
            "2: addi {at}, {at}, -4", "sw {word}, 0({at})", "addi {left}, {left}, -4", "bnez {left}, 2b",
            top = out(reg) top, at = out(reg) _, word = in(reg) word, left = inout(reg) bytes => _,
            options(nostack)
        );
    }
    top
}
