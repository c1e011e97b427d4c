//! What talks to the machine: boot, output, the count of instructions, the depth of the stack.
//!
//! QEMU under `-icount shift=5` lets each instruction take 32 ns of the board's time. The Arm
//! boards read it from SysTick, of 62.5 ns a tick (`microbit`, 16 MHz) or 40 ns (`mps2`, 25 MHz);
//! RISC-V counts instructions itself.
#![no_std]

mod stack;

use semihosting::io::{self, Write};
pub use semihosting::{print, println, process::exit};
pub use stack::{PAINTED, depth};

#[cfg(target_arch = "arm")]
mod cortex_m_board;
#[cfg(target_arch = "arm")]
use cortex_m_board as board;
#[cfg(target_arch = "riscv32")]
mod riscv_board;
#[cfg(target_arch = "riscv32")]
use riscv_board as board;

pub use board::{entry, known_loop, start_counter};

/// Prints bytes, without what formatting brings.
pub fn write(bytes: &[u8]) {
    // A board that nobody listens to goes on.
    let _ = io::stdout().and_then(|mut host| host.write_all(bytes));
}

/// Ends a program that checks: well, or after it has said what is wrong.
pub fn end(result: Result<(), impl core::fmt::Display>) -> ! {
    if let Err(error) = result {
        println!("error: {error}");
        exit(1)
    }
    exit(0)
}

/// Instructions that `f` executes, and its call.
#[inline(never)]
pub fn instructions(mut f: impl FnMut()) -> u32 {
    let start = board::counter();
    f();
    board::instructions_since(start)
}

#[panic_handler]
fn panic(info: &core::panic::PanicInfo) -> ! {
    println!("{info}");
    exit(101)
}
