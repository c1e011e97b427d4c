//! The README's table of contracts is the one in the code, and its features name the versions of
//! the manifest.
//!
//! To write it anew: `HEMIDISC_BLESS=1 cargo test --all-features --test readme`.

use std::fmt::Write;
use std::path::Path;
use testkit::contract::CONTRACTS;

/// The bounds as Markdown.
fn table() -> String {
    let mut text = String::from(
        "| arithmetic | map | position | norm | theta | z | density | of a sample | round trip |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for row in CONTRACTS {
        let name = if row.relative { "eps" } else { "LSB" };
        let unit = format!("{name} = 2^{}", row.unit.log2());
        let sum = |[first, slope]: [f64; 2], of: &str| match (first, slope) {
            (0.0, _) => "-".to_string(),
            (_, 0.0) => format!("{first}"),
            _ => format!("{first} + {slope} {of}"),
        };
        let (z, density) = (sum(row.z, "abs(ln z)"), sum(row.density, "sqrt e"));
        let sampled = sum(row.sampled, if row.relative { "abs(ln z)" } else { "sqrt e" });
        let theta = if row.theta == 0.0 { "-".to_string() } else { format!("{}", row.theta) };
        writeln!(
            text,
            "| `{}`, {unit} | {} | {} | {} | {theta} | {z} | {density} | {sampled} | {} |",
            row.arithmetic, row.map, row.position, row.norm, row.round_trip
        )
        .unwrap();
    }
    text
}

#[test]
fn the_contracts_are_as_printed() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let readme = std::fs::read_to_string(&path).unwrap();
    let (before, rest) = readme.split_once("<!-- contracts:").unwrap();
    let (marker, rest) = rest.split_once("-->\n").unwrap();
    let (printed, after) = rest.split_once("<!-- end -->").unwrap();
    let expected = table();
    if std::env::var_os("HEMIDISC_BLESS").is_some() {
        let text = format!("{before}<!-- contracts:{marker}-->\n{expected}<!-- end -->{after}");
        std::fs::write(&path, text).unwrap();
    } else {
        assert_eq!(printed, expected);
    }
}

/// The table of features says which version of a crate a feature is for, as far as it decides
/// whether two are compatible.
#[test]
fn features_name_their_versions() {
    let read = |name| std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(name));
    let (manifest, readme) = (read("Cargo.toml").unwrap(), read("README.md").unwrap());
    let (_, dependencies) = manifest.split_once("\n[dependencies]\n").unwrap();
    let (dependencies, _) = dependencies.split_once("\n\n").unwrap();
    for line in dependencies.lines() {
        let (name, rest) = line.split_once(" = ").unwrap();
        let version = rest.split('"').nth(1).unwrap();
        let mut parts = version.split('.');
        let (major, minor) = (parts.next().unwrap(), parts.next().unwrap());
        let row = readme.lines().find(|row| row.starts_with(&format!("| `{name}` |"))).unwrap();
        let named = [format!("`{name}` {major} |"), format!("`{name}` {major}.{minor} |")];
        let compatible = &named[usize::from(major == "0")..];
        assert!(compatible.iter().any(|named| row.contains(named)), "{line}: {row}");
    }
}
