//! Frames: shards by rows or by samples, by threads or processes, make the picture of `render`.

use super::{folder, holds, made, parts, run};
use examples::render::assembly::renderers;
use std::path::Path;

/// 16 rows, and 3 passes of which the last is short.
const SMALL: &str = "--scene still-life --width 24 --height 16 --spp 20 --seed 5";

#[track_caller]
fn rendered(folder: &Path, arguments: &str) -> Vec<u8> {
    let (status, said) = run("render", folder, &format!("{arguments} --out rendered.png"));
    assert_eq!((status, said.as_str()), (0, ""));
    let bytes = std::fs::read(folder.join("rendered.png")).unwrap();
    std::fs::remove_file(folder.join("rendered.png")).unwrap();
    bytes
}

#[track_caller]
fn same(arguments: &str, by: &str, shards: impl IntoIterator<Item = u16>) {
    let folder = folder();
    let expected = rendered(folder.path(), arguments);
    for of in shards {
        for split in ["rows", "samples"] {
            let arguments = format!("frame {arguments} --shards {of} --split {split} --by {by}");
            assert!(made(folder.path(), &arguments) == expected, "{arguments}");
        }
    }
    holds(folder.path(), &[]);
}

#[test]
fn threads_make_the_picture() {
    for (arithmetic, _) in renderers() {
        same(&format!("{SMALL} --arithmetic {arithmetic}"), "threads", [1, 2, 3, 7, 17]);
    }
    same(&SMALL.replace("--spp 20", "--spp 1 --effects none"), "threads", [2]);
    same(&format!("{SMALL} --effects lens,light --threads 3"), "threads", [7]);
}

#[test]
fn processes_make_the_picture() {
    same(SMALL, "processes", [1, 2, 3, 7, 17]);
    same(&format!("{SMALL} --arithmetic libm-f64 --effects none"), "processes", [3]);
}

#[test]
fn parts_in_any_order_make_the_picture() {
    let folder = folder();
    let folder = folder.path();
    let expected = rendered(folder, SMALL);
    for split in ["rows", "samples"] {
        let arguments = format!("frame {SMALL} --split {split}");
        parts(folder, &arguments, 0..3, 3);
        // A shard handed out again, in halves, on more threads.
        parts(folder, &format!("{arguments} --threads 3"), [2, 3], 6);
        for order in ["0-of-3 1-of-3 2-of-3", "2-of-3 1-of-3 0-of-3", "3-of-6 0-of-3 2-of-6 2-of-3"]
        {
            let names: Vec<_> = order.split(' ').map(|name| format!("{name}.part")).collect();
            assert!(made(folder, &format!("merge {}", names.join(" "))) == expected, "{order}");
        }
    }
}

/// The sums in a part, which are finer than the bytes of a picture.
fn sums(folder: &Path, shard: u16, of: u16) -> Vec<i64> {
    let part = std::fs::read(folder.join(format!("{shard}-of-{of}.part"))).unwrap();
    let end = part.iter().position(|byte| *byte == b'\n').unwrap();
    let (numbers, rest) = part[end + 1..].as_chunks();
    assert_eq!(rest, []);
    numbers.iter().map(|bytes| i64::from_le_bytes(*bytes)).collect()
}

#[test]
fn sums_of_parts_are_those_of_one_shard() {
    for arithmetic in ["libm-f64", "libm-f32"] {
        for split in ["rows", "samples"] {
            let folder = folder();
            let folder = folder.path();
            let arguments = format!("frame {SMALL} --split {split} --arithmetic {arithmetic}");
            parts(folder, &arguments, [0], 1);
            let whole = sums(folder, 0, 1);
            assert_eq!(whole.len(), 3 * 24 * 16);
            for of in [2, 3, 7] {
                parts(folder, &arguments, 0..of, of);
                let all = (0..of).map(|shard| sums(folder, shard, of));
                let together = if split == "rows" {
                    all.flatten().collect()
                } else {
                    all.fold(vec![0; whole.len()], |mut sums, part| {
                        sums.iter_mut().zip(part).for_each(|(sum, more)| *sum += more);
                        sums
                    })
                };
                assert!(together == whole, "{arguments} in {of} shards");
            }
        }
    }
}

#[test]
fn a_shard_computed_again_is_the_same_file() {
    let folder = folder();
    let part = || std::fs::read(folder.path().join("1-of-3.part")).unwrap();
    for split in ["rows", "samples"] {
        let arguments = format!("frame {SMALL} --split {split}");
        parts(folder.path(), &arguments, [1], 3);
        let first = part();
        parts(folder.path(), &format!("{arguments} --threads 2"), [1], 3);
        assert!(part() == first);
    }
}

/// What settles the picture is seen in it, so that the pictures above are the same for a reason.
#[test]
fn another_seed_is_another_picture() {
    let folder = folder();
    let arguments = SMALL.replace("--seed 5", "--seed 6");
    let other = made(folder.path(), &format!("frame {arguments} --shards 2"));
    assert!(other != rendered(folder.path(), SMALL));
    assert!(other == rendered(folder.path(), &arguments));
}
