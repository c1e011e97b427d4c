//! The cost of each effect on a board, used and unused.

use crate::folders::root;
use crate::report::{Record, Report};
use anyhow::{Context, Result};
use hemidisc::catalogue::EFFECTS;
use std::fs;

/// Of the arithmetic that the table is of.
const ARITHMETIC: &str = "fast-f32";
const CORES: [&str; 2] = ["Cortex-M0", "Cortex-M4F"];

/// Points drawn for effects and rays sent in a scene's whole picture, as the digests of every core
/// say.
fn tally(golden: &str, scene: &str) -> Result<[u64; 2]> {
    let start = format!("{ARITHMETIC} {scene} ");
    let line = golden.lines().find_map(|line| line.strip_prefix(&start));
    let fields = line.with_context(|| format!("no scene {scene}"))?.split(' ').skip(1);
    fields.into_iter().try_fold([0, 0], |[points, rays], field| {
        let (name, pair) = field.split_once('=').context("no tally")?;
        let (more_points, more_rays) = pair.split_once(',').context("no pair")?;
        // The base's points are those of the pixel filter.
        let more_points: u64 = if name == "base" { 0 } else { more_points.parse()? };
        Ok([points + more_points, rays + more_rays.parse::<u64>()?])
    })
}

fn of_scene<'a>(report: &'a Report, core: &str, scene: &str) -> Result<&'a Record> {
    let found = report.records.iter().find(|record| {
        record.core == core
            && record.scene.as_deref() == Some(scene)
            && record.arithmetic.as_deref() == Some(ARITHMETIC)
    });
    found.with_context(|| format!("{core} does not render {scene}"))
}

/// A row for the scene without effects, with each alone, and with all.
pub fn table(report: &Report) -> Result<String> {
    let path = root().join("tests/golden/render.txt");
    let golden = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let mut text = String::from(
        "| effect | points drawn | rays sent | instructions a sample, M0 | M4F | flash, bytes, M0 | M4F |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    let alone = EFFECTS.iter().map(|effect| (*effect, *effect));
    for (scene, name) in [("plain", "none")].into_iter().chain(alone).chain([("still-life", "all")])
    {
        let [points, rays] = tally(&golden, scene)?;
        text += &format!("| {name} | {points} | {rays} |");
        for core in CORES {
            let count = of_scene(report, core, scene)?.instructions_per_point;
            text += &format!(" {:.0} |", count.context("not counted")?);
        }
        for core in CORES {
            text += &format!(" {} |", of_scene(report, core, scene)?.flash_bytes);
        }
        text += "\n";
    }
    Ok(text)
}
