//! The command line of Forage, for any registry: [`main_with`] is a whole program.
//!
//! `forage` itself is `forage_cli::main_with(Registry::standard())`. A program with a planner of its own adds a line:
//!
//! ```no_run
//! use forage::{Registry, describe::Entry, kernel::Error, message};
//!
//! /// What there is to know of the planner.
//! const ENTRY: Entry = Entry::new("mine", "My planner", "", "What it does.", |_| {
//!     Err(Error::refused("planner", "mine", message!("mine-unfinished", "a planner that is finished")))
//! });
//!
//! fn main() -> std::process::ExitCode {
//!     forage_cli::main_with(Registry::standard().with(&ENTRY))
//! }
//! ```
//!
//! Exit codes: 0 a feasible result; 1 none was found; 2 the input was refused (message on standard error, nothing on standard
//! output); 3 a file cannot be read or written now (a full disk, another `forage` that writes it), so the same command may
//! succeed later; 130 an experiment was interrupted (finished runs are kept, except of a sample).
//!
//! Inside: `args` says what there is, a file a command does it. `names` completes and corrects names; `load` turns arguments into
//! scenes and setups.

mod args;
mod bench;
mod convert;
mod exact;
mod examples;
mod experiment;
mod failure;
mod files;
mod generate;
mod grade;
mod help;
mod install;
mod interrupt;
mod kinds;
mod language;
mod list;
mod load;
mod names;
mod output;
mod progress;
mod registry;
mod reproduce;
mod run;
mod suggest;
mod text;
mod usage;

use std::process::ExitCode;

use clap::FromArgMatches;
use forage::{Registry, message};

use args::{Cli, Command};
use failure::Failure;

/// Runs the command line with the planners, scenes, generators and followers of a registry, and returns its exit code. In one
/// process the registry of the first call counts.
pub fn main_with(known: Registry) -> ExitCode {
    registry::know(known);
    language::choose();
    let matched = help::command().try_get_matches();
    let command = match matched.and_then(|matches| Cli::from_arg_matches(&matches)) {
        Ok(cli) => cli.command,
        Err(error) => return usage::report(&error),
    };
    forage_isolate::watch(|| {
        output::report(&Failure::Refused(message!(
            "shell-unstoppable",
            "code: it took longer than 900 ms and could not be stopped: something built in took several seconds"
        )));
        std::process::exit(2);
    });
    let outcome = match command {
        Command::List(args) => list::list(&args),
        Command::Run(args) => run::run(&args),
        Command::Suggest(args) => suggest::suggest(args),
        Command::Exact(args) => exact::exact(&args.scene, args.json),
        Command::Convert(args) => convert::convert(&args),
        Command::Generate(args) => generate::generate(&args),
        Command::Grade(args) => grade::grade(&args),
        Command::Reproduce(args) => reproduce::reproduce(args),
        Command::Study(args) => reproduce::study(args),
        Command::Experiment(args) => experiment::experiment(&args),
        Command::Bench(args) => bench::bench(&args),
        Command::Completions { shell } => install::completions(shell),
        Command::Man { out } => install::man(out.as_deref()),
        Command::Licenses => install::licenses(),
    };
    outcome.unwrap_or_else(|failure| output::report(&failure))
}
