//! The bits that sequences are made of: a permutation of any length, and Owen's scramble.

mod owen;
mod permute;
