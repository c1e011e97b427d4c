//! What each effect costs on a board where a scene calls for it, and where it does not.

use crate::report::{Record, Report};
use crate::root;
use anyhow::{Context, Result};
use std::fs;

/// Of the arithmetic that the table is of.
const ARITHMETIC: &str = "fast-f32";
const CORES: [&str; 2] = ["Cortex-M0", "Cortex-M4F"];

/// Points drawn and rays sent for an effect in a scene's whole picture, as the digests of every core say.
fn tally(golden: &str, scene: &str, effect: &str) -> Result<[u64; 2]> {
    let start = format!("{ARITHMETIC} {scene} ");
    let line = golden.lines().find_map(|line| line.strip_prefix(&start));
    let mut fields = line.with_context(|| format!("no scene {scene}"))?.split(' ');
    let value = fields.find_map(|field| field.strip_prefix(effect)?.strip_prefix('='));
    let pair = value.and_then(|value| value.split_once(',')).context("no tally")?;
    Ok([pair.0.parse()?, pair.1.parse()?])
}

fn of_scene<'a>(report: &'a Report, core: &str, scene: &str) -> Result<&'a Record> {
    let found = report.records.iter().find(|record| {
        record.core == core
            && record.scene.as_deref() == Some(scene)
            && record.arithmetic.as_deref() == Some(ARITHMETIC)
    });
    found.with_context(|| format!("{core} does not render {scene}"))
}

/// A row for each effect: a scene with it alone, and the same without.
pub fn table(report: &Report) -> Result<String> {
    let path = root().join("tests/golden/render.txt");
    let golden = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let mut text = String::from(
        "| effect | points drawn, without | rays, without | instructions a pixel, M0 | M4F | flash, bytes, M0 | M4F |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: |\n",
    );
    for scene in ["plain", "lens", "light", "occlusion", "glossy", "still-life"] {
        let all = ["lens", "light", "occlusion", "glossy"];
        let effects = match scene {
            "plain" | "still-life" => &all[..],
            effect => &[effect][..],
        };
        let sum = |scene: &str| -> Result<[u64; 2]> {
            effects.iter().try_fold([0, 0], |[points, rays], effect| {
                let [more_points, more_rays] = tally(&golden, scene, effect)?;
                Ok([points + more_points, rays + more_rays])
            })
        };
        let ([points, rays], [without_points, without_rays]) = (sum(scene)?, sum("plain")?);
        let name = match scene {
            "plain" => "none",
            "still-life" => "all four",
            effect => effect,
        };
        text += &format!("| {name} | {points}, {without_points} | {rays}, {without_rays} |");
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
