//! Command lines that cannot be understood, as one message.

use std::{any::TypeId, borrow::Cow, ffi::OsString, path::PathBuf, process::ExitCode};

use clap::{
    Arg, CommandFactory,
    error::{ContextKind, ContextValue, Error, ErrorKind},
};

use forage::{kernel::Message, message};

use super::{
    args::Cli,
    failure::Failure,
    names, output,
    text::{listed, quoted, shorten},
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
fn message(error: &Error) -> Message {
    let similar = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    let mut similar: Vec<String> = similar.iter().flat_map(|&kind| texts(error, kind)).collect();
    if similar.is_empty() {
        let commands: Vec<String> = Cli::command().get_subcommands().map(|command| command.get_name().to_owned()).collect();
        let commands: Vec<&str> = commands.iter().map(String::as_str).collect();
        let typed = texts(error, ContextKind::InvalidSubcommand);
        similar.extend(typed.iter().flat_map(|typed| names::nearest(typed, &commands)).map(str::to_owned));
    }
    let help = message!("shell-help-shows", "`{command} --help` shows how to use it", command = command(error));
    let problem = problem(error);
    if similar.is_empty() { names::hinted(&problem, &help) } else { names::meant(&problem, &similar).then(help) }
}

fn problem(error: &Error) -> Message {
    let typed = text(error, ContextKind::InvalidArg);
    match error.kind() {
        ErrorKind::InvalidSubcommand => {
            let name = quoted(&texts(error, ContextKind::InvalidSubcommand).concat());
            message!("shell-no-command", "{name} is not a command", name)
        }
        ErrorKind::MissingSubcommand => message!("shell-command-missing", "a command is missing"),
        ErrorKind::UnknownArgument if typed.starts_with('-') => message!("shell-no-option", "`{typed}` is not an option", typed),
        ErrorKind::UnknownArgument => message!("shell-argument-too-many", "{argument} is one argument too many", argument = quoted(&typed)),
        ErrorKind::MissingRequiredArgument => {
            let missing = texts(error, ContextKind::InvalidArg);
            let (names, are) = (quoted_names(&missing), missing.len());
            message!("shell-missing", "{names} {are} missing", names, are => "is" | "are")
        }
        ErrorKind::ArgumentConflict => conflict(error, &plain(&typed)),
        ErrorKind::InvalidValue | ErrorKind::ValueValidation => refused_value(error, &plain(&typed)),
        ErrorKind::TooManyValues => {
            let (arg, value) = (plain(&typed), quoted(&text(error, ContextKind::InvalidValue)));
            message!("shell-value-too-many", "`{arg}` has a value too many: {value}", arg, value)
        }
        ErrorKind::InvalidUtf8 => not_utf8(),
        other => Message::verbatim(other.to_string()),
    }
}

/// Arguments that exclude each other.
fn conflict(error: &Error, arg: &str) -> Message {
    match texts(error, ContextKind::PriorArg).as_slice() {
        [] => message!("shell-only-argument", "`{arg}` must be the only argument", arg),
        [other] if plain(other) == arg => message!("shell-given-twice", "`{arg}` is given twice", arg),
        others => message!("shell-cannot-be-used-with", "`{arg}` cannot be used with {others}", arg, others = quoted_names(others)),
    }
}

/// An argument with a value that is not allowed, or without one.
fn refused_value(error: &Error, arg: &str) -> Message {
    let value = text(error, ContextKind::InvalidValue);
    if error.kind() == ErrorKind::InvalidValue {
        let names = listed(&texts(error, ContextKind::ValidValue));
        return if value.is_empty() {
            message!("shell-needs-a-value", "`{arg}` needs a value", arg)
        } else {
            message!("shell-not-one-of", "`{arg}` is {value}; it must be one of {names}", arg, value, names)
        };
    }
    let why = std::error::Error::source(error).map_or(String::new(), ToString::to_string);
    let why = shorten(&why, 100);
    if value.is_empty() {
        message!("shell-empty-value", "`{arg}` is empty; {why}", arg, why)
    } else {
        message!("shell-wrong-value", "`{arg}` is {value}; {why}", arg, value, why)
    }
}

fn quoted_names(names: &[String]) -> String {
    listed(&names.iter().map(|name| quoted(&plain(name))).collect::<Vec<_>>())
}

/// The first of what clap says of a kind, shortened.
fn text(error: &Error, kind: ContextKind) -> String {
    texts(error, kind).first().map_or(String::new(), |text| shorten(text, 70))
}

/// An argument without the signs of a usage line: `--scene <FILE>` is `--scene`, `[NAME]` is `NAME`.
fn plain(arg: &str) -> String {
    let name = if arg.starts_with('-') { arg.split([' ', '=']).next().unwrap_or(arg) } else { arg };
    name.replace(['<', '>', '[', ']'], "").replace("...", "")
}

/// Which argument is not UTF-8. File names that are only written or opened may be anything.
fn not_utf8() -> Message {
    let typed: Vec<OsString> = std::env::args_os().skip(1).collect();
    let command = Cli::command();
    let subcommand = typed.iter().find_map(|name| command.find_subcommand(name)).unwrap_or(&command);
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
            Some(_) => {
                return message!("shell-value-not-utf8", "`{name}` is {value}; it must be valid UTF-8", name, value = shorten(value, 70));
            }
            None if subcommand.get_positionals().any(is_path) && !text.starts_with('-') => {}
            None => return message!("shell-argument-not-utf8", "the argument {argument} is not valid UTF-8", argument = quoted(&text)),
        }
    }
    message!("shell-some-argument-not-utf8", "an argument is not valid UTF-8")
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
    let command = Cli::command();
    let typed = std::env::args_os().skip(1).find_map(|typed| command.find_subcommand(typed).map(|command| command.get_name().to_owned()));
    typed.map_or_else(|| "forage".to_owned(), |name| format!("forage {name}"))
}
