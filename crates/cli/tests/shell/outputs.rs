//! Files that are written: never over what is read or over each other, and where nothing can be written that is said first.

use std::{fs, path::Path};

use crate::support::{command, empty_folder, text};

/// The message of a refusal without anything printed.
fn refusal(folder: &Path, args: &[&str]) -> String {
    let output = command(args).current_dir(folder).output().unwrap();
    let message = text(&output.stderr);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{args:?}: {message}");
    assert!(message.chars().count() <= 310, "{message}");
    message
}

fn run(folder: &Path, args: &[&str]) {
    let output = command(args).current_dir(folder).output().unwrap();
    assert_eq!(output.status.code(), Some(0), "{args:?}: {}", text(&output.stderr));
}

#[test]
fn an_output_replaces_neither_an_input_nor_another_output() {
    let folder = empty_folder("outputs/apart");
    run(&folder, &["convert", "wolf-ant-20", "grid.json"]);
    run(&folder, &["convert", "wolf-ant-20", "grid.scen"]);
    run(&folder, &["convert", "random-52", "stops.tsp"]);
    fs::create_dir(folder.join("sub")).unwrap();
    let sweep = "scenes = ['grid.scen']\nseeds = [1, 2]\n[[planner]]\nname = 'a-star'\n";
    fs::write(folder.join("sweep.toml"), sweep).unwrap();
    run(&folder, &["experiment", "sweep.toml", "--shard", "1/2"]);
    let contents = || -> Vec<_> {
        let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|file| file.unwrap().path()).filter(|path| path.is_file()).collect();
        files.sort();
        files.into_iter().map(|path| (fs::read(&path).unwrap(), path)).collect()
    };
    let before = contents();
    for (args, message) in [
        (
            &["run", "a-star", "--scene", "grid.map", "--trace", "grid.map"] as &[&str],
            "`--trace` is grid.map; it must be another file than grid.map, which is read",
        ),
        (&["run", "a-star", "--scene", "grid.json", "--svg", "./sub/../grid.json"], "another file than grid.json, which is read"),
        (&["run", "a-star", "--scene", "grid.scen", "--svg", "grid.map"], "another file than grid.map, which is read"),
        (&["run", "two-opt", "--scene", "stops.tsp", "--tour", "stops.tsp"], "another file than stops.tsp, which is read"),
        (&["run", "a-star", "--scene", "grid.json", "--svg", "new", "--trace", "sub/../new"], "than new, which --svg writes"),
        (&["experiment", "sweep.toml", "--report", "grid.map"], "`--report` is grid.map; it must be another file than grid.map, which"),
        (&["experiment", "sweep.toml", "--report", "./sweep.csv"], "another file than sweep.csv, which holds the rows"),
        (
            &["experiment", "sweep.toml", "--merge", "sweep.1-of-2.csv", "--report", "sweep.1-of-2.csv"],
            "another file than sweep.1-of-2.csv, which is read",
        ),
    ] {
        let found = refusal(&folder, args);
        assert!(found.contains(message), "{args:?}: {found}");
    }
    assert_eq!(contents(), before, "nothing is written");
}

#[test]
fn what_cannot_be_written_is_said_before_anything_is_run() {
    let folder = empty_folder("outputs/folders");
    fs::create_dir(folder.join("sub")).unwrap();
    fs::write(folder.join("file"), "").unwrap();
    // Years of work: a refusal that came afterwards would not come.
    let sweep = "scenes = ['sphere']\nseeds = { from = 1, count = 1000000 }\niterations = 100000\n[[planner]]\nname = 'pso'\n";
    fs::write(folder.join("sweep.toml"), sweep).unwrap();
    let long = ["run", "pso", "--scene", "sphere", "--iterations", "1000000000"];
    for (args, message) in [
        (&["--svg", "sub"] as &[&str], "`sub` cannot be written: it is a directory"),
        (&["--svg", "file/a.svg"], "`file/a.svg` cannot be written: "),
        (&["--trace", "no/a.csv"], "`no/a.csv` cannot be written: there is no folder `no`"),
    ] {
        let found = refusal(&folder, &[&long[..], args].concat());
        assert!(found.contains(message), "{args:?}: {found}");
    }
    for (args, message) in [
        (&["experiment", "sweep.toml", "--report", "no/r.md"] as &[&str], "`no/r.md` cannot be written: there is no folder `no`"),
        (&["experiment", "sweep.toml", "--report", "sub"], "`sub` cannot be written: it is a directory"),
        (&["man", "--out", "file"], "`--out` is file; it must be a folder; file is a file"),
        (&["man", "--out", "file/man"], "`--out` is file/man; it must be a folder; file is a file"),
        (&["reproduce", "wcpso-paths", "--out", "file"], "`--out` is file; it must be a folder; file is a file"),
    ] {
        let found = refusal(&folder, args);
        assert!(found.contains(message), "{args:?}: {found}");
    }
    assert!(!folder.join("sweep.csv").exists());
    // The folder of the rows is made, and the report may be in it.
    fs::write(folder.join("quick.toml"), sweep.replace("000000", "").replace("100000\n", "2\n")).unwrap();
    run(&folder, &["experiment", "quick.toml", "--out", "new/rows.csv", "--report", "new/r.md"]);
    assert!(folder.join("new/r.md").exists());
}

#[cfg(unix)]
#[test]
fn links_to_an_input_are_the_input() {
    let folder = empty_folder("outputs/links");
    run(&folder, &["convert", "wolf-ant-20", "grid.json"]);
    fs::hard_link(folder.join("grid.json"), folder.join("hard.json")).unwrap();
    std::os::unix::fs::symlink("grid.json", folder.join("soft.json")).unwrap();
    let before = fs::read(folder.join("grid.json")).unwrap();
    for link in ["hard.json", "soft.json"] {
        let found = refusal(&folder, &["run", "a-star", "--scene", "grid.json", "--svg", link]);
        assert!(found.contains("another file than grid.json, which is read"), "{found}");
        let found = refusal(&folder, &["convert", "grid.json", link]);
        assert!(found.contains("another file than those that are read"), "{found}");
    }
    assert_eq!(fs::read(folder.join("grid.json")).unwrap(), before);
}

#[cfg(unix)]
#[test]
fn the_name_in_a_tour_is_one_line_and_devices_take_several_outputs() {
    let folder = empty_folder("outputs/tour");
    run(&folder, &["convert", "random-52", "stops.tsp"]);
    let tour = "x\nEOF.tour";
    run(&folder, &["run", "two-opt", "--scene", "stops.tsp", "--tour", tour, "--svg", "/dev/null", "--trace", "/dev/null"]);
    let written = fs::read_to_string(folder.join(tour)).unwrap();
    assert!(written.starts_with("NAME : x\\nEOF\nTYPE : TOUR\nDIMENSION : 52\nTOUR_SECTION\n"), "{written}");
}
