//! Parts that are not all of one job are refused, with a line that names which.

use super::{folder, holds, parts, refusal, run};
use std::fs;

const SMALL: &str = "frame --scene plain --width 6 --height 5 --spp 20";

#[test]
fn broken_sets_of_parts_are_refused() {
    let folder = folder();
    let folder = folder.path();
    parts(folder, SMALL, 0..3, 3);
    parts(folder, SMALL, [0], 2);
    let part = |name: &str| folder.join(name);
    let foreign = |name: &str, arguments: &str| {
        let arguments = format!("{arguments} --shards 3 --shard 1 --out {name}");
        assert_eq!(run("shard", folder, &arguments), (0, String::new()));
    };
    foreign("seed", &format!("{SMALL} --seed 1"));
    foreign("size", &SMALL.replace("--width 6", "--width 7"));
    foreign("samples", &SMALL.replace("--spp 20", "--spp 21"));
    foreign("effects", &SMALL.replace("plain", "lens"));
    foreign("number", &format!("{SMALL} --arithmetic libm-f64"));
    foreign("split", &format!("{SMALL} --split samples"));
    foreign("points", "points --sequence r2 --count 5 --map square");
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/plain.ron");
    let scene = fs::read_to_string(scene).unwrap();
    fs::write(part("plain.ron"), &scene).unwrap();
    foreign("same-scene", &SMALL.replace("plain", "plain.ron"));
    fs::write(part("plain.ron"), format!("{scene} ")).unwrap();
    foreign("scene", &SMALL.replace("plain", "plain.ron"));

    let good = fs::read(part("1-of-3.part")).unwrap();
    let edited = |name: &str, from: &str, to: &str| {
        let end = good.iter().position(|byte| *byte == b'\n').unwrap();
        let line = String::from_utf8(good[..end].to_vec()).unwrap();
        assert!(line.contains(from), "{line}");
        let line = line.replacen(from, to, 1);
        fs::write(part(name), [line.as_bytes(), &good[end..]].concat()).unwrap();
    };
    let version = env!("CARGO_PKG_VERSION");
    edited("version", &format!("hemidisc {version}"), "hemidisc 0.0.9");
    edited("range", "range:(start:1,end:3)", "range:(start:1,end:4)");
    edited("beyond", "shard:1,", "shard:3,");
    edited("bytes", "bytes:288", "bytes:289");
    edited("header", "shard:1,", "");
    edited("format", "format 1", "format 2");
    fs::write(part("short"), &good[..good.len() - 1]).unwrap();
    fs::write(part("long"), [&good[..], &[0]].concat()).unwrap();
    fs::write(part("cut"), &good[..100]).unwrap();
    fs::write(part("empty"), "").unwrap();

    let first = "0-of-3.part";
    let cases = [
        ("missing: shard 1 of 3 (rows 1..3)", "0-of-3.part 2-of-3.part"),
        ("duplicate: ./1-of-3.part and 1-of-3.part are both shard 1 of 3", "./1-of-3.part"),
        ("overlap: 0-of-2.part and 1-of-3.part both have rows 1..2", "0-of-2.part 2-of-3.part"),
        ("missing: rows 2..3", "0-of-2.part 2-of-3.part -"),
        ("foreign: seed has seed: 1 where FIRST has seed: 0", "seed"),
        ("foreign: size has width: 7 where FIRST has width: 6", "size"),
        ("foreign: samples has spp: 21 where FIRST has spp: 20", "samples"),
        ("foreign: effects has scene: \"lens\" where FIRST has scene: \"plain\"", "effects"),
        ("foreign: number has arithmetic: \"libm-f64\" where FIRST has", "number"),
        ("foreign: split has split: Samples where FIRST has split: Rows", "split"),
        ("foreign: points has Points where FIRST has Frame", "points"),
        ("foreign: scene has scene_digest: ", "scene"),
        ("foreign: version has program: hemidisc 0.0.9 where FIRST has", "version"),
        ("range: has a broken first line: its range is not that", "range"),
        ("beyond: has a broken first line: its range is not that", "beyond"),
        ("bytes: has a broken first line: its range is not that", "bytes"),
        ("header: has a broken first line: ", "header"),
        ("format: is not a part; accepted: what --shard I writes", "format"),
        ("short: is not whole: 287 bytes of data, not 288", "short"),
        ("long: is not whole: 289 bytes of data, not 288", "long"),
        ("cut: has a broken first line: ", "cut"),
        ("empty: is not a part", "empty"),
        ("plain.ron: is not a part", "plain.ron"),
        ("none: cannot be read: ", "none"),
    ];
    fs::create_dir(part("out")).unwrap();
    fs::write(part("out/made"), "as before").unwrap();
    for (wrong, named) in cases {
        // All that is good but the first, and what is not.
        let arguments = match named {
            "0-of-3.part 2-of-3.part" => named.to_owned(),
            "0-of-2.part 2-of-3.part" => format!("{named} 1-of-3.part"),
            "0-of-2.part 2-of-3.part -" => "0-of-2.part 2-of-3.part".to_owned(),
            _ => format!("{first} {named} 1-of-3.part 2-of-3.part"),
        };
        let message = refusal(folder, &format!("merge {arguments} --out out/made"));
        assert!(message.starts_with(&wrong.replace("FIRST", first)), "{message} for {named}");
        assert_eq!(fs::read(part("out/made")).unwrap(), b"as before");
        holds(&part("out"), &["made"]);
    }
    // Good parts still are, wherever their scene lay.
    let good = "merge 0-of-3.part same-scene 2-of-3.part --out out/made";
    assert_eq!(run("shard", folder, good), (0, String::new()));
}

