//! What is reported of each fill on each core.

use crate::cores::{CORES, Core};
use crate::digests::Files;
use crate::images::Image;
use crate::qemu::Count;
use anyhow::{Result, bail, ensure};
use hemidisc::catalogue::{ARITHMETICS, DISC_MAPS, EFFECTS, LOBES, SEQUENCES};
use serde::Serialize;

/// Points of a fill.
const COUNT: f64 = 256.0;

#[derive(Clone, Debug, Default, Serialize)]
pub struct Record {
    pub core: &'static str,
    /// `map`, `turned`, `components`, `sequence`, `fused`, `effect`, `render`, `peer`, `loop` or
    /// `exponent`.
    pub kind: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sequence: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub effect: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scene: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub disc: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arithmetic: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peer: Option<String>,
    /// Executed; of an exponent, which is prepared once, none.
    pub instructions_per_point: Option<f64>,
    /// Text and tables beyond an empty image.
    pub flash_bytes: u64,
    pub stack_bytes: Option<u32>,
    /// Whether the points are the host's, bit for bit; none where there are no digests.
    pub digest_ok: Option<bool>,
}

impl Record {
    pub fn new(
        core: &Core,
        count: &Count,
        image: &Image,
        nothing: &Image,
        files: &Files,
    ) -> Result<Self> {
        let own = |text: &str| Some(text.to_owned());
        let parts: Vec<_> = count.path.split('/').collect();
        let mut record = Self {
            core: core.name,
            kind: parts[0].to_owned(),
            instructions_per_point: Some(f64::from(count.instructions) / COUNT),
            flash_bytes: image.flash - nothing.flash,
            stack_bytes: Some(count.stack),
            ..Self::default()
        };
        match parts[1..] {
            [sequence] if parts[0] == "sequence" => record.sequence = own(sequence),
            [name] if parts[0] == "loop" => record.map = own(name),
            [map, disc, arithmetic] if ["map", "turned", "components"].contains(&parts[0]) => {
                (record.map, record.disc, record.arithmetic) =
                    (own(map), own(disc), own(arithmetic));
            }
            [scene, arithmetic] if parts[0] == "render" => {
                (record.scene, record.arithmetic) = (own(scene), own(arithmetic));
            }
            [effect, arithmetic] if parts[0] == "effect" => {
                (record.effect, record.arithmetic) = (own(effect), own(arithmetic));
            }
            [sequence, map, disc, arithmetic] if parts[0] == "fused" => {
                record.sequence = own(sequence);
                (record.map, record.disc, record.arithmetic) =
                    (own(map), own(disc), own(arithmetic));
            }
            [map, disc, peer] if parts[0] == "peer" => {
                (record.map, record.disc, record.peer) = (own(map), own(disc), own(peer));
            }
            _ => bail!("not the path of a fill: {}", count.path),
        }
        let arithmetic = record.arithmetic.as_deref().filter(|name| ARITHMETICS.contains(name));
        let file = match parts[0] {
            "effect" => Some("effects"),
            // Of these fills there are no digests, though of their maps.
            "turned" | "components" => None,
            // What the tests compare `plain` with.
            "render" if record.scene.as_deref() == Some("bare") => None,
            "render" => Some("render"),
            _ => arithmetic.or(record.sequence.as_ref().map(|_| "square")),
        };
        record.digest_ok = file.map(|name| files.names.contains(name));
        if record.peer.is_none() {
            let arithmetic = record.arithmetic.as_deref();
            let integers = arithmetic.is_none_or(|name| name.starts_with('q'));
            image.check(&count.path, integers)?;
        }
        Ok(record)
    }

    /// The preparation of an exponent.
    pub fn prepared(core: &Core, arithmetic: &str, image: &Image, nothing: &Image) -> Self {
        Self {
            core: core.name,
            kind: "exponent".to_owned(),
            arithmetic: Some(arithmetic.to_owned()),
            flash_bytes: image.flash - nothing.flash,
            ..Self::default()
        }
    }
}

