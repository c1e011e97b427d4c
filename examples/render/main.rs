//! Renders a scene with depth of field, soft shadows, ambient occlusion and glossy reflection, or
//! any of them.
//!
//! ```text
//! cargo run --release --example render -- --scene still-life --spp 64
//! cargo run --release --example render -- --scene lens --effects none --report json
//! ```
//!
//! `arguments` reads the command line, `report` says what each effect took, and `sheet` makes the
//! pictures of the README. The rest is the library's `render`, which the example `shard` shares.

mod arguments;
mod report;
mod sheet;
#[cfg(test)]
mod tests;

use arguments::Arguments;
use clap::Parser;
use examples::Failure;
use examples::progress::Progress;
use examples::render::effects::Effects;
use examples::render::output::{Output, say};
use examples::render::{file, picture, sums};
use std::io::{self, Write};
use std::process::ExitCode;

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
    let Err(failure) = result else { return ExitCode::SUCCESS };
    let (status, message) = failure.told();
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
