//! Other programs' files over the public face: round trips, fuzzing, the shell's `convert` and `generate`.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/generated.rs"]
mod generated;

use std::{
    path::PathBuf,
    process::{Command, Output},
};

use forage::{
    Error, Given, Scene, Value,
    planner::Yardstick,
    scene::{
        formats::{Format, NamedFile, export, import, wanted},
        generate::{GENERATORS, generate},
    },
};
use generated::{GENERATED, digest};
use proptest::prelude::*;

fn small(generator: usize, columns: usize, rows: usize, seed: u64) -> Scene {
    let sides = [("columns", columns), ("rows", rows)].map(|(name, side)| (name, Value::from(side as f64)));
    generate(GENERATORS[generator].name, &Given::from_iter(sides), seed).unwrap()
}

#[test]
fn every_generator_gives_the_stored_grid() {
    assert_eq!(GENERATED.len(), GENERATORS.len());
    for (i, expected) in GENERATED.iter().enumerate() {
        let scene = small(i, 31, 22, 7);
        assert_eq!(digest(&scene.grid().unwrap().lines().join("\n")), *expected, "{}", scene.name());
    }
}

/// The error of a refusal must name a field and say something about it.
fn said(error: &Error) -> bool {
    let message = error.to_string();
    !error.field().is_empty() && !error.allowed().is_empty() && message.len() > error.field().len() + 2
}

/// A file of each sort that is in order, with its partner.
fn valid() -> Vec<Vec<NamedFile>> {
    let scene = small(0, 9, 7, 4);
    let picture = "P2\n# by hand\n3 2\n15\n15 0 7\n15 15 15 ";
    let yaml = "image: \"a.pgm\" # its picture\nmode: scale\nresolution: 0.05\norigin:\n- -1\n- 0\n- 0.5\nnegate: 0\nfree_thresh: 0.25\n";
    let mut all: Vec<_> = Format::ALL.map(|format| export(&scene, format, "a").unwrap().files).into();
    all.push(vec![NamedFile::new("a.yaml", yaml), NamedFile::new("a.pgm", picture)]);
    all
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Cells and ends survive; ROS has no place for ends, and y grows upwards there.
    #[test]
    fn what_is_written_is_read_back(generator in 0..GENERATORS.len(), columns in 1_usize..40, rows in 1_usize..40, seed in 0_u64..1 << 40) {
        let scene = small(generator, columns, rows, seed);
        for format in Format::ALL {
            let files = export(&scene, format, "a map").unwrap().files;
            prop_assert!(wanted(&files).unwrap().is_none());
            let read = import(&files, None).unwrap();
            let (was, is) = (scene.grid().unwrap(), read.scene.grid().unwrap());
            prop_assert_eq!(was.lines(), is.lines());
            prop_assert!(format == Format::Ros || was == is);
            if format == Format::MovingAi {
                prop_assert_eq!(read.scene.exact_by(Yardstick::Cells).unwrap().length, read.problems[0].length);
            }
            // And once more, from what was read.
            let again = export(&read.scene, format, "a map").unwrap().files;
            prop_assert_eq!(&files, &again);
        }
    }

    #[test]
    fn random_bytes_are_refused_with_a_reason_or_read(
        name in 0..7_usize, head in 0..5_usize, bytes in proptest::collection::vec(any::<u8>(), 0..200), partner in 0..4_usize,
    ) {
        let name = ["a.map", "a.scen", "a.yaml", "a.pgm", "a.json", "a", ""][name];
        let head: &[u8] = [b"" as &[u8], b"type octile\nheight 3\nwidth 3\nmap\n", b"version 1\n0\ta.map\t3\t3\t", b"P5 3 3 255\n", b"image: a.pgm\n"][head];
        let mut files = vec![NamedFile::new(name, [head, &bytes].concat())];
        files.extend(valid()[partner].iter().filter(|file| file.name != name).cloned());
        for count in 1..=files.len() {
            if let Err(error) = import(&files[..count], None) {
                prop_assert!(said(&error), "{error:?}");
            }
            let _ = wanted(&files[..count]);
        }
    }

    #[test]
    fn a_valid_file_with_some_bytes_changed_is_refused_with_a_reason_or_read(
        which in 0..4_usize, part in 0..2_usize,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), 0..4_u8, prop::sample::select(&b"0 9-.\n\t:[]\"'#@x\xff\x00e+"[..])), 1..5),
    ) {
        let mut files = valid().swap_remove(which);
        let part = part % files.len();
        let bytes = &mut files[part].bytes;
        for (index, kind, byte) in changes {
            let at = index.index(bytes.len().max(1)).min(bytes.len());
            match kind {
                0 => bytes.insert(at, byte),
                1 => bytes.truncate(at),
                2 if at < bytes.len() => drop(bytes.remove(at)),
                _ => if let Some(there) = bytes.get_mut(at) { *there = byte },
            }
        }
        match import(&files, None) {
            Ok(read) => prop_assert_eq!(Scene::from_json(&read.scene.to_json()).unwrap(), read.scene),
            Err(error) => prop_assert!(said(&error), "{error:?}"),
        }
    }
}

