//! Proves what each sequence promises, exactly and on integers, and that what is called random
//! cannot be told from uniform noise by chi-square tests of 10^4 to 10^6 draws.
//!
//! | file | proves |
//! | --- | --- |
//! | `strata` | every set hits its grid and its columns and rows once, for every size from 1 to 300 |
//! | `nets` | every elementary interval of aligned blocks is hit once; base 3 too |
//! | `noise` | random points are uniform and uncorrelated; R2 has the full period, low discrepancy |
//! | `vectors` | Sobol, Halton, Hammersley, R2 and Owen's scramble are those of other sources |
//! | `access` | `at`, `point`, `iter` and `block` agree; sets repeat |
//! | `errors` | every constructor says what was wrong and what is accepted |
//!
//! Stratum c of n holds the cells k with floor(k n / 2^32) = c.

mod access;
mod errors;
mod nets;
mod noise;
mod strata;
mod vectors;
