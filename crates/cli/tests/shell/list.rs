//! `forage list`.

use serde_json::{Value, value::RawValue};

use crate::support::{command, empty_folder, forage, text};

fn catalogue() -> Value {
    serde_json::from_slice(&forage(&["list", "--json"]).stdout).unwrap()
}

fn names(catalogue: &Value, part: &str) -> Vec<String> {
    catalogue[part].as_array().unwrap().iter().map(|entry| entry["name"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn the_overview_has_one_aligned_line_per_name() {
    let catalogue = catalogue();
    for (columns, most) in [("80", 80), ("100", 100), ("300", 100), ("60", 60)] {
        let output = command(&["list"]).env("COLUMNS", columns).output().unwrap();
        let overview = text(&output.stdout);
        for name in ["planners", "generators", "scenes"].iter().flat_map(|part| names(&catalogue, part)) {
            let lines: Vec<_> = overview.lines().filter(|line| line.starts_with(&format!("  {name}  "))).collect();
            assert_eq!(lines.len(), 1, "{name}");
            assert!(lines[0].chars().nth(20) == Some(' ') && lines[0].chars().nth(21) != Some(' '), "{}", lines[0]);
        }
        assert!(overview.lines().all(|line| line.chars().count() <= most), "{columns}: {overview}");
        assert!(overview.contains("Planners: particle swarms\n  pso ") && overview.contains("Scenes: grids\n"), "{overview}");
    }
}

#[test]
fn every_name_has_a_page_whose_examples_work() {
    let catalogue = catalogue();
    let folder = empty_folder("list");
    for part in ["planners", "generators", "scenes"] {
        for name in names(&catalogue, part) {
            let output = forage(&["list", &name]);
            let page = text(&output.stdout);
            assert_eq!(output.status.code(), Some(0), "{name}");
            assert!(page.starts_with(&format!("{name}: ")) && page.lines().all(|line| line.chars().count() <= 100), "{page}");
            // A shipped scene's examples run a planner that has an example of its own.
            let examples = page.lines().filter_map(|line| line.strip_prefix("  forage ")).filter(|_| part != "scenes");
            for example in examples {
                let args: Vec<&str> = example.split(' ').collect();
                let output = command(&args).current_dir(&folder).output().unwrap();
                assert_eq!(output.status.code(), Some(0), "{example}: {}{}", text(&output.stdout), text(&output.stderr));
            }
        }
    }
    for name in ["drive", "motion"] {
        let page = text(&forage(&["list", name]).stdout);
        assert!(page.contains(&format!("--{name}-set NAME=VALUE")) && page.contains("Columns of the CSV file"), "{page}");
    }
}

#[test]
fn a_page_names_ranges_defaults_readings_and_conditions() {
    let page = text(&forage(&["list", "wcpso"]).stdout);
    for part in [
        "[WCPSO] §2",
        "discs, grid, function",
        "population      ",
        "default 150 on discs, 150 on grid, 60 on function",
        "only if initial=normal",
        "w_max           a number from 0 to 1.5; default 0.95",
        "Inertia weight.",
        "  forage run wcpso --scene wcpso-discs",
    ] {
        assert!(page.contains(part), "{part}: {page}");
    }
    let scene = text(&forage(&["list", "qpso-10m"]).stdout);
    for part in ["grid, 20 × 20 cells", "Planners that run on it", "ltqpso", "forage exact --scene qpso-10m"] {
        assert!(scene.contains(part), "{part}: {scene}");
    }
}

/// The same fields in the same order with the same digits as in the whole catalogue.
#[test]
fn one_entry_as_json_is_that_of_the_catalogue() {
    let whole = text(&forage(&["list", "--json"]).stdout);
    let compact = |text: &str| text.split('\n').map(str::trim_start).collect::<String>();
    let all = compact(&whole);
    let value: Value = serde_json::from_str(&whole).unwrap();
    for part in ["planners", "generators", "scenes"] {
        for name in names(&value, part) {
            let entry = text(&forage(&["list", &name, "--json"]).stdout);
            serde_json::from_str::<&RawValue>(entry.trim()).unwrap();
            assert!(entry.starts_with("{\n  \"") && all.contains(&compact(&entry)), "{name}: {entry}");
            assert_eq!(serde_json::from_str::<Value>(&entry).unwrap()["name"], *name);
        }
    }
    for name in ["drive", "motion"] {
        let entry: Value = serde_json::from_slice(&forage(&["list", name, "--json"]).stdout).unwrap();
        assert_eq!(entry, value[name]);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_error_and_a_full_disk_is_one() {
    #[cfg(target_os = "linux")]
    for (shell, code) in [("\"$0\" list | head -n 1 >&2", 0), ("\"$0\" list > /dev/full", 3)] {
        let output = std::process::Command::new("sh").args(["-c", shell, env!("CARGO_BIN_EXE_forage")]).output().unwrap();
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{shell}: {message}");
        assert!(!message.contains("panicked"), "{message}");
    }
}
