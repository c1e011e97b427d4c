//! What the gallery draws with. The bench `accuracy` draws its plot with the same.

pub mod canvas;
pub mod curve;
