//! Pages of help in lines that fit, whatever the script.

use clap::{Arg, ArgAction, Command};
use forage::message;

use super::words::{ARGUMENTS, COMMANDS, HELP, LESS_HELP, MORE_HELP, OPTIONS, USAGE, notes};
use crate::{
    language::say,
    text::{columns, padded, wide, wrap},
};

/// Where what is said of an option begins if its name leaves no room next to it.
const BELOW: usize = 10;

/// A heading, underlined on a terminal that can do that.
fn heading(text: &str) -> String {
    format!("\u{1b}[1m\u{1b}[4m{text}\u{1b}[0m")
}

/// A command's page; `long`: as `--help` has it.
pub(super) fn page(command: &mut Command, long: bool) -> String {
    let mut blocks = Vec::new();
    let about = command.get_long_about().filter(|_| long).or(command.get_about());
    blocks.extend(about.map(|about| paragraphs(&about.to_string(), 0)));
    let usage = command.render_usage().to_string();
    let usage = usage.trim_start_matches("Usage:").lines().map(str::trim).collect::<Vec<_>>().join("\n      ");
    let title = heading(say(USAGE, ""));
    blocks.push(message!("shell-usage", "{title} {usage}", title, usage).to_string());
    let commands = command.get_subcommands().filter(|command| !command.is_hide_set());
    let commands = commands.map(|command| {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        (command.get_name().to_owned(), about)
    });
    let commands: Vec<_> = commands.collect();
    blocks.extend(section(command.get_subcommand_help_heading().unwrap_or(COMMANDS), &commands));
    let more = command.get_long_about().is_some() || command.get_arguments().any(|arg| arg.get_long_help().is_some());
    let of = |positional: bool| -> Vec<_> {
        let some = command.get_arguments().filter(|arg| arg.is_positional() == positional && !arg.is_hide_set());
        some.map(|arg| (name(arg), said(arg, long, more))).collect()
    };
    blocks.extend(section(ARGUMENTS, &of(true)));
    blocks.extend(section(OPTIONS, &of(false)));
    blocks.extend(command.get_after_help().map(|after| after.to_string().lines().map(example).collect::<Vec<_>>().join("\n")));
    blocks.join("\n\n") + "\n"
}

/// A text by its paragraphs.
fn paragraphs(text: &str, indent: usize) -> String {
    let between = format!("\n\n{}", " ".repeat(indent));
    text.split("\n\n").map(|part| wrap(part, columns(), indent)).collect::<Vec<_>>().join(&between)
}

/// Names and what is said of them, below a heading.
fn section(title: &str, entries: &[(String, String)]) -> Option<String> {
    let longest = entries.iter().map(|(name, _)| wide(name)).max()?;
    let next_to = longest + 4 <= columns() * 2 / 5;
    let line = |(name, said): &(String, String)| {
        if next_to {
            return format!("  {}  {}", padded(name, longest), paragraphs(said, longest + 4)).trim_end().to_owned();
        }
        format!("  {name}\n{}{}", " ".repeat(BELOW), paragraphs(said, BELOW))
    };
    let lines: Vec<String> = entries.iter().map(line).collect();
    Some(format!("{}\n{}", heading(&message!("shell-heading", "{title}:", title = say(title, "")).text()), lines.join("\n")))
}

/// An argument as a line begins with it: `-h, --help`, `    --scene <FILE>`, `[NAME]`.
fn name(arg: &Arg) -> String {
    match arg.get_short() {
        _ if arg.is_positional() => arg.to_string(),
        Some(short) => format!("-{short}, {arg}"),
        None => format!("    {arg}"),
    }
}

/// What is said of an argument; `more`: whether `--help` says more than `-h`.
fn said(arg: &Arg, long: bool, more: bool) -> String {
    if matches!(arg.get_action(), ArgAction::Help) {
        let text = if !more {
            HELP
        } else if long {
            LESS_HELP
        } else {
            MORE_HELP
        };
        return say(text, "").to_owned();
    }
    let help = arg.get_long_help().filter(|_| long).or(arg.get_help());
    help.map(ToString::to_string).unwrap_or_default() + &notes(arg)
}

/// A line of examples. A command that is too long goes on in the next line, and what is said of it stands above it.
fn example(line: &str) -> String {
    if wide(line) <= columns() {
        return line.to_owned();
    }
    if let Some((command, said)) = line.split_once("# ") {
        return format!("  # {said}\n{}", example(command.trim_end()));
    }
    let Some(command) = line.strip_prefix("  ") else { return wrap(line, columns(), 0) };
    match command.split_once("  ") {
        Some((name, said)) => {
            let indent = line.len() - said.trim_start().len();
            format!("  {name}{}{}", " ".repeat(indent - 2 - name.len()), wrap(said, columns(), indent))
        }
        None => format!("  {}", wrap(command, columns() - 2, 6).replace('\n', " \\\n")),
    }
}
