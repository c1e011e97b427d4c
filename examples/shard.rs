//! Which range a shard computes: the example `shard` and its tests share it.

pub mod cover;
