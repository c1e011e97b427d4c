//! Why `render` or `shard` has no result, and how it says so.

use std::io;

/// Why there is no result.
#[derive(Debug)]
pub enum Failure {
    /// Names the argument, the field or the part, what was wrong and what is accepted.
    Usage(String),
    /// Names the file that cannot be written.
    Output(String, io::Error),
    /// Names the shard.
    Shard(String),
}

impl Failure {
    /// The exit status and one line.
    pub fn told(self) -> (u8, String) {
        match self {
            Self::Usage(message) => (2, message),
            Self::Output(path, error) => (1, format!("cannot write {path}: {error}")),
            Self::Shard(message) => (1, message),
        }
    }
}
