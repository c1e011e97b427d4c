//! Accuracy: every map and arithmetic against its contract (`hemidisc::arithmetic::contract`).
#![cfg(feature = "libm")]

mod contracts;
mod errors;
mod hard_cases;
