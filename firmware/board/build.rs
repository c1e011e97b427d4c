//! The memory of the board that stands for each target.

use std::path::PathBuf;
use std::{env, error::Error, fs};

/// `microbit`: 256 KiB of flash, 16 KiB of RAM.
const MICROBIT: &str = "MEMORY {
    FLASH : ORIGIN = 0x00000000, LENGTH = 256K
    RAM : ORIGIN = 0x20000000, LENGTH = 16K
}
";

/// `mps2-an385`, `mps2-an386`.
const MPS2: &str = "MEMORY {
    FLASH : ORIGIN = 0x00000000, LENGTH = 4M
    RAM : ORIGIN = 0x20000000, LENGTH = 4M
}
";

/// `virt`: all is RAM.
const VIRT: &str = "MEMORY {
    RAM : ORIGIN = 0x80000000, LENGTH = 4M
}
REGION_ALIAS(\"REGION_TEXT\", RAM);
REGION_ALIAS(\"REGION_RODATA\", RAM);
REGION_ALIAS(\"REGION_DATA\", RAM);
REGION_ALIAS(\"REGION_BSS\", RAM);
REGION_ALIAS(\"REGION_HEAP\", RAM);
REGION_ALIAS(\"REGION_STACK\", RAM);
";

fn main() -> Result<(), Box<dyn Error>> {
    let target = env::var("TARGET")?;
    let memory = match target.as_str() {
        "thumbv6m-none-eabi" => MICROBIT,
        "thumbv7m-none-eabi" | "thumbv7em-none-eabihf" => MPS2,
        "riscv32imc-unknown-none-elf" => VIRT,
        // Checked on a host, never linked.
        _ => return Ok(()),
    };
    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::write(out.join("memory.x"), memory)?;
    println!("cargo:rustc-link-search={}", out.display());
    println!("cargo:rerun-if-changed=build.rs");
    Ok(())
}
