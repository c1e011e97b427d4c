//! The commands of `docs/growing.md` do what the page says, `cmp` included.
#![cfg(unix)]

use super::folder;
use std::process::Command;
use testkit::programs;

#[test]
fn the_commands_of_the_page_run() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/growing.md");
    let page = std::fs::read_to_string(page).expect("a page");
    let blocks = page.split("\n```sh\n").skip(1);
    let blocks = blocks.map(|block| block.split("\n```").next().unwrap_or_default());
    // All but the first, which builds the programs; and on fewer pixels.
    let script: Vec<_> = blocks.filter(|block| !block.contains("cargo build")).collect();
    assert!(script.len() >= 5, "{script:?}");
    let script = script.join("\n").replace("--spp 64", "--spp 64 --width 30 --height 20");

    let folder = folder();
    let [render, shard] = ["render", "shard"].map(programs::program);
    assert_eq!(render.parent(), shard.parent());
    let beside = shard.parent().expect("a folder").display().to_string();
    let path = std::env::var("PATH").expect("a path");
    let mut command = Command::new("sh");
    command.args(["-euc", &script]).env("PATH", format!("{beside}:{path}"));
    let output = command.current_dir(folder.path()).output().expect("a shell");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(folder.path().join("halves.png").exists());
}
