//! Computes one shard, or all of them by threads or processes and then the whole.

use crate::arguments::{By, Shards, in_common};
use crate::job::Work;
use crate::{merge, part};
use examples::Failure;
use examples::progress::Progress;
use examples::render::output::Output;
use std::io;
use std::num::NonZeroUsize;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, OnceLock};
use std::thread;
use std::time::Duration;

/// Writes the part of `--shard`, or all parts and what they make up; returns the path of the file.
pub(crate) fn run(work: &dyn Work, shards: &Shards, given: &[String]) -> Result<String, Failure> {
    let of = shards.shards.get();
    if let Some(shard) = shards.shard {
        if shard >= of {
            let accepted = format!("an integer 0..={}", of - 1);
            return Err(Failure::Usage(format!(
                "--shard: {shard} with --shards {of}; accepted: {accepted}"
            )));
        }
        let output = Output::create(&shards.out)?;
        return compute(work, [shard, of], shards.threads(), output);
    }

    // Before anything that takes time.
    let output = Output::create(&shards.out)?;
    let folder = output.folder();
    let parts =
        tempfile::Builder::new().prefix("shards-").tempdir_in(&folder).map_err(|error| {
            let folder = folder.display();
            Failure::Usage(format!("--out: cannot make a folder for parts in {folder}: {error}"))
        })?;
    let paths: Vec<_> = (0..of).map(|shard| parts.path().join(format!("{shard}.part"))).collect();
    let given = in_common(given);
    each(shards.threads(), of, &|shard, failure| {
        let path = &paths[usize::from(shard)];
        match shards.by {
            Some(By::Processes) => process(&given, shard, path, failure),
            _ => compute(work, [shard, of], 1, Output::create(path)?).map(drop),
        }
    })?;
    merge::merge(&paths, output)
}

/// Writes the part of a shard.
fn compute(
    work: &dyn Work,
    [shard, of]: [u16; 2],
    threads: usize,
    output: Output,
) -> Result<String, Failure> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|error| Failure::Usage(format!("--threads: {error}")))?;
    pool.install(|| part::write(work, shard, of, output))
}

/// The first failure of a shard, once there is one.
type First = OnceLock<String>;

/// Calls a function for each shard, some at once, until one fails.
///
/// Not on the rendering threads: one that waits for rows would begin another shard, and hold both.
fn each(
    threads: usize,
    of: u16,
    shard: &(impl Fn(u16, &First) -> Result<(), Failure> + Sync),
) -> Result<(), Failure> {
    let cores = || thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let threads = if threads == 0 { cores() } else { threads }.min(of.into());
    let next = AtomicU32::new(0);
    let progress = Mutex::new(Progress::new(of.into()));
    let failure = First::new();
    let work = || {
        while failure.get().is_none() {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= of.into() {
                break;
            }
            match shard(number as u16, &failure) {
                Ok(()) => progress.lock().into_iter().for_each(|mut bar| bar.step("shards")),
                Err(error) => {
                    let (_, why) = error.told();
                    // Those that fail after the first are not told: they may have been stopped.
                    let _ = failure.set(format!("shard {number} of {of}: {why}"));
                }
            }
        }
    };
    thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    progress.into_inner().into_iter().for_each(Progress::finish);
    failure.into_inner().map_or(Ok(()), |message| Err(Failure::Shard(message)))
}

/// Runs this program for a shard, until it ends or another has failed.
fn process(given: &[String], shard: u16, part: &Path, others: &First) -> Result<(), Failure> {
    /// Between two looks at whether it has ended.
    const PAUSE: Duration = Duration::from_millis(2);
    let failed = |error: io::Error| Failure::Shard(format!("cannot be run: {error}"));
    let mut command = Command::new(std::env::current_exe().map_err(failed)?);
    command.args(given).args(["--threads", "1", "--shard", &shard.to_string(), "--out"]).arg(part);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(failed)?;
    while child.try_wait().map_err(failed)?.is_none() {
        if others.get().is_some() {
            // It may have ended by now.
            let _ = child.kill();
        }
        thread::sleep(PAUSE);
    }
    let ended = child.wait_with_output().map_err(failed)?;
    if ended.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&ended.stderr);
    let said: Vec<_> = said.lines().map(|line| line.trim_start_matches("error: ")).collect();
    let status = ended.status;
    let colon = if said.is_empty() { "" } else { ": " };
    Err(Failure::Shard(format!("{status}{colon}{}", said.join(" "))))
}