fn forage(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_forage")).args(args).output().unwrap()
}

fn words(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A path in a folder of this test's own.
fn place(test: &str, name: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("formats").join(test);
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name).display().to_string()
}

#[test]
fn a_random_grid_goes_through_every_format_in_the_shell() {
    let at = |name: &str| place("through", name);
    let printed = forage(&["generate", "maze", "--set", "columns=9", "--set", "rows=7", "--seed", "5"]);
    assert_eq!((printed.status.code(), words(&printed.stderr)), (Some(0), String::new()));
    let scene = Scene::from_json(&words(&printed.stdout)).unwrap();
    assert_eq!(scene.name(), "maze-9x7-5");
    std::fs::write(at("m.json"), &printed.stdout).unwrap();
    for (from, to) in [("m.json", "m.scen"), ("m.scen", "n.yaml"), ("n.pgm", "o.map"), ("o.map", "o.yml"), ("o.yml", "p.json")] {
        let output = forage(&["convert", &at(from), &at(to)]);
        assert_eq!((output.status.code(), words(&output.stdout)), (Some(0), String::new()), "{}", words(&output.stderr));
    }
    let last = Scene::from_json(&std::fs::read_to_string(at("p.json")).unwrap()).unwrap();
    assert_eq!(last.grid().unwrap().lines(), scene.grid().unwrap().lines());
    // Every command takes a map, and its partner is found beside it.
    let exact = forage(&["exact", "--scene", &at("m.scen"), "--json"]);
    assert_eq!(exact.status.code(), Some(0), "{}", words(&exact.stderr));
    assert!(words(&exact.stderr).contains("Problem 0 of 1"));
    let length = serde_json::from_slice::<serde_json::Value>(&exact.stdout).unwrap()["cells"]["length"].as_f64();
    assert_eq!(length, scene.exact_by(Yardstick::Cells).map(|exact| exact.length));
    let run = forage(&["run", "wcpso", "--scene", &at("n.yaml"), "--iterations", "3", "--json"]);
    assert!(run.status.code() < Some(2) && words(&run.stderr).contains("start and no goal"), "{}", words(&run.stderr));
    // A shipped scene by its name; what the format has no place for is told.
    let robot = forage(&["convert", "qpso-10m", &at("q.map")]);
    assert!(robot.status.code() == Some(0) && words(&robot.stderr).contains("the robot"));
    let full = forage(&["generate", "random", "--set", "share=1", "--out", &at("full.map")]);
    assert!(full.status.code() == Some(0) && words(&full.stderr).contains("1131 of 1200"), "{}", words(&full.stderr));
}

#[test]
fn the_command_in_a_random_grid_s_source_makes_it_again() {
    for generator in GENERATORS {
        let first = forage(&["generate", generator.name, "--set", "columns=12", "--seed", "9"]);
        let scene = Scene::from_json(&words(&first.stdout)).unwrap();
        let source = scene.header().source.clone().unwrap();
        let args: Vec<_> = source.split_once(' ').expect("a command and its words").1.split(' ').collect();
        assert_eq!(words(&forage(&args).stdout), words(&first.stdout), "{source}");
    }
}

#[test]
fn one_of_many_problems_can_be_chosen() {
    let at = |name: &str| place("problems", name);
    std::fs::write(at("a.map"), "type octile\nheight 1\nwidth 4\nmap\n....\n").unwrap();
    std::fs::write(at("a.scen"), "version 1\n0\tmaps/a.map\t4\t1\t0\t0\t1\t0\t1\n0\tmaps/a.map\t4\t1\t0\t0\t3\t0\t3\n").unwrap();
    for (problem, goal) in [(Some("0"), [1.5, 0.5]), (Some("1"), [3.5, 0.5]), (None, [3.5, 0.5])] {
        let mut args = vec!["convert".to_owned(), at("a.scen"), at("a.json")];
        args.extend(problem.map(|problem| format!("--problem={problem}")));
        let output = forage(&args.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(0), "{}", words(&output.stderr));
        let scene = Scene::from_json(&std::fs::read_to_string(at("a.json")).unwrap()).unwrap();
        assert_eq!(scene.ends().unwrap().1, goal);
    }
}

