//! Proves what each sequence promises, exactly and on integers. Chi-square tests of 10^4 to 10^6
//! draws do not distinguish the random ones from uniform noise.
//!
//! | file | proves |
//! | --- | --- |
//! | `strata` | every set hits its grid and its columns and rows once, for every size from 1 to 300 |
//! | `nets` | every elementary interval of aligned blocks is hit once; base 3 too |
//! | `permutation` | `permute` is a bijection for every length, and reaches every permutation |
//! | `domains` | streams of sibling domains are independent; a shuffle keeps its set |
//! | `noise` | random points are uniform and uncorrelated; R2 has the full period, low discrepancy |
//! | `access` | both `at`, `iter` and `block` agree; sets repeat |
//! | `errors` | every constructor says what was wrong and what is accepted |
//!
//! Stratum c of n holds the cells k with floor(k n / 2^32) = c.

mod access;
mod domains;
mod errors;
mod nets;
mod noise;
mod permutation;
mod strata;
