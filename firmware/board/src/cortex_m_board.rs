//! Cortex-M: SysTick counts down 24 bits.

pub use cortex_m_rt::entry;

use core::arch::asm;
use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};

const RELOAD: u32 = 0x00ff_ffff;

/// A tick in quarters of a nanosecond: SysTick of `microbit` and of `mps2`.
const TICK: u64 = if cfg!(target_has_atomic = "32") { 160 } else { 250 };
/// An instruction in quarters of a nanosecond: `-icount shift=5`.
const INSTRUCTION: u64 = 32 * 4;

/// Starts the counter; once, before anything is counted.
pub fn start_counter() {
    // SAFETY: nothing else in the programs uses a peripheral.
    let mut peripherals = unsafe { Peripherals::steal() };
    let systick = &mut peripherals.SYST;
    systick.set_clock_source(SystClkSource::Core);
    systick.set_reload(RELOAD);
    systick.clear_current();
    systick.enable_counter();
}

#[inline(always)]
pub(crate) fn counter() -> u32 {
    SYST::get_current()
}

/// To the nearest that a tick can tell, below 20 million.
#[inline(always)]
pub(crate) fn instructions_since(start: u32) -> u32 {
    let ticks = start.wrapping_sub(SYST::get_current()) & RELOAD;
    ((u64::from(ticks) * TICK + INSTRUCTION / 2) / INSTRUCTION) as u32
}

/// A loop of two instructions `rounds` times.
#[inline(always)]
pub fn known_loop(rounds: u32) {
    // SAFETY: it changes a register of its own and the flags.
    unsafe { asm!("2: subs {0}, #1", "bne 2b", inout(reg) rounds => _, options(nomem, nostack)) };
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
            "mov {top}, sp", "mov {at}, {top}",
            "2: subs {at}, #4", "str {word}, [{at}]", "subs {left}, #4", "bne 2b",
            top = out(reg) top, at = out(reg) _, word = in(reg) word, left = inout(reg) bytes => _,
            options(nostack)
        );
    }
    top
}