#[test]
fn what_is_refused_exits_with_2_and_writes_nothing() {
    let at = |name: &str| place("refused", name);
    std::fs::write(at("bad.map"), "type octile\nheight 1\nwidth 3\nmap\n.x.\n").unwrap();
    std::fs::write(at("good.map"), "type octile\nheight 1\nwidth 3\nmap\n...\n").unwrap();
    std::fs::write(at("alone.scen"), "version 1\n0\tgone.map\t3\t1\t0\t0\t2\t0\t2\n").unwrap();
    std::fs::write(at("alone.yaml"), "image: gone.pgm\nresolution: 1\n").unwrap();
    let scene = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "a", "title": "A", "cell": 1, "rows": [".#."],"#;
    std::fs::write(at("split.json"), format!(r#"{scene} "start": [0.5, 0.5], "goal": [2.5, 0.5]}}"#)).unwrap();
    let [bad, good, alone, yaml, split] = ["bad.map", "good.map", "alone.scen", "alone.yaml", "split.json"].map(at);
    let [out, scen] = ["out.json", "out.scen"].map(at);
    for (args, part) in [
        (&["convert", &bad, &out] as &[&str], "bad.map: line 5: found `x`, expected one of . G S @ O T W in column 2"),
        (&["convert", &alone, &out], "alone.scen: the file `gone.map` that belongs to it is missing"),
        (&["convert", &yaml, &out], "alone.yaml: the file `gone.pgm` that belongs to it is missing"),
        (&["convert", &alone, &good, "--problem", "3", &out], "problem: 3 is not allowed; it must be from 0 to 0"),
        (&["convert", &good, "--problem", "0", &out], "problem: 0"),
        (&["convert", &good, &at("out.png")], "OUT:"),
        (&["convert", &good, "OUT"], "OUT: OUT is not allowed; it must be a file that ends in .json, .map"),
        (&["convert", &good], "OUT: nothing is not allowed"),
        (&["convert", &split, &scen], "no way from start to goal"),
        (&["convert", &alone, &good], "gone.map"),
        (&["convert", &good, &at("good.scen")], "good.map is not allowed; it must be another file than those that are read"),
        (&["convert", &split, &split], "split.json is not allowed"),
        (&["convert", "sphere", &at("out.map")], "kind: function is not allowed"),
        (&["convert", &at("nowhere.map"), &out], "nowhere.map"),
        (&["convert", &good, &at("no/such/folder/a.json")], "a.json"),
        (&["run", "wcpso", "--scene", &bad], "bad.map: line 5"),
        (&["exact", "--scene", &alone], "gone.map"),
        (&["suggest", "ltqpso", "--scene", &yaml], "gone.pgm"),
        (&["generate", "sand"], "generator: there is no `sand`; known: random, rubble, rooms, maze"),
        (&["generate", "maze", "--set", "columns=0"], "columns: 0 is not allowed; it must be a whole number from 1 to 2048"),
        (&["generate", "maze", "--set", "share=0.5"], "parameter: there is no `share`"),
        (&["generate", "maze", "--seed", "-1"], "seed: -1"),
        (&["generate", "maze", "--out", "a.txt"], "--out: a.txt"),
    ] {
        let output = forage(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(output.stdout.is_empty(), "{args:?}");
        let message = words(&output.stderr);
        assert!(message.contains(part), "{args:?}: {message}");
    }
    for never in [out, scen] {
        assert!(!PathBuf::from(&never).exists(), "{never}");
    }
}

#[test]
fn help_and_list_follow_from_the_table_of_generators() {
    for args in [&["generate", "--help"] as &[&str], &["list"]] {
        let text = words(&forage(args).stdout);
        for generator in GENERATORS {
            assert!(text.contains(generator.title) && generator.parameters.iter().all(|p| text.contains(p.name)), "{args:?}");
        }
    }
    let list: serde_json::Value = serde_json::from_slice(&forage(&["list", "--json"]).stdout).unwrap();
    let names: Vec<_> = list["generators"].as_array().unwrap().iter().map(|g| g["name"].as_str().unwrap()).collect();
    assert_eq!(names, GENERATORS.iter().map(|g| g.name).collect::<Vec<_>>());
    assert_eq!(list["generators"][0]["parameters"][3]["default"], 0.3);
}
