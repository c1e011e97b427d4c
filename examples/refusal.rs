//! The command-line parser's errors on one line: the argument, what was wrong and what is accepted.

use clap::error::{ContextKind, ContextValue, ErrorKind};
use std::error::Error;

/// An error of the parser, which would take several lines, on one.
pub fn one_line(
    error: &clap::Error,
    command: &clap::Command,
    accepted: &dyn Fn(&str) -> String,
) -> String {
    let accepted = |argument: &str| accepted(argument.trim_start_matches('-'));
    let arguments = context(error, ContextKind::InvalidArg);
    let argument = arguments.first().map_or("", String::as_str);
    let value = context(error, ContextKind::InvalidValue).concat();
    match error.kind() {
        ErrorKind::MissingRequiredArgument => {
            let missing = arguments.iter();
            let missing =
                missing.map(|name| format!("{name}: missing; accepted: {}", accepted(name)));
            missing.collect::<Vec<_>>().join("; ")
        }
        ErrorKind::InvalidValue if value.is_empty() => {
            format!("{argument}: no value; accepted: {}", accepted(argument))
        }
        ErrorKind::InvalidValue => {
            format!("{argument}: {value:?} is not known; accepted: {}", accepted(argument))
        }
        ErrorKind::ValueValidation => {
            let wrong = error.source().map(ToString::to_string).unwrap_or_default();
            format!("{argument}: {value:?}: {wrong}; accepted: {}", accepted(argument))
        }
        ErrorKind::TooManyValues => {
            format!("{argument}: {value:?} given; accepted: {argument} without a value")
        }
        ErrorKind::ArgumentConflict => {
            match context(error, ContextKind::PriorArg).first().map(String::as_str) {
                Some(prior) if prior != argument => {
                    format!("{argument}: given with {prior}; accepted: one of the two")
                }
                _ => format!("{argument}: given more than once; accepted: once"),
            }
        }
        ErrorKind::UnknownArgument => {
            let known = command.get_arguments().filter_map(|known| known.get_long());
            let known: Vec<_> = known.map(|long| format!("--{long}")).collect();
            format!("{argument:?}: unknown argument; accepted: {}", known.join(", "))
        }
        ErrorKind::InvalidSubcommand
        | ErrorKind::MissingSubcommand
        | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let given = context(error, ContextKind::InvalidSubcommand);
            let wrong = given.first().map(|given| format!("{given:?} is not known"));
            let wrong = wrong.unwrap_or_else(|| "missing".to_owned());
            let known: Vec<_> = command.get_subcommands().map(clap::Command::get_name).collect();
            format!("command: {wrong}; accepted: {}", known.join(", "))
        }
        _ => error.to_string().lines().next().unwrap_or_default().to_owned(),
    }
}

/// What the parser says about an error: names of arguments without their placeholders, or values.
fn context(error: &clap::Error, kind: ContextKind) -> Vec<String> {
    let texts = match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    };
    let name = |text: String| text.split(" <").next().unwrap_or_default().to_owned();
    match kind {
        ContextKind::InvalidValue => texts,
        _ => texts.into_iter().map(name).collect(),
    }
}
