//! `--help`: a purpose, options, and examples that work.

use std::process::Command;

use crate::support::{command, empty_folder, forage, text};

const COMMANDS: [&str; 12] =
    ["list", "run", "suggest", "exact", "convert", "generate", "reproduce", "study", "experiment", "completions", "man", "licenses"];

/// The lines below `Examples:` or the like.
fn examples(help: &str) -> Vec<String> {
    let lines = help.lines().skip_while(|line| !matches!(*line, "Examples:" | "Example:" | "Quick start:")).skip(1);
    lines.take_while(|line| line.starts_with("  ")).map(|line| line.trim().to_owned()).collect()
}

#[test]
fn every_command_says_what_it_is_for_and_is_in_the_overview() {
    let overview = text(&forage(&["--help"]).stdout);
    assert!(overview.contains("Quick start:") && overview.contains("forage run wcpso --scene wcpso-discs"), "{overview}");
    for name in COMMANDS {
        let output = forage(&[name, "--help"]);
        let help = text(&output.stdout);
        let purpose = help.lines().next().unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert!(purpose.starts_with(char::is_uppercase) && help.contains("Usage: forage "), "{name}: {help}");
        assert!(overview.contains(&format!("\n  {name} ")), "{name}: {overview}");
        assert!(!examples(&help).is_empty(), "{name}: {help}");
    }
}

#[test]
fn help_is_a_command_too() {
    for (args, same) in [(&["help"] as &[&str], &["--help"] as &[&str]), (&["help", "run"], &["run", "--help"])] {
        let [help, same] = [args, same].map(forage);
        assert_eq!((help.status.code(), help.stderr.len()), (Some(0), 0), "{args:?}");
        assert_eq!(text(&help.stdout), text(&same.stdout), "{args:?}");
    }
}

#[cfg(unix)]
#[test]
fn every_example_works_in_an_empty_folder() {
    let folder = empty_folder("help");
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_forage")).parent().unwrap();
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap());
    let mut count = 0;
    for args in [vec!["--help"]].into_iter().chain(COMMANDS.map(|name| vec![name, "--help"])) {
        for example in examples(&text(&forage(&args).stdout)) {
            let output = Command::new("sh").args(["-c", &example]).current_dir(&folder).env("PATH", &path).output().unwrap();
            assert_eq!(output.status.code(), Some(0), "{example}: {}{}", text(&output.stdout), text(&output.stderr));
            count += 1;
        }
    }
    assert!(count > 40, "{count} examples");
}

#[test]
fn without_arguments_there_is_help_and_in_a_narrow_terminal_it_fits() {
    let output = forage(&[]);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
    assert!(text(&output.stderr).contains("Quick start:"));
    for name in COMMANDS {
        let output = command(&[name, "--help"]).env("COLUMNS", "60").env("NO_COLOR", "1").output().unwrap();
        let help = text(&output.stdout);
        let options = help.lines().take_while(|line| !line.ends_with("xamples:"));
        assert!(options.into_iter().all(|line| line.chars().count() <= 60 || line.starts_with("Usage:")), "{help}");
        assert!(!help.contains('\u{1b}'));
    }
}
