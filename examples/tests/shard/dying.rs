//! A shard's process that dies is named, and the others do not go on for nothing.
#![cfg(target_os = "linux")]

use super::{folder, holds};
use std::fs;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use testkit::programs;

/// A process that a thread of another has started, and the shard that its arguments name.
fn child(of: u32) -> Option<(u32, String)> {
    let threads = fs::read_dir(format!("/proc/{of}/task")).ok()?.flatten();
    let lists =
        threads.filter_map(|thread| fs::read_to_string(thread.path().join("children")).ok());
    let child = lists.collect::<String>().split_whitespace().next()?.parse().ok()?;
    let arguments = fs::read_to_string(format!("/proc/{child}/cmdline")).ok()?;
    let shard = arguments.split('\0').skip_while(|argument| *argument != "--shard").nth(1)?;
    Some((child, shard.to_owned()))
}

#[test]
fn a_shard_that_dies_is_named() {
    let folder = folder();
    // Half a minute a shard, if none dies.
    let arguments = "frame --scene still-life --width 400 --height 300 --spp 1000 --shards 3 \
                     --threads 2 --by processes --out out/made";
    let mut command = Command::new(programs::program("shard"));
    command.args(arguments.split_whitespace()).current_dir(folder.path()).stderr(Stdio::piped());
    let start = Instant::now();
    let running = command.spawn().expect("the program starts");
    let (child, shard) = loop {
        if let Some(found) = child(running.id()) {
            break found;
        }
        assert!(start.elapsed() < Duration::from_secs(10), "no shard runs");
        sleep(Duration::from_millis(5));
    };
    let killed = Command::new("kill").args(["-9", &child.to_string()]).status();
    assert!(killed.expect("the program kill").success());

    let ended = running.wait_with_output().expect("the program ends");
    let said = String::from_utf8(ended.stderr).expect("UTF-8");
    assert_eq!(said, format!("error: shard {shard} of 3: signal: 9 (SIGKILL)\n"));
    assert_eq!(ended.status.code(), Some(1));
    assert!(start.elapsed() < Duration::from_secs(15), "the others were waited for");
    // Neither a picture nor a part is left.
    holds(&folder.path().join("out"), &[]);
}
