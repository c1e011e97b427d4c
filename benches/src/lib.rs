//! What the benches `throughput` and `one` share.
//!
//! | module | what it has |
//! | --- | --- |
//! | [`arguments`] | the command line, and how a run ends |
//! | [`failure`] | the error of a run |
//! | [`rounds`] | contenders in turn, and the shortest time of each |
//! | [`builds`] | the baseline build and the one for the machine's own vectors |
//! | [`record`] | what was measured, in a file under `target` |
//! | [`table`] | figures as Markdown |
//! | [`functions`] | std's functions, on which the textbooks' formulas run |
//! | [`random`] | random words |

pub mod arguments;
pub mod builds;
pub mod failure;
pub mod functions;
pub mod random;
pub mod record;
pub mod rounds;
pub mod table;

/// The exponent of the power lobe: a highlight of some 10 degrees.
pub const EXPONENT: f32 = 50.0;
