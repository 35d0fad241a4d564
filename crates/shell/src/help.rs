//! The commands' help in the language that is printed. Its English is in the commands themselves.

use std::collections::BTreeSet;

use clap::{Arg, ArgAction, Command, CommandFactory, builder::StyledStr};
use forage_languages::speaker;

use super::{
    args::Cli,
    language::say,
    text::{columns, wrap},
};

/// What clap itself says.
const ARGUMENTS: &str = "Arguments";
const COMMANDS: &str = "Commands";
const OPTIONS: &str = "Options";
const USAGE: &str = "Usage:";
const HELP: &str = "Print help";
const VERSION: &str = "Print version";
const DEFAULT: &str = "Default:";
const ONE_OF: &str = "One of:";
const OWN: [&str; 8] = [ARGUMENTS, COMMANDS, OPTIONS, USAGE, HELP, VERSION, DEFAULT, ONE_OF];
/// The long help of an option begins in this column.
const INDENT: usize = 10;

/// The commands with their help in the language that is printed.
pub(super) fn command() -> Command {
    let command = Cli::command();
    if speaker().is_none() { command } else { translated(command.disable_help_subcommand(true)) }
}

/// All texts of help, for translators: each once, in their order.
pub(super) fn texts() -> Vec<String> {
    let mut all: Vec<String> = OWN.iter().map(|&text| text.to_owned()).collect();
    collect(&Cli::command(), &mut all);
    let mut seen = BTreeSet::new();
    all.retain(|text| seen.insert(text.clone()));
    all
}

fn collect(command: &Command, all: &mut Vec<String>) {
    let abouts = [command.get_about(), command.get_long_about()];
    all.extend(abouts.into_iter().flatten().flat_map(paragraphs));
    all.extend(command.get_subcommand_help_heading().map(str::to_owned));
    let after = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    all.extend(after.lines().flat_map(|line| parts(line).1).map(str::to_owned));
    for arg in command.get_arguments() {
        all.extend(arg.get_help_heading().map(str::to_owned));
        all.extend([arg.get_help(), arg.get_long_help()].into_iter().flatten().flat_map(paragraphs));
    }
    for command in command.get_subcommands() {
        collect(command, all);
    }
}

/// The paragraphs of a text.
fn paragraphs(text: &StyledStr) -> Vec<String> {
    text.to_string().split("\n\n").map(str::to_owned).collect()
}

/// What a line of examples begins with, and what it says: a whole line, or what follows a command.
fn parts(line: &str) -> (&str, Option<&str>) {
    match line.split_once("# ") {
        Some((before, said)) => (&line[..before.len() + 2], Some(said)),
        None if line.is_empty() || line.starts_with(' ') => (line, None),
        None => ("", Some(line)),
    }
}

/// Examples with what they say in the language that is printed.
pub(super) fn examples(text: &str) -> String {
    let line = |line: &str| match parts(line) {
        (before, Some(said)) => format!("{before}{}", say(said, "")),
        (line, None) => line.to_owned(),
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// A text by its paragraphs, in lines that fit: Han has no spaces, at which clap would break it.
fn told(text: &StyledStr, indent: usize) -> String {
    let wide = columns().saturating_sub(indent);
    paragraphs(text).iter().map(|part| wrap(say(part, ""), wide, 0)).collect::<Vec<_>>().join("\n\n")
}

fn translated(mut command: Command) -> Command {
    let template = format!("{{before-help}}{{about-with-newline}}\n{} {{usage}}\n\n{{all-args}}{{after-help}}", say(USAGE, ""));
    if let Some(about) = command.get_about().map(|about| told(about, 0)) {
        command = command.about(about);
    }
    if let Some(about) = command.get_long_about().map(|about| told(about, 0)) {
        command = command.long_about(about);
    }
    if let Some(after) = command.get_after_help().map(|after| examples(&after.to_string())) {
        command = command.after_help(after);
    }
    let heading = say(command.get_subcommand_help_heading().unwrap_or(COMMANDS), "").to_owned();
    let help = Arg::new("help").short('h').long("help").action(ArgAction::Help).help(say(HELP, "").to_owned());
    let version = Arg::new("version").short('V').long("version").action(ArgAction::Version).help(say(VERSION, "").to_owned());
    let option = say(OPTIONS, "").to_owned();
    command = command.help_template(template).subcommand_help_heading(heading).mut_args(argument).mut_subcommands(translated);
    command = command.disable_help_flag(true).arg(help.help_heading(option.clone()));
    command.disable_version_flag(true).arg(version.help_heading(option))
}

fn argument(arg: Arg) -> Arg {
    let heading = arg.get_help_heading().unwrap_or(if arg.is_positional() { ARGUMENTS } else { OPTIONS });
    let heading = say(heading, "").to_owned();
    let mut notes = String::new();
    let takes_values = arg.get_action().takes_values();
    if takes_values && !arg.is_hide_default_value_set() && !arg.get_default_values().is_empty() {
        let values: Vec<_> = arg.get_default_values().iter().map(|value| value.to_string_lossy().into_owned()).collect();
        notes += &format!(" {} {}", say(DEFAULT, ""), values.join(", "));
    }
    if takes_values && !arg.is_hide_possible_values_set() {
        let values: Vec<_> = arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
        if !values.is_empty() {
            notes += &format!(" {} {}", say(ONE_OF, ""), values.join(", "));
        }
    }
    let help = arg.get_help().map(|text| say(&text.to_string(), "").to_owned() + &notes);
    let long = arg.get_long_help().or(arg.get_help()).map(|text| told(text, INDENT) + &notes);
    let arg = arg.help_heading(heading);
    let arg = if takes_values { arg.hide_default_value(true).hide_possible_values(true) } else { arg };
    let arg = if let Some(help) = help { arg.help(help) } else { arg };
    if let Some(long) = long { arg.long_help(long) } else { arg }
}