/// The example of a lens on one core.
#[derive(Serialize)]
pub struct Lens {
    pub core: &'static str,
    pub flash_bytes: u64,
    /// Statics; the stack is not in them.
    pub ram_bytes: u64,
    #[serde(skip)]
    pub picture: String,
}

#[derive(Serialize)]
pub struct Report {
    pub compiler: String,
    pub records: Vec<Record>,
    pub lens: Vec<Lens>,
}

impl Report {
    pub fn new(compiler: String) -> Self {
        Self { compiler, records: Vec::new(), lens: Vec::new() }
    }

    /// Every member of the catalogue is in the report.
    pub fn covers_the_catalogue(&self) -> Result<()> {
        let is = |part: &Option<String>, name: &str| part.as_deref() == Some(name);
        let on_every_core = |what: &str, has: &dyn Fn(&Record) -> bool| {
            let counted = self.records.iter().filter(|record| has(record)).count();
            ensure!(
                counted == CORES.len(),
                "{what} is counted on {counted} of {} cores",
                CORES.len()
            );
            Ok(())
        };
        for name in SEQUENCES {
            on_every_core(&format!("the sequence {name}"), &|record| {
                record.kind == "sequence" && is(&record.sequence, name)
            })?;
        }
        for arithmetic in ARITHMETICS {
            for (map, disc) in maps() {
                on_every_core(&format!("{map} {disc} {arithmetic}"), &|record| {
                    record.kind == "map"
                        && is(&record.map, map)
                        && is(&record.disc, disc)
                        && is(&record.arithmetic, arithmetic)
                })?;
            }
        }
        for arithmetic in with_fills() {
            // A lens has two apertures.
            for effect in EFFECTS.iter().copied().chain(["lens-5-blades"]) {
                on_every_core(&format!("{effect} {arithmetic}"), &|record| {
                    is(&record.effect, effect) && is(&record.arithmetic, arithmetic)
                })?;
            }
        }
        for arithmetic in with_pictures() {
            for scene in EFFECTS.iter().copied().chain(["plain", "still-life", "bare"]) {
                on_every_core(&format!("{scene} {arithmetic}"), &|record| {
                    is(&record.scene, scene) && is(&record.arithmetic, arithmetic)
                })?;
            }
        }
        for (kind, of_each_core) in [("turned", 2), ("components", 2)] {
            let counted = self.records.iter().filter(|record| record.kind == kind).count();
            let expected = of_each_core * CORES.len();
            ensure!(counted == expected, "{counted} of {expected} fills of {kind} are counted");
        }
        Ok(())
    }
}

/// Coordinates, rejection, the disc maps, and each lobe over each of these.
fn maps() -> impl Iterator<Item = (&'static str, &'static str)> {
    let kinds = ["disc"].iter().chain(LOBES);
    let over_discs = kinds.flat_map(|kind| DISC_MAPS.iter().map(|disc| (*kind, *disc)));
    [("square", "-"), ("disc", "rejection")].into_iter().chain(over_discs)
}

macro_rules! boards {
    ($(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident $($facts:tt)*);
    )*) => {
        /// The arithmetics, and what the boards have of effects in each.
        const OF_EFFECTS: &[(&str, &str)] = &[$(($name, stringify!($boards))),*];
    };
}
hemidisc::for_each_arithmetic!(boards);

/// The arithmetics of which boards have fills of effects.
fn with_fills() -> impl Iterator<Item = &'static str> {
    let fills = OF_EFFECTS.iter().filter(|(_, boards)| ["fills", "pictures"].contains(boards));
    fills.map(|(name, _)| *name)
}

/// The arithmetics of which boards have pictures.
pub fn with_pictures() -> impl Iterator<Item = &'static str> {
    OF_EFFECTS.iter().filter(|(_, boards)| *boards == "pictures").map(|(name, _)| *name)
}
