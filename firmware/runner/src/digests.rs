//! The digests of a board against those of the host, in tests/golden.

use crate::cores::Core;
use crate::folders::root;
use anyhow::{Context, Result, ensure};
use std::collections::BTreeSet;
use std::fs;

/// The files that a board's digests equal.
pub struct Files {
    pub names: BTreeSet<String>,
    pub lines: usize,
}

/// Compares what a board prints with the files; an error names the first line that differs.
pub fn compare(core: &Core, printed: &str) -> Result<Files> {
    let mut files = Files { names: BTreeSet::new(), lines: 0 };
    for part in printed.split("file ").filter(|part| !part.is_empty()) {
        let (name, digests) = part.split_once('\n').context("a file's name and lines")?;
        let path = root().join(format!("tests/golden/{name}.txt"));
        let golden = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        // A first line may name a library's version.
        let golden: Vec<_> = golden.lines().filter(|line| !line.starts_with('#')).collect();
        let digests: Vec<_> = digests.lines().collect();
        for (golden, printed) in golden.iter().zip(&digests) {
            ensure!(
                golden == printed,
                "{name}: {} gives `{printed}`, the host `{golden}`",
                core.name
            );
        }
        ensure!(
            golden.len() == digests.len(),
            "{name}: {} gives {} digests of {}",
            core.name,
            digests.len(),
            golden.len()
        );
        files.lines += digests.len();
        files.names.insert(name.to_owned());
    }
    let expected = ["square", "domain", "effects", "render"]
        .into_iter()
        .chain(hemidisc::catalogue::ARITHMETICS.iter().copied());
    for name in expected {
        ensure!(files.names.contains(name), "{} gives no digests of {name}", core.name);
    }
    Ok(files)
}
