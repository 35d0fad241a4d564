//! What clap says by itself, and what is said of an option's values.

use clap::Arg;
use forage::message;

use crate::text::listed;

pub(super) const ARGUMENTS: &str = "Arguments";
pub(super) const COMMANDS: &str = "Commands";
pub(super) const OPTIONS: &str = "Options";
pub(super) const USAGE: &str = "Usage:";
pub(super) const HELP: &str = "Print help";
pub(super) const MORE_HELP: &str = "Print help (see more with '--help')";
pub(super) const LESS_HELP: &str = "Print help (see a summary with '-h')";
pub(super) const VERSION: &str = "Print version";
pub(super) const HELP_COMMAND: &str = "Print this message or the help of the given subcommand(s)";
pub(super) const HELP_OF: &str = "Print help for the subcommand(s)";
pub(super) const OWN: [&str; 10] = [ARGUMENTS, COMMANDS, OPTIONS, USAGE, HELP, MORE_HELP, LESS_HELP, VERSION, HELP_COMMAND, HELP_OF];

/// What is said of an option's default and of its possible values.
pub(super) fn notes(arg: &Arg) -> String {
    let mut notes = String::new();
    if !arg.get_action().takes_values() {
        return notes;
    }
    let defaults: Vec<_> = arg.get_default_values().iter().map(|value| value.to_string_lossy()).collect();
    if !arg.is_hide_default_value_set() && !defaults.is_empty() {
        notes += &message!("shell-default", "[default: {values}]", values = listed(&defaults)).text();
    }
    let possible: Vec<_> = arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
    if !arg.is_hide_possible_values_set() && !possible.is_empty() {
        notes += &message!("shell-possible-values", "[possible values: {values}]", values = listed(&possible)).text();
    }
    notes
}
