//! Images of one fill each: how large they are, and what is not in them.

use crate::cores::Core;
use crate::tools;
use anyhow::{Context, Result, bail, ensure};
use object::{Object, ObjectSection, ObjectSymbol, SectionKind};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A linked image.
pub struct Image {
    /// Bytes of text and tables.
    pub flash: u64,
    /// Bytes of statics in RAM; the stack is not in them.
    pub ram: u64,
    symbols: Vec<String>,
}

fn read(path: &Path) -> Result<Image> {
    let bytes = fs::read(path).with_context(|| path.display().to_string())?;
    let file = object::File::parse(&*bytes)?;
    let mut image = Image { flash: 0, ram: 0, symbols: Vec::new() };
    for section in file.sections() {
        match section.kind() {
            SectionKind::Text | SectionKind::ReadOnlyData | SectionKind::ReadOnlyString => {
                image.flash += section.size();
            }
            // Initial values are in flash, and copied.
            SectionKind::Data => {
                image.flash += section.size();
                image.ram += section.size();
            }
            // `riscv-rt` gives the stack a section.
            SectionKind::UninitializedData if section.name()? != ".stack" => {
                image.ram += section.size()
            }
            _ => {}
        }
    }
    image.symbols =
        file.symbols().filter_map(|symbol| Some(symbol.name().ok()?.to_owned())).collect();
    Ok(image)
}

/// The image of one entry of the static library and what it calls.
pub fn link(core: &Core, entry: &str) -> Result<Image> {
    let folder = tools::built(core);
    let path = folder.join("linked.elf");
    let mut linker = Command::new(core.linker);
    linker.args(core.linker_arguments).args(["--gc-sections", "--fatal-warnings", "-e", entry]);
    tools::output(linker.arg(folder.join("libimage.a")).arg("-o").arg(&path))?;
    let image = read(&path)?;
    ensure!(image.symbols.iter().any(|symbol| symbol == entry), "{entry} is not in its image");
    Ok(image)
}

/// The image of a program.
pub fn program(core: &Core, name: &str) -> Result<Image> {
    read(&tools::built(core).join(name))
}

/// Whether a symbol is a routine for floats of a core without an FPU, or for conversions.
fn is_float(symbol: &str) -> bool {
    let of_libgcc = |stem: &str| symbol.strip_prefix("__").is_some_and(|name| name.contains(stem));
    let arm = ["__aeabi_f", "__aeabi_d", "__aeabi_cf", "__aeabi_cd", "__aeabi_i2f", "__aeabi_i2d"];
    let arm_unsigned =
        ["__aeabi_ui2f", "__aeabi_ui2d", "__aeabi_l2f", "__aeabi_l2d", "__aeabi_ul2"];
    arm.iter().chain(&arm_unsigned).any(|stem| symbol.starts_with(stem))
        || [
            "sf2", "df2", "sf3", "df3", "sisf", "sidf", "disf", "didf", "sfsi", "dfsi", "sfdi",
            "dfdi",
        ]
        .into_iter()
        .any(of_libgcc)
}

impl Image {
    /// A symbol other than the entry that has a word in it.
    pub fn mentions(&self, word: &str, entry: &str) -> Option<&str> {
        let mut symbols = self.symbols.iter().filter(|symbol| *symbol != entry);
        symbols.find(|symbol| symbol.contains(word)).map(String::as_str)
    }

    /// An error for a panic in the image, and for a software float where there shall be none.
    pub fn check(&self, name: &str, integers_only: bool) -> Result<()> {
        if let Some(symbol) = self.symbols.iter().find(|symbol| symbol.contains("panic")) {
            bail!("{name}: a path to a panic: {symbol}");
        }
        if let Some(symbol) = self.symbols.iter().find(|symbol| integers_only && is_float(symbol)) {
            bail!("{name}: a software float: {symbol}");
        }
        Ok(())
    }
}

/// The checks find what they look for in images that have it.
pub fn shown_to_fail(core: &Core) -> Result<()> {
    let panics = link(core, "fault/panic")?.check("fault/panic", false);
    ensure!(panics.is_err(), "an unchecked index is not found");
    if core.soft_float {
        ensure!(
            link(core, "fault/float")?.check("fault/float", true).is_err(),
            "a float is not found"
        );
    }
    Ok(())
}
