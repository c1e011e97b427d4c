//! The contact sheet of the README: scenes without and with the effects they call for, the points
//! drawn for these and the time that the picture took.

use crate::report::tally;
use clap::{CommandFactory, Parser};
use examples::render::assembly::renderer_of;
use examples::render::effects::{Effect, Effects};
use examples::render::frame::{Frame, Settings};
use examples::render::output::Output;
use examples::render::picture::png;
use examples::render::sequence::{Pixels, Sequence};
use examples::render::{file, sums};
use examples::{Failure, refusal};
use hemidisc::FastF32;
use hemidisc::arithmetic::Arithmetic;
use std::path::PathBuf;

const SCENES: [&str; 5] = ["lens", "soft-shadow", "occlusion", "glossy", "still-life"];
const SETTINGS: Settings = Settings {
    size: [300, 200],
    samples: 64,
    sequence: Sequence::SobolOwen,
    pixels: Pixels::Screen,
    seed: 0,
};

/// Writes pictures of several scenes without and with effects, and prints what they took
#[derive(Parser)]
#[command(name = "render")]
pub(crate) struct Arguments {
    /// Where the pictures go
    #[arg(long, value_name = "DIR")]
    sheet: PathBuf,
}

/// Whether the sheet is asked for, and no picture of a scene.
pub(crate) fn is_asked_for(given: &[String]) -> bool {
    given.iter().any(|argument| argument.split('=').next() == Some("--sheet"))
}

/// An error of the parser on one line.
pub(crate) fn one_line(error: &clap::Error) -> String {
    let accepted = |_: &str| "the path of a folder".to_owned();
    refusal::one_line(error, &Arguments::command(), &accepted)
}

/// Writes the pictures into the folder, and returns the sheet as Markdown.
pub(crate) fn write(arguments: &Arguments) -> Result<String, Failure> {
    // The same bytes on every machine.
    let render = renderer_of(FastF32::NAME).expect("it renders in every build");
    let mut text = String::from("| scene | without effects | with |\n| --- | --- | --- |\n");
    for name in SCENES {
        let (path, description) = file::text(name)?;
        let scene = file::scene(&path, &description)?;
        let names: Vec<_> = scene.effects().each().map(Effect::name).collect();
        text += &format!("| {name}: {} |", names.join(", "));
        for (effects, with) in [(Effects::NONE, "without"), (scene.effects(), "with")] {
            let frame = render(&scene, effects, &SETTINGS, &SETTINGS.whole(), &mut || {});
            let frame = frame.map_err(Failure::Usage)?;
            let pixels = sums::means(&frame.sums, SETTINGS.samples.into());
            let output = Output::create(&arguments.sheet.join(format!("{name}-{with}.png")))?;
            let path = output.write(|out| png(out, SETTINGS.size, &pixels))?;
            text += &format!(" ![{name} {with} effects]({path})<br>{} |", caption(&frame));
        }
        text += "\n";
    }
    Ok(text)
}

fn caption(frame: &Frame) -> String {
    let points = |effect| tally(&frame.counts, effect).points;
    let points: u64 = Effect::ALL.iter().copied().map(points).sum();
    format!("{points} points, {:.2} s", frame.seconds)
}
