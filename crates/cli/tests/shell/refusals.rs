//! Refusals: short, in one line, without control characters, and with what was probably meant.

use std::{fs, path::Path};

use crate::support::{command, empty_folder, forage, text};

/// The message of a refusal without `forage: `.
fn refusal(folder: &Path, args: &[&str]) -> String {
    let output = command(args).current_dir(folder).output().unwrap();
    let shown: Vec<String> = args.iter().map(|arg| arg.chars().take(60).collect()).collect();
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{shown:?}: {message}");
    assert!(output.stdout.is_empty(), "{shown:?}");
    let message = message.strip_prefix("forage: ").unwrap().strip_suffix('\n').unwrap().to_owned();
    let length = message.chars().count();
    assert!(length <= 300, "{shown:?}: {length} characters: {message}");
    assert!(!message.contains(|c: char| c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')), "{message:?}");
    message
}

#[test]
fn a_mistyped_name_suggests_the_nearest_one() {
    let folder = empty_folder("refusals/names");
    let sweep = |planner: &str, params: &str| {
        let text = format!("scenes = ['sphere']\nseeds = [1]\n[[planner]]\nname = '{planner}'\nparams = {{ {params} }}\n");
        fs::write(folder.join(format!("{planner}.toml")), text).unwrap();
    };
    sweep("wcspo", "");
    sweep("pso", "populaton = 5");
    for (args, message) in [
        (
            &["run", "wcspo", "--scene", "sphere"] as &[&str],
            "`wcspo` is not a planner; did you mean `wcpso`? `forage list` shows all planners",
        ),
        (&["suggest", "ltqps", "--scene", "qpso-10m"], "`ltqps` is not a planner; did you mean `ltqpso`?"),
        (&["run", "pso", "--scene", "spere"], "did you mean `sphere`? `forage list` shows all scenes"),
        (&["run", "pso", "--scene", "#v=1&planner=pso&scene=spere"], "`spere` is not a shipped scene; did you mean `sphere`?"),
        (&["run", "pso", "--scene", "sphere", "--set", "populaton=9"], "`populaton` is not a parameter of pso; did you mean `population`?"),
        (&["run", "pso", "--scene", "sphere", "--set", "waypoints=9"], "`waypoints` applies to scenes of kind discs and grid"),
        (
            &["run", "qpso", "--scene", "qpso-10m", "--drive-set", "look_ahed=9"],
            "`look_ahed` is not a parameter of drive; did you mean `look_ahead`?",
        ),
        (&["run", "rrt", "--scene", "arm-free", "--motion-set", "sped=9"], "`sped` is not a parameter of motion; did you mean `speed`"),
        (&["generate", "mase"], "`mase` is not a generator; did you mean `maze`?"),
        (
            &["generate", "maze", "--set", "colums=9"],
            "`colums` is not a parameter of maze; did you mean `columns`? `forage list maze` shows",
        ),
        (&["reproduce", "wcpso-path"], "`wcpso-path` is not a reproduction; did you mean `wcpso-paths`?"),
        (&["list", "wcspo"], "did you mean `wcpso`?"),
        (&["experiment", "wcspo.toml"], "planner[0].name: `wcspo` is not a planner; did you mean `wcpso`?"),
        (&["experiment", "pso.toml"], "planner[0].params: `populaton` is not a parameter; did you mean `population`?"),
        (&["rnu"], "`rnu` is not a command; did you mean `run`? `forage --help`"),
        (&["run", "--scen", "sphere"], "`--scen` is not an option; did you mean `--scene`? `forage run --help`"),
        (&["completions", "bashh"], "SHELL is bashh; it must be one of bash, elvish, fish"),
        (&["run", "waldo", "--scene", "sphere"], "`waldo` is not a planner; it must be one of pso, wpso, cpso"),
        (&["run"], "a planner is missing, e.g. `forage run wcpso --scene wcpso-discs`"),
    ] {
        let found = refusal(&folder, args);
        assert!(found.replace("`SHELL`", "SHELL").contains(message), "{args:?}: {found}");
    }
    assert!(refusal(&folder, &["run", "waldo", "--scene", "sphere"]).contains("more; `forage list` shows all planners"));
}

#[test]
fn a_message_has_at_most_300_characters_whatever_the_input() {
    let folder = empty_folder("refusals/long");
    let long = "x".repeat(10_000);
    let wide = "\u{1b}[2J\u{202e}é\n".repeat(2_000);
    let deep = format!("{}/a.json", "d/".repeat(2_000));
    let link = format!("#v=1&planner=pso&scene=~{}", "A".repeat(100_000));
    let key = format!("#v=1&{}=1", "k".repeat(100_000));
    let hash = format!("#v=1&planner=pso&scene=sphere&{}=1", "\u{202e}".repeat(30_000));
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    write("key.toml", &format!("{} = 1\n", "k".repeat(1_000_000)));
    write("name.toml", &format!("scenes = ['sphere']\nseeds = [1]\n[[planner]]\nname = '{long}'\n"));
    write("scene.toml", &format!("scenes = ['{long}']\nseeds = [1]\n[[planner]]\nname = 'pso'\n"));
    write("value.toml", &format!("scenes = ['sphere']\nseeds = [1]\n[[planner]]\nname = 'pso'\nparams = {{ w = '{long}' }}\n"));
    write("open.toml", &format!("scenes = [{}\n", "'sphere',".repeat(10_000)));
    let head = r#"{"format": "forage-scene", "version": 1, "kind": "function", "function": "sphere", "dimension": 2, "title": "A""#;
    write("name.json", &format!(r#"{head}, "name": "{long}"}}"#));
    write("field.json", &format!(r#"{head}, "name": "a", "{long}": 1}}"#));
    write("kind.json", &format!(r#"{{"format": "forage-scene", "version": 1, "kind": "{long}"}}"#));
    write("bad.map", &format!("type octile\nheight {long}\nwidth 3\nmap\n...\n"));
    write("bad.tsp", &format!("NAME : a\nTYPE : {long}\n"));
    for value in [&long, &wide] {
        for args in [
            vec![value.as_str()],
            vec!["run", value, "--scene", "sphere"],
            vec!["run", "pso", "--scene", value],
            vec!["run", "pso", "--scene", "sphere", "--seed", value],
            vec!["run", "pso", "--scene", "sphere", "--set", value],
            vec!["run", "pso", "--scene", "sphere", value],
            vec!["exact", "--scene", "sphere", "--json", value],
            vec!["list", value],
            vec!["reproduce", value],
            vec!["generate", value],
            vec!["generate", "maze", "--out", value],
            vec!["convert", value, "a.map"],
            vec!["convert", "sphere", value],
            vec!["experiment", value],
            vec!["experiment", "name.toml", "--shard", value],
            vec!["completions", value],
        ] {
            refusal(&folder, &args);
        }
        let [option, set, name] = [format!("--{value}"), format!("w={value}"), format!("{value}=1")];
        for args in [&["run", &option] as &[&str], &["run", "pso", "--scene", "sphere", "--set", &set]] {
            refusal(&folder, args);
        }
        for option in ["--set", "--drive-set"] {
            refusal(&folder, &["run", "qpso", "--scene", "qpso-10m", option, &name]);
        }
        refusal(&folder, &["run", "rrt", "--scene", "arm-free", "--motion-set", &name]);
    }
    for scene in [&link, &key, &hash, &deep, "name.json", "field.json", "kind.json", "bad.map", "bad.tsp"] {
        refusal(&folder, &["run", "pso", "--scene", scene]);
    }
    for file in ["key.toml", "name.toml", "scene.toml", "value.toml", "open.toml"] {
        refusal(&folder, &["experiment", file]);
    }
    assert!(refusal(&folder, &["experiment", "open.toml"]).starts_with("open.toml: line 1, column "));
}

#[test]
fn control_characters_in_names_titles_and_notes_are_escaped() {
    let folder = empty_folder("refusals/control");
    let scene = |kind: &str, name: &str| {
        format!(
            r#"{{"format": "forage-scene", "version": 1, "kind": {kind}, "name": "{name}", "title": "T\u001b[2J\u202eT",
                "note": "N\u001b]0;\u0007N", "source": "S\u009bS", "units": "m\u001b[31m"}}"#
        )
    };
    let grid = scene(r#""grid", "cell": 1, "rows": ["..."], "start": [0.5, 0.5], "goal": [2.5, 0.5]"#, r"g\u001b[2J\u2066\ng");
    fs::write(folder.join("grid.json"), grid).unwrap();
    fs::write(folder.join("e\u{1b}[2J.json"), scene(r#""function", "function": "sphere", "dimension": 2"#, "e")).unwrap();
    let strange = "e\u{1b}[2J.json";
    for args in [
        &["run", "a-star", "--scene", "grid.json"] as &[&str],
        &["exact", "--scene", "grid.json"],
        &["convert", "grid.json", "o.map"],
        &["convert", "o.map", "p\u{202e}.json"],
        &["run", "pso", "--scene", strange, "--iterations", "2"],
        &["run", "pso", "--scene", strange, "--set", "\u{1b}=1"],
        &["convert", "grid.json", "\u{1b}]0;\u{7}.yaml"],
    ] {
        let output = command(args).current_dir(&folder).output().unwrap();
        for printed in [text(&output.stdout), text(&output.stderr)] {
            let wrong = |c: char| c.is_control() && c != '\n' || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
            assert!(!printed.contains(wrong), "{args:?}: {printed:?}");
        }
    }
    let run = command(&["run", "a-star", "--scene", "grid.json"]).current_dir(&folder).output().unwrap();
    assert!(text(&run.stdout).starts_with("a-star on g\\u{1b}[2J\\u{2066}\\ng, seed 1: solved"), "{}", text(&run.stdout));
    assert!(text(&run.stdout).contains("2.000 m\\u{1b}[31m"), "{}", text(&run.stdout));
    // JSON has escapes of its own, and stays as it is.
    let json = command(&["run", "a-star", "--scene", "grid.json", "--json"]).current_dir(&folder).output().unwrap();
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["scene"], "g\u{1b}[2J\u{2066}\ng");
}

#[test]
fn what_cannot_be_combined_or_is_missing_is_said() {
    for (args, message) in [
        (&["exact"] as &[&str], "`--scene` is missing; `forage exact --help`"),
        (&["suggest"], "`--scene`, `PLANNER` are missing"),
        (&["convert"], "`IN OUT` is missing"),
        (&["experiment"], "`FILE.toml` is missing"),
        (&["experiment", "a.toml", "--jobs", "0"], "`--jobs` is 0; it must be a whole number from 1 to 1024; `forage experiment --help`"),
        (&["experiment", "a.toml", "--jobs", "99999999"], "`--jobs` is 99999999; it must be a whole number from 1 to 1024"),
        (&["experiment", "a.toml", "--jobs", "-3"], "`--jobs` is -3; it must be"),
        (&["experiment", "a.toml", "--merge", "b.csv", "--fresh"], "`--merge` cannot be used with `--fresh`"),
        (&["experiment", "--example", "a.toml"], "`--example` must be the only argument; "),
        (&["run", "pso", "--scene", "a", "--scene", "b"], "`--scene` is given twice; "),
        (&["reproduce", "wcpso-paths", "--check", "a"], "`NAME` cannot be used with `--check`"),
        (&["reproduce", "--runs", "x"], "`--runs` is x; it must be a whole number from 2 to 1000000; "),
        (&["reproduce", "--runs", "-1"], "`--runs` is -1; it must be a whole number from 2 to 1000000; "),
        (&["reproduce", "--runs", ""], "`--runs` is empty; it must be"),
        (&["reproduce", "--runs", "99999999999999999999"], "is 99999999999999999999; it must be a whole number from 2 to 1000000; "),
        (&["reproduce", "--seconds", "0"], "`--seconds` is 0; it must be a whole number from 1 to 86400; "),
        (&["run", "pso", "--scene", "sphere", "--set", "w="], "`w` is empty; it must be a number from 0 to 1.5"),
        (&["run", "pso", "--scene", "sphere", "--set", "w=1e400"], "`w` is 1e400; it must be a number from 0 to 1.5"),
        (&["run", "pso", "--scene", "sphere", "--iterations", "1e400"], "`iterations` is 1e400; it must be"),
        (&["run", "pso", "--scene", "sphere", "--set", "=1"], "an empty text is not a parameter of pso"),
        (&["run", "pso", "--scene", "sphere", "--preset", "paper"], "`preset` is paper; it must be left out: pso has no presets"),
        (&["help", "rnu"], "`rnu` is not a command; did you mean `run`?"),
        (&["generate", "maze", "--out"], "needs a value"),
        (&["convert", "maze", "--problem", "first", "a.map"], "`--problem` is first; it must be a whole number from 0 to 4294967295; "),
        (&["exact", "--scene", "sphere", "more"], "`more` is one argument too many"),
        (&["list", "a", ""], "an empty text is one argument too many"),
    ] {
        let output = forage(args);
        let found = text(&output.stderr);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{args:?}");
        assert!(found.contains(message), "{args:?}: {found}");
    }
}

#[cfg(unix)]
#[test]
fn a_file_name_cannot_forge_a_line_or_break_json() {
    use std::{ffi::OsStr, os::unix::ffi::OsStrExt, process::Command};

    let folder = empty_folder("refusals/forged");
    let sweep = "scenes = ['sphere-2']\nseeds = [1, 2]\niterations = 2\n[[planner]]\nname = 'pso'\n";
    let strange = "s\nforage: FAKE";
    fs::write(folder.join(format!("{strange}.toml")), sweep).unwrap();
    let call = |args: &[&[u8]]| {
        let args = args.iter().map(|arg| OsStr::from_bytes(arg));
        Command::new(env!("CARGO_BIN_EXE_forage")).args(args).current_dir(&folder).output().unwrap()
    };
    let toml = format!("{strange}.toml");
    for args in [
        &["experiment", &toml, "--report", "report.md"] as &[&str],
        &["experiment", &toml, "--shard", "1/2"],
        &["reproduce", "wcpso-paths", "--runs", "2", "--out", strange],
    ] {
        let output = call(&args.iter().map(|arg| arg.as_bytes()).collect::<Vec<_>>());
        let printed = text(&output.stdout) + &text(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{args:?}: {printed}");
        assert!(printed.contains("s\\nforage: FAKE") && !printed.contains("\nforage: FAKE"), "{args:?}: {printed}");
        assert!(!printed.contains("To repeat a run\n\n"), "no heading stands above nothing: {printed}");
    }
    let report = fs::read_to_string(folder.join("report.md")).unwrap();
    assert!(report.starts_with("# s\\nforage: FAKE: 2 runs in s\\nforage: FAKE.csv\n"), "{report}");

    // A name that is not UTF-8 is still written as JSON.
    let toml = b"bad\xff\xc2\x9b.toml";
    fs::write(folder.join(OsStr::from_bytes(toml)), sweep).unwrap();
    for args in [
        &[b"experiment" as &[u8], toml, b"--json"] as &[&[u8]],
        &[b"experiment", toml, b"--json", b"--shard", b"1/2"],
        &[b"reproduce", b"wcpso-paths", b"--runs", b"2", b"--json", b"--out", b"out\xff\xc2\x9b"],
    ] {
        let output = call(args);
        let printed = text(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert!(serde_json::from_slice::<serde_json::Value>(&output.stdout).is_ok(), "{printed}");
        assert!(printed.contains("\u{fffd}\\u009b") && !printed.contains('\u{9b}'), "{printed}");
    }
}

#[cfg(unix)]
#[test]
fn an_argument_that_is_not_utf8_is_named() {
    use std::{ffi::OsStr, os::unix::ffi::OsStrExt, process::Command};

    for (args, message) in [
        (&[b"run" as &[u8], b"pso", b"--scene", b"caf\xe9"] as &[&[u8]], "`--scene` is caf\u{fffd}; it must be valid UTF-8; "),
        (&[b"run", b"pso", b"--svg", b"a\xe9", b"--scene=caf\xe9"], "`--scene` is caf\u{fffd}; it must be valid UTF-8; "),
        (&[b"run", b"pso", b"--svg", b"x=\xe9", b"--scene", b"caf\xe9"], "`--scene` is caf\u{fffd}; it must be valid UTF-8; "),
        (&[b"run", b"pso", b"--set", b"w=\xff"], "`--set` is w=\u{fffd}; it must be valid UTF-8; "),
        (
            &[b"experiment", b"x\xe9.toml", b"--merge", b"\xe9.csv", b"\xe9.csv", b"--shard", b"\xe9"],
            "`--shard` is \u{fffd}; it must be valid",
        ),
        (&[b"list", b"--json", b"caf\xe9"], "the argument `caf\u{fffd}` is not valid UTF-8; `forage list --help`"),
    ] {
        let args: Vec<_> = args.iter().map(|arg| OsStr::from_bytes(arg)).collect();
        let output = Command::new(env!("CARGO_BIN_EXE_forage")).args(&args).output().unwrap();
        let found = text(&output.stderr);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{args:?}: {found}");
        assert!(found.contains(message), "{args:?}: {found}");
    }
}
