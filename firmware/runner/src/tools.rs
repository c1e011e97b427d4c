//! The programs that a run needs: QEMU, linkers, and a cargo that has a `core` for each target.

use crate::cores::{CORES, Core};
use crate::folders::root;
use anyhow::{Context, Result, bail, ensure};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program, the Debian package that it comes in, and what it is for.
const NEEDED: [[&str; 3]; 4] = [
    ["qemu-system-arm", "qemu-system-arm", "boots the Cortex-M boards"],
    ["qemu-system-riscv32", "qemu-system-misc", "boots the RV32 board"],
    ["arm-none-eabi-ld", "binutils-arm-none-eabi", "links for Cortex-M"],
    ["riscv64-unknown-elf-ld", "binutils-riscv64-unknown-elf", "links for RV32"],
];

fn is_installed(program: &str) -> bool {
    std::env::var_os("PATH").is_some_and(|path| {
        std::env::split_paths(&path).any(|folder| folder.join(program).is_file())
    })
}

/// An error that says what to install.
pub fn check() -> Result<()> {
    let missing: Vec<_> = NEEDED.iter().filter(|[program, ..]| !is_installed(program)).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let lines =
        missing.iter().map(|[program, _, purpose]| format!("\n  {program}, which {purpose}"));
    let packages: Vec<_> = missing.iter().map(|[_, package, _]| *package).collect();
    bail!(
        "not installed:{}\nOn Debian or Ubuntu: apt-get install {}",
        lines.collect::<String>(),
        packages.join(" ")
    )
}

/// Standard output of a command that succeeds.
pub fn output(command: &mut Command) -> Result<String> {
    let output = command.output().with_context(|| format!("{command:?}"))?;
    let error = String::from_utf8_lossy(&output.stderr);
    let text = String::from_utf8_lossy(&output.stdout);
    ensure!(output.status.success(), "{command:?}: {}\n{text}{error}", output.status);
    Ok(text.replace("\r\n", "\n"))
}

/// A cargo that has a `core` for the target: rustup's where the target is installed, else Debian's
/// compiler and the source of its `core`.
fn cargo(target: &str) -> Result<(Command, &'static [&'static str])> {
    let installed = output(Command::new("rustup").args(["target", "list", "--installed"]));
    if installed.is_ok_and(|targets| targets.lines().any(|line| line == target)) {
        return Ok((Command::new("cargo"), &[]));
    }
    ensure!(
        Path::new("/usr/bin/cargo").exists()
            && Path::new("/usr/lib/rustlib/src/rust/library").exists(),
        "no core library for {target}: `rustup target add {target}`, or on Debian \
         `apt-get install rustc-web cargo-web rust-web-src`"
    );
    let mut cargo = Command::new("/usr/bin/cargo");
    // The nightly option that builds `core`, and the compiler of that source.
    cargo.env("RUSTC", "/usr/bin/rustc").env("RUSTC_BOOTSTRAP", "1").env_remove("RUSTUP_TOOLCHAIN");
    Ok((cargo, &["-Zbuild-std=core"]))
}

/// The compiler's version: counts and sizes are its as well.
pub fn compiler(core: &Core) -> Result<String> {
    let (cargo, extra) = cargo(core.target)?;
    let rustc = if extra.is_empty() { "rustc" } else { "/usr/bin/rustc" };
    drop(cargo);
    let version = output(Command::new(rustc).arg("--version"))?;
    Ok(version.split_whitespace().take(2).collect::<Vec<_>>().join(" "))
}

/// The workspace of the firmware.
pub fn workspace() -> PathBuf {
    root().join("firmware")
}

/// Where a build for a core puts its files.
pub fn built(core: &Core) -> PathBuf {
    workspace().join("target").join(core.target).join("release")
}

pub fn build(core: &Core, arguments: &[&str]) -> Result<()> {
    let (mut cargo, extra) = cargo(core.target)?;
    cargo.current_dir(workspace()).args(["build", "--quiet", "--release", "--locked"]);
    output(cargo.args(extra).args(["--target", core.target]).args(arguments)).map(drop)
}

/// The library, and what draws with it, build for cores without an operating system, an allocator
/// or an FPU.
pub fn build_library() -> Result<()> {
    for core in &CORES {
        for features in [
            "",
            "libm",
            "libm,micromath,fixed-point,bytemuck,heapless,rand_core,rand",
            "fixed-point,serde",
            "fixed-point,defmt",
        ] {
            let (mut cargo, extra) = cargo(core.target)?;
            cargo.current_dir(root()).args(["build", "--package", "hemidisc", "--lib"]);
            cargo.args(["--quiet", "--release", "--locked"]);
            cargo.args(extra).args(["--target", core.target, "--target-dir", "target/bare-metal"]);
            output(cargo.args(["--no-default-features", "--features", features]))?;
            println!("{} with features [{features}]: built", core.target);
        }
        let (mut cargo, extra) = cargo(core.target)?;
        cargo.current_dir(workspace().join("panel")).args(["build", "--quiet", "--release"]);
        cargo.args(["--locked", "--target-dir", "../../target/bare-metal"]);
        output(cargo.args(extra).args(["--target", core.target]))?;
        println!("{} with the drawing of `display`: built", core.target);
    }
    Ok(())
}

/// On an x86 without SSE2 integers build, and floats are refused with the reason.
pub fn build_x87() -> Result<()> {
    const TARGET: &str = "i586-unknown-linux-gnu";
    let build = |features: &str| -> Result<std::process::Output> {
        let (mut cargo, extra) = cargo(TARGET)?;
        cargo.current_dir(workspace().join("x87")).args(["build", "--quiet", "--locked"]);
        cargo.args(extra).args(["--target", TARGET, "--target-dir", "../../target/bare-metal"]);
        cargo.args(["--features", features]).output().with_context(|| format!("{cargo:?}"))
    };
    let (integers, floats) = (build("")?, build("floats")?);
    let [said, refusal] =
        [integers.stderr, floats.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    ensure!(integers.status.success(), "{TARGET}: {said}");
    ensure!(!floats.status.success(), "{TARGET}: floats are not refused");
    ensure!(refusal.contains("x86 without SSE2"), "{TARGET}: another refusal: {refusal}");
    println!("{TARGET}: integers built, floats refused");
    Ok(())
}
