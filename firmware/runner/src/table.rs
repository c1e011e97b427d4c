//! The report as Markdown, and its copies in docs/firmware.md and README.md.

use crate::cores::CORES;
use crate::effect_table;
use crate::report::{Record, Report};
use anyhow::{Context, Result, bail};
use hemidisc::catalogue::LOBES;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Writes `report.json`, and `report.md`, which has the tables.
pub fn write(report: &Report, folder: &Path) -> Result<()> {
    fs::create_dir_all(folder)?;
    fs::write(folder.join("report.json"), serde_json::to_string_pretty(report)? + "\n")?;
    fs::write(folder.join("report.md"), whole(report))?;
    println!("{} records in {}", report.records.len(), folder.join("report.json").display());
    Ok(())
}

/// A fill's name: what all cores have in common.
fn name(record: &Record) -> String {
    let parts = [
        &record.sequence,
        &record.map,
        &record.effect,
        &record.scene,
        &record.disc,
        &record.arithmetic,
        &record.peer,
    ];
    let known = parts.into_iter().flatten().filter(|part| *part != "-");
    let name = known.map(String::as_str).collect::<Vec<_>>().join(" ");
    if record.peer.is_some() { format!("*{name}*") } else { name }
}

/// The records of one fill on every core, in their order.
fn on_every_core<'a>(report: &'a Report, of: &Record) -> Vec<&'a Record> {
    let same = |record: &&Record| record.kind == of.kind && name(record) == name(of);
    report.records.iter().filter(same).collect()
}

fn cell<T: ToString>(value: Option<T>) -> String {
    value.map_or("-".to_owned(), |value| value.to_string())
}

/// Three digits are enough to read; the report has them all.
fn instructions(record: &Record) -> String {
    cell(record.instructions_per_point.map(|count| {
        let places = if count < 100.0 { 1 } else { 0 };
        format!("{count:.places$}")
    }))
}

/// Every fill of one kind: instructions, then flash, then stack, on every core.
fn of_kind(report: &Report, kind: &str) -> Result<String, std::fmt::Error> {
    let mut text = String::new();
    let cores: Vec<_> = CORES.iter().map(|core| core.name).collect();
    writeln!(text, "| {kind} | {} | flash, bytes | stack, bytes |", cores.join(" | "))?;
    writeln!(text, "| --- |{} --- | --- |", " ---: |".repeat(cores.len()))?;
    let first_core = report.records.iter().filter(|record| record.core == cores[0]);
    for record in first_core.filter(|record| record.kind == kind) {
        let all = on_every_core(report, record);
        let join = |cell: &dyn Fn(&Record) -> String, between| {
            all.iter().map(|record| cell(record)).collect::<Vec<_>>().join(between)
        };
        let flash = join(&|record| record.flash_bytes.to_string(), " / ");
        let stack = join(&|record| cell(record.stack_bytes), " / ");
        writeln!(
            text,
            "| {} | {} | {flash} | {stack} |",
            name(record),
            join(&instructions, " | ")
        )?;
    }
    Ok(text)
}

/// What ties the figures to a compiler.
fn compiler_line(report: &Report) -> String {
    format!("Compiled by {}, QEMU counting.\n\n", report.compiler)
}

/// All of it.
fn whole(report: &Report) -> String {
    let kinds = [
        "map",
        "turned",
        "components",
        "fused",
        "sequence",
        "effect",
        "render",
        "exponent",
        "peer",
        "loop",
    ];
    let tables = kinds.into_iter().map(|kind| of_kind(report, kind).unwrap_or_default());
    let mut text = compiler_line(report) + &tables.collect::<Vec<_>>().join("\n");
    text += "\n| lens example | flash, bytes | RAM without stack, bytes |\n| --- | ---: | ---: |\n";
    for lens in &report.lens {
        text += &format!("| {} | {} | {} |\n", lens.core, lens.flash_bytes, lens.ram_bytes);
    }
    text
}

/// The rows that a reader of the README wants first.
fn summary(report: &Report) -> String {
    let mut text = String::from("| fill |");
    for core in &CORES {
        text += &format!(" {} |", core.name);
    }
    text += " flash, M0 |\n| --- |";
    text += &" ---: |".repeat(CORES.len() + 1);
    text += "\n";
    let maps = ["disc"].iter().chain(LOBES);
    let arithmetics = ["q15", "q15-div", "q31", "q31-to-f32", "fast-f32", "libm-f32"];
    let disc = "concentric";
    let wanted = |record: &Record, map: &str| {
        record.core == CORES[0].name
            && record.map.as_deref() == Some(map)
            && (record.disc.as_deref() == Some(disc) || record.peer.is_some() && map != "disc")
            && match record.kind.as_str() {
                "map" => {
                    record.arithmetic.as_deref().is_some_and(|name| arithmetics.contains(&name))
                }
                "peer" => record.peer.as_deref().is_some_and(|peer| !peer.contains("cordic")),
                _ => false,
            }
    };
    for map in maps {
        for record in report.records.iter().filter(|record| wanted(record, map)) {
            let counts =
                on_every_core(report, record).into_iter().map(instructions).collect::<Vec<_>>();
            text += &format!(
                "| {} | {} | {} |\n",
                name(record),
                counts.join(" | "),
                record.flash_bytes
            );
        }
    }
    text
}

/// What stands between a marker and its end.
fn printed<'a>(text: &'a str, marker: &str) -> Result<[&'a str; 3]> {
    let missing = || format!("no `{marker}`");
    let (before, rest) = text.split_once(marker).with_context(missing)?;
    let (head, rest) = rest.split_once("-->\n").with_context(missing)?;
    let (printed, _) = rest.split_once("<!-- end -->").with_context(missing)?;
    let start = before.len() + marker.len() + head.len() + "-->\n".len();
    Ok([&text[..start], printed, &text[start + printed.len()..]])
}

/// Compares the committed tables with the report, where the compiler is the same; or writes them.
pub fn publish(report: &Report, root: &Path, bless: bool) -> Result<()> {
    for (file, marker, table) in [
        ("docs/firmware.md", "<!-- firmware:", whole(report)),
        ("README.md", "<!-- firmware:", compiler_line(report) + &summary(report)),
        ("README.md", "<!-- effects:", compiler_line(report) + &effect_table::table(report)?),
    ] {
        let path = root.join(file);
        let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        let [before, printed, after] = printed(&text, marker).with_context(|| file.to_owned())?;
        if bless {
            fs::write(&path, format!("{before}{table}{after}"))?;
        } else if !printed.starts_with(&compiler_line(report)) {
            println!(
                "{file} is of another compiler: {}",
                printed.lines().next().unwrap_or_default()
            );
        } else if let Some((printed, now)) =
            printed.lines().zip(table.lines()).find(|(a, b)| a != b)
        {
            bail!("{file} says\n{printed}\nbut now it is\n{now}\nTo write it anew: --bless");
        } else {
            println!("{file}: as measured");
        }
    }
    Ok(())
}
