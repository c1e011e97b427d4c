//! Accuracy: every map and arithmetic against its contract (`testkit::contract`).
#![cfg(feature = "libm")]

mod contracts;
mod hard_cases;
