//! Command lines that cannot be understood, as one message.

use std::{any::TypeId, borrow::Cow, ffi::OsString, path::PathBuf, process::ExitCode};

use clap::{
    Arg, CommandFactory,
    error::{ContextKind, ContextValue, Error, ErrorKind},
};

use super::{
    args::Cli,
    failure::Failure,
    names, output,
    text::{quoted, shorten},
};

/// Prints help or version, or the message about what is wrong.
pub(super) fn report(error: &Error) -> ExitCode {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand) {
        // A reader that has gone away is no error.
        let _ = error.print();
        return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
    }
    output::report(&Failure::Refused(message(error)))
}

/// What is wrong, what may have been meant, and where help is.
fn message(error: &Error) -> String {
    let problem = problem(error);
    let similar = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    let mut similar: Vec<String> = similar.iter().flat_map(|&kind| texts(error, kind)).collect();
    if similar.is_empty() {
        let commands: Vec<String> = Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).collect();
        let commands: Vec<&str> = commands.iter().map(String::as_str).collect();
        let typed = texts(error, ContextKind::InvalidSubcommand);
        similar.extend(typed.iter().flat_map(|typed| names::nearest(typed, &commands)).map(str::to_owned));
    }
    let similar: Vec<String> = similar.iter().map(|name| format!("`{name}`")).collect();
    let similar = if similar.is_empty() { String::new() } else { format!("; did you mean {}?", similar.join(" or ")) };
    let between = if similar.is_empty() { ";" } else { "" };
    format!("{problem}{similar}{between} `{} --help` shows how to use it", command(error))
}

fn problem(error: &Error) -> String {
    let text = |kind| texts(error, kind).first().map_or(String::new(), |text| shorten(text, 70));
    let typed = text(ContextKind::InvalidArg);
    let arg = plain(&typed);
    let value = text(ContextKind::InvalidValue);
    match error.kind() {
        ErrorKind::InvalidSubcommand => format!("{} is not a command", quoted(&texts(error, ContextKind::InvalidSubcommand).concat())),
        ErrorKind::MissingSubcommand => "a command is missing".to_owned(),
        ErrorKind::UnknownArgument if typed.starts_with('-') => format!("`{typed}` is not an option"),
        ErrorKind::UnknownArgument => format!("{} is one argument too many", quoted(&typed)),
        ErrorKind::MissingRequiredArgument => {
            let missing = texts(error, ContextKind::InvalidArg);
            format!("{} {} missing", list(&missing), if missing.len() > 1 { "are" } else { "is" })
        }
        ErrorKind::ArgumentConflict => match texts(error, ContextKind::PriorArg).as_slice() {
            [] => format!("`{arg}` must be the only argument"),
            [other] if plain(other) == arg => format!("`{arg}` is given twice"),
            others => format!("`{arg}` cannot be used with {}", list(others)),
        },
        ErrorKind::InvalidValue if value.is_empty() => format!("`{arg}` needs a value"),
        ErrorKind::InvalidValue => {
            format!("`{arg}` is {value}; it must be one of {}", texts(error, ContextKind::ValidValue).join(", "))
        }
        ErrorKind::ValueValidation => {
            let why = std::error::Error::source(error).map_or(String::new(), ToString::to_string);
            let value = if value.is_empty() { "empty" } else { &value };
            format!("`{arg}` is {value}; {}", shorten(&why, 100))
        }
        ErrorKind::TooManyValues => format!("`{arg}` has a value too many: {}", quoted(&value)),
        ErrorKind::InvalidUtf8 => not_utf8(),
        other => other.to_string(),
    }
}

fn list(names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|name| quoted(&plain(name))).collect();
    names.join(", ")
}

/// An argument without the signs of a usage line: `--scene <FILE>` is `--scene`, `[NAME]` is `NAME`.
fn plain(arg: &str) -> String {
    let name = if arg.starts_with('-') { arg.split([' ', '=']).next().unwrap_or(arg) } else { arg };
    name.replace(['<', '>', '[', ']'], "").replace("...", "")
}

/// Which argument is not UTF-8. File names that are only written or opened may be anything.
fn not_utf8() -> String {
    let typed: Vec<OsString> = std::env::args_os().skip(1).collect();
    let command = Cli::command();
    let subcommand = typed.first().and_then(|name| command.find_subcommand(name)).unwrap_or(&command);
    let is_path = |arg: &Arg| arg.get_value_parser().type_id() == TypeId::of::<PathBuf>();
    let option = |name: &str| {
        let long = name.strip_prefix("--")?;
        subcommand.get_arguments().find(|arg| arg.get_action().takes_values() && arg.get_long() == Some(long))
    };
    for (k, value) in typed.iter().enumerate().filter(|(_, value)| value.to_str().is_none()) {
        let text = value.to_string_lossy();
        let before = k.checked_sub(1).map_or(Cow::default(), |k| typed[k].to_string_lossy());
        let (name, value) = text.split_once('=').filter(|(name, _)| name.starts_with("--")).unwrap_or((&before, &text));
        match option(name) {
            Some(arg) if is_path(arg) => {}
            Some(_) => return format!("`{name}` is {}; it must be valid UTF-8", shorten(value, 70)),
            None if subcommand.get_positionals().any(is_path) && !text.starts_with('-') => {}
            None => return format!("the argument {} is not valid UTF-8", quoted(&text)),
        }
    }
    "an argument is not valid UTF-8".to_owned()
}

fn texts(error: &Error, kind: ContextKind) -> Vec<String> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text.clone()],
        Some(ContextValue::Strings(texts)) => texts.clone(),
        _ => Vec::new(),
    }
}

/// `forage` or `forage run`, by the usage line.
fn command(error: &Error) -> String {
    let usage = match error.get(ContextKind::Usage) {
        Some(ContextValue::StyledStr(usage)) => usage.to_string(),
        _ => String::new(),
    };
    let words = usage.trim_start_matches("Usage:").split_whitespace();
    let names: Vec<&str> = words.take_while(|word| word.chars().all(|c| c.is_ascii_lowercase())).collect();
    if !names.is_empty() {
        return names.join(" ");
    }
    let typed = std::env::args_os().nth(1).unwrap_or_default().to_string_lossy().into_owned();
    let command = Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).find(|name| *name == typed);
    command.map_or_else(|| "forage".to_owned(), |name| format!("forage {name}"))
}
