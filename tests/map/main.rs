//! The maps, in every arithmetic.
//!
//! | module | proves |
//! | --- | --- |
//! | `inputs` | the promises, over the whole domain of inputs |
//! | `accuracy` | errors are within the contracts, and no bound of a contract is stale |
//! | `statistics` | every map distributes points as it says |
//! | `distributions` | with `rand` in scope `sample` is the map's |
#![cfg(feature = "libm")]

mod accuracy;
#[cfg(feature = "rand")]
mod distributions;
mod inputs;
mod statistics;
