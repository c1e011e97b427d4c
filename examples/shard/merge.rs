//! Puts parts together: points one range after another, frames pixel by pixel.

use crate::job::{Job, Split};
use crate::part::Part;
use crate::rendering;
use examples::Failure;
use examples::render::output::Output;
use examples::render::picture;
use examples::render::request::Request;
use examples::render::sums::{self, Sum};
use examples::shard::cover;
use std::io::{self, Write};
use std::path::PathBuf;

/// Merges the parts of a job, which have to be all of it; returns the path of what was made.
pub(crate) fn merge(paths: &[PathBuf], output: Output) -> Result<String, Failure> {
    let parts = paths.iter().map(|path| Part::open(path)).collect::<Result<Vec<_>, _>>()?;
    let Some(first) = parts.first() else { return Err(Failure::Usage("no parts".to_owned())) };
    for part in &parts {
        if let Some([here, there]) = first.difference(part) {
            let [first, part] = [first, part].map(Part::name);
            return Err(Failure::Usage(format!(
                "foreign: {part} has {there} where {first} has {here}"
            )));
        }
    }
    let pieces: Vec<_> = parts.iter().map(Part::piece).collect();
    let job = first.job();
    let order = cover::order(job.len(), job.unit(), &pieces).map_err(Failure::Usage)?;
    let parts: Vec<_> = order.into_iter().filter_map(|index| parts.get(index)).collect();
    output.write(|out| match job {
        Job::Points { .. } => points(&parts, out),
        Job::Frame { request, split, .. } => frame(request, *split, &parts, out),
    })
}

fn points(parts: &[&Part], out: &mut dyn Write) -> io::Result<()> {
    parts.iter().try_for_each(|part| io::copy(&mut part.data()?, out).map(drop))
}

fn frame(request: &Request, split: Split, parts: &[&Part], out: &mut dyn Write) -> io::Result<()> {
    let settings = request.settings();
    let [width, height] = settings.size.map(|side| side as usize);
    let mut pixels = vec![Sum::default(); width * height];
    for part in parts {
        let rows = split.region(&settings, part.range()).rows;
        let [from, to] = [rows.start, rows.end].map(|row| width * row as usize);
        // Within the frame, as every range is within the job.
        let pixels = pixels.get_mut(from..to).unwrap_or_default();
        rendering::add(&mut part.data()?, pixels)?;
    }
    picture::png(out, settings.size, &sums::means(&pixels, settings.samples.into()))
}
