//! Every map distributes points as it says: in equally likely cells, by its density, and by its
//! moments, with random points as evenly as chance and with Owen-scrambled Sobol points far more
//! so.
//!
//! | file | proves |
//! | --- | --- |
//! | `cells` | as many points in each of 16 x 16 equally likely cells as chance puts there |
//! | `density` | densities integrate to 1, are 0 outside, and are those of the samples |
//! | `rejection` | survivors are uniform, and pi / 4 of the candidates |
//! | `cases` | the list: every map and lobe over either disc map, in each arithmetic |
//!
//! Cells and integrals are worked in f64 from the formulas, not from the crate's code.

mod cases;
mod cells;
mod density;
mod rejection;
