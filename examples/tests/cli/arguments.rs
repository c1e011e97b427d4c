//! Errors, notes and help: one line, the right stream, the right status.

use super::{Run, leave_after, points, run};
use hemidisc::catalogue::{ARITHMETICS, AVAILABLE_ARITHMETICS, DISC_MAPS, LOBES, SEQUENCES};

/// Asserts an error that names the argument and says what is accepted.
#[track_caller]
fn refused(run: &Run, argument: &str, accepted: &str) {
    assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{argument}: {run:?}");
    let one_line = run.stderr.ends_with('\n') && run.stderr.lines().count() == 1;
    assert!(one_line, "not one line: {}", run.stderr);
    let names = run.stderr.starts_with(&format!("error: {argument}: "));
    assert!(names, "{argument} is not named: {}", run.stderr);
    let clause = if accepted.starts_with("accepted") { "" } else { "accepted: " };
    let accepts = run.stderr.contains(&format!("; {clause}{accepted}"));
    assert!(accepts, "does not say that {accepted} is accepted: {}", run.stderr);
}

/// The maps, as errors list them.
fn maps() -> String {
    let discs = DISC_MAPS.iter().map(|disc| format!("disc-{disc}"));
    let lobes = LOBES.iter().map(|lobe| format!("hemisphere-{lobe}"));
    let others = ["square", "disc-rejection"].map(str::to_owned);
    others.into_iter().chain(discs).chain(lobes).collect::<Vec<_>>().join(", ") + "\n"
}

/// The sequences, as errors list them.
fn sequences() -> String {
    SEQUENCES.join(", ") + "\n"
}

/// Other programs use these names.
#[test]
fn names_are_kept() {
    let all = |names: &[&str], list: &[&str]| names.iter().all(|name| list.contains(name));
    let sequences = [
        "regular",
        "random",
        "jittered",
        "nrooks",
        "multi-jittered",
        "correlated",
        "hammersley",
        "halton",
        "sobol",
        "sobol-owen",
        "r2",
    ];
    assert!(all(&sequences, SEQUENCES), "{SEQUENCES:?}");
    assert!(all(&["polar", "concentric"], DISC_MAPS), "{DISC_MAPS:?}");
    assert!(all(&["uniform", "cosine", "power"], LOBES), "{LOBES:?}");
    let arithmetics =
        ["libm-f64", "libm-f32", "fast-f32", "micromath-f32", "q31", "q15", "q15-div"];
    assert!(all(&arithmetics, ARITHMETICS), "{ARITHMETICS:?}");
}

const COUNT: &str = "an integer 1..=4294967295";
const INDEX: &str = "an integer 0..=4294967295";
const EXPONENT: &str = "a finite number above -1\n";
const BOTH: &str = "two integers 0..=4294967295, as in 640,480";
const JOINT: &str = "4 with --sequence sobol or sobol-owen and --map square, without --density \
                     and --invert\n";
const FIXED_EXPONENT: &str = "accepted in fixed point: 0 <= e < 4294967296\n";

/// The arithmetics of this build, as errors list them.
fn arithmetics() -> String {
    AVAILABLE_ARITHMETICS.join(", ") + "\n"
}
const ALL: &str = "--sequence, --count, --start, --seed, --map, --disc, --exponent, --arithmetic, \
                   --dimensions, --screen, --spp, --pixel, --stdin, --density, --invert, --raw";

