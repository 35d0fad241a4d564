//! Files that are missing, damaged, too large, or no files at all.

use std::fs;

use crate::support::{command, empty_folder, text};

#[test]
fn a_missing_file_is_called_missing_and_a_damaged_one_says_where() {
    let folder = empty_folder("files/damaged");
    fs::write(folder.join("cut.json"), "{\"format\": \"forage-scene\",\n \"version\": ").unwrap();
    fs::write(folder.join("bytes.json"), b"{\xff\xfe}").unwrap();
    fs::write(folder.join("bytes.toml"), b"\xff").unwrap();
    let field =
        r#"{"format": "forage-scene", "version": 1, "kind": "function", "name": "a", "title": "A", "function": "sphere", "dimension": -3}"#;
    fs::write(folder.join("field.json"), field).unwrap();
    fs::write(folder.join("alone.scen"), "version 1\n0\tgone.map\t3\t1\t0\t0\t2\t0\t2\n").unwrap();
    for (args, message) in [
        (
            &["run", "pso", "--scene", "nowhere.json"] as &[&str],
            "`nowhere.json`: no such file (and not a shipped scene; `forage list` shows those)",
        ),
        (&["exact", "--scene", "no/where.map"], "`no/where.map`: no such file"),
        (&["convert", "nowhere.map", "a.json"], "`nowhere.map`: no such file"),
        (&["experiment", "nowhere.toml"], "`nowhere.toml`: no such file"),
        (&["run", "pso", "--scene", "cut.json"], "`cut.json`: not JSON: EOF while parsing a value at line 2"),
        (&["run", "pso", "--scene", "bytes.json"], "`bytes.json`: not JSON: invalid utf-8"),
        (&["experiment", "bytes.toml"], "`bytes.toml`: invalid utf-8"),
        (&["exact", "--scene", "field.json"], "`field.json`: `dimension` is -3; it must be"),
        (&["exact", "--scene", "alone.scen"], "the file `gone.map` that belongs to it is missing"),
        (&["run", "pso", "--scene", "sphere", "--svg", "no/a.svg"], "`no/a.svg` cannot be written: there is no folder `no`"),
        (&["run", "pso", "--scene", "sphere", "--trace", "no/a.csv"], "there is no folder `no`"),
        (&["generate", "maze", "--out", "no/a.json"], "there is no folder `no`"),
    ] {
        let output = command(args).current_dir(&folder).output().unwrap();
        let found = text(&output.stderr);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{args:?}: {found}");
        assert!(found.contains(message), "{args:?}: {found}");
    }
}

/// Names that are no UTF-8 are printed as far as they can be, also to programs.
#[cfg(target_os = "linux")]
#[test]
fn names_that_are_not_utf8_are_printed() {
    use std::{ffi::OsStr, os::unix::ffi::OsStrExt};

    let folder = empty_folder("files/bytes");
    let bad = |name: &[u8]| OsStr::from_bytes(name).to_owned();
    let toml = "scenes = [\"sphere\"]\nseeds = [1, 2]\niterations = 5\n[[planner]]\nname = \"pso\"\n";
    fs::write(folder.join(bad(b"a\xff.toml")), toml).unwrap();
    // Nor does one that breaks a line or moves the cursor.
    let output =
        command(&["experiment"]).arg(bad(b"a\xff.toml")).args(["--out", "x\nforage: FAKE\n.csv"]).current_dir(&folder).output().unwrap();
    assert!(text(&output.stdout).contains(r"x\nforage: FAKE\n.csv"), "{}", text(&output.stdout));
    let output =
        command(&["experiment", "--json"]).arg(bad(b"a\xff.toml")).args(["--out", "x\u{9b}31m.csv"]).current_dir(&folder).output().unwrap();
    assert!(text(&output.stdout).contains(r"x\u009b31m.csv"), "{}", text(&output.stdout));
    let printed: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(printed["rows"], "x\u{9b}31m.csv");
    for shard in [&["--shard", "1/2"] as &[&str], &[]] {
        let output = command(&["experiment", "--json"]).arg(bad(b"a\xff.toml")).args(shard).current_dir(&folder).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let printed: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(printed.is_object());
    }
}

