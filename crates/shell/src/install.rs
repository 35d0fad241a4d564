//! `forage completions`, `forage man` and `forage licenses`: what belongs to an installed program.

use std::{path::Path, process::ExitCode};

use clap::{Command, CommandFactory, builder::Resettable};
use forage::message;

use forage_study::disk;

use super::{
    args::Cli,
    failure::{Failure, Outcome},
    files, help,
    output::{note, print_raw},
    text::quoted,
};

/// What the pages belong to.
const SOURCE: &str = concat!("forage ", env!("CARGO_PKG_VERSION"));

const THIRD_PARTY: &str = include_str!("../THIRD-PARTY.md");

/// Prints a completion script: a program, which is in English.
pub(super) fn completions(shell: clap_complete::Shell) -> Outcome {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "forage", &mut script);
    print_raw(script.trim_ascii_end())?;
    Ok(ExitCode::SUCCESS)
}

/// Prints the manual page, or writes one page per subcommand into a folder.
pub(super) fn man(folder: Option<&Path>) -> Outcome {
    // `forage help` has nothing to say about itself.
    let mut command = help::described().disable_help_subcommand(true);
    command.build();
    let Some(folder) = folder else {
        print_raw(page(command)?.trim_ascii_end())?;
        return Ok(ExitCode::SUCCESS);
    };
    files::check_folder("--out", folder)?;
    disk::make_folder(folder).map_err(|error| Failure::write(folder, error))?;
    let mut commands = vec![command];
    let mut next = 0;
    while let Some(command) = commands.get(next) {
        let below: Vec<_> =
            command.get_subcommands().filter(|command| !command.is_hide_set() && command.get_name() != "help").cloned().collect();
        commands.extend(below);
        next += 1;
    }
    let count = commands.len();
    for command in commands {
        let name = command.get_display_name().unwrap_or_else(|| command.get_name()).to_owned();
        files::write(&folder.join(format!("{name}.1")), page(command)?)?;
    }
    let folder = quoted(&folder.to_string_lossy());
    note(message!("shell-wrote-pages", "wrote {count} manual pages to {folder}", count, folder));
    Ok(ExitCode::SUCCESS)
}

/// A manual page. Its examples keep their lines.
fn page(command: Command) -> Result<Vec<u8>, Failure> {
    let examples = command.get_after_help().map_or(String::new(), ToString::to_string);
    let mut page = Vec::new();
    let rendered = clap_mangen::Man::new(command.after_help(Resettable::Reset)).source(SOURCE).render(&mut page);
    rendered.map_err(|error| Failure::File(message!("shell-manual-page", "manual page").to_string(), error))?;
    page.extend(b".SH EXAMPLES\n.nf\n");
    for line in examples.lines() {
        // A line that begins with a point or an apostrophe would be a request.
        let line = line.replace('\\', "\\e").replace('-', "\\-");
        page.extend(format!("\\&{line}\n").bytes());
    }
    page.extend(b".fi\n");
    Ok(page)
}

/// Prints Forage's licence and third-party notices.
pub(super) fn licenses() -> Outcome {
    let own = "Forage: MIT OR Apache-2.0. Copyright (c) The Forage authors.";
    print_raw(format!("{own}\n\n{}", THIRD_PARTY.trim_end()).as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
