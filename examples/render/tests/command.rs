//! The command line, the scenes' files and the report.

use super::{SMALL, rendered, scene};
use crate::arguments::{Arguments, one_line};
use crate::{report, sheet};
use clap::Parser;
use examples::Failure;
use examples::render::effects::Effects;
use examples::render::file;
use hemidisc::catalogue::EFFECTS;

/// The one line that arguments are refused with.
fn refusal(line: &str) -> String {
    let line = format!("render {line}");
    let arguments = match Arguments::try_parse_from(line.split_whitespace()) {
        Err(error) => return one_line(&error),
        Ok(arguments) => arguments,
    };
    let request = &arguments.request;
    let known = file::text(&request.scene).and_then(|(path, text)| file::scene(&path, &text));
    match known.and_then(|scene| request.called_for(scene.effects())) {
        Err(Failure::Usage(message)) => message,
        _ => panic!("{line} is accepted"),
    }
}

#[test]
fn bad_arguments_are_refused_on_one_line() {
    let scenes = "accepted: glossy, lens, occlusion, plain, soft-shadow, still-life, or the path";
    let cases = [
        ("", "--scene: missing", scenes),
        ("--scene none", "--scene: \"none\" is not a scene", scenes),
        ("--scene none.ron", "--scene: cannot read none.ron", scenes),
        (
            "--scene plain --effects lens",
            "--effects: scene \"plain\" has no lens",
            "accepted: none",
        ),
        (
            "--scene lens --effects glossy",
            "--effects: scene \"lens\" has no glossy",
            "lens, or none",
        ),
        ("--scene lens --effects fog", "--effects: \"fog\": \"fog\" is not an effect", "or none"),
        ("--scene lens --effects lens,lens", "--effects: \"lens,lens\": lens is named", "or none"),
        ("--scene lens --spp 0", "--spp: \"0\"", "accepted: an integer 1..=65535"),
        ("--scene lens --spp -1", "--spp: \"-1\"", "accepted: an integer 1..=65535"),
        ("--scene lens --width 8193", "--width: \"8193\"", "accepted: an integer 1..=8192"),
        ("--scene lens --height x", "--height: \"x\"", "accepted: an integer 1..=8192"),
        ("--scene lens --threads 0", "--threads: \"0\"", "accepted: an integer 1..=255"),
        ("--scene lens --seed -1", "--seed: \"-1\"", "accepted: an integer 0..=4294967295"),
        ("--scene lens --report xml", "--report: \"xml\" is not known", "accepted: json"),
        ("--scene lens --sequence sobol", "--sequence: \"sobol\"", "accepted: sobol-owen, random"),
        ("--scene lens --sampler both", "--sampler: \"both\"", "accepted: pixel, screen"),
        (
            "--scene lens --sequence random --sampler screen",
            "--sampler: \"screen\" given with another sequence",
            "accepted: pixel",
        ),
        ("--scene lens --scene lens", "--scene: given more than once", "accepted: once"),
        ("--scene lens --size 4", "\"--size\": unknown argument", "accepted: --scene, --effects"),
    ];
    for (line, wrong, accepted) in cases {
        let message = refusal(line);
        assert!(message.starts_with(wrong), "{line}: {message}");
        assert!(message.contains(accepted), "{line}: {message}");
        assert_eq!(message.lines().count(), 1, "{line}: {message}");
    }
}

#[test]
fn a_sheet_takes_a_folder_alone() {
    let refused = |line: &str| {
        let given: Vec<_> = line.split_whitespace().map(str::to_owned).collect();
        assert!(sheet::is_asked_for(&given), "{line}");
        let error = sheet::Arguments::try_parse_from(&given).err();
        error.map(|error| sheet::one_line(&error))
    };
    assert_eq!(refused("render --sheet x"), None);
    assert_eq!(refused("render --sheet=x"), None);
    for (line, wrong) in [
        ("render --sheet", "--sheet: no value; accepted: the path of a folder"),
        ("render --sheet x --spp 3", "\"--spp\": unknown argument; accepted: --sheet"),
    ] {
        let message = refused(line).unwrap();
        assert!(message.starts_with(wrong), "{message}");
    }
}

