//! What an effect leaves in an image: its code if the scene uses it, else nothing.

use crate::cores::{CORES, Core};
use crate::images::{self, Image};
use crate::report::{Record, with_pictures};
use anyhow::{Result, ensure};

macro_rules! effects {
    ($($file:ident $effect:ident $name:literal;)*) => {
        /// Scenes that call for one effect, and the module that the effect's functions are in.
        const EFFECTS: &[(&str, &str)] = &[$(($name, stringify!($file))),*];
    };
}
hemidisc::for_each_effect!(effects);

/// The excess in flash and instructions that a scene without effects may have over the renderer
/// without them: it counts points and rays.
const ROOM: f64 = 1.05;

/// An error for an effect in the image of a scene that does not call for it, and for one that is
/// not there.
pub fn check(path: &str, image: &Image) -> Result<()> {
    let Some(scene) = path.strip_prefix("render/").and_then(|rest| rest.split('/').next()) else {
        return Ok(());
    };
    for (effect, module) in EFFECTS {
        let called_for = scene == *effect || scene == "still-life";
        let symbol = image.mentions(module, path);
        ensure!(
            symbol.is_some() == called_for,
            "{path}: {effect} is {}called for, and of its symbols there is {symbol:?}",
            if called_for { "" } else { "not " }
        );
    }
    Ok(())
}

/// The check finds an effect that is not called for, and misses one that is not there.
pub fn shown_to_fail(core: &Core) -> Result<()> {
    for (of, as_if) in [("still-life", "plain"), ("plain", "still-life"), ("light", "lens")] {
        let image = images::link(core, &format!("render/{of}/fast-f32"))?;
        let found = check(&format!("render/{as_if}/fast-f32"), &image);
        ensure!(found.is_err(), "effects of {of} are taken for those of {as_if}");
    }
    Ok(())
}

/// A scene without effects costs what it does in the renderer without them.
pub fn cost_nothing_where_absent(records: &[Record]) -> Result<()> {
    let mut compared = 0;
    for plain in records.iter().filter(|record| record.scene.as_deref() == Some("plain")) {
        let same = |bare: &&Record| {
            bare.scene.as_deref() == Some("bare")
                && (bare.core, &bare.arithmetic) == (plain.core, &plain.arithmetic)
        };
        for bare in records.iter().filter(same) {
            let [flash, bare_flash] = [plain, bare].map(|record| record.flash_bytes as f64);
            let [instructions, bare_instructions] =
                [plain, bare].map(|record| record.instructions_per_point.unwrap_or(f64::NAN));
            ensure!(
                flash <= ROOM * bare_flash && instructions <= ROOM * bare_instructions,
                "{}: without effects {flash} bytes and {instructions} instructions, never with one \
                 {bare_flash} and {bare_instructions}",
                plain.core
            );
            compared += 1;
        }
    }
    let expected = with_pictures().count() * CORES.len();
    ensure!(compared == expected, "{compared} of {expected} scenes without effects are compared");
    Ok(())
}
