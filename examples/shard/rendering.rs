//! A frame of a scene as bytes: of each pixel the sums of red, green and blue, i64, little-endian.

use crate::job::{Job, Split, Work};
use examples::Failure;
use examples::render::assembly::Render;
use examples::render::description::Scene;
use examples::render::effects::Effects;
use examples::render::file;
use examples::render::frame::{Region, Settings};
use examples::render::request::Request;
use examples::render::sums::Sum;
use examples::shard::cover;
use std::io::{self, Read, Write};
use std::path::Path;
use testkit::digest::Digest;

/// A scene that is known to be good, and how it is to be rendered.
pub(crate) struct Rendering {
    scene: Scene,
    effects: Effects,
    settings: Settings,
    render: Render,
    split: Split,
    job: Job,
}

impl Rendering {
    pub(crate) fn new(request: Request, split: Split) -> Result<Self, Failure> {
        let (path, text) = file::text(&request.scene)?;
        let scene = file::scene(&path, &text)?;
        let effects = request.called_for(scene.effects())?;
        let (settings, render) = (request.settings(), request.renderer()?);
        // What is good in f64 may not be so in the arithmetic: nothing is rendered yet.
        let nothing = Region { rows: 0..0, passes: 0..0 };
        render(&scene, effects, &settings, &nothing, &mut || {})
            .map_err(|wrong| Failure::Usage(format!("{}: {wrong}", path.display())))?;

        let mut digest = Digest::new();
        digest.bytes(text.as_bytes());
        // Wherever the scene lies on this machine.
        let name = Path::new(&request.scene).file_stem().unwrap_or_default();
        let scene_name = name.to_string_lossy().into_owned();
        let request = Request { scene: scene_name, effects: Some(effects), ..request };
        let scene_digest = format!("{:016x}", digest.value());
        let job = Job::Frame { request, scene_digest, split };
        Ok(Self { scene, effects, settings, render, split, job })
    }
}

impl Work for Rendering {
    fn job(&self) -> &Job {
        &self.job
    }

    fn write(&self, shard: u16, of: u16, out: &mut dyn Write) -> io::Result<()> {
        let units = cover::range(self.job.len(), shard, of);
        let region = self.split.region(&self.settings, units);
        let Self { scene, effects, settings, render, .. } = self;
        let frame = render(scene, *effects, settings, &region, &mut || {});
        let frame = frame.map_err(io::Error::other)?;
        let mut components = frame.sums.iter().flat_map(|sum| sum.0);
        components.try_for_each(|component| out.write_all(&component.to_le_bytes()))
    }
}

/// Adds the sums that were written of some pixels.
pub(crate) fn add(written: &mut impl Read, pixels: &mut [Sum]) -> io::Result<()> {
    for pixel in pixels {
        let mut sum = Sum::default();
        for component in &mut sum.0 {
            let mut bytes = [0; size_of::<i64>()];
            written.read_exact(&mut bytes)?;
            *component = i64::from_le_bytes(bytes);
        }
        *pixel += sum;
    }
    Ok(())
}