#[test]
fn bad_arguments_are_refused_on_one_line() {
    let lists = [arithmetics(), maps(), sequences(), DISC_MAPS.join(", ") + "\n"];
    let [arithmetics, maps, sequences, discs] = lists.each_ref().map(String::as_str);
    let cases = [
        ("--count 4 --map square", "--sequence", sequences),
        ("--sequence r2 --map square", "--count", COUNT),
        ("--sequence r2 --count 4", "--map", maps),
        ("--stdin", "--map", maps),
        ("--sequence best --count 4 --map square", "--sequence", sequences),
        ("--sequence R2 --count 4 --map square", "--sequence", sequences),
        ("--sequence r2 --count 0 --map square", "--count", COUNT),
        ("--sequence r2 --count -1 --map square", "--count", COUNT),
        ("--sequence r2 --count 4.0 --map square", "--count", COUNT),
        ("--sequence r2 --count 4294967296 --map square", "--count", COUNT),
        ("--sequence r2 --count four --map square", "--count", COUNT),
        ("--sequence r2 --map square --count", "--count", COUNT),
        ("--sequence r2 --count 4 --count 4 --map square", "--count", "once"),
        ("--sequence r2 --count 4 --start -1 --map square", "--start", INDEX),
        ("--sequence r2 --count 4 --start 4294967296 --map square", "--start", INDEX),
        ("--sequence r2 --count 4 --seed 4294967296 --map square", "--seed", INDEX),
        (
            "--sequence r2 --count 4 --start 4294967293 --map square",
            "--start",
            "an integer 0..=4294967292\n",
        ),
        ("--sequence hammersley --count 4 --start 5 --map square", "--start", "an integer 0..=4\n"),
        ("--sequence r2 --count 4 --map", "--map", maps),
        ("--sequence r2 --count 4 --map disc", "--map", maps),
        ("--sequence r2 --count 4 --map square --disc round", "--disc", discs),
        ("--sequence r2 --count 4 --map square --arithmetic f16", "--arithmetic", arithmetics),
        ("--sequence r2 --count 4 --map square --arithmetic", "--arithmetic", arithmetics),
        ("--sequence r2 --count 4 --map hemisphere-power", "--exponent", EXPONENT),
        ("--sequence r2 --stdin --map square", "--sequence", "one of the two"),
        ("--sequence r2 --count 4 --map square --raw=yes", "--raw", "--raw without a value"),
        ("--sequence r2 --count 4 --map square --colour red", "\"--colour\"", ALL),
        ("--sequence r2 --count 4 --map square -x", "\"-x\"", ALL),
        ("--sequence r2 --count 4 --map square more", "\"more\"", ALL),
        ("--sequence sobol --count 4 --map square --dimensions 3", "--dimensions", "2, 4\n"),
        ("--sequence r2 --count 4 --map square --dimensions 4", "--dimensions", JOINT),
        ("--sequence sobol --count 4 --map disc-polar --dimensions 4", "--dimensions", JOINT),
        ("--sequence sobol --count 4 --map square --dimensions 4 --density", "--dimensions", JOINT),
        ("--sequence sobol-owen --map square --screen 64,48 --spp 4", "--pixel", BOTH),
        ("--sequence sobol-owen --map square --screen 64 --spp 4 --pixel 1,2", "--screen", BOTH),
        ("--sequence sobol-owen --map square --screen 64,48 --spp 0 --pixel 1,2", "--spp", COUNT),
        (
            "--sequence sobol-owen --map square --screen 64,48 --spp 4 --pixel 64,2",
            "--pixel",
            "x below 64 and y below 48\n",
        ),
        (
            "--sequence sobol-owen --map square --screen 0,48 --spp 4 --pixel 64,2",
            "--screen",
            "at least 1 x 1\n",
        ),
        (
            "--sequence r2 --map square --screen 64,48 --spp 4 --pixel 1,2",
            "--screen",
            "--sequence sobol-owen\n",
        ),
        ("--sequence r2 --count 4 --map square -- --raw", "\"--raw\"", ALL),
    ];
    for (arguments, argument, accepted) in cases {
        refused(&points(arguments), argument, accepted);
    }
    // Where the map does not use the exponent, it is still checked.
    for map in ["hemisphere-power", "square --disc polar"] {
        for exponent in ["", "ten", "--raw", "-1", "-1.5", "nan", "inf", "-inf", "1e39"] {
            let arguments = format!("--sequence r2 --count 4 --map {map} --exponent {exponent}");
            refused(&points(&arguments), "--exponent", EXPONENT);
        }
    }
    // Fixed point has its own range, and takes any decimal within.
    for name in ARITHMETICS.iter().filter(|name| name.starts_with('q')) {
        if !AVAILABLE_ARITHMETICS.contains(name) {
            continue;
        }
        let arguments =
            format!("--sequence r2 --count 4 --map hemisphere-power --arithmetic {name}");
        refused(&points(&arguments), "--exponent", FIXED_EXPONENT);
        for exponent in ["ten", "-1", "-0.5", "nan", "inf", "1e39", "4294967296"] {
            let run = points(&format!("{arguments} --exponent {exponent}"));
            refused(&run, "--exponent", FIXED_EXPONENT);
            let value = exponent.parse::<f64>().map_or(exponent.to_string(), |e| e.to_string());
            assert!(run.stderr.contains(&value), "{}", run.stderr);
        }
        let ten = points(&format!("{arguments} --exponent 10")).quiet();
        for exponent in ["10.0", "1e1", "+10"] {
            assert_eq!(points(&format!("{arguments} --exponent {exponent}")).quiet(), ten);
        }
        for exponent in ["0", "0.001", "1e8", "4294967295.9"] {
            points(&format!("{arguments} --exponent {exponent}")).quiet();
        }
    }
    // A line break in an argument is not one in the error.
    for break_at in ["squ\nare", "\n", "square\r\n\n"] {
        refused(&run(&["--stdin", "--map", break_at], b""), "--map", maps);
    }
    let several = points("");
    refused(&several, "--map", maps.trim_end());
    assert!(several.stderr.contains("--sequence: ") && several.stderr.contains("--count: "));
}

