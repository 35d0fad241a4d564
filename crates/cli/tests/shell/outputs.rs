//! Files that are written: never over what is read or over each other, and where nothing can be written that is said first.

use std::{fs, path::Path, process::Stdio, thread::sleep, time::Duration};

use crate::support::{command, empty_folder, text};

/// The message of a refusal without anything printed, which comes before anything is run: at once.
fn refusal(folder: &Path, args: &[&str]) -> String {
    let mut child = command(args).current_dir(folder).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut waited = 0;
    while child.try_wait().unwrap().is_none() {
        waited += 1;
        if waited > 6000 {
            child.kill().unwrap();
        }
        sleep(Duration::from_millis(10));
    }
    let output = child.wait_with_output().unwrap();
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
        (&["run", "a-star", "--scene", "grid.scen", "--trace", "grid.scen"], "another file than grid.scen, which is read"),
        (&["run", "two-opt", "--scene", "stops.tsp", "--tour", "stops.tsp"], "another file than stops.tsp, which is read"),
        (&["run", "a-star", "--scene", "grid.json", "--svg", "new", "--trace", "sub/../new"], "than new, which --svg writes"),
        (&["experiment", "sweep.toml", "--report", "grid.map"], "`--report` is grid.map; it must be another file than grid.map, which"),
        (&["experiment", "sweep.toml", "--report", "./sweep.csv"], "another file than sweep.csv, which holds the rows"),
        (&["experiment", "sweep.toml", "--report", "sweep.csv.bad"], "than sweep.csv.bad, which would keep damaged rows"),
        (
            &["experiment", "sweep.toml", "--out", "sweep.toml"],
            "`--out` is sweep.toml; it must be another file than sweep.toml, which is read",
        ),
        (
            &["experiment", "sweep.toml", "--merge", "sweep.1-of-2.csv", "--report", "sweep.1-of-2.csv"],
            "another file than sweep.1-of-2.csv, which is read",
        ),
    ] {
        let found = refusal(&folder, args);
        assert!(found.contains(message), "{args:?}: {found}");
    }
    assert_eq!(contents(), before, "nothing is written");
    // What another run wrote is replaced.
    let trace = ["run", "a-star", "--scene", "grid.json", "--trace", "trace.csv"];
    run(&folder, &trace);
    let first = fs::read(folder.join("trace.csv")).unwrap();
    fs::write(folder.join("trace.csv"), "old").unwrap();
    run(&folder, &trace);
    assert_eq!(fs::read(folder.join("trace.csv")).unwrap(), first);
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
    let too_long = "x".repeat(260);
    for (args, message) in [
        (&["--svg", "sub"] as &[&str], "`sub` cannot be written: it is a folder"),
        (&["--svg", "file/a.svg"], "`file/a.svg` cannot be written: `file` is a file"),
        (&["--svg", "file/x/a.svg"], "`file/x/a.svg` cannot be written: `file` is a file"),
        (&["--svg", "new/"], "`new/` cannot be written: there is no folder `new/`"),
        (&["--trace", "no/a.csv"], "`no/a.csv` cannot be written: there is no folder `no`"),
        (&["--trace", &too_long], "File name too long"),
    ] {
        let found = refusal(&folder, &[&long[..], args].concat());
        assert!(found.contains(message), "{args:?}: {found}");
    }
    for (args, message) in [
        (&["experiment", "sweep.toml", "--report", "file/r.md"] as &[&str], "`--report` is file; it must be a folder, but it is a file"),
        (&["experiment", "sweep.toml", "--report", "sub"], "`sub` cannot be written: it is a folder"),
        (&["experiment", "sweep.toml", "--out", "file/x/a.csv"], "`--out` is file/x; it must be a folder, but `file` is a file"),
        (&["experiment", "sweep.toml", "--out", "a.xls"], "`--out` is a.xls; it must be a file that ends in .csv"),
        (&["experiment", "sweep.toml", "--shard", "-1/2"], "`--shard` is -1/2; it must be I/N"),
        (&["man", "--out", "file"], "`--out` is file; it must be a folder, but it is a file"),
        (&["man", "--out", "file/man"], "`--out` is file/man; it must be a folder, but `file` is a file"),
        (&["reproduce", "wcpso-paths", "--out", "file"], "`--out` is file; it must be a folder, but it is a file"),
    ] {
        let found = refusal(&folder, args);
        assert!(found.contains(message), "{args:?}: {found}");
    }
    let names = |folder: &Path| -> Vec<_> {
        let mut names: Vec<_> = fs::read_dir(folder).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    assert_eq!(names(&folder), ["file", "sub", "sweep.toml"], "nothing is left of looking whether it can be written");
    // The folders of the rows and of the report are made.
    fs::write(folder.join("quick.toml"), sweep.replace("000000", "").replace("100000\n", "2\n")).unwrap();
    run(&folder, &["experiment", "quick.toml", "--out", "new/rows.csv", "--report", "new/r.md"]);
    assert_eq!(names(&folder.join("new")), ["r.md", "rows.csv"]);
    run(&folder, &["experiment", "quick.toml", "--out", "./rows/rows.csv", "--report", "report/of/r.md"]);
    assert!(folder.join("report/of/r.md").exists());
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
        assert!(found.contains("another file than grid.json, which is read"), "{found}");
    }
    assert_eq!(fs::read(folder.join("grid.json")).unwrap(), before);
}

#[cfg(unix)]
#[test]
fn links_to_what_does_not_exist_yet_are_followed() {
    let folder = empty_folder("outputs/dangling");
    let sweep = "scenes = ['sphere-2']\nseeds = [1, 2]\niterations = 2\n[[planner]]\nname = 'pso'\n";
    fs::write(folder.join("s.toml"), sweep).unwrap();
    for (target, link) in
        [("rows.csv", "r.md"), ("pair.scen", "pair.map"), ("bb", "aa"), ("no/a.svg", "a.svg"), ("no", "pages"), ("x", "y"), ("y", "x")]
    {
        std::os::unix::fs::symlink(target, folder.join(link)).unwrap();
    }
    for (args, message) in [
        (&["experiment", "s.toml", "--out", "rows.csv", "--report", "r.md"] as &[&str], "another file than rows.csv, which holds the rows"),
        (&["run", "pso", "--scene", "sphere-2", "--svg", "aa", "--trace", "bb"], "another file than aa, which --svg writes"),
        (&["convert", "wolf-ant-20", "pair.scen"], "which is written, too"),
        (&["generate", "maze", "--out", "pair.map"], "which is written, too"),
        (&["run", "pso", "--scene", "sphere-2", "--svg", "a.svg"], "`a.svg` cannot be written: there is no folder `"),
        (&["run", "pso", "--scene", "sphere-2", "--svg", "x"], "`x` cannot be written: its links lead in a circle"),
        (&["man", "--out", "pages"], "`--out` is pages; it must be a folder, but it is a link to what does not exist"),
    ] {
        let found = refusal(&folder, args);
        assert!(found.contains(message), "{args:?}: {found}");
    }
    run(&folder, &["run", "pso", "--scene", "sphere-2", "--iterations", "2", "--svg", "aa"]);
    assert!(fs::read_to_string(folder.join("bb")).unwrap().starts_with("<svg") && folder.join("aa").is_symlink());
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
