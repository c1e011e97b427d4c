//! The builds that are compared: `baseline` for the architecture's guaranteed vectors, `native` for
//! more.

/// Their names, in the order of their figures.
pub const BUILDS: [&str; 2] = ["baseline", "native"];

/// The name of this build.
pub const THIS: &str = if NATIVE { BUILDS[1] } else { BUILDS[0] };

const NATIVE: bool = cfg!(any(target_feature = "avx2", target_feature = "sve"));

/// The widest vectors that this build may use.
pub const VECTORS: &str = if cfg!(target_feature = "avx512f") {
    "avx512f"
} else if cfg!(target_feature = "avx2") {
    "avx2"
} else if cfg!(target_feature = "sse2") {
    "sse2"
} else if cfg!(target_feature = "sve") {
    "sve"
} else if cfg!(target_feature = "neon") {
    "neon"
} else {
    "none"
};

/// The place of a build among them, by its name.
pub fn place(name: &str) -> Option<usize> {
    BUILDS.iter().position(|build| *build == name)
}

/// Of a figure for each of [`BUILDS`], that of one.
pub fn figure(figures: [f64; 2], name: &str) -> Option<f64> {
    figures.get(place(name)?).copied()
}