#[cfg(unix)]
#[test]
fn what_is_no_regular_file_or_too_large_is_refused_before_it_is_read() {
    use std::{os::unix::fs::symlink, os::unix::net::UnixListener, process::Command};

    let folder = empty_folder("files/special");
    let at = |name: &str| folder.join(name);
    for ending in ["json", "map", "scen", "yaml", "pgm", "tsp", "tour", "csv", "toml", "txt"] {
        symlink("/dev/zero", at(&format!("zero.{ending}"))).unwrap();
        let large = if ending == "toml" { 5 << 20 } else { 65 << 20 };
        fs::File::create(at(&format!("large.{ending}"))).unwrap().set_len(large).unwrap();
    }
    assert!(Command::new("mkfifo").arg(at("pipe.json")).arg(at("pipe.csv")).arg(at("pipe.toml")).status().unwrap().success());
    fs::create_dir_all(at("folder.json")).unwrap();
    // A socket's path has a hundred bytes at most.
    let short = tempfile::tempdir().unwrap();
    let socket = UnixListener::bind(short.path().join("a"));
    symlink(short.path().join("a"), at("socket.json")).unwrap();
    fs::write(at("zero-partner.scen"), "version 1\n0\tzero.map\t3\t1\t0\t0\t2\t0\t2\n").unwrap();
    fs::write(at("large-partner.yaml"), "image: large.pgm\nresolution: 1\n").unwrap();
    fs::write(at("good.toml"), "scenes = ['sphere-2']\nseeds = [1]\niterations = 2\n[[planner]]\nname = 'pso'\n").unwrap();
    fs::write(at("zero-scene.toml"), "scenes = ['zero.json']\nseeds = [1]\n[[planner]]\nname = 'pso'\n").unwrap();
    fs::create_dir_all(at("kept")).unwrap();
    symlink("/dev/zero", at("kept/REPRODUCTION.md")).unwrap();
    fs::create_dir_all(at("rows")).unwrap();
    symlink("/dev/zero", at("rows/wcpso-paths-runs.csv")).unwrap();
    fs::create_dir_all(at("large-rows")).unwrap();
    // More than the limited memory below: sparse, so that nothing is on the disk.
    let huge = |name: &str, beginning: &str| {
        fs::write(at(name), beginning).unwrap();
        fs::OpenOptions::new().write(true).open(at(name)).unwrap().set_len(3 << 30).unwrap();
    };
    huge("large-rows/wcpso-paths-runs.csv", "");
    huge("huge.csv", "");
    huge("huge.jsonl", "{\"scene\":\"");

    let mut cases: Vec<(Vec<&str>, &str)> = Vec::new();
    for ending in ["json", "map", "scen", "yaml", "pgm", "tsp", "tour", "csv", "txt"] {
        let [zero, large] = ["zero", "large"].map(|name| &*format!("{name}.{ending}").leak());
        cases.push((vec!["exact", "--scene", zero], "is not a regular file but a device"));
        cases.push((vec!["run", "pso", "--scene", large], "has 65.0 MiB; a scene file may have at most 64 MiB"));
        cases.push((vec!["convert", zero, "o.json"], "is not a regular file but a device"));
        cases.push((vec!["convert", large, "o.json"], "at most 64 MiB"));
    }
    cases.extend([
        (vec!["run", "pso", "--scene", "/dev/zero"], "`/dev/zero` is not a regular file but a device"),
        (vec!["exact", "--scene", "pipe.json"], "`pipe.json` is not a regular file but a named pipe"),
        (vec!["exact", "--scene", "folder.json"], "`folder.json` is not a regular file but a folder"),
        (vec!["exact", "--scene", "socket.json"], "`socket.json` is not a regular file but a socket"),
        (vec!["exact", "--scene", "zero-partner.scen"], "zero.map` is not a regular file but a device"),
        (vec!["exact", "--scene", "large-partner.yaml"], "large.pgm` has 65.0 MiB"),
        (vec!["convert", "zero-partner.scen", "o.json"], "zero.map` is not a regular file"),
        (vec!["experiment", "zero.toml"], "is not a regular file but a device"),
        (vec!["experiment", "pipe.toml"], "is not a regular file but a named pipe"),
        (vec!["experiment", "large.toml"], "has 5.0 MiB; an experiment’s file may have at most 4 MiB"),
        (vec!["experiment", "zero-scene.toml"], "`zero.json` is not a regular file but a device"),
        (vec!["experiment", "good.toml", "--out", "zero.csv"], "`zero.csv` is not a regular file but a device"),
        (vec!["experiment", "good.toml", "--out", "pipe.csv"], "`pipe.csv` is not a regular file but a named pipe"),
        (vec!["experiment", "good.toml", "--merge", "zero.csv"], "`zero.csv` is not a regular file but a device"),
        (vec!["experiment", "good.toml", "--merge", "pipe.csv"], "`pipe.csv` is not a regular file but a named pipe"),
        (vec!["experiment", "good.toml", "--out", "huge.csv"], "it does not begin like a file of rows"),
        (vec!["experiment", "good.toml", "--out", "new.csv", "--merge", "huge.csv"], "it does not begin like a file of rows"),
        (vec!["experiment", "good.toml", "--out", "huge.jsonl"], "line 1 has more than 1024 KiB"),
        (vec!["reproduce", "wcpso-paths", "--out", "large-rows"], "it has 3.0 GiB; a file of rows may have at most 1 GiB"),
        (vec!["reproduce", "--check", "kept"], "REPRODUCTION.md` is not a regular file but a device"),
        (vec!["reproduce", "wcpso-paths", "--out", "rows"], "runs.csv` is not a regular file but a device"),
    ]);
    for (args, message) in cases {
        let limited = "ulimit -v 2000000; exec timeout 20 \"$0\" \"$@\"";
        let output =
            Command::new("sh").args(["-c", limited, env!("CARGO_BIN_EXE_forage")]).args(&args).current_dir(&folder).output().unwrap();
        let found = text(&output.stderr);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{args:?}: {found}");
        assert!(found.contains(message), "{args:?}: {found}");
    }
    drop(socket);
}