#[test]
fn an_error_is_the_only_line() {
    let with_a_note = "--sequence halton --count 4 --start 9 --map square --disc polar";
    assert!(points(with_a_note).stderr.starts_with("note: --disc "));
    let with_a_note = with_a_note.replace("halton", "hammersley");
    refused(&points(&with_a_note), "--start", "an integer 0..=4");
}

#[test]
fn arithmetics_that_a_build_does_not_have_are_refused() {
    for name in ARITHMETICS {
        let run = points(&format!("--sequence r2 --count 4 --map square --arithmetic {name}"));
        if AVAILABLE_ARITHMETICS.contains(name) {
            run.quiet();
        } else {
            refused(&run, "--arithmetic", &arithmetics());
            assert!(run.stderr.contains("needs a feature"), "{}", run.stderr);
        }
    }
}

#[test]
fn arguments_without_an_effect_are_noted() {
    let cases = [
        ("--sequence r2 --count 4 --map disc-polar", "--disc polar", "--disc"),
        ("--sequence r2 --count 4 --map square", "--exponent -0.5", "--exponent"),
        ("--sequence r2 --count 4 --map hemisphere-cosine", "--exponent 10.0", "--exponent"),
        ("--stdin --map square", "--count 4", "--count"),
        ("--stdin --map square", "--start 4", "--start"),
        ("--stdin --map square", "--seed 4", "--seed"),
    ];
    for (arguments, unused, name) in cases {
        let plain = points(arguments).quiet();
        let noted = points(&format!("{arguments} {unused}"));
        assert_eq!((noted.status, noted.table()), (0, plain), "{arguments} {unused}");
        let one_line = noted.stderr.lines().count() == 1;
        assert!(one_line && noted.stderr.starts_with(&format!("note: {name} ")), "{noted:?}");
    }
    for used in ["hemisphere-power --exponent -0.5 --disc polar", "hemisphere-cosine --disc polar"]
    {
        points(&format!("--sequence r2 --count 4 --map {used}")).quiet();
    }
}

#[test]
fn help_and_version_go_to_standard_output() {
    let help = points("--help");
    assert_eq!((help.status, help.stderr.as_str()), (0, ""));
    for option in ALL.split(", ") {
        assert!(help.stdout.contains(option), "{option}");
    }
    let version = points("--version");
    assert_eq!((version.status, version.stderr.as_str()), (0, ""));
    assert_eq!(version.stdout, format!("points {}\n", env!("CARGO_PKG_VERSION")));
}

/// Rows come as they are made: collecting 2^32 - 1 of them would take minutes and 32 GiB.
#[test]
fn a_reader_may_leave_at_any_time() {
    for map in ["square", "disc-rejection"] {
        let arguments = format!("--sequence sobol-owen --count {} --map {map}", u32::MAX);
        let (status, lines, stderr) = leave_after(10_000, &arguments);
        assert_eq!((status, lines.len(), stderr.as_str()), (0, 10_000, ""), "{map}");
    }
}
