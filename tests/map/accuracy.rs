//! Accuracy: every map and arithmetic against its contract (`testkit::contract`).

mod contracts;
mod hard_cases;
