//! The README's table of contracts is the one in the code.
//!
//! To write it anew: `HEMIDISC_BLESS=1 cargo test --all-features --test readme`.

use std::fmt::Write;
use std::path::Path;
use testkit::contract::CONTRACTS;

/// The bounds as Markdown.
fn table() -> String {
    let mut text = String::from(
        "| arithmetic | map | position | norm | theta | z | density | round trip |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
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
        let theta = if row.theta == 0.0 { "-".to_string() } else { format!("{}", row.theta) };
        writeln!(
            text,
            "| `{}`, {unit} | {} | {} | {} | {theta} | {z} | {density} | {} |",
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
