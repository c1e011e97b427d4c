//! The repository's structure: no `#[path]` leads out of its tree, and no files import each other
//! in a circle.
//!
//! A file is read after those that it imports, so a circle has no first file. Both checks are shown
//! to fail, on trees in memory.

mod imports;
mod tokens;

use imports::{Files, circles, imports};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use tokens::{Token, tokens};

/// The root files of the crates without a circle.
const ROOTS: &[&str] = &[
    "benches/src/lib.rs",
    "benches/accuracy/main.rs",
    "benches/one/main.rs",
    "benches/throughput/main.rs",
    "firmware/runner/src/main.rs",
];

/// The `.rs` files of the repository.
fn repository() -> Files {
    fn gather(folder: &Path, name: &str, files: &mut Files) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let own = path.file_name().unwrap().to_string_lossy().into_owned();
            let inner = if name.is_empty() { own.clone() } else { format!("{name}/{own}") };
            if path.is_dir() && own != "target" && !own.starts_with('.') {
                gather(&path, &inner, files);
            } else if own.ends_with(".rs") {
                files.insert(inner, fs::read_to_string(&path).unwrap());
            }
        }
    }
    let mut files = Files::new();
    gather(Path::new(env!("CARGO_MANIFEST_DIR")), "", &mut files);
    files
}

/// The tree that a file belongs to: its top folder, and of the firmware the folder within that.
fn tree(file: &str) -> &str {
    let levels = if file.starts_with("firmware/") { 2 } else { 1 };
    file.match_indices('/').nth(levels - 1).map_or(file, |(at, _)| &file[..at])
}

/// Every `#[path]` that leads out of its file's tree, with the file that it names.
fn outward(files: &Files) -> Vec<String> {
    let mut found = Vec::new();
    for (file, source) in files {
        let tokens = tokens(source);
        for window in tokens.windows(5) {
            let [hash, bracket, path, equals, Token::Text(to)] = window else { continue };
            if !(hash.is("#") && bracket.is("[") && path.is("path") && equals.is("=")) {
                continue;
            }
            let mut parts: Vec<&str> = file.split('/').collect();
            parts.pop();
            for part in to.split('/') {
                match part {
                    ".." if parts.pop().is_none() => parts.push(".."),
                    ".." | "." => {}
                    _ => parts.push(part),
                }
            }
            let to = parts.join("/");
            if tree(&to) != tree(file) {
                found.push(format!("{file}: {to}"));
            }
        }
    }
    found
}

#[test]
fn no_path_leads_out_of_its_tree() {
    assert_eq!(outward(&repository()), Vec::<String>::new());
}

#[test]
fn files_are_not_in_circles() {
    let files = repository();
    for root in ROOTS {
        let imports = imports(&files, root);
        assert!(imports.len() > 5, "{root}: {imports:?}");
        assert_eq!(circles(&imports), BTreeSet::new(), "{root}");
    }
    let own = imports(&files, "src/lib.rs");
    let read: BTreeSet<_> = own.keys().cloned().collect();
    let compiled = |file: &&String| file.starts_with("src/") && !file.ends_with("/tests.rs");
    let expected: BTreeSet<_> = files.keys().filter(compiled).cloned().collect();
    assert_eq!(read, expected, "the modules of src are not its files");
    assert_eq!(circles(&own), BTreeSet::new());
}

/// A tree in memory, of files and their sources.
fn small(files: &[(&str, &str)]) -> Files {
    files.iter().map(|(file, source)| ((*file).to_owned(), (*source).to_owned())).collect()
}

fn circles_of(files: &[(&str, &str)]) -> BTreeSet<BTreeSet<String>> {
    circles(&imports(&small(files), "src/lib.rs"))
}

#[track_caller]
fn assert_circle(files: &[(&str, &str)], expected: &[&str]) {
    let expected = expected.iter().map(|file| (*file).to_owned()).collect();
    assert_eq!(circles_of(files), BTreeSet::from([expected]));
}

#[test]
fn a_circle_is_found() {
    let lib = ("src/lib.rs", "mod a; mod b; mod c;");
    let b = ("src/b.rs", "pub struct B; fn f() { crate::c::g(); }");
    let c = ("src/c.rs", "pub fn g() {} #[cfg(test)] mod tests { use crate::a::A; }");
    assert_eq!(circles_of(&[lib, ("src/a.rs", "use crate::b::B; pub struct A;"), b, c]), [].into());
    let c = ("src/c.rs", "use super::{a::{self, A as Other}}; pub fn g() {}");
    let a = ("src/a.rs", "/* */ use crate::b::{B}; pub struct A;");
    assert_circle(&[lib, a, b, c], &["src/a.rs", "src/b.rs", "src/c.rs"]);
}

#[test]
fn a_parent_and_its_child_are_a_circle_unless_it_only_re_exports() {
    let child = ("src/a/b.rs", "use super::A; pub struct B;");
    let lib = ("src/lib.rs", "mod a;");
    assert_eq!(
        circles_of(&[lib, child, ("src/a.rs", "mod b; pub use b::B; pub struct A;")]),
        [].into()
    );
    let a = ("src/a.rs", "mod b; use b::B; pub struct A;");
    assert_circle(&[lib, child, a], &["src/a.rs", "src/a/b.rs"]);
}

#[test]
fn a_re_export_is_followed_to_the_file_that_defines() {
    let lib = ("src/lib.rs", "mod a; mod c; pub use a::B;");
    let a = ("src/a.rs", "mod b; pub use b::B;");
    let b = ("src/a/b.rs", "use crate::c::C; pub struct B;");
    let c = ("src/c.rs", "use crate::B; pub struct C;");
    assert_circle(&[lib, a, b, c], &["src/a/b.rs", "src/c.rs"]);
}

#[test]
fn an_outward_path_is_found() {
    let inward = ("tests/a/main.rs", "#[path = \"../b.rs\"] mod b;");
    let firmware = ("firmware/x/src/lib.rs", "#[path = \"../../y/src/lib.rs\"] mod y;");
    let above = ("fuzz/lib.rs", "#[path = \"../../b.rs\"] mod b;");
    let said = ("src/lib.rs", "// #[path = \"../tests/b.rs\"] mod b;");
    assert_eq!(outward(&small(&[inward, said])), <[String; 0]>::default());
    let found = outward(&small(&[inward, said, firmware, above]));
    assert_eq!(found, ["firmware/x/src/lib.rs: firmware/y/src/lib.rs", "fuzz/lib.rs: ../b.rs"]);
}
