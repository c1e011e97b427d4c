//! What a bench measured, in `target/BENCH/NAME`: what a run leaves for those who read it, and for
//! the next run to merge with.

use crate::failure::{Failure, failed};
use serde::{Serialize, de::DeserializeOwned};
use std::fs;
use std::io::ErrorKind;
use std::path::PathBuf;

/// The record of earlier runs; empty if there is none.
pub fn read<T: Default + DeserializeOwned>(bench: &str, name: &str) -> Result<T, Failure> {
    let path = path(bench, name);
    match fs::read(&path) {
        Ok(bytes) => serde_json::from_slice(&bytes).map_err(|error| failed(&path, &error)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(T::default()),
        Err(error) => Err(failed(&path, &error)),
    }
}

/// Writes it anew.
pub fn write(bench: &str, name: &str, record: &impl Serialize) -> Result<(), Failure> {
    let path = path(bench, name);
    let text = serde_json::to_string_pretty(record)? + "\n";
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    folder.and_then(|()| fs::write(&path, text)).map_err(|error| failed(&path, &error))
}

/// The same for every build, which may have target folders of their own.
fn path(bench: &str, name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "..", "target", bench, name].iter().collect()
}
