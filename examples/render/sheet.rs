//! The contact sheet of the README: scenes without and with the effects they call for, the points drawn for these
//! and the time that the picture took.

use crate::assembly::renderer_of;
use crate::effects::{Effect, Effects};
use crate::frame::{Frame, Settings};
use crate::picture::{Output, bytes};
use crate::report::tally;
use crate::sequence::Sequence;
use crate::{Failure, file};
use hemidisc::FastF32;
use hemidisc::arithmetic::Arithmetic;
use std::path::Path;

const SCENES: [&str; 5] = ["lens", "soft-shadow", "occlusion", "glossy", "still-life"];
const SETTINGS: Settings =
    Settings { size: [300, 200], samples: 64, sequence: Sequence::SobolOwen, seed: 0 };

/// Writes the pictures into a folder, and returns the sheet as Markdown.
pub(crate) fn write(folder: &Path) -> Result<String, Failure> {
    // The same bytes on every machine.
    let render = renderer_of(FastF32::NAME).expect("it renders in every build");
    let mut text = String::from("| scene | without effects | with |\n| --- | --- | --- |\n");
    for name in SCENES {
        let (_, scene) = file::scene(name)?;
        let names: Vec<_> = scene.effects().each().map(Effect::name).collect();
        text += &format!("| {name}: {} |", names.join(", "));
        for (effects, with) in [(Effects::NONE, "without"), (scene.effects(), "with")] {
            let frame = render(&scene, effects, &SETTINGS, &mut || {}).map_err(Failure::Usage)?;
            let path = folder.join(format!("{name}-{with}.png"));
            let path = Output::create(&path)?.write(SETTINGS.size, &bytes(&frame.pixels))?;
            text += &format!(" ![{name} {with} effects]({path})<br>{} |", caption(&frame));
        }
        text += "\n";
    }
    Ok(text)
}

fn caption(frame: &Frame) -> String {
    let points = |effect| tally(&frame.counts, effect).points;
    let points: u64 = Effect::ALL.into_iter().map(points).sum();
    format!("{points} points, {:.2} s", frame.seconds)
}
