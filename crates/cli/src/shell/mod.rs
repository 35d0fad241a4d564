//! The command line of Forage: [`main`] is the whole program `forage`.
//!
//! Exit codes: 0 a feasible result; 1 none was found; 2 the input was refused (message on standard error, nothing on standard
//! output); 3 a file cannot be read or written now (a full disk, another `forage` that writes it), so the same command may
//! succeed later; 130 an experiment was interrupted (finished runs are kept, except of a sample).

mod args;
mod convert;
mod exact;
mod examples;
mod experiment;
mod failure;
mod files;
mod generate;
mod install;
mod interrupt;
mod list;
mod load;
mod names;
mod output;
mod progress;
mod reproduce;
mod run;
mod suggest;
mod text;
mod usage;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};

/// Runs the command line and returns its exit code.
pub fn main() -> ExitCode {
    let command = match Cli::try_parse() {
        Ok(cli) => cli.command,
        Err(error) => return usage::report(&error),
    };
    let outcome = match command {
        Command::List(args) => list::list(&args),
        Command::Run(args) => run::run(&args),
        Command::Suggest(args) => suggest::suggest(args),
        Command::Exact(args) => exact::exact(&args.scene, args.json),
        Command::Convert(args) => convert::convert(&args),
        Command::Generate(args) => generate::generate(&args),
        Command::Reproduce(args) => reproduce::reproduce(args),
        Command::Study(args) => reproduce::study(args),
        Command::Experiment(args) => experiment::experiment(&args),
        Command::Completions { shell } => install::completions(shell),
        Command::Man { out } => install::man(out.as_deref()),
        Command::Licenses => install::licenses(),
    };
    outcome.unwrap_or_else(|failure| output::report(&failure))
}
