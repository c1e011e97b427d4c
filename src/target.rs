//! The target's processor: every `cfg` of one, its reason and its measurement.
//!
//! The bits are the same whichever form a constant chooses. Tests compile both forms of each kernel
//! and compare them. docs/firmware.md has the instructions counted on each core.

#[cfg(target_pointer_width = "16")]
compile_error!("hemidisc counts points in u32 and needs a usize of at least 32 bits");

/// Whether a buffer is filled by blocks of 64 and of 16 points rather than point by point.
///
/// Blocks become vector code. On x86-64 they were faster for every sequence and map tried; on a
/// microcontroller the arrays of a block cost more than they save.
pub(crate) const BLOCKED: bool = cfg!(not(any(target_arch = "arm", target_arch = "riscv32")));

/// Whether an operation of floats rounds to their type. On x86 before SSE2 the compiler computes in
/// x87's registers of 80 bits and rounds where it happens to store: points would differ from those
/// of other machines, and a fill from a single point of the same program.
pub(crate) const ROUNDS_FLOATS: bool =
    cfg!(not(all(target_arch = "x86", not(target_feature = "sse2"))));

/// Items that are left out where floats do not round: what no generic function can refuse.
macro_rules! where_floats_round {
    ($($item:item)*) => {$(
        #[cfg(not(all(target_arch = "x86", not(target_feature = "sse2"))))]
        $item
    )*};
}
pub(crate) use where_floats_round;

/// How the kernels of fast f32 are written. The bits are the same.
pub(crate) mod form {
    /// For a lane of a block, which becomes vector code: no branch, and only what vectors have.
    pub(crate) const LANE: u8 = 0;
    /// For a point alone on a processor of 64-bit words: no branch either, for half of them would be
    /// mispredicted.
    pub(crate) const WORDS: u8 = 1;
    /// For a small core. It has no vectors, and a branch costs it less than the swap or test that it
    /// avoids. With branches the kernels take a third fewer instructions on the M3 and M4F.
    pub(crate) const BRANCHES: u8 = 2;
    /// For a point alone, here.
    pub(crate) const ONE: u8 = if !super::BLOCKED {
        BRANCHES
    } else if super::WIDE_WORDS {
        WORDS
    } else {
        LANE
    };
}

/// Whether a conversion from an integer waits for whoever wrote its register last: x86-64 before AVX,
/// whose instruction keeps the register's upper part. In a function of its own that is the call
/// before, for there the compiler does not clear the register. The calls then hardly overlap.
pub(crate) const CONVERSIONS_WAIT: bool =
    cfg!(all(target_arch = "x86_64", not(target_feature = "avx")));

/// Whether floats have instructions. Where stable Rust does not show that they have, as on RV32F,
/// square roots by integers have the same bits.
pub(crate) const HAS_FPU: bool =
    cfg!(not(any(all(target_arch = "arm", not(target_abi = "eabihf")), target_arch = "riscv32")));

/// Whether the processor lacks the product of 32 x 32 bits to 64: Armv6-M and the baseline of
/// Armv8-M (Cortex-M0 and M23).
///
/// Such a core calls a routine of 64 x 64 bits for the product of two `u32`. Four products of
/// halves are a third of its cost. It also lacks instructions that count zeros or reverse bits.
///
/// Stable Rust shows neither `thumb2` nor another sign of the difference between a Cortex-M23 and
/// an M3. Where unstable features are visible (a nightly, or `core` built from source) the M23 is
/// recognised; elsewhere `RUSTFLAGS="--cfg hemidisc_short_products"` says so. An M23 that takes the
/// M3's forms needs up to twice the instructions: 259 for a concentric disc in Q31 where the M0's
/// form takes 158, and 6738 for a power lobe where it takes 4996.
pub(crate) const HALVES: bool = cfg!(all(
    target_arch = "arm",
    any(
        not(target_has_atomic = "32"),
        all(target_feature = "mclass", not(target_feature = "thumb2")),
        hemidisc_short_products,
    )
));

/// Whether the processor counts leading zeros in one instruction.
#[cfg(feature = "fixed-point")]
pub(crate) const COUNTS_ZEROS: bool =
    !HALVES && !cfg!(all(target_arch = "riscv32", not(target_feature = "zbb")));

/// Whether the processor reverses bits in one instruction or in vectors.
///
/// Where it does not, reversing takes some 20 instructions, and counting on with a carry from the
/// highest bit down passes two bits on average.
pub(crate) const REVERSES_BITS: bool = !HALVES && !cfg!(target_arch = "riscv32");

/// Whether vectors multiply halves of words but not words: x86 before SSE4.1.
///
/// It takes a product of words apart into two products of every other word and shuffles them
/// together again. A fill of Owen-scrambled points takes 2.79 ns a point in halves and 3.60 in
/// words there. With AVX-512 halves are 9 % slower than words.
pub(crate) const VECTORS_OF_HALVES: bool =
    cfg!(all(any(target_arch = "x86", target_arch = "x86_64"), not(target_feature = "sse4.1")));

/// Whether the processor's words have 64 bits. It then multiplies them to 128, and it predicts
/// branches far ahead, so a choice that it would mispredict every other time is a look-up instead.
pub(crate) const WIDE_WORDS: bool = cfg!(target_pointer_width = "64");
