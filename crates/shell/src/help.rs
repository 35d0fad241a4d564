//! The commands' help in the language that is printed. Its English is in the commands themselves, and is laid out by clap; help in
//! other languages is laid out here: clap breaks lines at spaces only.

mod layout;
mod words;

use std::collections::BTreeSet;

use clap::{Arg, Command, CommandFactory, builder::StyledStr};
use forage_languages::speaker;
use forage_study::{
    registry::{REPRODUCTIONS, STUDIES},
    words::WORDS,
};

use self::words::OWN;
use super::{args::Cli, language::say, registry::registry};

/// What the notes of generators say, and which formula suggests sizes.
const NOTES: [&str; 5] = [
    "[LTQPSO] ({1})",
    "There are {1} discs, not {2}: there is room for no more.",
    "There are {1} stops, not {2}: there is room for no more.",
    "There are {1} moving obstacles, not {2}: there is no room for more clear of the start.",
    "{1} of {2} cells are blocked, not {3}: more would leave no way from start to goal.",
];

/// The commands with their help in the language that is printed.
pub(super) fn command() -> Command {
    let mut command = Cli::command();
    if speaker().is_none() {
        return command;
    }
    command.build();
    laid_out(translated(command))
}

/// The same with texts that nothing is done to, as manual pages have them.
pub(super) fn described() -> Command {
    let command = Cli::command();
    if speaker().is_none() { command } else { translated(command) }
}

/// All texts of help, and those of what there is that the catalogue does not have, for translators: each once, in their order.
pub(super) fn texts() -> Vec<String> {
    let mut all: Vec<String> = OWN.iter().chain(&NOTES).map(|&text| text.to_owned()).collect();
    collect(&Cli::command(), &mut all);
    for entry in registry().planners() {
        all.extend([entry.evaluation, entry.source].map(str::to_owned));
    }
    for follower in registry().followers() {
        all.extend([follower.title, follower.needs, follower.source].map(str::to_owned));
    }
    let sources = registry().scenes().iter().filter_map(|scene| scene.header().source.clone());
    // Some are commands.
    all.extend(sources.filter(|source| !source.starts_with("forage ")));
    for study in REPRODUCTIONS.iter().chain(STUDIES) {
        all.extend([study.title, study.source].map(str::to_owned));
    }
    all.extend(WORDS.iter().map(|&word| word.to_owned()));
    let mut seen = BTreeSet::new();
    all.retain(|text| !text.is_empty() && seen.insert(text.clone()));
    all
}

fn collect(command: &Command, all: &mut Vec<String>) {
    let abouts = [command.get_about(), command.get_long_about()];
    all.extend(abouts.into_iter().flatten().flat_map(paragraphs));
    all.extend(command.get_subcommand_help_heading().map(str::to_owned));
    let after = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    all.extend(after.lines().filter_map(|line| parts(line).1).map(str::to_owned));
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
fn examples(text: &str) -> String {
    let line = |line: &str| match parts(line) {
        (before, Some(said)) => format!("{before}{}", say(said, "")),
        (line, None) => line.to_owned(),
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// A text by its paragraphs.
fn plain(text: &StyledStr) -> String {
    paragraphs(text).iter().map(|part| say(part, "").to_owned()).collect::<Vec<_>>().join("\n\n")
}

/// Every text of a command and of those below it.
fn translated(mut command: Command) -> Command {
    if let Some(about) = command.get_about().map(plain) {
        command = command.about(about);
    }
    if let Some(about) = command.get_long_about().map(plain) {
        command = command.long_about(about);
    }
    if let Some(after) = command.get_after_help().map(|after| examples(&after.to_string())) {
        command = command.after_help(after);
    }
    if let Some(heading) = command.get_subcommand_help_heading().map(|heading| say(heading, "").to_owned()) {
        command = command.subcommand_help_heading(heading);
    }
    command.mut_args(argument).mut_subcommands(translated)
}

fn argument(arg: Arg) -> Arg {
    let (help, long) = (arg.get_help().map(plain), arg.get_long_help().map(plain));
    let arg = if let Some(help) = help { arg.help(help) } else { arg };
    if let Some(long) = long { arg.long_help(long) } else { arg }
}

/// Has a command and those below it print pages of their own instead of clap's.
fn laid_out(mut command: Command) -> Command {
    let [short, long] = [false, true].map(|long| layout::page(&mut command, long));
    command.before_help(short).before_long_help(long).help_template("{before-help}").mut_subcommands(laid_out)
}
