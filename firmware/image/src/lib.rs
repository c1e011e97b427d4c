//! A static library of every fill: linked with the path of one as its entry, an image of it alone.
#![no_std]

use kernels as _;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

/// The image to compare with: nothing.
#[unsafe(export_name = "nothing")]
extern "C" fn nothing() {}

/// What a check for panics must find: an index without a check of the caller's.
#[unsafe(export_name = "fault/panic")]
fn unchecked(table: &[u32], index: usize) -> u32 {
    table[index]
}

/// What a check for software floats must find.
#[unsafe(export_name = "fault/float")]
fn float(a: f32, b: f32) -> f32 {
    a + b
}
