//! The command line of Forage, as a library: [`main`] is the whole program `forage`.
//!
//! Exit codes: 0 a feasible result, 1 none found, 2 the input was refused (message on standard error, nothing on
//! standard output), 3 a file could not be read or written, though it is there and may be (a full disk, another `forage` that
//! writes it: the same command may do later), 130 an experiment was interrupted (what is finished is kept).
#![cfg(not(target_arch = "wasm32"))]

mod args;
mod convert;
mod exact;
mod experiment;
mod generate;
mod interrupt;
mod list;
mod load;
mod progress;
mod reproduce;
mod run;
mod suggest;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};

/// What a command ended with.
type Outcome = Result<ExitCode, Failure>;

/// Why a command did not do what it was asked.
enum Failure {
    /// The input was refused: exit code 2.
    Refused(forage::Error),
    /// A file could not be read or written.
    File(String, std::io::Error),
    /// Ctrl-C ended an experiment: exit code 130, as shells have it.
    Interrupted(String),
}

impl Failure {
    fn code(&self) -> u8 {
        use std::io::ErrorKind::{AlreadyExists, InvalidInput, IsADirectory, NotADirectory, NotFound, PermissionDenied};
        match self {
            Self::Refused(_) => 2,
            // What was asked for cannot be: it is the same the next time.
            Self::File(_, error) => match error.kind() {
                NotFound | PermissionDenied | IsADirectory | NotADirectory | AlreadyExists | InvalidInput => 2,
                _ => 3,
            },
            Self::Interrupted(_) => 130,
        }
    }
}

impl From<forage::Error> for Failure {
    fn from(error: forage::Error) -> Self {
        Self::Refused(error)
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Refused(error) => error.fmt(f),
            Self::File(path, error) => write!(f, "{path}: {error}"),
            Self::Interrupted(message) => f.write_str(message),
        }
    }
}

/// Runs the command line and says how it went.
pub fn main() -> ExitCode {
    let outcome = match Cli::parse().command {
        Command::List { json } => {
            list::list(json);
            Ok(ExitCode::SUCCESS)
        }
        Command::Run(args) => run::run(&args),
        Command::Suggest { planner, scene, set, json } => suggest::suggest(planner, &scene, &set, json),
        Command::Exact { scene, json } => exact::exact(&scene, json),
        Command::Convert(args) => convert::convert(&args),
        Command::Generate(args) => generate::generate(&args),
        Command::Reproduce(args) => reproduce::reproduce(args),
        Command::Experiment(args) => experiment::experiment(&args),
    };
    outcome.unwrap_or_else(|failure| {
        eprintln!("forage: {failure}");
        ExitCode::from(failure.code())
    })
}

/// Prints to standard output; a reader that has gone away (`forage list | head`) is no error.
fn print(text: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stdout(), "{}", text.trim_end());
}

fn print_json(value: &impl serde::Serialize) {
    // Everything that is printed is made of plain numbers and texts: this cannot fail. NaN becomes null.
    print(&serde_json::to_string_pretty(value).unwrap_or_default());
}
