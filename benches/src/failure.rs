//! The error of a run.

use std::error::Error;
use std::path::Path;

/// Any error.
pub type Failure = Box<dyn Error>;

/// An error with the file that it is of.
pub fn failed(path: &Path, error: &dyn Error) -> Failure {
    format!("{}: {error}", path.display()).into()
}
