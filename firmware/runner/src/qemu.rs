//! Programs in QEMU, and what they print.

use crate::cores::Core;
use crate::tools;
use anyhow::{Context, Result, bail, ensure};
use std::process::Command;

/// What a program prints, which must end by itself and well.
pub fn run(core: &Core, program: &str) -> Result<String> {
    run_with(core, program, &[])
}

fn run_with(core: &Core, program: &str, arguments: &[&str]) -> Result<String> {
    // A fault of the board is an endless loop there.
    let mut qemu = Command::new("timeout");
    qemu.args(["600", core.qemu]).args(core.machine).args(["-nographic", "-monitor", "none"]);
    qemu.args(["-semihosting-config", "enable=on,target=native"]).args(arguments);
    let text = tools::output(qemu.arg("-kernel").arg(tools::built(core).join(program)));
    text.with_context(|| format!("{program} in QEMU"))
}

/// What the board says of one fill.
#[derive(Debug, PartialEq)]
pub struct Count {
    pub path: String,
    /// Executed for all 256 points.
    pub instructions: u32,
    pub stack: u32,
}

fn parse(line: &str) -> Result<Count> {
    let mut words = line.split(' ');
    let mut next = || words.next().with_context(|| format!("not a count: {line}"));
    let path = next()?.to_owned();
    Ok(Count { path, instructions: next()?.parse()?, stack: next()?.parse()? })
}

fn counts_once(core: &Core, program: &str) -> Result<Vec<Count>> {
    let shift = format!("shift={},sleep=off", core.shift);
    run_with(core, program, &["-icount", &shift])?.lines().map(parse).collect()
}

/// The counts of two runs of a program, which must be the same, after those of a loop of known
/// length.
pub fn counts(core: &Core, program: &str) -> Result<Vec<Count>> {
    let mut counts = counts_once(core, program)?;
    for (first, second) in counts.iter().zip(counts_once(core, program)?) {
        ensure!(*first == second, "two runs differ: {first:?}, {second:?}");
    }
    let known = counts.remove(0);
    let Some(expected) = known.path.strip_prefix("calibration/") else {
        bail!("the first count is not the known loop: {known:?}");
    };
    let expected: u32 = expected.parse()?;
    // A tick of the Arm boards' timers is up to two instructions, read twice.
    ensure!(
        known.instructions.abs_diff(expected) <= 4,
        "a loop of {expected} instructions is counted as {}",
        known.instructions
    );
    Ok(counts)
}
