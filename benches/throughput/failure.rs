//! The error of a run.

use std::error::Error;
use std::path::Path;

pub(crate) type Failure = Box<dyn Error>;

/// An error with the file that it is of.
pub(crate) fn failed(path: &Path, error: &dyn Error) -> Failure {
    format!("{}: {error}", path.display()).into()
}
