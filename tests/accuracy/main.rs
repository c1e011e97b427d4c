//! Accuracy: every map and arithmetic against its contract (`hemidisc::arithmetic::contract`).
#![cfg(feature = "libm")]

#[macro_use]
#[path = "../arithmetics/mod.rs"]
mod arithmetics;
mod contracts;
mod errors;
mod hard_cases;
mod reference;
mod vectors;