#[test]
fn a_wrong_scene_is_refused_with_its_line_and_field() {
    let good = "(
camera: (position: (0, 0, 0), ahead: (0, 0, 1), field_of_view: 40),
lens: (radius: 0.1, focus: 2),
light: (position: (0, 0, 0), toward: (0, -1, 0), intensity: (1, 1, 1), radius: 1),
ambient: (colour: (0, 0, 0), reach: inf),
sky: (horizon: (0, 0, 0), zenith: (0, 0, 0)),
spheres: [(centre: (0, 0, 0), radius: 1, material: (
albedo: (0, 0, 0), reflection: (reflectance: (1, 1, 1), exponent: 9)))],
)";
    assert_eq!(file::parsed(good).map(|scene| scene.effects().each().count()), Ok(4));
    let cases = [
        ("radius: 0.1", "radius: -0.1", "3:", "lens.radius: radius is -0.1; accepted: a finite"),
        ("focus: 2", "focus: 0", "3:", "lens.focus: distance is 0; accepted: a number above 0"),
        ("focus: 2", "focus: \"far\"", "3:", "lens.focus: "),
        ("focus: 2", "focal: 2", "3:", "focal"),
        (", focus: 2", "", "3:", "lens: "),
        ("intensity: (1, 1, 1)", "intensity: (1, -1, 1)", "4:", "light.intensity: -1; accepted"),
        ("toward: (0, -1, 0)", "toward: (0, 0, 0)", "4:", "light.toward: a vector that is zero"),
        ("radius: 1)", "radius: NaN)", "4:", "light.radius: radius is NaN"),
        ("reach: inf", "reach: -inf", "5:", "ambient.reach: distance is -inf"),
        ("field_of_view: 40", "field_of_view: 180", "2:", "camera.field_of_view: 180; accepted"),
        (
            "radius: 1, mat",
            "radius: 0, mat",
            "7:",
            "spheres[0].radius: 0; accepted: a number from 1e-15",
        ),
        ("radius: 1, mat", "radius: 1e39, mat", "7:", "accepted: a number from 1e-15 to 1e15"),
        (
            "(1, 1, 1), radius: 1",
            "(1, 1, 1e39), radius: 1",
            "4:",
            "accepted: numbers from 0 to 1e15",
        ),
        (
            "exponent: 9",
            "exponent: -1",
            "8:",
            "spheres[0].material.reflection.exponent: exponent is",
        ),
        ("],\n)", "],\n", "8:73: Unexpected end", ""),
        ("],\n)", "],\n) 7", "9:", ""),
    ];
    for (from, to, line, wrong) in cases {
        assert!(good.contains(from), "{from}");
        let message = file::parsed(&good.replacen(from, to, 1)).unwrap_err();
        assert!(message.starts_with(line), "{to}: {message}");
        assert!(message.contains(wrong), "{to}: {message}");
        assert_eq!(message.lines().count(), 1, "{to}: {message}");
    }
}

#[test]
fn scenes_call_for_the_effects_they_are_named_for() {
    let expected = [
        ("glossy", "glossy"),
        ("lens", "lens"),
        ("occlusion", "occlusion"),
        ("plain", "none"),
        ("soft-shadow", "light"),
        ("still-life", "lens,light,occlusion,glossy"),
    ];
    assert_eq!(file::names(), expected.map(|(name, _)| name));
    for (name, effects) in expected {
        assert_eq!(Ok(scene(name).effects()), effects.parse::<Effects>(), "{name}");
    }
}

#[test]
fn the_report_is_the_json_that_was_promised() {
    let mut frame = rendered("libm-f32", &scene("lens"), "lens".parse().unwrap(), &SMALL);
    frame.seconds = 2.0;
    let mut render = |effects: Effects| {
        assert_eq!(effects, Effects::NONE);
        let mut frame = rendered("libm-f32", &scene("lens"), effects, &SMALL);
        frame.seconds = 0.5;
        Ok(frame)
    };
    let Ok(json) = report::json("lens".parse().unwrap(), &frame, &mut render) else {
        panic!("no report");
    };
    let absent = "{\"called_for\": false, \"points_drawn\": 0, \"rays\": 0, \"seconds\": 0.000000}";
    let lens =
        "{\"called_for\": true, \"points_drawn\": 1536, \"rays\": 1536, \"seconds\": 1.500000}";
    let promised = format!(
        "{{\"effects\": {{\"lens\": {lens}, \"light\": {absent}, \"occlusion\": {absent}, \
         \"glossy\": {absent}"
    );
    let others = EFFECTS[4..].iter().map(|name| format!(", \"{name}\": {absent}"));
    assert_eq!(json, promised + &others.collect::<String>() + "}}\n");
}
