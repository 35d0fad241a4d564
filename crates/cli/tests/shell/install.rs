//! `forage completions`, `forage man` and `forage licenses`.

use crate::support::{empty_folder, forage, text};

#[test]
fn completions_know_commands_options_and_planners() {
    for (shell, planners) in [("bash", true), ("zsh", true), ("fish", false), ("elvish", false), ("powershell", false)] {
        let output = forage(&["completions", shell]);
        let script = text(&output.stdout);
        assert!(output.status.success() && output.stderr.is_empty(), "{shell}");
        assert!(["experiment", "--drive-set"].iter().all(|name| script.contains(name)) || shell == "fish", "{shell}");
        assert!(script.contains("reproduce") && (!planners || script.contains("d-star-lite-drive")), "{shell}");
    }
    // Links and files are still taken.
    let link = forage(&["run", "#v=1&planner=wcpso&scene=sphere-2&seed=7&at=2"]);
    assert_eq!(link.status.code(), Some(0), "{}", text(&link.stderr));
    #[cfg(unix)]
    {
        let script = empty_folder("completions").join("forage.bash");
        std::fs::write(&script, forage(&["completions", "bash"]).stdout).unwrap();
        let checked = std::process::Command::new("bash").args(["-n", script.to_str().unwrap()]).status();
        assert!(checked.is_ok_and(|status| status.success()));
    }
}

#[test]
fn there_is_a_manual_page_for_each_command() {
    let page = text(&forage(&["man"]).stdout);
    assert!(page.contains(".TH forage 1") && page.contains("forage\\-run(1)"), "{page}");
    let folder = empty_folder("man");
    let output = forage(&["man", "--out", folder.to_str().unwrap()]);
    assert!(output.status.success() && output.stdout.is_empty());
    let count = std::fs::read_dir(&folder).unwrap().count();
    assert!(text(&output.stderr).contains(&format!("wrote {count} manual pages")), "{}", text(&output.stderr));
    assert!(["forage.1", "forage-bench.1", "forage-bench-bbob.1"].iter().all(|page| folder.join(page).exists()));
    let run = std::fs::read_to_string(folder.join("forage-run.1")).unwrap();
    assert!(run.contains(concat!("\"forage ", env!("CARGO_PKG_VERSION"), "\"")), "{run}");
    assert!(run.contains("forage\\-run") && run.contains("\\-\\-drive\\-set"), "{run}");
    let lines: Vec<_> = run.lines().collect();
    let example = lines.iter().position(|line| line.contains("forage run wcpso \\-\\-scene wcpso\\-discs")).unwrap();
    assert!(lines[..example].contains(&".nf"), "examples keep their lines");
}

#[test]
fn licenses_are_our_own_and_those_of_others() {
    let notices = text(&forage(&["licenses"]).stdout);
    assert!(notices.starts_with("Forage: MIT OR Apache-2.0"), "{notices}");
    assert!(notices.contains("# Third-party notices") && notices.contains("\n- clap ") && notices.contains("Permission is hereby granted"));
    for name in ["clap", "nalgebra", "rayon", "serde_json", "strsim"] {
        assert!(notices.contains(name), "{name}");
    }
}
