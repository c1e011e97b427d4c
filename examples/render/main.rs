//! Renders a scene with depth of field, soft shadows, ambient occlusion and glossy reflection, or any of them.
//!
//! ```text
//! cargo run --release --example render -- --scene still-life --spp 64
//! cargo run --release --example render -- --scene lens --effects none --report json
//! ```
//!
//! `testkit::tracer` is the renderer, which the firmware shares; the rest is the host's: `arguments` reads the command
//! line, `request` what settles the picture, `description` is a scene as its file has it, of checked `values`, and
//! `file` reads it. `assembly` makes a renderer of the scene's `objects` and the effects called for, `frame` renders
//! its rows on all cores into `sums`, `picture` makes a PNG of them for the `output`, and `report` says what each
//! effect took. The example `shard` shares all but the report.

mod arguments;
mod assembly;
mod description;
mod effects;
mod file;
mod frame;
mod objects;
#[expect(dead_code, reason = "shards have their parts beside it")]
mod output;
mod picture;
#[path = "../gallery/progress.rs"]
mod progress;
#[path = "../points/refusal.rs"]
mod refusal;
mod report;
mod request;
mod sequence;
mod sheet;
mod sums;
#[cfg(test)]
mod tests;
mod values;

use arguments::Arguments;
use clap::Parser;
use effects::Effects;
use output::{Output, say};
use progress::Progress;
use std::io::{self, Write};
use std::process::ExitCode;

/// Why there is no picture.
enum Failure {
    /// Names the argument or the field, what was wrong and what is accepted.
    Usage(String),
    Output(String, io::Error),
}

fn main() -> ExitCode {
    let given = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned());
    let given: Vec<_> = given.collect();
    let result = if sheet::is_asked_for(&given) {
        parsed(&given, sheet::one_line).and_then(|arguments| {
            arguments.map_or(Ok(()), |arguments| say(&sheet::write(&arguments)?))
        })
    } else {
        parsed(&given, arguments::one_line)
            .and_then(|arguments| arguments.map_or(Ok(()), |arguments| run(&arguments)))
    };
    let (status, message) = match result {
        Ok(()) => return ExitCode::SUCCESS,
        Err(Failure::Usage(message)) => (2, message),
        Err(Failure::Output(path, error)) => (1, format!("cannot write {path}: {error}")),
    };
    // There is nowhere to say that this could not be written.
    let _ = writeln!(io::stderr(), "error: {message}");
    ExitCode::from(status)
}

/// The arguments; none after help was asked for, and printed.
fn parsed<A: Parser>(
    given: &[String],
    one_line: fn(&clap::Error) -> String,
) -> Result<Option<A>, Failure> {
    match A::try_parse_from(given) {
        Ok(arguments) => Ok(Some(arguments)),
        Err(error) if error.use_stderr() => Err(Failure::Usage(one_line(&error))),
        Err(help) => say(&help.to_string()).map(|()| None),
    }
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    let request = &arguments.request;
    let (path, text) = file::text(&request.scene)?;
    let scene = file::scene(&path, &text)?;
    let effects = request.called_for(scene.effects())?;
    let settings = request.settings();
    let render = request.renderer()?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads()).build();
    let pool = pool.map_err(|error| Failure::Usage(format!("--threads: {error}")))?;
    // Before anything that takes time.
    let output = Output::create(&arguments.picture())?;

    let others = if arguments.report.is_some() { effects.each().count() } else { 0 };
    let mut progress = Progress::new(settings.passes() as usize * (1 + others));
    let mut render = |effects: Effects| {
        let step = &mut || progress.step(&request.scene);
        pool.install(|| render(&scene, effects, &settings, &settings.whole(), step))
            .map_err(|wrong| Failure::Usage(format!("{}: {wrong}", path.display())))
    };
    let frame = render(effects)?;
    let report = match arguments.report {
        Some(_) => Some(report::json(effects, &frame, &mut render)?),
        None => None,
    };
    progress.finish();

    let pixels = sums::means(&frame.sums, settings.samples.into());
    let written = output.write(|out| picture::png(out, settings.size, &pixels))?;
    say(&report.unwrap_or_else(|| format!("{written}\n")))
}
