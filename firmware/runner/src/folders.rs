//! Folders of the repository.

use std::path::{Path, PathBuf};

/// The crate's own folder.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