#[test]
fn bad_arguments_are_refused_on_one_line() {
    let points = "points --sequence r2 --count 4 --out x";
    let frame = "frame --scene plain --out x";
    let cases = [
        ("", "command: missing; accepted: points, frame, merge"),
        ("pixels", "command: \"pixels\" is not known; accepted: points, frame, merge"),
        ("merge --out x", "<PART>...: missing; accepted: paths of parts"),
        ("merge x", "--out: missing; accepted: the path of a file"),
        ("frame --scene plain --out x", "--shards: missing; accepted: an integer 1..=65535"),
        ("FRAME --shards 0", "--shards: \"0\""),
        ("FRAME --shards 65536", "--shards: \"65536\""),
        ("FRAME --shards 2 --shard 2", "--shard: 2 with --shards 2; accepted: an integer 0..=1"),
        ("FRAME --shards 2 --shard -1", "--shard: \"-1\""),
        ("FRAME --shards 2 --shard 0 --by threads", "--shard: given with --by; accepted: one"),
        (
            "FRAME --shards 2 --by magic",
            "--by: \"magic\" is not known; accepted: threads, processes",
        ),
        (
            "FRAME --shards 2 --split tiles",
            "--split: \"tiles\" is not known; accepted: rows, samples",
        ),
        ("FRAME --shards 2 --threads 0", "--threads: \"0\""),
        ("FRAME --shards 2 --arithmetic q15", "--arithmetic: \"q15\" does not render"),
        ("FRAME --shards 2 --effects lens", "--effects: scene \"plain\" has no lens"),
        ("FRAME --shards 2 --tiles 2", "\"--tiles\": unknown argument; accepted: --scene, "),
        (
            "POINTS --map square --shards 2 --scene x",
            "\"--scene\": unknown argument; accepted: --sequence",
        ),
        (
            "POINTS --map cosine --shards 2",
            "--map: \"cosine\" is not known; accepted: square, disc",
        ),
        ("POINTS --map disc-rejection --shards 2", "--map: \"disc-rejection\" is not known"),
        ("POINTS --map square --shards 2 --arithmetic f16", "--arithmetic: \"f16\" is not known"),
        ("POINTS --map square --disc polar --shards 2", "--disc: has no effect with --map square"),
        ("POINTS --map square --exponent 2 --shards 2", "--exponent: has no effect"),
        (
            "POINTS --map hemisphere-power --shards 2",
            "--exponent: missing, hemisphere-power needs it",
        ),
        ("POINTS --map hemisphere-power --exponent -2 --shards 2", "--exponent: exponent is -2"),
        (
            "POINTS --map hemisphere-power --exponent x --shards 2",
            "--exponent: \"x\" is not a number",
        ),
    ];
    let folder = folder();
    for (arguments, wrong) in cases {
        let arguments = arguments.replace("FRAME", frame).replace("POINTS", points);
        let message = refusal(folder.path(), &arguments);
        assert!(message.starts_with(wrong), "{arguments}: {message}");
        assert!(message.contains("accepted: "), "{arguments}: {message}");
    }
    holds(folder.path(), &[]);
}
